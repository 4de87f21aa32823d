#pragma once

#include "formats/medit/keywords.h"
#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace morph {

/// Sections of a MEDIT file that a mesh keeps as text: references of the vertices, and lists (Corners,
/// Ridges, RequiredEdges, …) of numbers that count lines of other sections. Kept in a mesh, the lists name
/// vertices, pairs of vertices and elements, from 0, so that they hold whatever the order of writing.

/// A list as the file has it.
struct MeditNumbers {
    MeditList list;
    std::vector<std::int64_t> numbers; ///< from 1
    std::size_t position = 0;          ///< of its keyword in the file
};

using MeditEdges = std::vector<std::array<Index, 2>>;

/// How many vertices, edges or faces there are for such a list.
std::size_t listed_medit_things(MeditListed listed, const MeditEdges& edges, const MeshData& mesh);

/// The references of the vertices, one for each, as text.
OpaqueSection vertex_reference_section(const std::vector<std::int64_t>& references);

/// @param list  its numbers are from 1 to listed_medit_things()
OpaqueSection list_section(const MeditNumbers& list, const MeditEdges& edges, const MeshData& mesh);

/// What goes back into a file.
struct MeditExtras {
    std::vector<std::int64_t> vertex_references; ///< empty: all are 0
    std::vector<MeditNumbers> lists;             ///< in the order of mesh.sections
    std::vector<std::string> lost;               ///< what fits the mesh no more, for a warning
};

/// @param edges  all that are written, in this order
MeditExtras medit_extras(const MeshData& mesh, const MeditEdges& edges);

/// The edges of all markers, in the order in which they are written.
MeditEdges marker_edges(const MeshData& mesh);

} // namespace morph
