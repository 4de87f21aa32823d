#pragma once

#include "libmorph/core/parallel.h"
#include "libmorph/core/types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace morph {

/// A number to sort by, and what it stands for.
template <typename Key>
struct Keyed {
    Key key;
    Index item;
};

/// Sort by key, smallest first; equal keys keep their order. Linear time, on every core.
///
/// @param key_bits  every key is below 2^key_bits
template <typename Key>
void radix_sort(std::vector<Keyed<Key>>& items, int key_bits)
{
    constexpr int kDigitBits = 8;
    constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
    constexpr std::size_t kMaxBlocks = 64;
    constexpr std::size_t kMinGrain = 16384; // below it a thread costs more than it does
    const std::size_t n = items.size();
    const std::size_t grain = std::max(kMinGrain, (n + kMaxBlocks - 1) / kMaxBlocks);

    std::vector<Keyed<Key>> sorted(n);
    std::vector<std::array<std::size_t, kDigits>> places((n + grain - 1) / grain);
    for (int shift = 0; shift < key_bits; shift += kDigitBits) {
        const auto digit = [shift](const Keyed<Key>& k) { return (k.key >> shift) & Key{kDigits - 1}; };
        parallel_for(n, grain, [&](std::size_t begin, std::size_t end) {
            auto& count = places[begin / grain];
            count.fill(0);
            for (std::size_t i = begin; i < end; ++i)
                ++count[digit(items[i])];
        });
        std::size_t place = 0; // counts become first places: by digit, then by block, which keeps the order
        for (std::size_t d = 0; d < kDigits; ++d)
            for (auto& block : places)
                place += std::exchange(block[d], place);
        parallel_for(n, grain, [&](std::size_t begin, std::size_t end) {
            auto& next = places[begin / grain];
            for (std::size_t i = begin; i < end; ++i)
                sorted[next[digit(items[i])]++] = items[i];
        });
        items.swap(sorted);
    }
}

} // namespace morph
