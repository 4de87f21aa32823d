#pragma once

#include "formats/om_files.h"
#include "formats/ply_names.h"
#include "formats/vtk_numbers.h"

#include <string>
#include <vector>

namespace morph {

/// Collects what an .om file has beside vertices and faces, and makes fields, groups and markers of it.
class OmProperties {
public:
    explicit OmProperties(const InputBytes& file) : file_(file) {}

    /// Normals, colours, texture coordinates; others are left out.
    void add_attribute(const OmChunk& chunk, std::size_t count, std::string_view bytes);

    /// A property of @p count vertices, faces, … with its name and, from version 2.1 on, type.
    void add_custom(OmEntity entity, std::string_view name, std::string_view type, std::size_t count,
                    std::string_view bytes);

    /// @throws InputError  a marker names a vertex that the mesh does not have
    void add_to(MeshData& mesh);

private:
    struct Property {
        OmEntity entity;
        std::string_view name;
        std::string_view type;
        std::size_t count;
        std::string_view bytes;
    };
    void add_field(const Property& property, const PlyNames& names, MeshData& mesh) const;
    void add_groups(const PlyNames& names, MeshData& mesh) const;
    void add_markers(const PlyNames& names, MeshData& mesh) const;

    const InputBytes& file_;
    std::vector<Property> properties_;
    std::vector<Field> attributes_;
};

} // namespace morph
