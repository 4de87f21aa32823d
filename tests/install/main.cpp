// Morph a mesh in ten lines: a curve around the airfoil lifts it and the mesh follows.
#include "formats/formats.h"
#include "libmorph/deform/apply.h"
#include "libmorph/weights/harmonic_curves.h"

int main(int, char** argv)
{
    morph::Mesh mesh = morph::read_mesh(argv[1]);
    morph::CurveDefinition box{.degree = 2, .closed = true, .control_points = morph::Points2(4, 2)};
    box.control_points << 0, -0.1, 1, -0.1, 1, 0.1, 0, 0.1;
    const morph::Weights weights = morph::harmonic_curve_weights(mesh, {{"airfoil", morph::Curve(box)}});
    morph::apply_weights(weights, morph::Matrix::Constant(4, 2, 0.01), morph::points(mesh));
    morph::write_mesh(mesh, argv[2]);
}
