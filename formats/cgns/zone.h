#pragma once

#include "formats/cgns/file.h"
#include "formats/mesh/volume_cells.h"
#include "formats/text/message_text.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace morph {

/// What an element of a zone became.
enum class CgnsKind { other, edge, face, cell };

struct CgnsItem {
    CgnsKind kind;
    Index index; ///< among those of its kind
};

/// Elements with consecutive numbers, as the file lists them.
struct CgnsSection {
    std::string name;
    std::int64_t first = 1; ///< number of the first element
    std::vector<CgnsItem> items;
};

/// One zone while it is read. Vertices are numbered from 0 here.
struct CgnsZone {
    int base = 1;
    int number = 1; ///< in the base, from 1
    std::string name;
    int cell_dimension = 2;             ///< of the base
    int index_dimension = 1;            ///< 1: unstructured; 2 or 3: structured
    std::array<Index, 3> size{1, 1, 1}; ///< vertices along each index
    Index cell_count = 0;               ///< rows of a field of cells
    MeshData mesh; ///< markers and groups of equal names are joined when all zones are there
    std::vector<std::array<Index, 2>> edges;
    std::vector<VolumeCell> cells;
    std::vector<CgnsSection> sections; ///< by number of the first element

    bool structured() const { return index_dimension > 1; }
    Index vertex_count() const { return size[0] * size[1] * size[2]; }
    std::string title() const { return "zone " + quoted_text(name); }
};

/// The elements of an unstructured zone.
/// @throws InputError  "path: zone 'a', section 'b': …": a type of elements that is not supported, a number
/// of
///                     a vertex or an element out of range
void read_cgns_sections(const CgnsFile& file, CgnsZone& zone);

/// The quads (or hexahedra) of a structured zone.
void make_cgns_grid(CgnsZone& zone);

/// The boundary conditions and subregions, as markers and groups of the zone's mesh by the name of their
/// family, or their own.
/// @throws InputError  as above, for points of a boundary
void read_cgns_boundaries(const CgnsFile& file, CgnsZone& zone);

/// Solutions at vertices and cells as fields; those elsewhere are warned of.
/// @throws InputError  an array cannot be read
void read_cgns_solutions(const CgnsFile& file, CgnsZone& zone);

} // namespace morph
