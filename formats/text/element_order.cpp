#include "formats/text/element_order.h"

#include <algorithm>
#include <charconv>

namespace morph {

namespace {

constexpr std::string_view kOrder = "# order ";

/// Append @p count elements of some number of corners; false when there are not so many left.
bool append_run(std::vector<int>& order, std::size_t count, int corners, std::size_t& left)
{
    if (count > left)
        return false;
    left -= count;
    order.insert(order.end(), count, corners);
    return true;
}

/// For each element the number of corners, as the comment says; empty when there is none that fits.
std::vector<int> read_element_order(std::string_view text, std::size_t triangles, std::size_t quads)
{
    const std::size_t start = text.find(kOrder);
    if (start == std::string_view::npos)
        return {};
    std::vector<int> order;
    order.reserve(triangles + quads);
    const char* at = text.data() + start + kOrder.size();
    const char* const end = text.data() + text.size();
    while (at != end && *at != '\n' && *at != '\r') {
        std::size_t count = 0;
        const auto [after, error] = std::from_chars(at, end, count);
        if (error != std::errc{} || after == end || (*after != 't' && *after != 'q'))
            return {};
        const bool triangle = *after == 't';
        if (!append_run(order, count, triangle ? 3 : 4, triangle ? triangles : quads))
            return {};
        at = after + 1;
    }
    return triangles == 0 && quads == 0 ? order : std::vector<int>{};
}

} // namespace

std::string element_order_text(const std::vector<Element>& elements)
{
    if (std::is_partitioned(elements.begin(), elements.end(),
                            [](const Element& element) { return corner_count(element) == 3; }))
        return "";
    std::string text(kOrder);
    for (std::size_t begin = 0, end = 0; begin < elements.size(); begin = end) {
        const int corners = corner_count(elements[begin]);
        while (end < elements.size() && corner_count(elements[end]) == corners)
            ++end;
        text += std::to_string(end - begin);
        text += corners == 3 ? 't' : 'q';
    }
    return text + "\n";
}

std::vector<std::int64_t> join_faces(std::array<std::vector<Element>, 2>& faces,
                                     std::array<std::vector<std::int64_t>, 2>& references,
                                     std::string_view text, std::vector<Element>& elements)
{
    std::vector<int> order;
    if (!faces[0].empty() && !faces[1].empty())
        order = read_element_order(text, faces[0].size(), faces[1].size());
    if (order.empty()) {
        elements = std::move(faces[0]);
        elements.insert(elements.end(), faces[1].begin(), faces[1].end());
        std::vector<std::int64_t> joined = std::move(references[0]);
        joined.insert(joined.end(), references[1].begin(), references[1].end());
        return joined;
    }
    std::vector<std::int64_t> joined;
    std::array<std::size_t, 2> next{0, 0};
    for (const int corners : order) {
        const std::size_t kind = corners == 3 ? 0 : 1;
        const std::size_t face = next.at(kind)++;
        elements.push_back(faces.at(kind)[face]);
        joined.push_back(references.at(kind)[face]);
    }
    return joined;
}

} // namespace morph
