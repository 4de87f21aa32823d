#include "formats/gmsh/tags.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace morph {

void GmshTags::store(std::int64_t tag)
{
    if (tags_.empty()) {
        tags_.resize(static_cast<std::size_t>(count_));
        std::iota(tags_.begin(), tags_.end(), first_);
    }
    tags_.push_back(tag);
}

std::optional<std::int64_t> GmshTags::sort()
{
    constexpr std::uint64_t most_gaps = 4; // places for each tag, beyond which sorting takes less memory
    if (tags_.empty())
        return std::nullopt;
    const auto [least, most] = std::minmax_element(tags_.begin(), tags_.end());
    first_ = *least;
    const std::uint64_t span = place_of(*most);
    if (span < most_gaps * tags_.size()) {
        std::optional<std::int64_t> twice;
        by_place_.assign(span + 1, -1);
        for (std::size_t i = 0; i < tags_.size(); ++i) {
            Index& place = by_place_[place_of(tags_[i])];
            if (place >= 0)
                twice = tags_[i];
            else
                place = static_cast<Index>(i);
        }
        return twice;
    }
    sorted_.resize(tags_.size());
    std::iota(sorted_.begin(), sorted_.end(), 0);
    const auto tag_of = [&](Index i) { return tags_[static_cast<std::size_t>(i)]; };
    std::sort(sorted_.begin(), sorted_.end(), [&](Index a, Index b) {
        return std::pair{tag_of(a), a} < std::pair{tag_of(b), b};
    });
    const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                          [&](Index a, Index b) { return tag_of(a) == tag_of(b); });
    if (twice == sorted_.end())
        return std::nullopt;
    return tag_of(*twice);
}

Index GmshTags::find_sorted(std::int64_t tag) const
{
    const auto found =
        std::lower_bound(sorted_.begin(), sorted_.end(), tag, [&](Index i, std::int64_t wanted) {
            return tags_[static_cast<std::size_t>(i)] < wanted;
        });
    return found != sorted_.end() && tags_[static_cast<std::size_t>(*found)] == tag ? *found : -1;
}

} // namespace morph
