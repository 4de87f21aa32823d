// Move a mesh with its airfoil: fit a curve once, then move its control points as often as you like.
//   move examples/naca0012_inv.su2 moved.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    morph::Mesh mesh = morph::read_mesh(argv[1]);
    const morph::FittedMarker airfoil = morph::fit_marker(mesh, "airfoil", {.control_points = 12});

    morph::MotionSettings motion;
    motion.curves = {{.marker = "airfoil", .curve = airfoil.fit.curve}};
    motion.deform.diffusivity = morph::Diffusivity::inverse_distance;
    const morph::Deformer deformer(mesh, motion); // one solve; every move below is one matrix product

    for (const double lift : {0.01, 0.02, 0.03}) {
        morph::Matrix displacements = morph::Matrix::Zero(12, 2); // 12 control points, (dx, dy) each
        displacements.col(1).setConstant(lift);
        const morph::MoveResult moved = deformer.move(displacements);
        std::cout << "up by " << lift << ": " << moved.after->inverted
                  << " inverted elements, smallest scaled Jacobian " << moved.after->min_scaled_jacobian
                  << '\n';
        if (lift == 0.03)
            morph::write_mesh_data(morph::to_mesh_data(mesh, moved), argv[2]);
    }
}
