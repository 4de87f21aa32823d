#include "formats/su2/vertex_ids.h"

#include "formats/su2/sections.h"

#include <algorithm>
#include <numeric>

namespace morph {

void Su2VertexIds::read_columns(TextScanner& in, Index vertex)
{
    std::int64_t id = vertex;
    for (bool first = true; !in.at_line_end(); first = false) {
        const bool integer = in.try_integer(id);
        double not_an_id = 0;
        if (!integer && !in.try_real(not_an_id))
            in.fail_expected("the id of vertex " + std::to_string(vertex));
        if (!integer)
            id = vertex;
        if (first && !(integer && id == vertex))
            first_column_counts_ = false;
    }
    store(vertex, id);
}

void Su2VertexIds::store(Index vertex, std::int64_t id)
{
    if (id == vertex && ids_.empty())
        return;
    if (ids_.empty()) {
        ids_.resize(static_cast<std::size_t>(vertex));
        std::iota(ids_.begin(), ids_.end(), 0);
    }
    ids_.push_back(id);
}

namespace {

[[noreturn]] void fail_at_vertex(TextScanner& in, std::size_t section, std::size_t vertex,
                                 const std::string& message)
{
    seek_su2_line(in, section, vertex);
    in.fail("vertex " + std::to_string(vertex) + " " + message);
}

} // namespace

std::vector<Index> Su2VertexIds::permutation(TextScanner& in, std::size_t section, Index count) const
{
    const bool only_zeros = std::all_of(ids_.begin(), ids_.end(), [](std::int64_t id) { return id == 0; });
    if (first_column_counts_ || only_zeros) // zeros: a column of z
        return {};
    std::vector<Index> owner(ids_.size(), -1);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        const std::int64_t id = ids_[i];
        if (id < 0 || id >= count)
            fail_at_vertex(in, section, i,
                           "has the id " + std::to_string(id) + ", expected one from 0 to " +
                               std::to_string(count - 1));
        Index& first = owner[static_cast<std::size_t>(id)];
        if (first >= 0)
            fail_at_vertex(in, section, i,
                           "has the id " + std::to_string(id) + ", which vertex " + std::to_string(first) +
                               " has already");
        first = static_cast<Index>(i);
    }
    return {ids_.begin(), ids_.end()};
}

} // namespace morph
