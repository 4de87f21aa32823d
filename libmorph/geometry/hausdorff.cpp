#include "libmorph/geometry/hausdorff.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/mesh_parts.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kMostPieces = 4096; // of one triangle
constexpr std::size_t kRowsPerBlock = 512;

/// What is known of the largest distance: it is attained at a place, and bounded.
struct Extent {
    double value = 0;
    double bound = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();

    void raise(double distance, const Eigen::Vector3d& p)
    {
        bound = std::max(bound, distance);
        if (distance > value) {
            value = distance;
            place = p;
        }
    }
};

/// How closely a distance has to be known.
struct Precision {
    double relative = 0;
    double absolute = 0;
    double ignored = 0; ///< distances up to this are all the same

    double limit(double value) const { return std::max({ignored, value * (1 + relative), value + absolute}); }
};

/// The largest distance of a part of one mesh from the other.
class PartSearch {
public:
    PartSearch(const MeshParts& to, const Precision& precision, Extent& extent)
        : to_(to), precision_(precision), extent_(extent)
    {
    }

    void run(const ConvexPiece& whole)
    {
        pending_.assign(1, whole);
        for (std::size_t pieces = 0; !pending_.empty(); ++pieces) {
            const ConvexPiece piece = pending_.back();
            pending_.pop_back();
            const Eigen::Vector3d middle = piece.middle();
            const MeshParts::Nearest near = to_.nearest(middle, last_);
            last_ = near.part;
            extent_.raise(near.distance, middle);
            const Farthest far = farthest(piece, near.part);
            if (pieces >= kMostPieces || far.distance <= limit())
                extent_.bound = std::max(extent_.bound, far.distance);
            else
                divide(piece, near.part);
        }
    }

private:
    struct Farthest {
        double distance = 0;
        Eigen::Vector3d corner;
    };

    double limit() const { return precision_.limit(extent_.value); }

    /// The corner farthest from one part of the other mesh: no point of the piece is farther.
    Farthest farthest(const ConvexPiece& piece, std::size_t part) const
    {
        Farthest found{-1, {}};
        for (std::size_t i = 0; i < piece.size(); ++i)
            if (const double d = to_.distance(part, piece.corner(i)); d > found.distance)
                found = {d, piece.corner(i)};
        return found;
    }

    void divide(const ConvexPiece& piece, std::size_t part)
    {
        constexpr std::size_t kManyCorners = ConvexPiece::kMostCorners - 4; // walls cut off a corner each
        ConvexPiece inside = piece;
        if (piece.size() <= kManyCorners)
            for (const MeshParts::Plane& wall : to_.walls(part)) {
                const auto [in, out] = inside.cut(wall.origin, wall.normal);
                if (in.size() == 0 || out.size() == 0)
                    continue;
                inside = in;
                pending_.push_back(out);
            }
        const Farthest far = farthest(inside, part);
        MeshParts::Nearest near{part, 0};
        if (far.distance > limit()) {
            near = to_.nearest(far.corner, part);
            extent_.raise(near.distance, far.corner);
        }
        if (far.distance > limit())
            cut_in_two(inside, part, near.part);
        else
            extent_.bound = std::max(extent_.bound, far.distance);
    }

    /// Where the parts nearest to the middle and to the worst corner are equally far, or just in halves.
    void cut_in_two(const ConvexPiece& piece, std::size_t part, std::size_t of_corner)
    {
        std::pair<ConvexPiece, ConvexPiece> parts;
        if (of_corner != part) {
            const MeshParts::Plane between = to_.bisector(part, of_corner, piece.middle());
            parts = piece.cut(between.origin, between.normal);
        }
        if (parts.first.size() == 0 || parts.second.size() == 0)
            parts = piece.halves();
        for (const ConvexPiece& half : {parts.first, parts.second})
            if (half.size() > 0)
                pending_.push_back(half);
    }

    const MeshParts& to_;
    const Precision& precision_;
    Extent& extent_;
    std::vector<ConvexPiece> pending_;
    std::size_t last_ = 0; ///< nearest part of the last piece
};

/// Search every @p stride-th part, each block of them from what was known before.
Extent farthest(const MeshParts& from, const MeshParts& to, const Precision& precision, const Extent& known,
                std::size_t stride)
{
    const std::size_t count = (from.size() + stride - 1) / stride;
    std::vector<Extent> of_block((count + kRowsPerBlock - 1) / kRowsPerBlock, known);
    parallel_for(count, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        PartSearch search(to, precision, of_block[begin / kRowsPerBlock]);
        for (std::size_t i = begin; i < end; ++i)
            search.run(from.piece(i * stride));
    });
    Extent largest = known;
    for (const Extent& extent : of_block) {
        largest.raise(extent.value, extent.place);
        largest.bound = std::max(largest.bound, extent.bound);
    }
    return largest;
}

/// A sample first, so that most parts are compared with nearly the largest distance.
Extent farthest(const MeshParts& from, const MeshParts& to, const Precision& precision, const Extent& known)
{
    constexpr std::size_t kStride = 61;
    Extent sample = farthest(from, to, precision, known, kStride);
    sample.bound = std::max(sample.value, known.bound);
    return farthest(from, to, precision, sample, 1);
}

void require_comparable(const Mesh& first, const Mesh& second)
{
    if (first.dimension != second.dimension)
        throw InputError("a planar mesh and a surface have no distance; both must be one or the other");
    for (const Mesh* mesh : {&first, &second})
        if (element_count(*mesh) == 0)
            throw InputError("a mesh without elements has no distance from another");
}

double diagonal(const Mesh& mesh)
{
    const auto place = points(mesh);
    return (place.colwise().maxCoeff() - place.colwise().minCoeff()).norm();
}

void add_beyond(const MeshParts& from, const MeshParts& to, double distance, std::vector<DistantPlace>& found)
{
    constexpr double kRelativePrecision = 0.1;
    const Precision precision{kRelativePrecision, 0, distance};
    std::vector<Extent> extents(from.size());
    parallel_for(from.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            PartSearch(to, precision, extents[i]).run(from.piece(i));
    });
    for (const Extent& extent : extents)
        if (extent.value > distance)
            found.push_back({extent.place, extent.value});
}

} // namespace

HausdorffDistance hausdorff_distance(const Mesh& first, const Mesh& second, double tolerance)
{
    require_comparable(first, second);
    constexpr double kRounding = 1e-10;
    const Precision precision{tolerance, kRounding * std::max(diagonal(first), diagonal(second)), 0};
    const MeshParts a(first), b(second);
    const Extent one_way = farthest(a, b, precision, {});
    const Extent both = farthest(b, a, precision, one_way);
    return {both.value, both.bound, both.place, both.value == one_way.value};
}

std::vector<DistantPlace> places_beyond(const Mesh& first, const Mesh& second, double distance)
{
    require_comparable(first, second);
    const MeshParts a(first), b(second);
    std::vector<DistantPlace> found;
    add_beyond(a, b, distance, found);
    add_beyond(b, a, distance, found);
    return found;
}

} // namespace morph
