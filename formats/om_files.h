#pragma once

#include "formats/format.h"

#include <cstdint>
#include <string_view>

namespace morph {

/// What OpenMesh's chunks are about, and of which kind; from its OMFormat.hh.
enum class OmEntity : unsigned { vertex = 0, mesh = 1, face = 2, edge = 4, halfedge = 6, end = 7 };
enum class OmType : unsigned {
    position = 0,
    normal = 1,
    texture = 2,
    status = 3,
    color = 4,
    custom = 6,
    topology = 7
};

/// The 16 bits in front of a chunk.
struct OmChunk {
    OmEntity entity = OmEntity::vertex;
    OmType type = OmType::position;
    bool named = false;
    bool real = false;
    unsigned dimension = 1; ///< 1 to 8 numbers
    unsigned bits = 0;      ///< a number has 1 << bits bytes, a real one 4 << bits
};

/// A property of this name of the mesh has, as text, the lines that ply_names.h describes.
inline constexpr std::string_view kOmNames = "libmorph names";
/// A property of this name of the mesh has the edges of markers: two vertices and the number of the marker,
/// as 32-bit integers.
inline constexpr std::string_view kOmMarkers = "libmorph markers";

/// Read a mesh as OpenMesh stores it, versions 1 and 2. Normals, colours, texture coordinates and properties
/// of numbers are fields; names, groups and markers come back from files that write_om() wrote.
///
/// This and the writer are ours, checked against OpenMesh's: its own reader (9.0) takes counts and halfedges
/// of the file on trust, both print, and both know meshes only that a halfedge structure can hold.
/// @throws InputError  "path: byte N: …"
MeshData read_om(const InputBytes& file);

/// Write a mesh in version 1.2, in which faces name their vertices, with everything that MeshData holds.
/// OpenMesh reads mesh and, as properties of doubles (Vec2d, …), fields of up to 6 components.
void write_om(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

} // namespace morph
