#include "formats/vtk/cells.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace morph {

namespace {

/// Find the cell array of one component and take it out of the fields.
bool take_field(std::vector<Field>& fields, const std::string& name, Field& taken)
{
    const Field* found = find_field(fields, name, FieldLocation::element);
    if (!found || found->values.cols() != 1)
        return false;
    const auto at = fields.begin() + (found - fields.data());
    taken = std::move(*at);
    fields.erase(at);
    return true;
}

bool is_number_to(double number, std::size_t most)
{
    return number >= 0 && number <= static_cast<double>(most) && std::floor(number) == number;
}

void append_edges(const VtkGrid& grid, std::size_t cell, Marker& marker)
{
    for (std::int64_t i = grid.begin_of(cell); i + 1 < grid.ends[cell]; ++i)
        marker.edges.push_back({grid.corner(i), grid.corner(i + 1)});
}

std::vector<Marker> named_markers(VtkGrid& grid, const std::vector<std::size_t>& lines,
                                  const std::string& path)
{
    std::vector<Marker> markers;
    for (const std::string& name : grid.markers.names)
        markers.push_back({name, {}});
    Field numbers;
    if (!take_field(grid.fields, grid.markers.array, numbers) && !lines.empty())
        throw InputError(path + ": markers are named, but there is no cell array '" + grid.markers.array +
                         "' that numbers them");
    for (const std::size_t cell : lines) {
        const double number = numbers.values(static_cast<Index>(cell), 0);
        if (!is_number_to(number, markers.size()) || number == 0)
            throw InputError(path + ": line cell " + std::to_string(cell) + " is of marker number " +
                             std::to_string(number) + ", but " + std::to_string(markers.size()) +
                             " are named");
        append_edges(grid, cell, markers[static_cast<std::size_t>(number) - 1]);
    }
    return markers;
}

/// The cell array with one whole number for every line, by the names that generators and converters use, or
/// null.
const Field* grouping_field(const VtkGrid& grid, const std::vector<std::size_t>& lines)
{
    constexpr std::array<const char*, 8> names{"marker",     "CellEntityIds",   "gmsh:physical",
                                               "cell_tags",  "medit:ref",       "PhysicalIds",
                                               "ElementTag", "gmsh:geometrical"};
    const auto whole = [](double number) { return std::abs(number) < 1e15 && std::floor(number) == number; };
    for (const char* name : names) {
        const Field* field = find_field(grid.fields, name, FieldLocation::element);
        if (field && field->values.cols() == 1 &&
            std::all_of(lines.begin(), lines.end(),
                        [&](std::size_t cell) { return whole(field->values(static_cast<Index>(cell), 0)); }))
            return field;
    }
    return nullptr;
}

/// The elements whose cell has the number in the array.
std::vector<Index> elements_of(const Field& numbers, double number, const std::vector<Index>& element_cells)
{
    std::vector<Index> elements;
    for (std::size_t e = 0; e < element_cells.size(); ++e)
        if (numbers.values(element_cells[e], 0) == number)
            elements.push_back(static_cast<Index>(e));
    return elements;
}

} // namespace

void use_names(VtkGrid& grid, const std::string& array, std::vector<std::string> names)
{
    if (const std::string numbered = numbered_array(array, VtkNamed::marker); !numbered.empty())
        grid.markers = {numbered, std::move(names)};
    else if (const std::string groups = numbered_array(array, VtkNamed::group); !groups.empty())
        grid.groups = {groups, std::move(names)};
}

std::vector<Marker> take_markers(VtkGrid& grid, const std::vector<std::size_t>& lines,
                                 const std::string& path)
{
    if (!grid.markers.array.empty())
        return named_markers(grid, lines, path);
    std::vector<Marker> markers;
    if (lines.empty())
        return markers;
    const Field* numbers = grouping_field(grid, lines);
    std::map<double, std::size_t> marker_of;
    for (const std::size_t cell : lines) {
        const double number = numbers ? numbers->values(static_cast<Index>(cell), 0) : 0;
        const auto [entry, is_new] = marker_of.try_emplace(number, markers.size());
        if (is_new)
            markers.push_back(
                {numbers ? std::to_string(static_cast<std::int64_t>(number)) : std::string("lines"), {}});
        append_edges(grid, cell, markers[entry->second]);
    }
    return markers;
}

std::vector<ElementGroup> take_groups(VtkGrid& grid, const std::vector<Index>& element_cells,
                                      const std::string& path)
{
    std::vector<ElementGroup> groups;
    for (const std::string& name : grid.groups.names)
        groups.push_back({name, {}});
    if (groups.empty())
        return groups;
    Field numbers;
    if (!take_field(grid.fields, grid.groups.array, numbers))
        throw InputError(path + ": groups are named, but there is no cell array '" + grid.groups.array +
                         "' that numbers them");
    for (std::size_t e = 0; e < element_cells.size(); ++e) {
        const double number = numbers.values(element_cells[e], 0);
        if (!is_number_to(number, groups.size()))
            throw InputError(path + ": cell " + std::to_string(element_cells[e]) + " is of group number " +
                             std::to_string(number) + ", but " + std::to_string(groups.size()) +
                             " are named");
        if (number > 0)
            groups[static_cast<std::size_t>(number) - 1].elements.push_back(static_cast<Index>(e));
    }
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (take_field(grid.fields, overlap_array(grid.groups.array, g + 1), numbers))
            groups[g].elements = elements_of(numbers, 1, element_cells);
    return groups;
}

} // namespace morph
