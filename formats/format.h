#pragma once

#include "formats/output_file.h"
#include "libmorph/mesh/mesh_data.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// What to read of a file that holds more than one mesh of triangles and quads.
struct ReadOptions {
    bool surface = false; ///< of a volume mesh: its boundary faces
    std::string zone; ///< number (from 1) or name of the zone to take; empty: all, each a group of elements
};

/// What a reader reports in addition to the mesh.
struct ReadNotes {
    std::string version;               ///< of the file: "4.1, binary"
    std::vector<std::string> warnings; ///< what was left out of the mesh, by name, one line each
};

/// What a file is called, what is in it and what to read of it. Readers work on the bytes; @p path is for
/// messages and for the files next to it.
struct InputBytes {
    std::string path;
    std::string_view bytes;
    ReadOptions options = {};
    ReadNotes* notes = nullptr; ///< gets what the reader reports; may be null

    void warn(const std::string& what) const
    {
        if (notes)
            notes->warnings.push_back(path + ": " + what);
    }
    void set_version(const std::string& version) const
    {
        if (notes)
            notes->version = version;
    }
};

/// What a format has a place for; the rest is named in a warning on writing.
struct FormatCapabilities {
    bool surface = false; ///< z coordinates
    bool markers = false;
    bool groups = false; ///< named sets of elements
    bool vertex_fields = false;
    bool element_fields = false;
    bool elements = true; ///< false: points only, never taken for a mesh
    bool quads = true;    ///< false: writers split them into triangles and say so
    bool ascii = true;    ///< written as text
    bool binary = false;  ///< written as numbers
    bool compressed = false;
    bool volume = false; ///< a volume mesh can be in it, whose boundary `surface` of ReadOptions takes
};

struct WriteOptions {
    bool binary = true;    ///< where the format has both
    bool compress = false; ///< where the format can
};

/// A file that goes with a mesh file and holds what that cannot.
struct Companion {
    std::string suffix; ///< of its name, in place of the mesh file's extension: ".neighbours.txt"
    std::function<void(const MeshData&, OutputFile&)> write;

    /// Its path for that of the mesh file; null: by the suffix.
    std::function<std::string(const std::string&)> path = nullptr;
};

/// One file format: a row of the table by extension. Each formats/NAME/format.cpp defines one of these, and
/// formats/CMakeLists.txt lists NAME; nothing else has to know of it.
struct Format {
    std::string_view name;                    ///< for --from and --to
    std::vector<std::string_view> extensions; ///< with the dot, lower case
    std::string_view description;             ///< a few words for help
    FormatCapabilities holds;

    /// @throws InputError  "path:line: what is wrong" (binary: "path: byte 123: …")
    std::function<MeshData(const InputBytes&)> read;
    std::function<void(const MeshData&, const WriteOptions&, OutputFile&)> write; ///< null: only read

    /// What else of this mesh the format cannot hold, each for "FORMAT cannot hold …"; may be empty.
    std::function<std::vector<std::string>(const MeshData&, const WriteOptions&)> losses = nullptr;

    /// The files that are written with one of this mesh; what they hold counts as held by the format.
    std::function<std::vector<Companion>(const MeshData&)> companions = nullptr;

    std::string_view old_name = {}; ///< which --from and --to still understand
};

/// Every format, in the order of formats/CMakeLists.txt.
const std::vector<const Format*>& all_formats();

/// The format of that name, or by the extension of @p path (before a ".gz") when @p name is empty.
/// @throws InputError  unknown; lists those known
const Format& find_format(const std::string& path, const std::string& name);

} // namespace morph
