// Any bytes become fields of a small mesh, agree with its neighbours, or are an InputError: taken for a
// table, for the thesis's function values and neighbours, and for a mesh file.
#include "formats/field_file.h"
#include "formats/thesis/files.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace {

using namespace morph;

/// The unit square, and a triangle to its right.
MeshData small_mesh()
{
    MeshData mesh;
    mesh.points.resize(5, 3);
    mesh.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5, 0;
    mesh.elements = {{1, 2, 3, 0}, {1, 4, 2, -1}};
    return mesh;
}

void expect_fields_of(const MeshData& mesh, const std::vector<Field>& fields)
{
    for (const Field& field : fields) {
        const auto rows = field.location == FieldLocation::vertex
                              ? mesh.points.rows()
                              : static_cast<Eigen::Index>(mesh.elements.size());
        if (field.values.rows() != rows || !field.values.allFinite())
            std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    static const MeshData mesh = small_mesh();
    static const Mesh built = build_mesh(mesh);
    const InputBytes file{"fuzz", {reinterpret_cast<const char*>(bytes), size}};
    for (const char* format : {"csv", "thesis", "vtu"})
        try {
            expect_fields_of(mesh, parse_fields(file, mesh, format).fields);
        } catch (const InputError&) { // what broken files deserve
        }
    try {
        check_thesis_neighbors(file, built);
    } catch (const InputError&) { // as above
    }
    return 0;
}
