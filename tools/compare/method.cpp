#include "tools/compare/method.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/deform/repair.h"
#include "tools/common/report.h"
#include "tools/deform/case_motion.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace morph::tools {

namespace {

const std::string kUntangled = "+untangle";

std::size_t bytes_of(const CaseMotion& motion)
{
    if (const Weights* dense = std::get_if<Weights>(&motion.weights))
        return sizeof(double) * static_cast<std::size_t>(dense->values.size());
    const auto& sparse = std::get<SparseWeights>(motion.weights).values;
    return (sizeof(double) + sizeof(Index)) * static_cast<std::size_t>(sparse.nonZeros()) +
           sizeof(Index) * static_cast<std::size_t>(sparse.rows() + 1);
}

/// The move of a prepared case, timed.
void apply(const Mesh& mesh, const CaseFile& file, const CaseMotion& motion, MovedMesh& moved)
{
    // Of a product of weights the shortest time counts: the others wait for memory or another process.
    const int repeats = motion.carry ? 1 : 5;
    for (int i = 0; i < repeats; ++i) {
        moved.positions = points(mesh);
        Stopwatch watch;
        apply_motion(mesh, file, motion,
                     Eigen::Map<Points>(moved.positions.data(), moved.positions.rows(), 3));
        const double seconds = watch.lap();
        moved.move_seconds = i == 0 ? seconds : std::min(moved.move_seconds, seconds);
    }
    moved.control_variables =
        static_cast<Index>(motion.displacements.size() -
                           static_cast<Eigen::Index>(motion.held().size()) * motion.displacements.cols());
    moved.weights_bytes = bytes_of(motion);
}

/// The curves move the boundary, the method that @p choose sets carries the mesh.
template <typename Choose>
auto carried_by(Choose choose)
{
    return [choose](const Mesh& mesh, const PlacedBoundaries&, CaseFile file) {
        choose(file.deform);
        file.lattice.reset();
        Stopwatch watch;
        const CaseMotion motion = prepare_motion(mesh, file);
        MovedMesh moved;
        moved.weights_seconds = watch.lap();
        apply(mesh, file, motion, moved);
        return moved;
    };
}

auto by_method(const std::string& method)
{
    return carried_by([method](DeformEntry& deform) { deform.method = method; });
}

auto by_harmonic(const std::string& diffusivity, bool rotations = false)
{
    return carried_by([diffusivity, rotations](DeformEntry& deform) {
        deform.method = "harmonic";
        deform.diffusivity = diffusivity;
        deform.rotations = rotations;
    });
}

/// A lattice around all bodies with half their size to spare, for a case that has none.
LatticeEntry lattice_around(const PlacedBoundaries& placed)
{
    constexpr double kMargin = 0.5;
    Eigen::AlignedBox2d box;
    for (const CurveBoundary& boundary : placed.boundaries)
        for (const auto& point : boundary.curve.definition().control_points.rowwise())
            box.extend(Eigen::Vector2d(point.transpose()));
    const double margin = kMargin * box.sizes().maxCoeff();
    LatticeEntry entry;
    entry.points = {12, 10, 1};
    entry.degree = {3, 3, 0};
    entry.corners = Matrix::Zero(2, 3);
    entry.corners->row(0).head<2>() = (box.min().array() - margin).matrix().transpose();
    entry.corners->row(1).head<2>() = (box.max().array() + margin).matrix().transpose();
    entry.displacements = Matrix::Zero(entry.count(), 3);
    entry.sparse_displacements = Matrix::Zero(0, 6);
    return entry;
}

/// The case with its lattice, or one around its bodies; what displacements the lattice has are the fit's to
/// find.
CaseFile with_lattice(CaseFile file, const PlacedBoundaries& placed, int continuity)
{
    file.deform.method = "ffd";
    if (!file.lattice) {
        file.lattice = lattice_around(placed);
        file.lattice->continuity = continuity;
    }
    return file;
}

/// One lattice holds body and mesh, fitted to the moved curves.
MovedMesh move_ffd(const Mesh& mesh, const PlacedBoundaries& placed, const CaseFile& file)
{
    constexpr int kSmooth = 1; // at the faces of the box
    const CaseFile ffd = with_lattice(file, placed, kSmooth);
    Stopwatch watch;
    CaseMotion motion = prepare_motion(mesh, ffd);
    control_motion(mesh, ffd, motion);
    MovedMesh moved;
    moved.weights_seconds = watch.lap();
    apply(mesh, ffd, motion, moved);
    return moved;
}

/// The lattice moves the boundary alone, fitted to the moved curves; another method carries the mesh.
auto by_lattice_and(const std::string& method)
{
    return [method](const Mesh& mesh, const PlacedBoundaries& placed, const CaseFile& file) {
        CaseFile ffd = with_lattice(file, placed, -1);
        Stopwatch watch;
        CaseMotion fitted = prepare_motion(mesh, ffd);
        control_motion(mesh, ffd, fitted);
        ffd.deform.method = method;
        ffd.deform.diffusivity = "inverse-distance";
        for (const BoundaryEntry& boundary : ffd.boundaries)
            ffd.lattice->markers.push_back(boundary.name);
        ffd.boundaries.clear();
        CaseMotion motion = prepare_motion(mesh, ffd);
        motion.displacements = fitted.displacements;
        MovedMesh moved;
        moved.weights_seconds = watch.lap();
        apply(mesh, ffd, motion, moved);
        return moved;
    };
}

/// @p method, and then its inverted elements repaired; the repair counts as part of the move.
CompareMethod untangled(const CompareMethod& method)
{
    return {method.name + kUntangled, method.description + ", then untangled",
            [move = method.move](const Mesh& mesh, const PlacedBoundaries& placed, const CaseFile& file) {
                MovedMesh moved = move(mesh, placed, file);
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

const std::vector<CompareMethod>& compare_methods()
{
    static const std::vector<CompareMethod> table{
        {"harmonic", "Laplace's equation, as in the thesis", by_harmonic("uniform")},
        {"harmonic-distance", "harmonic, stiff near the body: diffusivity 1/distance",
         by_harmonic("inverse-distance")},
        {"harmonic-area", "harmonic, small elements stiff: diffusivity 1/area", by_harmonic("inverse-area")},
        {"harmonic-rotations", "harmonic (1/distance), the boundary's rotation spread too",
         by_harmonic("inverse-distance", true)},
        {"biharmonic", "biharmonic, conformal at the walls", by_method("biharmonic")},
        {"elasticity", "the mesh as an elastic solid, small elements stiff", by_method("elasticity")},
        {"spring", "springs along the edges, torsion at the corners", by_method("spring")},
        {"rbf", "radial basis functions, Wendland C2", by_method("rbf")},
        {"idw", "inverse distance, with rotations", by_method("idw")},
        {"damping", "the nearest boundary's move, damped with distance", by_method("damping")},
        {"ffd", "a lattice holds body and mesh: free-form deformation as in the thesis", move_ffd},
        {"ffd-harmonic", "a lattice moves the body, harmonic weights (1/distance) the mesh",
         by_lattice_and("harmonic")},
        {"ffd-rbf", "a lattice moves the body, radial basis functions the mesh", by_lattice_and("rbf")},
    };
    return table;
}

CompareMethod compare_method(const std::string& name)
{
    const bool repair = name.ends_with(kUntangled);
    const std::string base = repair ? name.substr(0, name.size() - kUntangled.size()) : name;
    std::vector<std::string> names;
    for (const CompareMethod& method : compare_methods()) {
        if (method.name == base)
            return repair ? untangled(method) : method;
        names.push_back(method.name);
    }
    throw InputError("method '" + name + "' is not known; known are " + joined(names) +
                     did_you_mean(name, names));
}

} // namespace morph::tools
