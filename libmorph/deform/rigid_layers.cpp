#include "libmorph/deform/rigid_layers.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/rigid_frames.h"
#include "libmorph/geometry/segment_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace morph {

namespace {

/// A held boundary that grows by the vertices of layers.
class LayeredBoundary {
public:
    LayeredBoundary(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)
        : mesh_(mesh), frames_(boundary_frames(mesh, held, displacement)), displacement_(displacement),
          row_(static_cast<std::size_t>(mesh.numbering.file_vertices), -1), held_(held)
    {
        for (std::size_t i = 0; i < held.vertices.size(); ++i)
            row(held.vertices[i]) = static_cast<Index>(i);
    }

    void add(const RigidLayer& layer)
    {
        if (!(layer.distance >= 0))
            throw InputError("the layers of marker '" + layer.marker + "' have a distance below 0");
        const auto& edges = marker(mesh_, layer.marker).edges;
        for (const auto& [a, b] : edges)
            if (!has_frame(a) || !has_frame(b))
                throw InputError("marker '" + layer.marker +
                                 "' is neither moved nor fixed, so its layers "
                                 "have nothing to follow");
        const SegmentTree tree(points(mesh_), edges);
        Index hint = 0;
        for (Index v = 0; v < vertex_count(mesh_); ++v) {
            const Eigen::RowVector2d x = points(mesh_).row(v).head<2>();
            const SegmentTree::Nearest nearest = tree.nearest(x.x(), x.y(), hint);
            hint = nearest.segment;
            if (row(v) < 0 && nearest.distance <= layer.distance)
                hold(v, follow(x, edges[static_cast<std::size_t>(nearest.segment)]));
        }
    }

    const DirichletBoundary& held() const { return held_; }

    Matrix displacement() const
    {
        Matrix all(displacement_.rows() + std::ssize(added_), 2);
        all.topRows(displacement_.rows()) = displacement_;
        for (std::size_t i = 0; i < added_.size(); ++i)
            all.row(displacement_.rows() + static_cast<Index>(i)) = added_[i];
        return all;
    }

private:
    /// The row of a vertex, or of a copy of it, among the held ones.
    Index& row(Index v)
    {
        const Index number = mesh_.numbering.vertex[static_cast<std::size_t>(v)];
        return row_[static_cast<std::size_t>(number)];
    }

    bool has_frame(Index v) { return row(v) >= 0 && row(v) < displacement_.rows(); }

    void hold(Index v, const Eigen::RowVector2d& displacement)
    {
        row(v) = static_cast<Index>(held_.vertices.size());
        held_.vertices.push_back(v);
        added_.push_back(displacement);
    }

    /// The displacement at @p x when it moves as the frame of a held vertex does.
    Eigen::RowVector2d of_frame(Index v, const Eigen::RowVector2d& x)
    {
        const Index at = row(v);
        const auto i = static_cast<std::size_t>(at);
        if (frames_.body[i] < 0)
            return displacement_.row(at);
        const Eigen::Vector2d arm = (x - frames_.pivot.row(frames_.body[i])).transpose();
        return frames_.translation.row(at) + (Eigen::Rotation2Dd(frames_.angle[i]) * arm - arm).transpose();
    }

    /// The blend of the frames at both ends of the nearest edge.
    Eigen::RowVector2d follow(const Eigen::RowVector2d& x, const std::array<Index, 2>& edge)
    {
        const Eigen::RowVector2d a = points(mesh_).row(edge[0]).head<2>();
        const Eigen::RowVector2d along = points(mesh_).row(edge[1]).head<2>() - a;
        const double length2 = along.squaredNorm();
        const double share = length2 > 0 ? std::clamp((x - a).dot(along) / length2, 0.0, 1.0) : 0.0;
        return (1 - share) * of_frame(edge[0], x) + share * of_frame(edge[1], x);
    }

    const Mesh& mesh_;
    BoundaryFrames frames_;
    const Matrix& displacement_;
    std::vector<Index> row_; ///< by file number: among the held vertices, or -1
    DirichletBoundary held_;
    std::vector<Eigen::RowVector2d> added_;
};

} // namespace

BoundaryMove with_rigid_layers(BoundaryMove move, std::vector<RigidLayer> layers)
{
    return [move = std::move(move), layers = std::move(layers)](
               const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement) {
        LayeredBoundary layered(mesh, held, displacement);
        for (const RigidLayer& layer : layers)
            layered.add(layer);
        return move(mesh, layered.held(), layered.displacement());
    };
}

} // namespace morph
