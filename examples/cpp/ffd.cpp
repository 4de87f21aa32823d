// Free-form deformation: a lattice of 5 x 4 control points around an airfoil bends it and its mesh.
//   ffd examples/naca0012_inv.su2 bent.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    const morph::Mesh mesh = morph::read_mesh(argv[1]);
    morph::LatticeSettings lattice;
    lattice.shape.points = {5, 4, 1};
    lattice.shape.degree = {3, 3, 0};
    lattice.box = morph::LatticeBox{{-0.5, -0.5, 0}, {1.5, 0.5, 0}};
    lattice.displacements = morph::Matrix::Zero(20, 2); // control point (i, j) is row i + 5 j
    for (const int j : {1, 2})
        lattice.displacements.row(2 + 5 * j) << 0,
            0.05; // the outer layers stay, so that the mesh outside fits

    morph::MotionSettings motion;
    motion.lattice = lattice;
    motion.deform.method = morph::Method::ffd;
    const morph::MoveResult moved = morph::Deformer(mesh, motion).move();
    std::cout << moved.after->inverted << " inverted elements\n";
    morph::write_mesh_data(morph::to_mesh_data(mesh, moved), argv[2]);
}
