#include "libmorph/remap/supermesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/remap/visited_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 8192;

// What rounding may make of the sum of overlaps that cover a piece, relative to its area.
constexpr double kSumRounding = 1e-12;

// What rounding may make of two pieces that only touch, relative to the smaller one's area.
constexpr double kTouching = 1e-13;

Points centre_of(const ConvexPart& piece)
{
    Points centre = Points::Zero(1, 3);
    for (int k = 0; k < piece.outline.corners; ++k)
        centre += Eigen::RowVector3d(piece.outline[k].x, piece.outline[k].y, 0) / piece.outline.corners;
    return centre;
}

Eigen::AlignedBox3d box_of(const ConvexPart& piece)
{
    Eigen::AlignedBox3d box;
    for (int k = 0; k < piece.outline.corners; ++k)
        box.extend(Eigen::Vector3d(piece.outline[k].x, piece.outline[k].y, 0));
    return box;
}

/// Finds the covers of one piece after the other.
class Search {
public:
    Search(const Locator& source, Cut cut) : source_(source), mesh_(source.source()), cut_(cut) {}

    /// @param start  the element that holds the centre, or -1
    SupermeshCell covers(const ConvexPart& piece, Index start)
    {
        bool found = false;
        if (start >= 0 && piece.area > 0) {
            flood(piece, start);
            found = std::abs(covered_ - piece.area) <= kSumRounding * piece.area;
        }
        if (!found)
            list(piece);
        return {-1, -1, piece, covers_, covered_};
    }

private:
    void reset()
    {
        covers_.clear();
        covered_ = 0;
    }

    void flood(const ConvexPart& piece, Index start)
    {
        reset();
        visited_.clear();
        visited_.insert(start);
        front_.assign(1, start);
        while (!front_.empty()) {
            const Index face = front_.back();
            front_.pop_back();
            std::array<bool, 4> crossed{};
            add(piece, face, crossed);
            cross(face, crossed);
        }
    }

    void list(const ConvexPart& piece)
    {
        reset();
        if (piece.area == 0)
            return;
        source_.tree().overlapping(box_of(piece), candidates_);
        std::array<bool, 4> crossed{};
        for (const Index face : candidates_)
            add(piece, face, crossed);
    }

    /// @param crossed  set for the sides of the element that reach into the piece
    void add(const ConvexPart& piece, Index face, std::array<bool, 4>& crossed)
    {
        for (const ConvexParts pieces = split_convex(mesh_, face, cut_);
             const ConvexPart& part : pieces.all()) {
            const bool part_first = part.area < piece.area;
            const ConvexPolygon& small = part_first ? part.outline : piece.outline;
            const ConvexPolygon common = clip(small, part_first ? piece.outline : part.outline);
            for (int k = 0; k < common.corners; ++k)
                if (const int side = common.side[static_cast<std::size_t>(k)]; side != kNoSide)
                    crossed[static_cast<std::size_t>(side)] = true;
            const double common_area = area(common);
            if (part.area > 0 && common_area > kTouching * std::min(part.area, piece.area)) {
                covers_.push_back({face, part, common, small[0], common_area});
                covered_ += common_area;
            }
        }
    }

    void cross(Index face, const std::array<bool, 4>& crossed)
    {
        HalfedgeHandle side = mesh_.kernel.halfedge_handle(FaceHandle(face)); // into corner 0
        for (const bool open : crossed) {
            side = mesh_.kernel.next_halfedge_handle(side);
            if (!open)
                continue;
            const FaceHandle beyond = mesh_.kernel.opposite_face_handle(side);
            if (beyond.is_valid() && visited_.insert(beyond.idx()))
                front_.push_back(beyond.idx());
        }
    }

    const Locator& source_;
    const Mesh& mesh_;
    Cut cut_;
    std::vector<Overlap> covers_;
    double covered_ = 0;
    VisitedSet visited_;
    std::vector<Index> front_;
    std::vector<Index> candidates_;
};

void require_planar(const Mesh& mesh, const char* which)
{
    if (mesh.dimension != 2)
        throw InputError(std::string("the ") + which +
                         " lies in space, but only planar meshes can be remapped conservatively");
}

/// Of each element its first piece, and the number of pieces in the end.
std::vector<Index> first_pieces(const Mesh& mesh, Cut cut)
{
    const auto faces = static_cast<std::size_t>(element_count(mesh));
    std::vector<Index> first(faces + 1, 0);
    parallel_for(faces, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            first[f + 1] = convex_part_count(mesh, static_cast<Index>(f), cut);
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

} // namespace

Supermesh::Supermesh(const Locator& source, const Mesh& target, Cut cut)
    : source_(source), target_(target), cut_(cut)
{
    require_planar(source.source(), "source");
    require_planar(target, "target");
    if (element_count(source.source()) == 0)
        throw InputError("the source has no element to take values from");
    first_piece_ = first_pieces(target, cut);
    Points centres = Points::Zero(first_piece_.back(), 3);
    parallel_for(first_piece_.size() - 1, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            Index i = first_piece_[f];
            for (const ConvexParts pieces = split_convex(target, static_cast<Index>(f), cut);
                 const ConvexPart& piece : pieces.all())
                centres.row(i++) = centre_of(piece);
        }
    });
    start_ = source.locate(centres).face;
}

void Supermesh::visit(std::size_t begin, std::size_t end,
                      const std::function<void(const SupermeshCell&)>& visitor) const
{
    Search search(source_, cut_);
    for (std::size_t f = begin; f < end; ++f) {
        Index number = first_piece_[f];
        ConvexParts pieces = split_convex(target_, static_cast<Index>(f), cut_);
        for (ConvexPart& piece : pieces.all()) {
            piece.outline.side.fill(kNoSide);
            SupermeshCell covered = search.covers(piece, start_[static_cast<std::size_t>(number)]);
            covered.face = static_cast<Index>(f);
            covered.number = number++;
            visitor(covered);
        }
    }
}

} // namespace morph
