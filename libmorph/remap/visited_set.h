#pragma once

#include "libmorph/core/types.h"

#include <cstddef>
#include <vector>

namespace morph {

/// A set of indices that is emptied often: a table with open addressing whose entries are out of date once
/// the round moves on. Memory for about 4 times the largest set; indices close together do not collide.
class VisitedSet {
public:
    void clear()
    {
        ++round_;
        size_ = 0;
    }

    /// Whether @p i was not in the set before.
    bool insert(Index i)
    {
        if (2 * (size_ + 1) > slots_.size())
            grow();
        Slot& slot = slot_of(i);
        if (slot.round == round_)
            return false;
        slot = {round_, i};
        ++size_;
        return true;
    }

private:
    struct Slot {
        std::size_t round = 0;
        Index index = -1;
    };

    Slot& slot_of(Index i)
    {
        std::size_t k = static_cast<std::size_t>(i) & (slots_.size() - 1);
        while (slots_[k].round == round_ && slots_[k].index != i)
            k = (k + 1) & (slots_.size() - 1);
        return slots_[k];
    }

    void grow()
    {
        const std::vector<Slot> old = std::move(slots_);
        slots_.assign(2 * old.size(), {});
        for (const Slot& slot : old)
            if (slot.round == round_)
                slot_of(slot.index) = slot;
    }

    std::vector<Slot> slots_ = std::vector<Slot>(64); // a power of two
    std::size_t size_ = 0;
    std::size_t round_ = 1;
};

} // namespace morph
