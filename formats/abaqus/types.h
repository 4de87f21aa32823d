#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace morph {

enum class AbaqusShape { line, triangle, quad, tetrahedron, pyramid, prism, hexahedron, point };

/// What an element type of Abaqus is for a mesh.
struct AbaqusType {
    AbaqusShape shape;
    bool planar = false; ///< a continuum element whose sides S1, S2, … are edges (CPS4), not a shell (S4)
};

/// The type by its name (in upper case): modifiers behind the number of nodes (R, H, T, …) make no
/// difference. Masses, springs and connectors are points. Nothing for what is unknown or of higher order.
std::optional<AbaqusType> abaqus_type(const std::string& name);

/// 2 to 8; 0 for a point.
int corner_count(AbaqusShape shape);

/// Corners (from 0) of side S1, S2, … of a cell or of edge E1, E2, … of a face, in the order of Abaqus; no
/// more sides: empty.
std::vector<int> abaqus_side(AbaqusShape shape, int number);

} // namespace morph
