#include "tools/common/field_source.h"

#include "formats/field_file.h"

namespace morph::tools {

bool take_fields_from(const std::string& path, MeshData& mesh)
{
    FieldFile file = read_fields(path, mesh);
    for (Field& field : file.fields) {
        std::erase_if(mesh.fields, [&](const Field& own) { return own.name == field.name; });
        mesh.fields.push_back(std::move(field));
    }
    return file.su2_restart;
}

} // namespace morph::tools
