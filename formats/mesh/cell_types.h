#pragma once

#include <cstdint>
#include <string>

namespace morph {

/// Element types by the numbers VTK gives them, which SU2 uses too. Supported are these and, in
/// markers, edges.
inline constexpr int kVertexCell = 1;
inline constexpr int kEdgeCell = 3;
inline constexpr int kTriangleCell = 5;
inline constexpr int kQuadCell = 9;

/// "a tetrahedron (type 10)", or "of the unknown type 99": for the message that refuses it.
std::string cell_type_name(std::int64_t type);

} // namespace morph
