#include "formats/mesh/merge_parts.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace morph {

namespace {

/// The marker or group of that name, made if there is none.
template <class Named>
Named& called(std::vector<Named>& list, const std::string& name)
{
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Named& entry) { return entry.name == name; });
    return found != list.end() ? *found : list.emplace_back(Named{name, {}});
}

class PartMerger {
public:
    PartMerger(std::vector<MeshPart>& parts, const InputBytes& file) : parts_(parts), file_(file) {}

    MeshData mesh()
    {
        reserve();
        add_fields();
        for (MeshPart& part : parts_) {
            add(part);
            part.mesh = {}; // its memory is needed no longer
        }
        for (ElementGroup& group : part_groups_) {
            std::vector<Index>& elements = called(mesh_.groups, group.name).elements;
            elements.insert(elements.end(), group.elements.begin(), group.elements.end());
            std::sort(elements.begin(), elements.end());
            elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
        }
        return std::move(mesh_);
    }

private:
    void reserve()
    {
        std::size_t vertices = 0;
        std::size_t elements = 0;
        for (const MeshPart& part : parts_) {
            vertices += static_cast<std::size_t>(part.mesh.points.rows());
            elements += part.mesh.elements.size();
        }
        if (std::max(vertices, elements) > std::numeric_limits<Index>::max())
            throw InputError(file_.path + ": has " + std::to_string(vertices) + " vertices and " +
                             std::to_string(elements) + " elements in all, more than " +
                             std::to_string(std::numeric_limits<Index>::max()));
        mesh_.points.resize(static_cast<Index>(vertices), 3);
        mesh_.elements.reserve(elements);
    }

    static const Field* same_field(const MeshData& mesh, const Field& field)
    {
        const Field* found = find_field(mesh.fields, field.name, field.location);
        return found && found->values.cols() == field.values.cols() ? found : nullptr;
    }

    void add_fields()
    {
        std::vector<std::string> left_out;
        for (const MeshPart& part : parts_)
            for (const Field& field : part.mesh.fields) {
                if (find_field(mesh_.fields, field.name, field.location) ||
                    std::find(left_out.begin(), left_out.end(), field.name) != left_out.end())
                    continue;
                if (std::all_of(parts_.begin(), parts_.end(),
                                [&](const MeshPart& other) { return same_field(other.mesh, field); }))
                    mesh_.fields.push_back(joined_field(field));
                else
                    left_out.push_back(field.name);
            }
        if (!left_out.empty())
            file_.warn("field(s) " + joined(left_out) + " that not all parts have were left out");
    }

    Field joined_field(const Field& first) const
    {
        Field field{first.name, first.location, {}};
        const auto rows = std::accumulate(parts_.begin(), parts_.end(), Eigen::Index{0},
                                          [&](Eigen::Index sum, const MeshPart& part) {
                                              return sum + same_field(part.mesh, first)->values.rows();
                                          });
        field.values.resize(rows, first.values.cols());
        Eigen::Index row = 0;
        for (const MeshPart& part : parts_) {
            const Matrix& values = same_field(part.mesh, first)->values;
            field.values.middleRows(row, values.rows()) = values;
            row += values.rows();
        }
        return field;
    }

    void add(const MeshPart& part)
    {
        const MeshData& from = part.mesh;
        const auto first_element = static_cast<Index>(mesh_.elements.size());
        for (Element element : from.elements) {
            for (Index& v : element)
                v += v < 0 ? 0 : first_vertex_;
            mesh_.elements.push_back(element);
        }
        for (const Marker& marker : from.markers)
            for (auto& edges = called(mesh_.markers, marker.name).edges; const auto& [a, b] : marker.edges)
                edges.push_back({a + first_vertex_, b + first_vertex_});
        for (const ElementGroup& group : from.groups)
            for (auto& elements = called(mesh_.groups, group.name).elements; const Index e : group.elements)
                elements.push_back(e + first_element);
        std::vector<Index> all(from.elements.size());
        std::iota(all.begin(), all.end(), first_element);
        part_groups_.push_back({part.name, std::move(all)});
        mesh_.points.middleRows(first_vertex_, from.points.rows()) = from.points;
        first_vertex_ += static_cast<Index>(from.points.rows());
        mesh_.dimension = std::max(mesh_.dimension, from.dimension);
        mesh_.sections.insert(mesh_.sections.end(), from.sections.begin(), from.sections.end());
    }

    std::vector<MeshPart>& parts_;
    const InputBytes& file_;
    MeshData mesh_;
    std::vector<ElementGroup> part_groups_;
    Index first_vertex_ = 0;
};

} // namespace

std::size_t picked_part(const std::vector<std::string>& names, const std::string& what,
                        const InputBytes& file)
{
    const std::string& zone = file.options.zone;
    if (zone.empty())
        return names.size();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (std::to_string(i + 1) == zone)
            return i;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == zone)
            return i;
    throw InputError(file.path + ": there is no " + what + " '" + zone + "'; there are " + joined(names));
}

MeshData merge_parts(std::vector<MeshPart> parts, const InputBytes& file)
{
    return PartMerger(parts, file).mesh();
}

} // namespace morph
