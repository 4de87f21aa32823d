// The same move by every method: rotate an airfoil by 30 degrees and count inverted elements.
//   methods examples/naca0012_inv.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>
#include <numbers>

int main(int, char** argv)
{
    const morph::Mesh mesh = morph::read_mesh(argv[1]);
    const morph::CurveDefinition curve = morph::fit_marker(mesh, "airfoil", {.control_points = 12}).fit.curve;
    const morph::Points2& P = curve.control_points;
    const Eigen::Rotation2Dd rotation(-30 * std::numbers::pi / 180);
    const morph::Points2 displacements = P * rotation.toRotationMatrix().transpose() - P;

    for (const auto& [method, name] : morph::kEnumNames<morph::Method>) {
        if (method == morph::Method::ffd)
            continue; // moves by a lattice, see ffd.cpp
        morph::MotionSettings motion;
        motion.curves = {{.marker = "airfoil", .curve = curve, .displacements = displacements}};
        motion.deform.method = method;
        const morph::MoveResult moved = morph::Deformer(mesh, motion).move();
        std::cout << name << ": " << moved.after->inverted << " inverted elements\n";
    }
}
