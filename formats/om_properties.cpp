#include "formats/om_properties.h"

#include "formats/message_text.h"
#include "formats/names_in_text.h"
#include "formats/ply_names.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <set>

namespace morph {

namespace {

constexpr std::string_view kGroup = "libmorph group ";
constexpr std::size_t kMostComponents = 9;

NumberArray array_of(NumberType type, std::string_view bytes)
{
    return {type, bytes, std::endian::native != std::endian::little};
}

struct ValueType {
    NumberType number;
    std::size_t components;
};

/// "double", "int32_t", "Vec3f", …; nothing for what is no number.
std::optional<ValueType> value_type(std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, NumberType>, 20> types{
        {{"double", NumberType::float64}, {"float", NumberType::float32},
         {"int8_t", NumberType::int8},    {"uint8_t", NumberType::uint8},
         {"int16_t", NumberType::int16},  {"uint16_t", NumberType::uint16},
         {"int32_t", NumberType::int32},  {"uint32_t", NumberType::uint32},
         {"int64_t", NumberType::int64},  {"uint64_t", NumberType::uint64},
         {"char", NumberType::int8},      {"unsigned char", NumberType::uint8},
         {"d", NumberType::float64},      {"f", NumberType::float32},
         {"c", NumberType::int8},         {"uc", NumberType::uint8},
         {"s", NumberType::int16},        {"us", NumberType::uint16},
         {"i", NumberType::int32},        {"ui", NumberType::uint32}}};
    std::size_t components = 1;
    if (name.starts_with("Vec") && name.size() > 4 && name[3] >= '1' && name[3] <= '6') {
        components = static_cast<std::size_t>(name[3] - '0');
        name.remove_prefix(4);
    } else if (name.size() < 4) {
        return std::nullopt;
    }
    for (const auto& [type_name, type] : types)
        if (type_name == name)
            return ValueType{type, components};
    return std::nullopt;
}

Field field_of(std::string name, FieldLocation location, std::size_t rows, std::size_t columns,
               const NumberArray& numbers)
{
    Matrix values(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    copy_numbers(numbers, values.data());
    return {std::move(name), location, std::move(values)};
}

std::vector<std::string> lines_of(std::string_view text)
{
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

} // namespace

void OmProperties::add_attribute(const OmChunk& chunk, std::size_t count, std::string_view bytes)
{
    constexpr std::array<std::string_view, 5> names{"position", "normal", "texture", "status", "color"};
    const auto type = static_cast<std::size_t>(chunk.type);
    if (type == static_cast<std::size_t>(OmType::status) || count == 0)
        return;
    const bool element = chunk.entity == OmEntity::vertex || chunk.entity == OmEntity::face;
    const bool number = chunk.real ? chunk.bits <= 1 : chunk.bits == 0;
    if (type >= names.size() || type == 0 || !element || !number)
        return file_.warn("a chunk of " + std::string(type < names.size() ? names[type] : "an unknown kind") +
                          " was left out");
    const NumberType numbers = !chunk.real       ? NumberType::uint8
                               : chunk.bits == 0 ? NumberType::float32
                                                 : NumberType::float64;
    attributes_.push_back(
        field_of(std::string(names[type]),
                 chunk.entity == OmEntity::vertex ? FieldLocation::vertex : FieldLocation::element, count,
                 chunk.dimension, array_of(numbers, bytes)));
}

void OmProperties::add_custom(OmEntity entity, std::string_view name, std::string_view type,
                              std::size_t count, std::string_view bytes)
{
    properties_.push_back({entity, name, type, count, bytes});
}

void OmProperties::add_to(MeshData& mesh)
{
    PlyNames names;
    for (const Property& property : properties_)
        if (property.entity == OmEntity::mesh && property.name == kOmNames)
            names = ply_names(lines_of(property.bytes));
    mesh.fields = std::move(attributes_);
    for (const Property& property : properties_)
        if (property.name != kOmNames && property.name != kOmMarkers && !property.name.starts_with(kGroup))
            add_field(property, names, mesh);
    add_groups(names, mesh);
    add_markers(names, mesh);
}

void OmProperties::add_field(const Property& property, const PlyNames& names, MeshData& mesh) const
{
    const bool nodal = property.entity == OmEntity::vertex;
    const auto& fields = nodal ? names.vertex_fields : names.face_fields;
    const auto ours = fields.find(line_name(property.name, " "));
    std::optional<ValueType> type = value_type(property.type);
    std::string name(property.name);
    if (property.type.empty() && ours != fields.end()) {
        type = {NumberType::float64, static_cast<std::size_t>(ours->second.components)};
        name = ours->second.name;
    }
    const bool placed = nodal || property.entity == OmEntity::face;
    if (!placed || !type || type->components > kMostComponents || property.count == 0 ||
        property.bytes.size() != property.count * type->components * size_of(type->number))
        return file_.warn("the property " + quoted_text(property.name) + " was left out");
    mesh.fields.push_back(field_of(std::move(name), nodal ? FieldLocation::vertex : FieldLocation::element,
                                   property.count, type->components, array_of(type->number, property.bytes)));
}

void OmProperties::add_groups(const PlyNames& names, MeshData& mesh) const
{
    std::map<Index, std::size_t> places;
    for (const auto& [number, name] : names.groups) {
        places[number] = mesh.groups.size();
        mesh.groups.push_back({name, {}});
    }
    for (const Property& property : properties_) {
        if (property.entity != OmEntity::face || !property.name.starts_with(kGroup) ||
            property.bytes.size() != property.count * sizeof(Index))
            continue;
        const auto numbers = whole_numbers<Index>(array_of(NumberType::int32, property.bytes));
        for (std::size_t e = 0; e < numbers.size(); ++e)
            if (const auto place = places.find(numbers[e]); place != places.end())
                mesh.groups[place->second].elements.push_back(static_cast<Index>(e));
    }
    for (ElementGroup& group : mesh.groups) {
        std::sort(group.elements.begin(), group.elements.end());
        group.elements.erase(std::unique(group.elements.begin(), group.elements.end()), group.elements.end());
    }
}

void OmProperties::add_markers(const PlyNames& names, MeshData& mesh) const
{
    std::map<Index, std::size_t> places;
    for (const auto& [number, name] : names.markers) {
        places[number] = mesh.markers.size();
        mesh.markers.push_back({name, {}});
    }
    for (const Property& property : properties_) {
        if (property.entity != OmEntity::mesh || property.name != kOmMarkers ||
            property.bytes.size() % (3 * sizeof(Index)) != 0)
            continue;
        const auto numbers = whole_numbers<Index>(array_of(NumberType::int32, property.bytes));
        for (std::size_t i = 0; i < numbers.size(); i += 3) {
            const auto place = places.find(numbers[i + 2]);
            for (const Index v : {numbers[i], numbers[i + 1]})
                if (v < 0 || v >= mesh.points.rows())
                    throw InputError(file_.path + ": edge " + std::to_string(i / 3) +
                                     " of the markers names vertex " + std::to_string(v) +
                                     ", but the mesh has " + std::to_string(mesh.points.rows()));
            if (place != places.end())
                mesh.markers[place->second].edges.push_back({numbers[i], numbers[i + 1]});
        }
    }
}

} // namespace morph
