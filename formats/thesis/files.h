#pragma once

#include "formats/format.h"
#include "libmorph/mesh/mesh.h"

#include <array>
#include <vector>

namespace morph {

/// The text files of S. Tavla, Technical University of Crete, 2021, chapter 4: white-space separated, ids
/// from 1 (also in messages about their elements; vertices count from 0 as everywhere).
///
/// - Mesh: `nodes triangles quads`, a heading, then `id x1 y1 x2 y2 x3 y3 x4 y4` for each element, with
///   x4 = y4 = 0 for a triangle.
/// - Destinations: `nodes`, then `x y` for each.
/// - Function values: `elements`, then `id f1 f2 f3 f4` by corner, with f4 = 0 for a triangle.
/// - Neighbours: `elements`, a heading, then `id n1 n2 n3 [n4]`, where n_k is the element beyond the side
///   from corner k to the next; 0, or a number above the count: none.
///
/// A quad whose fourth corner lies at the origin looks like a triangle. It is therefore written from its
/// second corner on, in all of these files; they are read either way.

/// Read a mesh or a list of destinations, distinguished by the number of counts in line 1.
///
/// Nodes are numbered as they first appear; corners with equal coordinates are one. A row whose fourth corner
/// is 0 0 is a triangle or a quad with a corner there: where the counts leave it open, the quads are those
/// rows that are convex as quads and whose diagonal from corner 1 to 3 is no other element's side.
/// @throws InputError  "path:line: …": also when line 1 counts other than what was found, or when neither the
///                     counts nor the above show which rows are quads
MeshData read_thesis(const InputBytes& file);

/// The corners of an element in the order in which they are written.
Element thesis_element(const MeshData& mesh, std::size_t number);

/// Write a mesh, or its points when it has no elements.
void write_thesis(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

/// What of this mesh neither write_thesis() nor its accompanying files hold.
std::vector<std::string> thesis_losses(const MeshData& mesh, const WriteOptions& options);

/// The nodal field in a file of function values, called f. Where values at one node differ by rounding, the
/// first counts.
/// @throws InputError  "path:line: …": another number of elements than the mesh has; values of one node that
///                     differ by more than 1e-9 of the range of all; a vertex of no element
Field read_thesis_values(const InputBytes& file, const MeshData& mesh);

/// Write one component of a nodal field.
void write_thesis_values(const MeshData& mesh, const Field& field, Eigen::Index component, OutputFile& out);

/// Numbers of the elements around each element, from 0; -1: none. Elements and their sides, from corner k to
/// the next, as in the mesh's own file.
std::vector<std::array<Index, 4>> element_neighbors(const Mesh& mesh);

void write_thesis_neighbors(const Mesh& mesh, OutputFile& out);

/// Compare a file of neighbours with the halfedge structure. Its first side may be any, as long as it is the
/// same one for all triangles and the same one for all quads.
/// @throws InputError  "path:line: …": names the first element that has other neighbours, and both lists
void check_thesis_neighbors(const InputBytes& file, const Mesh& mesh);

} // namespace morph
