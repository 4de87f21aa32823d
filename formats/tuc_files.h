#pragma once

#include "formats/format.h"
#include "libmorph/mesh/mesh.h"

#include <array>
#include <vector>

namespace morph {

/// The text files of S. Tavla, Technical University of Crete, 2021, chapter 4: white-space separated, ids
/// from 1.
///
/// Mesh: `nodes triangles quads`, a heading, then `id x1 y1 x2 y2 x3 y3 x4 y4` for each element, x4 = y4 = 0
/// for a triangle. Destination: `nodes`, then `x y` for each. Function values: `elements`, then `id f1 f2 f3
/// f4`. Neighbours: `elements`, a heading, then `id n1 n2 n3 [n4]`, where n_k is the element beyond the side
/// from corner k to the next; 0, or a number above the count: none.

/// Read a mesh or a list of destinations, which the number of numbers in line 1 tells apart.
///
/// Nodes are numbered as they first appear; corners with equal coordinates are one. A row whose fourth corner
/// is (0, 0) is a triangle or a quad with a corner there: where the counts leave it open, those rows are
/// quads that are convex as such and share both sides at the origin with other elements or the boundary.
/// @throws InputError  "path:line: …": also when line 1 counts other than what was found
MeshData read_tuc(const InputBytes& file);

/// The corners of an element in the order they are written: from the second on where the fourth lies at the
/// origin, so that nobody takes the quad for a triangle.
Element tuc_element(const MeshData& mesh, std::size_t number);

/// Write a mesh, or its points when it has no elements.
void write_tuc(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

/// The nodal field in a file of function values, called f.
/// @throws InputError  "path:line: …": another number of elements than the mesh has; corners of one node
/// differ
///                     by more than 1e-9 of the values' range
Field read_tuc_values(const InputBytes& file, const MeshData& mesh);

/// Write one component of a nodal field.
void write_tuc_values(const MeshData& mesh, const Field& field, Eigen::Index component, OutputFile& out);

/// Numbers of the elements around each, from 0; -1: none. By sides as the file lists the corners.
std::vector<std::array<Index, 4>> element_neighbors(const Mesh& mesh);

void write_tuc_neighbors(const Mesh& mesh, OutputFile& out);

/// Compare a file of neighbours with the halfedge structure. Its sides may start at any corner, but with the
/// same one throughout for triangles and for quads.
/// @throws InputError  "path:line: …": names the first element that has other neighbours, and both lists
void check_tuc_neighbors(const InputBytes& file, const Mesh& mesh);

} // namespace morph
