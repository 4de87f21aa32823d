#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace morph {

/// Numbers nodes in the order in which their coordinates first appear; -0 is 0.
class ThesisNodes {
public:
    /// The number of the node there, from 0.
    Index number_of(double x, double y)
    {
        const std::array<double, 2> place{x + 0.0, y + 0.0};
        const auto [found, is_new] = numbers_.try_emplace(place, static_cast<Index>(numbers_.size()));
        if (is_new)
            xyz_.insert(xyz_.end(), {place[0], place[1], 0});
        return found->second;
    }
    /// x, y, 0 of each node.
    const std::vector<double>& coordinates() const { return xyz_; }
    Index size() const { return static_cast<Index>(numbers_.size()); }

private:
    struct Hash {
        std::size_t operator()(const std::array<double, 2>& place) const
        {
            return mixed(mixed(std::bit_cast<std::uint64_t>(place[0])) +
                         std::bit_cast<std::uint64_t>(place[1]));
        }
        /// Coordinates differ in their leading bits, buckets in the last: bring the former to the latter.
        static std::uint64_t mixed(std::uint64_t bits)
        {
            bits *= 0x9E3779B97F4A7C15U; // 2^64 over the golden ratio
            return bits ^ (bits >> 32U);
        }
    };

    std::unordered_map<std::array<double, 2>, Index, Hash> numbers_;
    std::vector<double> xyz_;
};

} // namespace morph
