#include "tools/quality/text_table.h"

#include "libmorph/core/names.h"
#include "tools/common/report.h"

#include <algorithm>
#include <cstdint>

namespace morph::tools {

namespace {

std::string padded_left(const std::string& text, std::size_t width)
{
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string bar_line(const std::string& label, Index count, Index largest)
{
    constexpr std::int64_t kLongest = 40;
    const auto length = static_cast<std::size_t>((kLongest * count + largest - 1) / largest);
    const std::string bar = length > 0 ? "  " + std::string(length, '#') : "";
    return padded_left(label, 14) + padded_left(std::to_string(count), 10) + bar;
}

} // namespace

std::vector<std::string> bar_lines(const std::string& title, Index inverted, const std::vector<Index>& counts,
                                   double end)
{
    const Index largest = std::max({Index{1}, inverted, *std::max_element(counts.begin(), counts.end())});
    const auto bound = [&](std::size_t i) {
        return short_number(end * static_cast<double>(i) / static_cast<double>(counts.size()));
    };
    std::vector<std::string> lines{title};
    if (inverted > 0)
        lines.push_back(bar_line("inverted", inverted, largest));
    for (std::size_t i = 0; i < counts.size(); ++i)
        lines.push_back(bar_line(bound(i) + " to " + padded_left(bound(i + 1), 3), counts[i], largest));
    return lines;
}

std::vector<std::string> table_lines(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> width;
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            width.resize(std::max(width.size(), i + 1));
            width[i] = std::max(width[i], row[i].size());
        }
    std::vector<std::string> lines;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += row[i] + std::string(i + 1 < row.size() ? width[i] - row[i].size() + 2 : 0, ' ');
        lines.push_back(line);
    }
    return lines;
}

} // namespace morph::tools
