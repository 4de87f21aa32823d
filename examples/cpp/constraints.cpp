// Pull one point of an airfoil up, keep its area and its trailing edge.
//   constraints examples/naca0012_inv.su2 constrained.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    const morph::Mesh mesh = morph::read_mesh(argv[1]);
    morph::MotionSettings motion;
    motion.curves = {{.marker = "airfoil", .curve = morph::fit_marker(mesh, "airfoil").fit.curve}};

    morph::PullSettings pull;
    pull.points = morph::Matrix::Zero(1, 3);
    pull.points.row(0) << 0.4, 0.06, 0; // the vertex nearest to here
    pull.displacements = morph::Matrix::Zero(1, 3);
    pull.displacements.row(0) << 0, 0.01, 0;
    motion.pulls = {pull};

    morph::ConstraintSettings keep;
    keep.area = {"airfoil"};
    keep.fixed_points = morph::Matrix::Zero(1, 3);
    keep.fixed_points.row(0) << 1, 0, 0;
    motion.constraints = keep;

    const morph::MoveResult moved = morph::Deformer(mesh, motion).move();
    for (const morph::MeasuredConstraint& measured : moved.control.constrained->measured)
        std::cout << measured.name << ": " << measured.undisplaced << " before, " << measured.reached
                  << " after\n";
    std::cout << moved.after->inverted << " inverted elements\n";
    morph::write_mesh_data(morph::to_mesh_data(mesh, moved), argv[2]);
}
