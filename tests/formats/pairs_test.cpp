// Every ordered pair of formats: what the second can hold of what the first held is equal after the trip.
#include "formats/field_file.h"
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/triangulate.h"

#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace morph;
using testing::HasSubstr;

/// Fields of values that single precision holds, a group over half of the elements and one of the rest.
void add_all_parts(MeshData& mesh)
{
    const auto vertices = static_cast<Index>(mesh.points.rows());
    const auto elements = static_cast<Index>(mesh.elements.size());
    Field p{"pressure", FieldLocation::vertex, Matrix(vertices, 1)};
    Field v{"velocity", FieldLocation::vertex, Matrix(vertices, 3)};
    Field c{"quality", FieldLocation::element, Matrix(elements, 1)};
    for (Index i = 0; i < vertices; ++i) {
        p.values(i, 0) = 0.5 * i - 3;
        v.values.row(i) << i, -0.25 * i, 1;
    }
    ElementGroup first{"front", {}};
    ElementGroup second{"back", {}};
    for (Index e = 0; e < elements; ++e) {
        c.values(e, 0) = 1.0 / (1 << (e % 8));
        (e < elements / 2 ? first : second).elements.push_back(e);
    }
    mesh.groups = {first, second};
    mesh.fields = {p, v, c};
}

MeshData hybrid()
{
    MeshData mesh = test::quad_square(3);
    const Element cut = mesh.elements[4];
    mesh.elements[4] = {cut[0], cut[1], cut[2], -1};
    mesh.elements.push_back({cut[0], cut[2], cut[3], -1});
    return mesh;
}

MeshData surface()
{
    MeshData mesh = test::uneven_square(3);
    mesh.dimension = 3;
    mesh.markers.pop_back(); // a part of the border without a name
    for (Index v = 0; v < mesh.points.rows(); ++v)
        mesh.points(v, 2) = 1 + mesh.points(v, 0) * mesh.points(v, 1);
    return mesh;
}

/// Coordinates that single precision holds, for the formats that have no more (binary STL).
MeshData rounded(MeshData mesh)
{
    for (double& x : mesh.points.reshaped())
        x = static_cast<double>(static_cast<float>(x));
    add_all_parts(mesh);
    return mesh;
}

std::vector<std::pair<std::string, MeshData>> meshes()
{
    return {{"triangles", rounded(test::uneven_square(3))},
            {"quads", rounded(test::quad_square(3))},
            {"hybrid", rounded(hybrid())},
            {"surface", rounded(surface())}};
}

/// Formats that hold meshes and are written.
std::vector<const Format*> mesh_formats()
{
    std::vector<const Format*> formats = all_formats();
    std::erase_if(formats, [](const Format* format) { return !format->holds.elements || !format->write; });
    return formats;
}

void drop_fields(MeshData& mesh, FieldLocation location)
{
    std::erase_if(mesh.fields, [&](const Field& field) { return field.location == location; });
}

/// What @p format holds of a mesh, by what it says of itself.
MeshData held(MeshData mesh, const Format& format)
{
    if (!format.holds.quads)
        mesh = triangulated(std::move(mesh));
    if (!format.holds.markers)
        mesh.markers.clear();
    if (!format.holds.groups)
        mesh.groups.clear();
    if (!format.holds.vertex_fields)
        drop_fields(mesh, FieldLocation::vertex);
    if (!format.holds.element_fields)
        drop_fields(mesh, FieldLocation::element);
    return mesh;
}

using Corner = std::array<double, 3>;

Corner corner(const MeshData& mesh, Index v)
{
    return {mesh.points(v, 0), mesh.points(v, 1), mesh.points(v, 2)};
}

