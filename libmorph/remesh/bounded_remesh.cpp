#include "libmorph/remesh/bounded_remesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/geometry/element_tree.h"
#include "libmorph/geometry/hausdorff.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/chord_size.h"
#include "libmorph/remesh/target_size.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

/// Lower the sizes around places that are too far away.
/// @param power  of the size that the distance goes with
/// @param least  n: sizes that shorter edges would not help below
/// @return whether any could be lowered
bool lower_around(const Mesh& mesh, const ElementTree& tree, const std::vector<DistantPlace>& places,
                  double distance, double power, const Eigen::VectorXd& least, Eigen::VectorXd& sizes)
{
    constexpr double kSafety = 0.9;
    constexpr double kReach = 2;           // times the size there
    constexpr double kSmallestStep = 0.25; // a place very far away says little about the size that will do
    const Eigen::VectorXd old = sizes;
    std::vector<Index> faces;
    for (const DistantPlace& place : places) {
        const double factor =
            std::max(kSafety * std::pow(distance / place.distance, 1 / power), kSmallestStep);
        const Element on = element_corners(mesh, tree.closest(place.point).face);
        const double reach = kReach * std::max({old[on[0]], old[on[1]], old[on[2]]});
        Eigen::AlignedBox3d box(place.point);
        box.min().array() -= reach;
        box.max().array() += reach;
        tree.overlapping(box, faces);
        for (const Index face : faces)
            for (const Index v : element_corners(mesh, face))
                if (v >= 0)
                    sizes[v] = std::min(sizes[v], std::max(factor * old[v], least[v]));
    }
    return sizes != old;
}

/// Nodes of a planar boundary lie on the curve through the old ones, which is as far from the input as the
/// input's own chords are from it: edges shorter than these change nothing. On a surface they lie on the
/// input's triangles and come nearer to its vertices.
Eigen::VectorXd least_sizes(const Mesh& mesh)
{
    constexpr double kSizeRatio = 0.125;
    return mesh.dimension == 2 ? current_sizes(mesh) : Eigen::VectorXd(kSizeRatio * current_sizes(mesh));
}

} // namespace

RemeshResult remesh_within(const Mesh& mesh, double distance, Eigen::VectorXd& sizes,
                           const RemeshSettings& settings)
{
    constexpr int kRounds = 10; // far more than it takes where the distance can be met
    if (!(distance > 0))
        throw InputError("the distance from the input to keep is " + number_text(distance) +
                         ", but it has to be positive");
    const Eigen::VectorXd least = least_sizes(mesh).cwiseMin(sizes);
    // The middle of an equilateral triangle is h^2 / 6 r from a sphere, that of its edge h^2 / 8 r.
    const double of_edge = mesh.dimension == 2 ? distance : 0.75 * distance;
    const double of_wanted_length = of_edge / (kLongEdge * kLongEdge);
    sizes = sizes.cwiseMin(chord_sizes(mesh, settings.features, of_wanted_length)).cwiseMax(least);
    RemeshResult made = remesh(mesh, sizes, settings);
    const ElementTree tree(mesh);
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<DistantPlace> places = places_beyond(mesh, build_mesh(made.data), distance);
        // A smooth surface is cut off by the square of the size, a vertex of a coarse one by the size itself.
        if (!lower_around(mesh, tree, places, distance, round == 0 ? 2 : 1, least, sizes))
            break;
        made = remesh(mesh, sizes, settings);
    }
    return made;
}

} // namespace morph
