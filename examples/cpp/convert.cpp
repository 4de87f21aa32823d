// Convert a mesh from one format to another, with a marker renamed and millimetres turned into metres.
//   convert examples/naca0012_inv.su2 converted.vtu
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    morph::MeshData mesh = morph::read_mesh_data(argv[1]);
    morph::Edits edits;
    edits.renames = {{"airfoil", "wing"}};
    edits.transform = morph::Transform{.linear = 0.001 * Eigen::Matrix3d::Identity()};
    for (const std::string& warning : morph::apply_edits(edits, mesh))
        std::cerr << warning << '\n';
    for (const std::string& warning : morph::write_mesh_data(mesh, argv[2]))
        std::cerr << warning << '\n';
}
