#include "formats/tecplot/variables.h"

#include "formats/text/message_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace morph {

namespace {

constexpr std::size_t kMostComponents = 9;

std::size_t find_coordinate(const std::vector<std::string>& variables, int axis)
{
    const auto found = std::find_if(variables.begin(), variables.end(), [&](const std::string& name) {
        return is_tecplot_coordinate(name, axis);
    });
    return static_cast<std::size_t>(found - variables.begin());
}

bool is_volume(const TecplotZone& zone)
{
    return zone.cells == TecplotCells::tetrahedra || zone.cells == TecplotCells::bricks;
}

class FieldMaker {
public:
    FieldMaker(const TecplotFile& file, const std::vector<std::size_t>& zones, const TecplotNodes& nodes,
               const InputBytes& input)
        : file_(file), zones_(zones), nodes_(nodes), input_(input)
    {
    }

    /// The field of @p count variables from @p first on.
    Field make(const std::string& name, std::size_t first, std::size_t count) const
    {
        Field field{name, is_centred(first) ? FieldLocation::element : FieldLocation::vertex, {}};
        field.values.resize(is_centred(first) ? element_count() : nodes_.count(),
                            static_cast<Eigen::Index>(count));
        for (std::size_t c = 0; c < count; ++c)
            if (is_centred(first))
                fill_elements(field.values, first + c, static_cast<Eigen::Index>(c));
            else
                fill_vertices(field.values, first + c, static_cast<Eigen::Index>(c));
        return field;
    }

    bool is_centred(std::size_t variable) const
    {
        const bool centred = file_.zones[zones_.front()].variables[variable].centred;
        for (const std::size_t z : zones_)
            if (file_.zones[z].variables[variable].centred != centred)
                throw InputError(input_.path + ": " + quoted_text(file_.variables[variable]) + " is at " +
                                 (centred ? "cells in zone " : "nodes in zone ") +
                                 std::to_string(zones_.front() + 1) + ", but not in zone " +
                                 std::to_string(z + 1));
        return centred;
    }

private:
    Eigen::Index element_count() const
    {
        Eigen::Index count = 0;
        for (const std::size_t z : zones_)
            count += is_volume(file_.zones[z]) ? 0 : file_.zones[z].elements;
        return count;
    }

    void fill_elements(Matrix& values, std::size_t variable, Eigen::Index column) const
    {
        Eigen::Index row = 0;
        for (const std::size_t z : zones_)
            if (!is_volume(file_.zones[z]))
                for (const double value : *file_.zones[z].variables[variable].values)
                    values(row++, column) = value;
    }

    /// Backwards, so that the first zone of a vertex has the last word.
    void fill_vertices(Matrix& values, std::size_t variable, Eigen::Index column) const
    {
        std::set<std::pair<const void*, const void*>> done; // zones that share vertices and values
        for (auto z = zones_.rbegin(); z != zones_.rend(); ++z) {
            const std::vector<double>& from = *file_.zones[*z].variables[variable].values;
            const TecplotNumbering& numbering = nodes_.numbering(*z);
            if (z + 1 != zones_.rend() && !done.emplace(&from, &numbering).second)
                continue;
            for (std::size_t node = 0; node < from.size(); ++node)
                values(numbering.vertex(static_cast<Index>(node)), column) = from[node];
        }
    }

    const TecplotFile& file_;
    const std::vector<std::size_t>& zones_;
    const TecplotNodes& nodes_;
    const InputBytes& input_;
};

} // namespace

bool is_tecplot_coordinate(const std::string& name, int axis)
{
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::string letter(1, "xyz"[axis]);
    const bool spelt_out = lower.find("coord") != std::string::npos &&
                           (lower.starts_with(letter + "_") || lower.starts_with(letter + "-"));
    return lower == letter || lower == "coordinate" + letter || spelt_out ||
           lower.starts_with(letter + " ") || lower.starts_with(letter + "[") ||
           lower.starts_with(letter + "(");
}

TecplotCoordinates tecplot_coordinates(const std::vector<std::string>& variables)
{
    TecplotCoordinates xyz{};
    for (int axis = 0; axis < 3; ++axis)
        xyz[static_cast<std::size_t>(axis)] = find_coordinate(variables, axis);
    if (xyz[0] == variables.size() || xyz[1] == variables.size())
        return {0, 1, variables.size()};
    return xyz;
}

std::vector<Field> tecplot_fields(const TecplotFile& file, const std::vector<std::size_t>& zones,
                                  const TecplotNodes& nodes, const TecplotCoordinates& xyz,
                                  const InputBytes& input)
{
    const FieldMaker maker(file, zones, nodes, input);
    const std::vector<std::string>& names = file.variables;
    const auto is_coordinate = [&](std::size_t v) {
        return std::find(xyz.begin(), xyz.end(), v) != xyz.end();
    };
    const auto component_count = [&](std::size_t first) {
        const std::string base = names[first].substr(0, names[first].size() - 2);
        std::size_t count = 0;
        while (first + count < names.size() && !is_coordinate(first + count) &&
               names[first + count] == base + "_" + std::to_string(count) &&
               maker.is_centred(first + count) == maker.is_centred(first))
            ++count;
        return count >= 2 && count <= kMostComponents ? count : 1;
    };
    std::vector<Field> fields;
    for (std::size_t v = 0; v < names.size();) {
        const bool vector = !is_coordinate(v) && names[v].size() > 2 && names[v].ends_with("_0");
        const std::size_t count = vector ? component_count(v) : 1;
        if (!is_coordinate(v))
            fields.push_back(
                maker.make(count > 1 ? names[v].substr(0, names[v].size() - 2) : names[v], v, count));
        v += count;
    }
    return fields;
}

} // namespace morph
