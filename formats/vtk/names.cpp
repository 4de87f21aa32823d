#include "formats/vtk/names.h"

#include <algorithm>

namespace morph {

namespace {

std::string first_name(VtkNamed kind)
{
    return kind == VtkNamed::marker ? "marker" : "group";
}

} // namespace

std::string names_array(const std::string& array)
{
    return array + "_names";
}

std::string numbered_array(const std::string& name, VtkNamed kind)
{
    std::string array = first_name(kind);
    while (name.starts_with(array)) {
        if (name == names_array(array))
            return array;
        array += '_';
    }
    return {};
}

std::string overlap_array(const std::string& group_array, std::size_t number)
{
    return group_array + "_" + std::to_string(number);
}

std::string free_array(const MeshData& mesh, VtkNamed kind)
{
    std::string array = first_name(kind);
    const auto taken = [&](const Field& field) {
        return field.location == FieldLocation::element &&
               (field.name == array || field.name.starts_with(array + "_"));
    };
    while (std::any_of(mesh.fields.begin(), mesh.fields.end(), taken))
        array += '_';
    return array;
}

GroupNumbers group_numbers(const MeshData& mesh)
{
    GroupNumbers numbers{std::vector<std::int32_t>(mesh.elements.size(), 0), {}};
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        bool complete = true;
        for (const Index element : mesh.groups[g].elements) {
            std::int32_t& number = numbers.first[static_cast<std::size_t>(element)];
            complete = complete && number == 0;
            if (number == 0)
                number = static_cast<std::int32_t>(g + 1);
        }
        if (!complete)
            numbers.incomplete.push_back(g + 1);
    }
    return numbers;
}

std::vector<std::uint8_t> membership(const MeshData& mesh, const ElementGroup& group)
{
    std::vector<std::uint8_t> member(mesh.elements.size(), 0);
    for (const Index element : group.elements)
        member[static_cast<std::size_t>(element)] = 1;
    return member;
}

} // namespace morph
