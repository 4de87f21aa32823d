#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <string>
#include <vector>

namespace morph {

/// Vertex indices of a triangle (the fourth is -1) or of a quad, in order around it.
using Element = std::array<Index, 4>;

/// 3 or 4.
inline int corner_count(const Element& element)
{
    return element[3] < 0 ? 3 : 4;
}

/// Named part of the boundary, or of the inside: directed edges (from, to) in the order of the file.
struct Marker {
    std::string name;
    std::vector<std::array<Index, 2>> edges;
};

/// Named set of elements: a physical group, patch, zone or property of the file. An element may be in
/// several.
struct ElementGroup {
    std::string name;
    std::vector<Index> elements; ///< in the order of the file, each once
};

enum class FieldLocation { vertex, element };

/// Named values, 1 to 9 components, one row per vertex or element.
struct Field {
    std::string name;
    FieldLocation location = FieldLocation::vertex;
    Matrix values;
};

/// Text of one format that the mesh has no place for (FFD boxes, periodic blocks). It goes back
/// into a file of the same format unchanged; other formats name it in a warning.
struct OpaqueSection {
    std::string format; ///< name of the format, such as "su2"
    std::string what;   ///< a few words for the warning, such as "2 FFD boxes"
    std::string text;
    bool names_vertices = true; ///< vertices or elements, by number: no use for another mesh
};

/// A mesh as a file holds it: flat arrays in the file's numbering. Readers fill it, writers take it,
/// build_mesh() turns it into halfedges.
struct MeshData {
    int dimension = 2; ///< 2: planar, z = 0 throughout · 3: surface in space
    Points points;     ///< n x 3
    std::vector<Element> elements;
    std::vector<Marker> markers;
    std::vector<ElementGroup> groups;
    std::vector<Field> fields;
    std::vector<OpaqueSection> sections;
};

/// Marker of that name, or null.
const Marker* find_marker(const std::vector<Marker>& markers, const std::string& name);

/// Field of that name and place, or null.
const Field* find_field(const std::vector<Field>& fields, const std::string& name, FieldLocation location);

/// Add a field at the end; one of its name and place goes.
void set_field(std::vector<Field>& fields, Field field);

/// 2 where all points have z = 0, else 3.
int dimension_of(const Points& points);

} // namespace morph
