#include "formats/stl/point_welder.h"

#include <algorithm>
#include <bit>

namespace morph {

namespace {

constexpr std::size_t kFewestSlots = 64;
constexpr std::size_t kBatch = 48; ///< points whose slots are on their way from memory at the same time

/// Multiplications mix towards the high bits, so those are taken.
std::uint32_t hash_of(const PointWelder::Corner& corner)
{
    std::uint64_t hash = 0;
    for (const double x : corner) { // 0 and -0 are equal and have to hash alike
        hash = (hash ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29;
    }
    return static_cast<std::uint32_t>((hash * 0xbf58476d1ce4e5b9U) >> 32);
}

} // namespace

PointWelder::PointWelder(std::size_t vertices) : slots_(std::bit_ceil(std::max(kFewestSlots, 2 * vertices)))
{
    xyz_.reserve(3 * vertices);
}

void PointWelder::weld(const Corner* corners, std::size_t count, Index* numbers)
{
    std::array<std::uint32_t, kBatch> hashes{};
    for (std::size_t begin = 0; begin < count; begin += kBatch) {
        const std::size_t size = std::min(kBatch, count - begin);
        for (std::size_t i = 0; i < size; ++i) {
            hashes[i] = hash_of(corners[begin + i]);
            __builtin_prefetch(&slots_[hashes[i] & (slots_.size() - 1)], 1);
        }
        for (std::size_t i = 0; i < size; ++i)
            numbers[begin + i] = number_of(corners[begin + i], hashes[i]);
    }
}

Index PointWelder::number_of(const Corner& corner, std::uint32_t hash)
{
    for (std::size_t at = hash;; ++at) {
        Slot& slot = slots_[at & (slots_.size() - 1)];
        if (slot.vertex < 0) {
            slot = {hash, static_cast<Index>(xyz_.size() / 3)};
            xyz_.insert(xyz_.end(), corner.begin(), corner.end());
            if (2 * xyz_.size() > 3 * slots_.size())
                double_slots();
            return static_cast<Index>(xyz_.size() / 3 - 1);
        }
        if (slot.hash == hash &&
            std::equal(corner.begin(), corner.end(), &xyz_[3 * static_cast<std::size_t>(slot.vertex)]))
            return slot.vertex;
    }
}

void PointWelder::double_slots()
{
    std::vector<Slot> larger(2 * slots_.size());
    for (const Slot& slot : slots_) {
        if (slot.vertex < 0)
            continue;
        std::size_t at = slot.hash & (larger.size() - 1);
        while (larger[at].vertex >= 0)
            at = (at + 1) & (larger.size() - 1);
        larger[at] = slot;
    }
    slots_ = std::move(larger);
}

} // namespace morph
