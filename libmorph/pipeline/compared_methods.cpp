#include "libmorph/pipeline/comparison.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/deform/repair.h"
#include "libmorph/pipeline/deformer.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace morph {

namespace {

const std::string kUntangled = "+untangle";

/// The move alone, timed.
void move_by(const Deformer& deformer, const Matrix& displacements, MovedMesh& moved)
{
    // Of a product of weights the shortest time counts: the others wait for memory or another process.
    const int repeats = needs_nonlinear_motion(deformer.settings().deform) ? 1 : 5;
    for (int i = 0; i < repeats; ++i) {
        moved.positions = points(deformer.mesh());
        Stopwatch watch;
        deformer.move_points(displacements, {moved.positions.data(), moved.positions.rows(), 3});
        const double seconds = watch.lap();
        moved.move_seconds = i == 0 ? seconds : std::min(moved.move_seconds, seconds);
    }
    moved.control_variables = static_cast<Index>(
        displacements.size() - static_cast<Eigen::Index>(deformer.held().size()) * displacements.cols());
    moved.weights_bytes = deformer.weights_bytes();
}

/// The curves move the boundary, the method that @p deform chooses moves the rest of the mesh.
auto by_method(const DeformSettings& deform)
{
    return [deform](const Mesh& mesh, const PlacedBoundaries&, MotionSettings motion) {
        motion.lattice.reset();
        motion.deform.method = deform.method;
        if (deform.method == Method::harmonic) {
            motion.deform.diffusivity = deform.diffusivity;
            motion.deform.rotations = deform.rotations;
        }
        Stopwatch watch;
        const Deformer deformer(mesh, motion);
        MovedMesh moved;
        moved.weights_seconds = watch.lap();
        move_by(deformer, deformer.displacements(), moved);
        return moved;
    };
}

auto by_method(Method method)
{
    DeformSettings deform;
    deform.method = method;
    return by_method(deform);
}

auto by_harmonic(Diffusivity diffusivity, bool rotations = false)
{
    DeformSettings deform;
    deform.diffusivity = diffusivity;
    deform.rotations = rotations;
    return by_method(deform);
}

/// A lattice around all curves with half their size to spare, for a motion that has none.
LatticeSettings lattice_around(const PlacedBoundaries& placed)
{
    constexpr double kMargin = 0.5;
    Eigen::AlignedBox2d box;
    for (const CurveBoundary& boundary : placed.boundaries)
        for (const auto& point : boundary.curve.definition().control_points.rowwise())
            box.extend(Eigen::Vector2d(point.transpose()));
    const double margin = kMargin * box.sizes().maxCoeff();
    LatticeSettings lattice;
    lattice.shape.dimension = 2;
    lattice.shape.points = {12, 10, 1};
    lattice.shape.degree = {3, 3, 0};
    lattice.box = {{box.min().x() - margin, box.min().y() - margin, 0},
                   {box.max().x() + margin, box.max().y() + margin, 0}};
    return lattice;
}

/// The motion with its lattice, or one around its curves; what displacements the lattice has are the
/// fit's to find.
MotionSettings with_lattice(MotionSettings motion, const PlacedBoundaries& placed, int continuity)
{
    motion.deform.method = Method::ffd;
    if (!motion.lattice) {
        motion.lattice = lattice_around(placed);
        motion.lattice->continuity = continuity;
    }
    return motion;
}

/// One lattice holds body and mesh, fitted to the moved curves.
MovedMesh move_ffd(const Mesh& mesh, const PlacedBoundaries& placed, const MotionSettings& motion)
{
    constexpr int kSmooth = 1; // at the faces of the box
    const MotionSettings ffd = with_lattice(motion, placed, kSmooth);
    Stopwatch watch;
    const Deformer deformer(mesh, ffd);
    Matrix displacements = deformer.displacements();
    deformer.satisfy(displacements);
    MovedMesh moved;
    moved.weights_seconds = watch.lap();
    move_by(deformer, displacements, moved);
    return moved;
}

/// The lattice moves the boundary alone, fitted to the moved curves; another method moves the rest of the mesh.
auto by_lattice_and(Method method)
{
    return [method](const Mesh& mesh, const PlacedBoundaries& placed, const MotionSettings& curves) {
        MotionSettings motion = with_lattice(curves, placed, -1);
        Stopwatch watch;
        const Deformer fitted(mesh, motion);
        Matrix displacements = fitted.displacements();
        fitted.satisfy(displacements);
        motion.deform.method = method;
        motion.deform.diffusivity = Diffusivity::inverse_distance;
        for (const CurveMove& curve : motion.curves)
            motion.lattice->markers.push_back(curve.marker);
        motion.curves.clear();
        const Deformer deformer(mesh, motion);
        MovedMesh moved;
        moved.weights_seconds = watch.lap();
        move_by(deformer, displacements, moved);
        return moved;
    };
}

/// @p method, and then its inverted elements repaired; the repair counts as part of the move.
ComparedMethod untangled(const ComparedMethod& method)
{
    return {
        method.name + kUntangled, method.description + ", then untangled", method.uses_lattice,
        [move = method.move](const Mesh& mesh, const PlacedBoundaries& placed, const MotionSettings& motion) {
            MovedMesh moved = move(mesh, placed, motion);
            Mesh repaired = mesh;
            points(repaired) = moved.positions;
            Stopwatch watch;
            repair(repaired, points(mesh));
            moved.move_seconds += watch.lap();
            moved.positions = points(repaired);
            return moved;
        }};
}

} // namespace

