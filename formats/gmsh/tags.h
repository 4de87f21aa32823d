#pragma once

#include "libmorph/core/types.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace morph {

/// The tags by which a Gmsh file names its vertices or elements, any whole numbers in any order.
/// Nearly every file counts without gaps, and then nothing is stored.
class GmshTags {
public:
    /// The tag of the next vertex or element.
    void add(std::int64_t tag)
    {
        if (!tags_.empty() || (count_ > 0 && place_of(tag) != static_cast<std::uint64_t>(count_)))
            store(tag);
        else if (count_ == 0)
            first_ = tag;
        ++count_;
    }

    /// To be called between the last add() and the first find().
    /// @return a tag that was added more than once, if there is one
    std::optional<std::int64_t> sort();

    /// The number, in the order of add(), of the first that has this tag; -1: none has.
    Index find(std::int64_t tag) const
    {
        const std::uint64_t place = place_of(tag);
        if (tags_.empty())
            return place < static_cast<std::uint64_t>(count_) ? static_cast<Index>(place) : -1;
        if (!by_place_.empty())
            return place < by_place_.size() ? by_place_[place] : -1;
        return find_sorted(tag);
    }

private:
    std::uint64_t place_of(std::int64_t tag) const
    {
        return static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(first_);
    }
    void store(std::int64_t tag);
    Index find_sorted(std::int64_t tag) const;

    std::int64_t first_ = 0; ///< of tags without gaps; else the smallest
    std::int64_t count_ = 0;
    std::vector<std::int64_t> tags_; ///< empty as long as there are no gaps
    std::vector<Index> by_place_;    ///< of tag first_, first_ + 1, …; empty when gaps are too large
    std::vector<Index> sorted_;      ///< numbers in the order of their tags, if by_place_ is empty
};

} // namespace morph
