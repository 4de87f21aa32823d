#include "formats/element_order.h"

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

} // namespace morph
