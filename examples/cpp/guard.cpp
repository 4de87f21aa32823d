// A move too large for harmonic weights, repaired: the airfoil rotates by 90 degrees.
//   guard examples/naca0012_inv.su2 rotated.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    const morph::Mesh mesh = morph::read_mesh(argv[1]);
    const morph::CurveDefinition curve = morph::fit_marker(mesh, "airfoil").fit.curve;
    morph::Points2 displacements(curve.control_points.rows(), 2);
    displacements << curve.control_points.col(1), -curve.control_points.col(0);
    displacements -= curve.control_points;

    morph::MotionSettings motion;
    motion.curves = {{.marker = "airfoil", .curve = curve, .displacements = displacements}};
    motion.deform.guard = morph::Guard::untangle;
    const morph::MoveResult moved = morph::Deformer(mesh, motion).move();
    std::cout << "safe part of the move: " << moved.safe_step->step << '\n'
              << moved.tangled << " inverted elements before the repair, " << moved.after->inverted
              << " after\n";
    morph::write_mesh_data(morph::to_mesh_data(mesh, moved), argv[2]);
    return morph::is_valid(moved) ? 0 : 3;
}
