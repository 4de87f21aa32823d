#include "formats/text/id_table.h"

#include <algorithm>
#include <numeric>

namespace morph {

namespace {

constexpr std::int64_t kWidestGap =
    4; // ids for each one that is there, beyond which a table by id is a waste

} // namespace

void IdTable::add(Index id, std::size_t position)
{
    ids_.push_back(id);
    positions_.push_back(position);
}

void IdTable::finish(const TextScanner& in, const std::string& what)
{
    if (ids_.empty())
        return;
    const auto fail_twice = [&](Index first, Index second) {
        const std::size_t earlier = std::min(positions_[static_cast<std::size_t>(first)],
                                             positions_[static_cast<std::size_t>(second)]);
        const std::size_t later = std::max(positions_[static_cast<std::size_t>(first)],
                                           positions_[static_cast<std::size_t>(second)]);
        in.fail_at(later, what + " " + std::to_string(ids_[static_cast<std::size_t>(first)]) +
                              " is there again, after line " + std::to_string(in.line_of(earlier)));
    };
    const auto [least, greatest] = std::minmax_element(ids_.begin(), ids_.end());
    smallest_ = *least;
    const std::int64_t span = std::int64_t{*greatest} - smallest_ + 1;
    if (span <= kWidestGap * static_cast<std::int64_t>(ids_.size())) {
        dense_.assign(static_cast<std::size_t>(span), -1);
        for (Index i = 0; i < count(); ++i) {
            Index& place = dense_[static_cast<std::size_t>(ids_[static_cast<std::size_t>(i)] - smallest_)];
            if (place >= 0)
                fail_twice(place, i);
            place = i;
        }
        return;
    }
    sorted_.resize(ids_.size());
    std::iota(sorted_.begin(), sorted_.end(), 0);
    const auto id = [&](Index i) { return ids_[static_cast<std::size_t>(i)]; };
    std::sort(sorted_.begin(), sorted_.end(),
              [&](Index a, Index b) { return id(a) != id(b) ? id(a) < id(b) : a < b; });
    const auto twice =
        std::adjacent_find(sorted_.begin(), sorted_.end(), [&](Index a, Index b) { return id(a) == id(b); });
    if (twice != sorted_.end())
        fail_twice(*twice, *(twice + 1));
}

} // namespace morph