const std::vector<ComparedMethod>& compared_methods()
{
    static const std::vector<ComparedMethod> table{
        {"harmonic", "Laplace's equation, as in the thesis", false, by_harmonic(Diffusivity::uniform)},
        {"harmonic-distance", "harmonic, stiff near the body: diffusivity 1/distance", false,
         by_harmonic(Diffusivity::inverse_distance)},
        {"harmonic-area", "harmonic, small elements stiff: diffusivity 1/area", false,
         by_harmonic(Diffusivity::inverse_area)},
        {"harmonic-rotations", "harmonic (1/distance), the boundary's rotation spread too", false,
         by_harmonic(Diffusivity::inverse_distance, true)},
        {"biharmonic", "biharmonic, conformal at the walls", false, by_method(Method::biharmonic)},
        {"elasticity", "the mesh as an elastic solid, small elements stiff", false,
         by_method(Method::elasticity)},
        {"spring", "springs along the edges, torsion at the corners", false, by_method(Method::spring)},
        {"rbf", "radial basis functions, Wendland C2", false, by_method(Method::rbf)},
        {"idw", "inverse distance, with rotations", false, by_method(Method::idw)},
        {"damping", "the nearest boundary's move, damped with distance", false, by_method(Method::damping)},
        {"ffd", "a lattice holds body and mesh: free-form deformation as in the thesis", true, move_ffd},
        {"ffd-harmonic", "a lattice moves the body, harmonic weights (1/distance) the mesh", true,
         by_lattice_and(Method::harmonic)},
        {"ffd-rbf", "a lattice moves the body, radial basis functions the mesh", true,
         by_lattice_and(Method::rbf)},
    };
    return table;
}

ComparedMethod compared_method(const std::string& name)
{
    const bool repair = name.ends_with(kUntangled);
    const std::string base = repair ? name.substr(0, name.size() - kUntangled.size()) : name;
    std::vector<std::string> names;
    for (const ComparedMethod& method : compared_methods()) {
        if (method.name == base)
            return repair ? untangled(method) : method;
        names.push_back(method.name);
    }
    throw InputError("method '" + name + "' is not known; known are " + joined(names) +
                     did_you_mean(name, names));
}

} // namespace morph
