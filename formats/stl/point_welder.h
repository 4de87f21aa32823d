#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace morph {

/// Gives equal points one number, in the order of their first appearance: for files that repeat the
/// coordinates of a vertex in each triangle that has it. 0 and -0 are equal.
class PointWelder {
public:
    using Corner = std::array<double, 3>;

    /// @param vertices  how many distinct points are likely; a wrong guess costs time alone
    explicit PointWelder(std::size_t vertices = 0);

    /// The numbers of @p count points, written to @p numbers.
    void weld(const Corner* corners, std::size_t count, Index* numbers);

    /// x, y, z of each distinct point, as it was at its first appearance. The welder is then empty.
    std::vector<double> take_points() { return std::move(xyz_); }

private:
    /// An entry of a table with open addressing; the hash spares most comparisons of points.
    struct Slot {
        std::uint32_t hash = 0;
        Index vertex = -1;
    };
    Index number_of(const Corner& corner, std::uint32_t hash);
    void double_slots();

    std::vector<Slot> slots_; ///< a power of two, at most half of them taken
    std::vector<double> xyz_;
};

} // namespace morph
