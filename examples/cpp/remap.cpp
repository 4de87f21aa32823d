// Transfer a field from one mesh to another of the same domain.
//   remap examples/naca0012_inv.su2 remapped.vtu
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    const morph::Mesh source = morph::read_mesh(argv[1]);
    const morph::Field field{"x squared", morph::FieldLocation::vertex,
                             morph::points(source).col(0).array().square()};

    // The target: the same domain with triangles twice as large.
    morph::SizeSettings sizes;
    sizes.scale = 2;
    morph::Mesh target = morph::build_mesh(morph::remesh(source, morph::target_sizes(source, sizes)).data);

    const morph::Locator locator(source);
    morph::Remapper remapper(locator, target);
    const std::vector<const morph::Field*> fields{&field};
    target.fields = remapper.transfer(fields);
    std::cout << morph::vertex_count(source) << " vertices to " << morph::vertex_count(target) << '\n';
    morph::write_mesh(target, argv[2]);
}
