#pragma once

#include "formats/format.h"
#include "formats/output_files.h"
#include "libmorph/mesh/mesh.h"

#include <string>
#include <vector>

namespace morph {

/// Read a mesh file into flat arrays.
/// @param path     of the file; its extension names the format
/// @param format   name of the format; empty: by the extension
/// @param options  zone and what else can be chosen
/// @param notes    gets what the reader left out; may be null
/// @throws InputError  "path:line: what is wrong"
MeshData read_mesh_data(const std::string& path, const std::string& format = "",
                        const ReadOptions& options = {}, ReadNotes* notes = nullptr);

/// Read a mesh file and build its halfedge structure.
/// @throws InputError  as read_mesh_data() and build_mesh(), with the path in front
Mesh read_mesh(const std::string& path, const std::string& format = "");

/// build_mesh() whose errors have the path in front, for data that was read from there.
Mesh build_mesh_of(MeshData data, const std::string& path);

/// Write a mesh to a temporary file next to @p path and rename it once complete, so that a failure leaves nothing.
/// @return one warning for each kind of thing the format cannot hold
/// @throws InputError  the file cannot be written
std::vector<std::string> write_mesh(const Mesh& mesh, const std::string& path, const std::string& format = "",
                                    const WriteOptions& options = {});

/// As write_mesh(), from flat arrays.
std::vector<std::string> write_mesh_data(const MeshData& data, const std::string& path,
                                         const std::string& format = "", const WriteOptions& options = {});

/// As write_mesh_data(), into files (the mesh's, and its format's companions) that the caller commits, so
/// that they appear together with others.
std::vector<std::string> write_mesh_data(const MeshData& data, const std::string& path, OutputFiles& files,
                                         const std::string& format = "", const WriteOptions& options = {});

} // namespace morph
