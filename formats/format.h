#pragma once

#include "formats/output_file.h"
#include "libmorph/mesh/mesh_data.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// What a file is called and what is in it. Readers work on the bytes; @p path is for messages.
struct InputBytes {
    std::string path;
    std::string_view bytes;
};

/// What a format has a place for; the rest is named in a warning on writing.
struct FormatCapabilities {
    bool surface = false; ///< z coordinates
    bool markers = false;
    bool vertex_fields = false;
    bool element_fields = false;
    bool elements = true; ///< false: points only, which nobody takes for a mesh
};

struct WriteOptions {
    bool binary = true; ///< where the format has both
};

/// A file that goes with a mesh file and holds what that cannot.
struct Companion {
    std::string suffix; ///< of its name, in place of the mesh file's extension: ".neighbours.txt"
    std::function<void(const MeshData&, OutputFile&)> write;
};

/// One file format: a row of the table by extension. Each formats/NAME.cpp defines one of these, and
/// formats/CMakeLists.txt lists NAME; nothing else has to know of it.
struct Format {
    std::string_view name;                    ///< for --from and --to
    std::vector<std::string_view> extensions; ///< with the dot, lower case
    std::string_view description;             ///< a few words for help
    FormatCapabilities holds;

    /// @throws InputError  "path:line: what is wrong" (binary: "path: byte 123: …")
    std::function<MeshData(const InputBytes&)> read;
    std::function<void(const MeshData&, const WriteOptions&, OutputFile&)> write;

    /// What else of this mesh the format cannot hold, each for "FORMAT cannot hold …"; may be empty.
    std::function<std::vector<std::string>(const MeshData&, const WriteOptions&)> losses = nullptr;

    /// The files that are written with one of this mesh; what they hold counts as held by the format.
    std::function<std::vector<Companion>(const MeshData&)> companions = nullptr;
};

/// Every format, in the order of formats/CMakeLists.txt.
const std::vector<const Format*>& all_formats();

/// The format of that name, or by the extension of @p path when @p name is empty.
/// @throws InputError  unknown; lists those known
const Format& find_format(const std::string& path, const std::string& name);

} // namespace morph
