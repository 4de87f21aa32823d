// PLY: rows of vertices and faces with the properties that a header names, as text or binary.
// Properties of one number beside the coordinates become fields.
#include "formats/format.h"
#include "formats/ply_header.h"
#include "formats/surface.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace morph {

namespace {

class PlyReader {
public:
    explicit PlyReader(const InputBytes& file)
        : path_(file.path), in_(file.path, file.bytes), header_(read_ply_header(in_))
    {
    }

    MeshData read()
    {
        require_once("vertex");
        require_once("face");
        for (const PlyElement& element : header_.elements)
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                skip(element);
        require_corners();
        return std::move(mesh_);
    }

private:
    /// A second table of vertices or faces would start their numbers anew.
    void require_once(const std::string& name) const
    {
        if (std::count_if(header_.elements.begin(), header_.elements.end(),
                          [&](const PlyElement& element) { return element.name == name; }) > 1)
            throw InputError(path_ + ": the header has more than one element '" + name + "'");
    }

    bool text() const { return header_.coding == PlyCoding::ascii; }

    [[noreturn]] void fail(std::size_t position, const std::string& what) const
    {
        if (text())
            in_.fail_at(position, what);
        throw InputError(path_ + ": byte " + std::to_string(position) + ": " + what);
    }

    double number(NumberType type)
    {
        if (text()) {
            in_.skip_white();
            double value = 0;
            if (!in_.try_real(value))
                in_.fail_expected("a number");
            return value;
        }
        const std::string_view rest = in_.rest();
        if (rest.size() < size_of(type))
            fail(in_.position(), "the file ends within its rows; it is cut off");
        const bool little = header_.coding == PlyCoding::little_endian;
        double value = 0;
        copy_numbers(
            {type, rest.substr(0, size_of(type)), little != (std::endian::native == std::endian::little)},
            &value);
        in_.seek(in_.position() + size_of(type));
        return value;
    }

    /// The numbers of a list in list_.
    void read_list(const PlyProperty& property)
    {
        const std::size_t position = in_.position();
        const double length = number(*property.length_type);
        if (!(length >= 0 && length <= static_cast<double>(in_.rest().size())))
            fail(position, "a list of the property '" + property.name + "' has an impossible length");
        list_.clear();
        for (double i = 0; i < length; ++i)
            list_.push_back(number(property.type));
    }

    void skip(const PlyElement& element)
    {
        if (element.properties.empty())
            return;
        for (std::size_t row = 0; row < element.count; ++row)
            for (const PlyProperty& property : element.properties)
                if (property.length_type)
                    read_list(property);
                else
                    number(property.type);
    }

    /// The coordinate that a property of vertices is, or -1.
    static int axis_of(const PlyProperty& property)
    {
        return property.length_type || property.name.size() != 1
                   ? -1
                   : static_cast<int>(std::string_view("xyz").find(property.name));
    }

    /// A field for each property of one number but the coordinates; its number, or -1 for the others.
    std::vector<int> make_fields(const PlyElement& element, FieldLocation location)
    {
        std::vector<int> field_of;
        for (const PlyProperty& property : element.properties) {
            const bool coordinate = location == FieldLocation::vertex && axis_of(property) >= 0;
            if (property.length_type || coordinate) {
                field_of.push_back(-1);
                continue;
            }
            field_of.push_back(static_cast<int>(mesh_.fields.size()));
            mesh_.fields.push_back(
                {property.name, location, Matrix(static_cast<Eigen::Index>(element.count), 1)});
        }
        return field_of;
    }

    void read_vertices(const PlyElement& element)
    {
        std::array<bool, 3> has_axis{};
        for (const PlyProperty& property : element.properties)
            if (const int axis = axis_of(property); axis >= 0)
                has_axis[static_cast<std::size_t>(axis)] = true;
        if (!has_axis[0] || !has_axis[1])
            fail(in_.position(), "vertices have no coordinates x and y");
        const std::vector<int> field_of = make_fields(element, FieldLocation::vertex);
        std::vector<double> xyz(3 * element.count, 0.0);
        for (std::size_t row = 0; row < element.count; ++row)
            for (std::size_t p = 0; p < element.properties.size(); ++p)
                read_vertex_property(element.properties[p], field_of[p], row, xyz);
        set_points(mesh_, xyz);
    }

