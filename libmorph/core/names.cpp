#include "libmorph/core/names.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <numeric>

namespace morph {

namespace {

/// Levenshtein distance; letters that differ in case only count as equal.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const bool same = std::tolower(static_cast<unsigned char>(a[i])) ==
                              std::tolower(static_cast<unsigned char>(b[j]));
            const std::size_t changed = diagonal + (same ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

} // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates)
{
    constexpr std::size_t kLongestName = 200; // longer texts are no typing errors
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        if (std::max(name.size(), candidate.size()) > kLongestName)
            continue;
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates)
{
    const std::string nearest = nearest_name(name, candidates);
    return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string number_text(double value)
{
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "%.9g", value);
    return digits.data();
}

std::string short_number(double value)
{
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "%.4g", value);
    return digits.data();
}

std::size_t index_of_name(std::string_view name, const std::vector<std::string>& names)
{
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw InputError("'" + std::string(name) + "' is none of " + joined(names) +
                         did_you_mean(name, names));
    return static_cast<std::size_t>(found - names.begin());
}

} // namespace morph
