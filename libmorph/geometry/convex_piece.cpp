#include "libmorph/geometry/convex_piece.h"

#include <algorithm>
#include <cmath>

namespace morph {

void ConvexPiece::add(const Eigen::Vector3d& corner)
{
    if (size_ < kMostCorners && (size_ == 0 || corner != corners_[size_ - 1]))
        corners_[size_++] = corner;
}

Eigen::Vector3d ConvexPiece::middle() const
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < size_; ++i)
        sum += corners_[i];
    return sum / static_cast<double>(size_);
}

std::pair<ConvexPiece, ConvexPiece> ConvexPiece::cut(const Eigen::Vector3d& origin,
                                                     const Eigen::Vector3d& normal) const
{
    constexpr double kOnPlane = 1e-6; // of the piece's height
    std::array<double, kMostCorners> height{};
    double highest = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        height[i] = normal.dot(corners_[i] - origin);
        highest = std::max(highest, std::abs(height[i]));
    }
    bool above = false, below = false;
    for (std::size_t i = 0; i < size_; ++i) {
        height[i] = std::abs(height[i]) <= kOnPlane * highest ? 0 : height[i];
        above = above || height[i] > 0;
        below = below || height[i] < 0;
    }
    if (!above || !below)
        return below ? std::pair{ConvexPiece(), *this} : std::pair{*this, ConvexPiece()};
    std::pair<ConvexPiece, ConvexPiece> parts;
    for (std::size_t i = 0; i < size_; ++i) {
        const std::size_t next = (i + 1) % size_;
        if (height[i] >= 0)
            parts.first.add(corners_[i]);
        if (height[i] <= 0)
            parts.second.add(corners_[i]);
        if (height[i] * height[next] >= 0)
            continue;
        const double t = height[i] / (height[i] - height[next]);
        const Eigen::Vector3d crossing = (1 - t) * corners_[i] + t * corners_[next];
        parts.first.add(crossing);
        parts.second.add(crossing);
    }
    return parts;
}

std::pair<ConvexPiece, ConvexPiece> ConvexPiece::halves() const
{
    std::size_t from = 0, to = 0;
    double longest = 0;
    for (std::size_t i = 0; i < size_; ++i)
        for (std::size_t j = i + 1; j < size_; ++j)
            if (const double length = (corners_[i] - corners_[j]).squaredNorm(); length > longest) {
                longest = length;
                from = i;
                to = j;
            }
    return cut((corners_[from] + corners_[to]) / 2, corners_[to] - corners_[from]);
}

} // namespace morph