    void read_vertex_property(const PlyProperty& property, int field, std::size_t row,
                              std::vector<double>& xyz)
    {
        if (property.length_type)
            return read_list(property);
        const std::size_t position = in_.position();
        const double value = number(property.type);
        if (field >= 0) {
            mesh_.fields[static_cast<std::size_t>(field)].values(static_cast<Eigen::Index>(row), 0) = value;
            return;
        }
        if (!std::isfinite(value))
            fail(position, "a coordinate of vertex " + std::to_string(row) + " is not finite");
        xyz[3 * row + static_cast<std::size_t>(axis_of(property))] = value;
    }

    void read_faces(const PlyElement& element)
    {
        const std::vector<int> field_of = make_fields(element, FieldLocation::element);
        mesh_.elements.reserve(element.count);
        for (std::size_t row = 0; row < element.count; ++row) {
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (property.name == "vertex_indices" || property.name == "vertex_index")
                    read_corners(property);
                else if (property.length_type)
                    read_list(property);
                else
                    mesh_.fields[static_cast<std::size_t>(field_of[p])].values(static_cast<Eigen::Index>(row),
                                                                               0) = number(property.type);
            }
            if (mesh_.elements.size() != row + 1)
                fail(in_.position(), "faces need one list 'vertex_indices'");
        }
    }

    void read_corners(const PlyProperty& property)
    {
        if (text())
            in_.skip_white();
        const std::size_t position = in_.position();
        if (!property.length_type)
            fail(position, "the property '" + property.name + "' of faces is no list");
        read_list(property);
        if (list_.size() != 3 && list_.size() != 4)
            fail(position, "face " + std::to_string(mesh_.elements.size()) + " has " +
                               std::to_string(list_.size()) +
                               " corners, but only triangles and quads are supported");
        Element element{-1, -1, -1, -1};
        for (std::size_t i = 0; i < list_.size(); ++i) {
            if (!(list_[i] >= 0 && list_[i] <= INT32_MAX && std::floor(list_[i]) == list_[i]))
                fail(position, "face " + std::to_string(mesh_.elements.size()) +
                                   " has a corner that is no vertex number");
            element[i] = static_cast<Index>(list_[i]);
        }
        mesh_.elements.push_back(element);
    }

    /// Faces may stand before the vertices.
    void require_corners() const
    {
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            for (const Index v : mesh_.elements[e])
                if (v >= mesh_.points.rows())
                    throw InputError(path_ + ": face " + std::to_string(e) + " names vertex " +
                                     std::to_string(v) + ", but the mesh has " +
                                     std::to_string(mesh_.points.rows()));
    }

    std::string path_;
    TextScanner in_;
    PlyHeader header_;
    MeshData mesh_;
    std::vector<double> list_;
};

MeshData read_ply(const InputBytes& file)
{
    return PlyReader(file).read();
}

void append_raw(OutputFile& out, const auto* numbers, std::size_t count)
{
    out.append({reinterpret_cast<const char*>(numbers), count * sizeof *numbers});
}

void write_ply(const MeshData& mesh, const WriteOptions& options, OutputFile& out)
{
    const std::string order = std::endian::native == std::endian::little ? "little" : "big";
    out.append("ply\nformat " + (options.binary ? "binary_" + order + "_endian" : std::string("ascii")) +
               " 1.0\nelement vertex " + std::to_string(mesh.points.rows()) +
               "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
               std::to_string(mesh.elements.size()) +
               "\nproperty list uchar int vertex_indices\nend_header\n");
    if (options.binary)
        append_raw(out, mesh.points.data(), static_cast<std::size_t>(mesh.points.size()));
    for (Eigen::Index v = 0; !options.binary && v < mesh.points.rows(); ++v)
        append_point(out, mesh.points, v);
    for (const Element& element : mesh.elements) {
        const auto corners = static_cast<std::uint8_t>(corner_count(element));
        if (options.binary) {
            append_raw(out, &corners, 1);
            append_raw(out, element.data(), corners);
        } else {
            out.append(corners == 3 ? "3 " : "4 ");
            append_corners(out, element, 0);
        }
    }
}

} // namespace

extern const Format ply_format;
const Format ply_format{"ply", {".ply"}, "Polygon File Format", {.surface = true}, read_ply, write_ply};

} // namespace morph
