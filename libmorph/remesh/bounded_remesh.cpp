#include "libmorph/remesh/bounded_remesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/geometry/element_tree.h"
#include "libmorph/geometry/hausdorff.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/wanted_size.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morph {

namespace {

/// A turn of the mesh over a length, at some of its vertices.
class ChordLimit {
public:
    ChordLimit(double error, double most_turn, Eigen::VectorXd& sizes)
        : error_(error), most_turn_(most_turn * std::numbers::pi / 180), sizes_(sizes)
    {
    }

    void apply(const Eigen::Vector3d& before, const Eigen::Vector3d& after, double length,
               std::initializer_list<Index> vertices) const
    {
        const double turn = std::atan2(before.cross(after).norm(), before.dot(after));
        if (turn > most_turn_ || turn <= 0)
            return;
        const double size = std::sqrt(8 * error_ * length / turn);
        for (const Index v : vertices)
            sizes_[v] = std::min(sizes_[v], size);
    }

private:
    double error_, most_turn_;
    Eigen::VectorXd& sizes_;
};

/// Twice the area of a face's first triangle times its normal.
Eigen::Vector3d face_normal(const Mesh& mesh, FaceHandle face)
{
    const Element e = element_corners(mesh, face.idx());
    const auto place = points(mesh);
    const Eigen::RowVector3d ab = place.row(e[1]) - place.row(e[0]), ac = place.row(e[2]) - place.row(e[0]);
    return ab.cross(ac);
}

void limit_on_surface(const Mesh& mesh, const ChordLimit& limit)
{
    const auto place = points(mesh);
    for (const auto edge : mesh.kernel.edges()) {
        if (edge.is_boundary())
            continue;
        const Eigen::Vector3d m = face_normal(mesh, edge.h0().face()),
                              n = face_normal(mesh, edge.h1().face());
        const double length = (place.row(edge.v0().idx()) - place.row(edge.v1().idx())).norm();
        // From the middle of one triangle to that of the other, about a third of both heights.
        limit.apply(m, n, (m.norm() + n.norm()) / (3 * length), {edge.v0().idx(), edge.v1().idx()});
    }
}

void limit_on_border(const Mesh& mesh, const ChordLimit& limit)
{
    const auto place = points(mesh);
    for (const auto h : mesh.kernel.halfedges()) {
        if (!h.is_boundary())
            continue;
        const auto next = h.next();
        const Eigen::Vector3d before = place.row(h.to().idx()) - place.row(h.from().idx()),
                              after = place.row(next.to().idx()) - place.row(next.from().idx());
        limit.apply(before, after, (before.norm() + after.norm()) / 2,
                    {h.from().idx(), h.to().idx(), next.to().idx()});
    }
}

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
    constexpr double kOfOwn = 0.125;
    return mesh.dimension == 2 ? own_sizes(mesh) : Eigen::VectorXd(kOfOwn * own_sizes(mesh));
}

} // namespace

void limit_chord_error(const Mesh& mesh, double error, const FeatureSettings& features,
                       Eigen::VectorXd& sizes)
{
    if (mesh.dimension == 2)
        limit_on_border(mesh, {error, features.corner_angle, sizes});
    else
        limit_on_surface(mesh, {error, features.crease_angle, sizes});
}

RemadeMesh remesh_within(const Mesh& mesh, double distance, Eigen::VectorXd& sizes,
                         const RemeshSettings& settings)
{
    constexpr int kRounds = 6;
    if (!(distance > 0))
        throw InputError("the distance from the input to keep is " + number_text(distance) +
                         ", but it has to be positive");
    const Eigen::VectorXd least = least_sizes(mesh).cwiseMin(sizes);
    limit_chord_error(mesh, distance / (kLongEdge * kLongEdge), settings.features, sizes);
    sizes = sizes.cwiseMax(least);
    RemadeMesh made = remesh(mesh, sizes, settings);
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
