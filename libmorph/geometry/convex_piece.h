#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>

namespace morph {

/// A flat convex polygon in space, of a few corners; a segment is one of two.
class ConvexPiece {
public:
    static constexpr std::size_t kMostCorners = 12;

    std::size_t size() const { return size_; }
    const Eigen::Vector3d& corner(std::size_t i) const { return corners_[i]; }
    /// A corner more; those beyond kMostCorners are not taken.
    void add(const Eigen::Vector3d& corner);
    /// Mean of the corners, a point of the piece.
    Eigen::Vector3d middle() const;

    /// The parts on the side of a plane that @p normal points to and on the other; either may be empty. No
    /// sliver is cut off: corners nearer to the plane than 1e-6 of the farthest are taken as on it.
    std::pair<ConvexPiece, ConvexPiece> cut(const Eigen::Vector3d& origin,
                                            const Eigen::Vector3d& normal) const;

    /// Both halves, cut across the longest line between two corners.
    std::pair<ConvexPiece, ConvexPiece> halves() const;

private:
    std::array<Eigen::Vector3d, kMostCorners> corners_;
    std::size_t size_ = 0;
};

} // namespace morph
