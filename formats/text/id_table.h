#pragma once

#include "formats/text/text_scanner.h"
#include "libmorph/core/types.h"

#include <string>
#include <vector>

namespace morph {

/// Finds the vertices (or elements) of a file that gives them ids of its own, with gaps and in any order.
class IdTable {
public:
    /// The next one has this id, from 0; @p position in the file is for messages.
    void add(Index id, std::size_t position);

    /// Call once all are added.
    /// @param what  for the message: "GRID"
    /// @throws InputError  "path:line: GRID 7 is there again, after line 3"
    void finish(const TextScanner& in, const std::string& what);

    /// Forget what only messages need.
    void drop_positions() { positions_ = {}; }

    /// Which one has this id, from 0 in the order of add(); -1: none.
    Index find(Index id) const;

    Index id(Index number) const { return ids_[static_cast<std::size_t>(number)]; }
    std::size_t position(Index number) const { return positions_[static_cast<std::size_t>(number)]; }
    Index count() const { return static_cast<Index>(ids_.size()); }

private:
    std::vector<Index> ids_;
    std::vector<std::size_t> positions_;
    std::vector<Index> dense_;  ///< by id - smallest_, -1 where there is none; empty where gaps are wide
    std::vector<Index> sorted_; ///< by id, where dense_ is empty
    Index smallest_ = 0;
};

inline Index IdTable::find(Index id) const
{
    const std::int64_t place = std::int64_t{id} - smallest_;
    if (!dense_.empty())
        return place >= 0 && place < static_cast<std::int64_t>(dense_.size())
                   ? dense_[static_cast<std::size_t>(place)]
                   : -1;
    std::size_t low = 0;
    std::size_t high = sorted_.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        const Index found = ids_[static_cast<std::size_t>(sorted_[middle])];
        if (found == id)
            return sorted_[middle];
        (found < id ? low : high) = found < id ? middle + 1 : middle;
    }
    return -1;
}

} // namespace morph
