// Remesh a domain with triangles of half the size, its boundary layers kept.
//   remesh examples/naca0012_inv.su2 fine.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    const morph::Mesh mesh = morph::read_mesh(argv[1]);
    morph::SizeSettings sizes;
    sizes.scale = 0.5;
    const morph::RemeshResult result = morph::remesh(mesh, morph::target_sizes(mesh, sizes));
    const morph::QualityReport quality = morph::quality_report(morph::build_mesh(result.data));
    std::cout << quality.triangles << " triangles, smallest angle " << quality.min_angle << " degrees\n";
    morph::write_mesh_data(result.data, argv[2]);
}
