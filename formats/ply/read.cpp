#include "formats/ply/files.h"
#include "formats/ply/names.h"
#include "formats/ply/rows.h"
#include "formats/text/message_text.h"
#include "formats/text/number_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace morph {

namespace {

/// Where the numbers of a property go: every stride-th double from `to`; null: nowhere.
struct Target {
    double* to = nullptr;
    std::size_t stride = 1;
    bool coordinate = false; ///< must be finite
};

/// The coordinate that a property of vertices is, or -1.
int axis_of(const PlyProperty& property)
{
    return property.length_type || property.name.size() != 1
               ? -1
               : static_cast<int>(std::string_view("xyz").find(property.name));
}

bool is_corner_list(const PlyProperty& property)
{
    return property.name == "vertex_indices" || property.name == "vertex_index";
}

/// The value as a number from 0 to 2^31 - 1, or -1.
Index whole_number(double value)
{
    return value >= 0 && value <= INT32_MAX && std::floor(value) == value ? static_cast<Index>(value) : -1;
}

class PlyReader {
public:
    explicit PlyReader(const InputBytes& file)
        : file_(file), in_(file.path, file.bytes), rows_(in_), names_(ply_names(rows_.header().comments))
    {
    }

    MeshData read()
    {
        file_.set_version(rows_.header().coding == PlyCoding::ascii           ? "1.0, ASCII"
                          : rows_.header().coding == PlyCoding::little_endian ? "1.0, binary little endian"
                                                                              : "1.0, binary big endian");
        for (const char* name : {"vertex", "face", "edge"})
            require_once(name);
        for (const auto& [number, name] : names_.markers)
            marker_place(number);
        for (const PlyElement& element : rows_.header().elements)
            read_element(element);
        require_corners();
        return std::move(mesh_);
    }

private:
    /// A second table of vertices or faces would restart their numbers.
    void require_once(const std::string& name) const
    {
        const std::vector<PlyElement>& elements = rows_.header().elements;
        if (std::count_if(elements.begin(), elements.end(),
                          [&](const PlyElement& element) { return element.name == name; }) > 1)
            throw InputError(file_.path + ": the header has more than one element '" + name + "'");
    }

    void read_element(const PlyElement& element)
    {
        if (element.name == "vertex")
            read_vertices(element);
        else if (element.name == "face")
            read_faces(element);
        else if (element.name == "edge" && property_number(element, "vertex1") &&
                 property_number(element, "vertex2"))
            read_edges(element);
        else
            skip(element);
    }

    static std::optional<std::size_t> property_number(const PlyElement& element, std::string_view name)
    {
        for (std::size_t p = 0; p < element.properties.size(); ++p)
            if (element.properties[p].name == name && !element.properties[p].length_type)
                return p;
        return std::nullopt;
    }

    void skip(const PlyElement& element)
    {
        if (element.count > 0)
            file_.warn("the element " + quoted_text(element.name) + " was left out");
        if (!element.properties.empty())
            read_rows(element, std::vector<Target>(element.properties.size()),
                      [](const PlyProperty&, std::size_t, const std::vector<double>&) {});
    }

    /// All rows: numbers to the targets of their properties, lists to @p use_list(property, position, list).
    template <class UseList>
    void read_rows(const PlyElement& element, const std::vector<Target>& targets, const UseList& use_list)
    {
        for (std::size_t row = 0; row < element.count; ++row)
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                const Target& target = targets[p];
                const std::size_t position = property.length_type || target.coordinate ? rows_.position() : 0;
                if (property.length_type) {
                    use_list(property, position, rows_.list(property));
                    continue;
                }
                const double value = rows_.number(property.type);
                if (target.coordinate && !std::isfinite(value))
                    rows_.fail(position, "a coordinate of vertex " + std::to_string(row) + " is not finite");
                if (target.to)
                    target.to[row * target.stride] = value;
            }
    }

