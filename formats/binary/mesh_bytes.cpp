#include "formats/binary/mesh_bytes.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace morph {

namespace {

class Packer {
public:
    explicit Packer(MemoryFile& to) : to_(to) {}

    void number(std::int64_t value) { to_.append({reinterpret_cast<const char*>(&value), sizeof value}); }

    template <class T>
    void array(const T* values, std::size_t count)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        number(static_cast<std::int64_t>(count));
        to_.append({reinterpret_cast<const char*>(values), count * sizeof(T)});
    }
    template <class T>
    void vector(const std::vector<T>& values)
    {
        array(values.data(), values.size());
    }
    void text(const std::string& text) { array(text.data(), text.size()); }

private:
    MemoryFile& to_;
};

class Unpacker {
public:
    Unpacker(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

    [[noreturn]] void fail() const
    {
        throw InputError(path_ + ": damaged so that the library for its format made no sound mesh of it");
    }
    void require(bool sound) const
    {
        if (!sound)
            fail();
    }

    std::int64_t number()
    {
        std::int64_t value = 0;
        copy(&value, sizeof value);
        return value;
    }
    /// A count of things that take at least @p size bytes each.
    std::size_t count(std::size_t size)
    {
        const std::int64_t value = number();
        require(value >= 0 && static_cast<std::uint64_t>(value) <= bytes_.size() / size);
        return static_cast<std::size_t>(value);
    }
    template <class T>
    std::vector<T> vector()
    {
        std::vector<T> values(count(sizeof(T)));
        copy(values.data(), values.size() * sizeof(T));
        return values;
    }
    std::string text()
    {
        std::string text(count(1), '\0');
        copy(text.data(), text.size());
        return text;
    }
    /// Fills all of @p values.
    void matrix(auto& values)
    {
        require(count(sizeof(double)) == static_cast<std::size_t>(values.size()));
        copy(values.data(), sizeof(double) * static_cast<std::size_t>(values.size()));
    }

private:
    void copy(void* to, std::size_t size)
    {
        require(size <= bytes_.size());
        if (size > 0)
            std::memcpy(to, bytes_.data(), size);
        bytes_.remove_prefix(size);
    }

    std::string_view bytes_;
    const std::string& path_;
};

void unpack_points(Unpacker& from, MeshData& mesh)
{
    const auto rows = static_cast<Index>(from.count(3 * sizeof(double)));
    mesh.points.resize(rows, 3);
    from.matrix(mesh.points);
    mesh.elements = from.vector<Element>();
    for (const Element& element : mesh.elements) {
        from.require(element[3] >= -1 && element[3] < rows);
        from.require(
            std::all_of(element.begin(), element.begin() + 3, [&](Index v) { return v >= 0 && v < rows; }));
    }
}

void unpack_sets(Unpacker& from, MeshData& mesh)
{
    const auto vertices = static_cast<Index>(mesh.points.rows());
    const auto elements = static_cast<Index>(mesh.elements.size());
    for (std::size_t left = from.count(sizeof(std::int64_t)); left > 0; --left) {
        const std::string name = from.text();
        mesh.markers.push_back({name, from.vector<std::array<Index, 2>>()});
        for (const auto& [a, b] : mesh.markers.back().edges)
            from.require(std::min(a, b) >= 0 && std::max(a, b) < vertices);
    }
    for (std::size_t left = from.count(sizeof(std::int64_t)); left > 0; --left) {
        const std::string name = from.text();
        mesh.groups.push_back({name, from.vector<Index>()});
        for (const Index e : mesh.groups.back().elements)
            from.require(e >= 0 && e < elements);
    }
}

void unpack_fields(Unpacker& from, MeshData& mesh)
{
    for (std::size_t left = from.count(sizeof(std::int64_t)); left > 0; --left) {
        Field& field = mesh.fields.emplace_back();
        field.name = from.text();
        const std::int64_t at_elements = from.number();
        const std::int64_t columns = from.number();
        from.require((at_elements == 0 || at_elements == 1) && columns >= 1 && columns <= 9);
        field.location = at_elements == 1 ? FieldLocation::element : FieldLocation::vertex;
        field.values.resize(
            at_elements == 1 ? static_cast<Eigen::Index>(mesh.elements.size()) : mesh.points.rows(), columns);
        from.matrix(field.values);
    }
}

} // namespace

void append_mesh(MemoryFile& to, const VolumeFile& volume, const ReadNotes& notes)
{
    const MeshData& mesh = volume.mesh;
    Packer packer(to);
    packer.number(mesh.dimension);
    packer.number(mesh.points.rows());
    packer.array(mesh.points.data(), static_cast<std::size_t>(mesh.points.size()));
    packer.vector(mesh.elements);
    packer.number(static_cast<std::int64_t>(mesh.markers.size()));
    for (const Marker& marker : mesh.markers) {
        packer.text(marker.name);
        packer.vector(marker.edges);
    }
    packer.number(static_cast<std::int64_t>(mesh.groups.size()));
    for (const ElementGroup& group : mesh.groups) {
        packer.text(group.name);
        packer.vector(group.elements);
    }
    packer.number(static_cast<std::int64_t>(mesh.fields.size()));
    for (const Field& field : mesh.fields) {
        packer.text(field.name);
        packer.number(field.location == FieldLocation::element ? 1 : 0);
        packer.number(field.values.cols());
        packer.array(field.values.data(), static_cast<std::size_t>(field.values.size()));
    }
    packer.vector(volume.cells);
    packer.text(notes.version);
    packer.number(static_cast<std::int64_t>(notes.warnings.size()));
    for (const std::string& warning : notes.warnings)
        packer.text(warning);
}

VolumeFile mesh_from_bytes(std::string_view bytes, const std::string& path, ReadNotes& notes)
{
    Unpacker from(bytes, path);
    VolumeFile volume;
    volume.mesh.dimension = from.number() == 3 ? 3 : 2;
    unpack_points(from, volume.mesh);
    unpack_sets(from, volume.mesh);
    unpack_fields(from, volume.mesh);
    volume.cells = from.vector<VolumeCell>();
    for (const VolumeCell& cell : volume.cells)
        from.require(cell.shape >= VolumeShape::tetrahedron && cell.shape <= VolumeShape::hexahedron);
    notes.version = from.text();
    for (std::size_t left = from.count(sizeof(std::int64_t)); left > 0; --left)
        notes.warnings.push_back(from.text());
    return volume;
}

} // namespace morph
