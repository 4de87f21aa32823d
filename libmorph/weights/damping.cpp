#include "libmorph/weights/damping.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/weights/boundary_segments.h"

#include <optional>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 4096; // vertices a thread takes at a time

std::optional<NearestOnSegments> nearest_on(const Points& points, const std::vector<BoundarySegment>& edges)
{
    if (edges.empty())
        return std::nullopt;
    return NearestOnSegments(points, edges);
}

class DampingExtension final : public BoundaryExtension {
public:
    DampingExtension(const DomainView& domain, const DirichletBoundary& boundary)
        : BoundaryExtension(domain, boundary)
    {
        if (held().vertices().empty())
            throw InputError("no vertex is held: there is nothing to damp");
        const BoundarySegments edges = boundary_segments(domain, boundary, held());
        const Points at_rest = held_points(domain, held());
        const auto moving = nearest_on(at_rest, edges.moving), still = nearest_on(at_rest, edges.still);
        const auto x = domain.positions();
        sources_.resize(static_cast<std::size_t>(x.rows()));
        parallel_for(sources_.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            Source at;
            for (std::size_t v = begin; v < end; ++v) {
                const Eigen::Vector3d point = x.row(static_cast<Index>(v)).transpose();
                if (moving)
                    at.moving = moving->nearest(point, at.moving.segment);
                if (still)
                    at.still = still->nearest(point, at.still.segment);
                at.share = !moving ? 0 : !still ? 1 : share(at.moving.distance, at.still.distance);
                sources_[v] = at;
            }
        });
    }

private:
    Matrix solve(const Matrix& joined) const override
    {
        Matrix result(static_cast<Index>(sources_.size()), joined.cols());
        parallel_for(sources_.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const auto& [moving, still, share] = sources_[v];
                result.row(static_cast<Index>(v)) =
                    share * moving.value(joined) + (1 - share) * still.value(joined);
            }
        });
        return result;
    }

    /// Where the value of a vertex comes from.
    struct Source {
        EdgePoint moving;
        EdgePoint still;
        double share = 0; ///< of moving
    };

    /// f; by the quotient of the distances, whose squares might underflow.
    static double share(double moving, double still)
    {
        const double quotient = moving / still;
        return moving == 0 ? 1 : 1 / (1 + quotient * quotient);
    }

    std::vector<Source> sources_; ///< of each vertex
};

} // namespace

std::unique_ptr<BoundaryExtension> damping_extension(const DomainView& domain,
                                                     const DirichletBoundary& boundary)
{
    return std::make_unique<DampingExtension>(domain, boundary);
}

} // namespace morph