    /// Numbers of consecutive properties from @p first that are no lists, have no target yet and no name of
    /// their own in the comments, at most @p wanted.
    static std::size_t components(const PlyElement& element, const std::vector<Target>& targets,
                                  const std::map<std::string, PlyNames::FieldName>& names, std::size_t first,
                                  std::size_t wanted)
    {
        std::size_t count = 1;
        while (count < wanted && first + count < targets.size() &&
               !element.properties[first + count].length_type && !targets[first + count].to &&
               names.count(element.properties[first + count].name) == 0)
            ++count;
        return count;
    }

    /// Make fields of the properties of one number that have no target yet.
    void add_fields(const PlyElement& element, FieldLocation location, std::vector<Target>& targets)
    {
        const auto& names = location == FieldLocation::vertex ? names_.vertex_fields : names_.face_fields;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (property.length_type || targets[p].to || element.count == 0)
                continue;
            const auto named = names.find(property.name);
            PlyNames::FieldName field{1, property.name};
            if (named != names.end())
                field = named->second;
            const std::size_t columns =
                components(element, targets, names, p, static_cast<std::size_t>(field.components));
            mesh_.fields.push_back(
                {field.name, location,
                 Matrix(static_cast<Eigen::Index>(element.count), static_cast<Eigen::Index>(columns))});
            for (std::size_t c = 0; c < columns; ++c)
                targets[p + c] = {mesh_.fields.back().values.data() + c, columns, false};
        }
    }

    void warn_of_lists(const PlyElement& element)
    {
        for (const PlyProperty& property : element.properties)
            if (property.length_type && (element.name != "face" || !is_corner_list(property)))
                file_.warn("the list " + quoted_text(property.name) + " of the element '" + element.name +
                           "' was left out");
    }

    void read_vertices(const PlyElement& element)
    {
        warn_of_lists(element);
        std::vector<double> xyz(3 * element.count, 0.0);
        std::vector<Target> targets(element.properties.size());
        std::array<bool, 3> has_axis{};
        for (std::size_t p = 0; p < targets.size(); ++p)
            if (const int axis = axis_of(element.properties[p]); axis >= 0) {
                has_axis[static_cast<std::size_t>(axis)] = true;
                targets[p] = {xyz.empty() ? nullptr : xyz.data() + axis, 3, true};
            }
        if (!has_axis[0] || !has_axis[1])
            rows_.fail(in_.position(), "vertices have no coordinates x and y");
        add_fields(element, FieldLocation::vertex, targets);
        read_rows(element, targets, [](const PlyProperty&, std::size_t, const std::vector<double>&) {});
        set_points(mesh_, xyz);
    }

    void read_faces(const PlyElement& element)
    {
        warn_of_lists(element);
        const auto lists =
            std::count_if(element.properties.begin(), element.properties.end(), is_corner_list);
        if (element.count > 0 && lists != 1)
            rows_.fail(in_.position(), "faces need one list 'vertex_indices'");
        std::vector<Target> targets(element.properties.size());
        std::vector<std::vector<double>> group_columns;
        group_columns.reserve(targets.size());
        for (std::size_t p = 0; p < targets.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (is_corner_list(property) && !property.length_type)
                rows_.fail(in_.position(), "the property '" + property.name + "' of faces is no list");
            if (!names_.groups.empty() && !property.length_type && is_ply_group(property.name))
                targets[p] = {group_columns.emplace_back(element.count, 0.0).data(), 1, false};
        }
        add_fields(element, FieldLocation::element, targets);
        mesh_.elements.reserve(element.count);
        read_rows(element, targets,
                  [&](const PlyProperty& property, std::size_t position, const std::vector<double>& list) {
                      if (is_corner_list(property))
                          add_face(position, list);
                  });
        add_groups(group_columns);
    }

    void add_face(std::size_t position, const std::vector<double>& list)
    {
        const std::string face = "face " + std::to_string(mesh_.elements.size());
        if (list.size() != 3 && list.size() != 4)
            rows_.fail(position, face + " has " + std::to_string(list.size()) +
                                     " corners, but only triangles and quads are supported");
        Element element{-1, -1, -1, -1};
        for (std::size_t i = 0; i < list.size(); ++i) {
            element[i] = whole_number(list[i]);
            if (element[i] < 0)
                rows_.fail(position, face + " has a corner that is no vertex number");
        }
        mesh_.elements.push_back(element);
    }

    /// Groups by their numbers; 0 is none, and a number without a name gives its own.
    void add_groups(const std::vector<std::vector<double>>& columns)
    {
        std::map<double, std::size_t> place;
        for (const auto& [number, name] : names_.groups) {
            place[number] = mesh_.groups.size();
            mesh_.groups.push_back({name, {}});
        }
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            for (const std::vector<double>& column : columns) {
                if (column[e] == 0 || std::isnan(column[e]))
                    continue;
                const auto [entry, is_new] = place.try_emplace(column[e], mesh_.groups.size());
                if (is_new)
                    mesh_.groups.push_back({"group_" + exact_text(column[e]), {}});
                std::vector<Index>& elements = mesh_.groups[entry->second].elements;
                if (elements.empty() || elements.back() != static_cast<Index>(e))
                    elements.push_back(static_cast<Index>(e));
            }
    }

    /// The place of the marker of that number in the mesh, made if it is new.
    std::size_t marker_place(Index number)
    {
        const auto [entry, is_new] = marker_places_.try_emplace(number, mesh_.markers.size());
        if (is_new) {
            const auto name = names_.markers.find(number);
            mesh_.markers.push_back(
                {name == names_.markers.end() ? "marker_" + std::to_string(number) : name->second, {}});
        }
        return entry->second;
    }

    /// Edges without a property `marker` are those of one marker "edges".
    void read_edges(const PlyElement& element)
    {
        std::vector<double> values(3 * (element.count + 1), -1.0); // two vertices and a marker for each row
        std::vector<Target> targets(element.properties.size());
        const auto marker = property_number(element, "marker");
        targets[*property_number(element, "vertex1")] = {values.data(), 3, false};
        targets[*property_number(element, "vertex2")] = {values.data() + 1, 3, false};
        if (marker)
            targets[*marker] = {values.data() + 2, 3, false};
        for (std::size_t p = 0; p < targets.size(); ++p)
            if (!targets[p].to)
                file_.warn("the property " + quoted_text(element.properties[p].name) +
                           " of the element 'edge' was left out");
        read_rows(element, targets, [](const PlyProperty&, std::size_t, const std::vector<double>&) {});
        if (!marker && element.count > 0)
            mesh_.markers.push_back({"edges", {}});
        for (std::size_t e = 0; e < element.count; ++e) {
            const Index number = marker ? whole_number(values[3 * e + 2]) : 0;
            const std::array<Index, 2> edge{whole_number(values[3 * e]), whole_number(values[3 * e + 1])};
            if (edge[0] < 0 || edge[1] < 0 || number < 0)
                throw InputError(file_.path + ": edge " + std::to_string(e) +
                                 " has a vertex or marker that is no number of one");
            mesh_.markers[marker ? marker_place(number) : mesh_.markers.size() - 1].edges.push_back(edge);
        }
    }

    /// Faces and edges may stand before the vertices.
    void require_corners() const
    {
        const auto fail = [&](const std::string& what, Index vertex) {
            throw InputError(file_.path + ": " + what + " names vertex " + std::to_string(vertex) +
                             ", but the mesh has " + std::to_string(mesh_.points.rows()));
        };
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            for (const Index v : mesh_.elements[e])
                if (v >= mesh_.points.rows())
                    fail("face " + std::to_string(e), v);
        for (const Marker& marker : mesh_.markers)
            for (std::size_t e = 0; e < marker.edges.size(); ++e)
                for (const Index v : marker.edges[e])
                    if (v >= mesh_.points.rows())
                        fail("edge " + std::to_string(e) + " of the marker " + quoted_text(marker.name), v);
    }

    const InputBytes& file_;
    TextScanner in_;
    PlyRows rows_;
    PlyNames names_;
    MeshData mesh_;
    std::map<Index, std::size_t> marker_places_; ///< by number
};

} // namespace

MeshData read_ply(const InputBytes& file)
{
    return PlyReader(file).read();
}

} // namespace morph
