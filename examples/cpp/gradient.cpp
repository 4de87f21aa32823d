// Sensitivities: derivatives of an objective by the vertices become those by the control points.
//   gradient examples/naca0012_inv.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    const morph::Mesh mesh = morph::read_mesh(argv[1]);
    morph::MotionSettings motion;
    motion.curves = {
        {.marker = "airfoil", .curve = morph::fit_marker(mesh, "airfoil", {.control_points = 8}).fit.curve}};
    const morph::Deformer deformer(mesh, motion);

    // J = sum of |x|^2 / 2 over all vertices, so dJ/dX = X; an adjoint flow solver gives it in earnest.
    const morph::Matrix by_vertex = morph::points(mesh).leftCols(2);
    const morph::Matrix by_control_point = deformer.gradient(by_vertex);
    for (morph::Index k = 0; k < by_control_point.rows(); ++k) {
        const morph::ControlPoint& point = deformer.control_points()[static_cast<std::size_t>(k)];
        std::cout << point.boundary << ' ' << point.number + 1 << ": " << by_control_point.row(k) << '\n';
    }
}