/// Corners of an element from the smallest on, which does not depend on numbering or on where a format
/// begins.
std::vector<Corner> shape(const MeshData& mesh, const Element& element)
{
    std::vector<Corner> corners;
    for (int k = 0; k < corner_count(element); ++k)
        corners.push_back(corner(mesh, element[static_cast<std::size_t>(k)]));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

using Row = std::vector<double>;

Row row(const Matrix& values, Index i)
{
    Row numbers;
    for (Index c = 0; c < values.cols(); ++c)
        numbers.push_back(values(i, c));
    return numbers;
}

/// A mesh as sorted facts that no numbering of vertices and elements changes.
struct Facts {
    std::vector<std::vector<Corner>> elements;
    std::vector<std::pair<std::string, std::vector<std::vector<Corner>>>> markers, groups;
    std::vector<std::pair<std::string, std::vector<std::pair<std::vector<Corner>, Row>>>> fields;
    bool operator==(const Facts&) const = default;
};

template <typename Parts>
void sort_all(Parts& parts)
{
    for (auto& [name, members] : parts)
        std::sort(members.begin(), members.end());
    std::sort(parts.begin(), parts.end());
}

Facts facts(const MeshData& mesh)
{
    Facts facts;
    for (const Element& element : mesh.elements)
        facts.elements.push_back(shape(mesh, element));
    for (const Marker& marker : mesh.markers) {
        facts.markers.push_back({marker.name, {}});
        for (const auto& [a, b] : marker.edges)
            facts.markers.back().second.push_back(
                {std::min(corner(mesh, a), corner(mesh, b)), std::max(corner(mesh, a), corner(mesh, b))});
    }
    for (const ElementGroup& group : mesh.groups) {
        facts.groups.push_back({group.name, {}});
        for (const Index e : group.elements)
            facts.groups.back().second.push_back(facts.elements[static_cast<std::size_t>(e)]);
    }
    for (const Field& field : mesh.fields) {
        facts.fields.push_back({field.name, {}});
        for (Index i = 0; i < field.values.rows(); ++i)
            facts.fields.back().second.push_back({field.location == FieldLocation::vertex
                                                      ? std::vector<Corner>{corner(mesh, i)}
                                                      : facts.elements[static_cast<std::size_t>(i)],
                                                  row(field.values, i)});
    }
    std::sort(facts.elements.begin(), facts.elements.end());
    sort_all(facts.markers);
    sort_all(facts.groups);
    sort_all(facts.fields);
    return facts;
}

/// The first kind of thing that differs, for the message.
std::string unequal_part(const Facts& a, const Facts& b)
{
    if (a.elements != b.elements)
        return "elements";
    if (a.markers != b.markers)
        return "markers";
    if (a.groups != b.groups)
        return "groups";
    return a.fields != b.fields ? "fields" : "";
}

/// Names of what is in @p before and not in @p after.
std::vector<std::string> lost_names(const MeshData& before, const MeshData& after)
{
    std::vector<std::string> lost;
    for (const Marker& marker : before.markers)
        if (!find_marker(after.markers, marker.name))
            lost.push_back(marker.name);
    for (const Field& field : before.fields)
        if (!find_field(after.fields, field.name, field.location))
            lost.push_back(field.name);
    for (const ElementGroup& group : before.groups)
        if (std::none_of(after.groups.begin(), after.groups.end(),
                         [&](const ElementGroup& kept) { return kept.name == group.name; }))
            lost.push_back(group.name);
    return lost;
}

/// What is lost on the way from @p before to @p after is named in one of the warnings.
void expect_named(const MeshData& before, const MeshData& after, const std::vector<std::string>& warnings)
{
    for (const std::string& name : lost_names(before, after))
        EXPECT_THAT(testing::PrintToString(warnings), HasSubstr(name));
}

/// A file of @p format in a folder of its own, so that companions do not meet those of others.
std::string file_for(const test::TemporaryFolder& folder, const Format& format)
{
    return folder.file("mesh" + std::string(format.extensions.front()));
}

/// The thesis keeps every component of a field in a file of its own, which is no part of the mesh file.
void read_companion_fields(MeshData& mesh, const test::TemporaryFolder& folder,
                           const std::vector<Field>& fields)
{
    for (const Field& field : fields) {
        Field read{field.name, FieldLocation::vertex, Matrix(mesh.points.rows(), field.values.cols())};
        for (Index c = 0; c < field.values.cols(); ++c) {
            const std::string part = field.values.cols() == 1 ? "" : "_" + std::to_string(c);
            read.values.col(c) =
                read_fields(folder.file("mesh." + field.name + part + ".txt"), mesh).fields[0].values;
        }
        mesh.fields.push_back(std::move(read));
    }
}

/// Without the parts that @p back has not: a format may hold them in some files only (STL's groups are text).
void keep_named_parts(MeshData& expected, const MeshData& back)
{
    const std::vector<std::string> lost = lost_names(expected, back);
    const auto is_lost = [&](const auto& part) {
        return std::find(lost.begin(), lost.end(), part.name) != lost.end();
    };
    std::erase_if(expected.markers, is_lost);
    std::erase_if(expected.groups, is_lost);
    std::erase_if(expected.fields, is_lost);
}

/// Write and read back: what the format holds is equal, and whatever is not there afterwards was named.
void expect_trip(const MeshData& mesh, const Format& format, MeshData& back)
{
    const test::TemporaryFolder folder;
    MeshData expected = held(mesh, format);
    const std::vector<std::string> warnings = write_mesh_data(mesh, file_for(folder, format));
    back = read_mesh_data(file_for(folder, format));
    if (format.name == "thesis")
        read_companion_fields(back, folder, expected.fields);
    expect_named(mesh, back, warnings);
    keep_named_parts(expected, back);
    EXPECT_EQ(unequal_part(facts(back), facts(expected)), "");
}

TEST(FormatPairs, WhatTheSecondFormatCanHoldIsEqualAfterTheTripAndTheRestIsNamed)
{
    for (const auto& [name, mesh] : meshes())
        for (const Format* first : mesh_formats()) {
            if (mesh.dimension == 3 && !first->holds.surface)
                continue;
            SCOPED_TRACE(name + " to " + std::string(first->name));
            MeshData once;
            expect_trip(mesh, *first, once);
            for (const Format* second : mesh_formats()) {
                if (mesh.dimension == 3 && !second->holds.surface)
                    continue;
                SCOPED_TRACE("to " + std::string(second->name));
                MeshData twice;
                expect_trip(once, *second, twice);
            }
        }
}

TEST(FormatPairs, APlanarFormatRefusesASurfaceInsteadOfFlatteningIt)
{
    const test::TemporaryFolder folder;
    std::vector<const Format*> planar = mesh_formats();
    std::erase_if(planar, [](const Format* format) { return format->holds.surface; });
    for (const Format* format : planar)
        EXPECT_THROW(write_mesh_data(surface(), file_for(folder, *format)), InputError) << format->name;
    EXPECT_FALSE(planar.empty());
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
