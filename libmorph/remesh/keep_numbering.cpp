#include "libmorph/remesh/keep_numbering.h"

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

} // namespace

std::vector<Index> kept_numbers(const std::vector<Index>& wishes)
{
    const auto count = static_cast<Index>(wishes.size());
    std::vector<bool> taken(wishes.size(), false);
    std::vector<Index> number(wishes.size(), -1);
    for (std::size_t i = 0; i < wishes.size(); ++i)
        if (wishes[i] >= 0 && wishes[i] < count && !taken[at(wishes[i])]) {
            number[i] = wishes[i];
            taken[at(wishes[i])] = true;
        }
    Index next = 0;
    for (Index& n : number)
        if (n < 0) {
            while (taken[at(next)])
                ++next;
            n = next++;
        }
    return number;
}

} // namespace morph
