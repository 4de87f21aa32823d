#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph {

/// Number the vertices along a space-filling curve.
///
/// Fills the vertices of the kernel and numbering.vertex; elements and markers of @p data then name the
/// new numbers, and its points are gone.
void renumber_vertices(Mesh& mesh, MeshData& data);

/// Number the elements by their smallest vertex, those with the same in the order of the file. Fills
/// numbering.element.
void renumber_elements(Mesh& mesh, std::vector<Element>& elements);

} // namespace morph
