#pragma once

#include "libmorph/mesh/halfedges.h"

#include <vector>

namespace morph {

/// Reverse elements so that all of a part (elements connected by shared edges) run the same way round.
///
/// The majority of a part stays as it is listed; on a tie, the element of the lowest file number does.
/// In a planar mesh a part in which more elements run clockwise than counter-clockwise is reversed as a
/// whole. A reversed element keeps its first corner: (v0, v1, …, vk) becomes (v0, vk, …, v1).
///
/// @param mesh      dimension, the vertices of the kernel, and numbering
/// @param elements  m elements, reversed in place
/// @param edges     of the elements; consistent afterwards
/// @return m flags, set for reversed elements
/// @throws InputError  a surface with one side only, such as a Moebius strip
std::vector<bool> orient_elements(const Mesh& mesh, std::vector<Element>& elements, EdgeTable& edges);

/// The element listed the other way round, first corner kept.
Element reversed(const Element& element);

/// 1 for a planar element whose area is positive (counter-clockwise), -1 for negative, 0 for none: exact.
int area_sign(const Element& element, Eigen::Map<const Points> points);

} // namespace morph
