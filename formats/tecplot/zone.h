#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace morph {

/// The cells of a zone. Ordered zones become lines, quads or bricks once their data are read.
enum class TecplotCells { lines, triangles, quads, tetrahedra, bricks, ordered };

/// 2, 3, 4, 4 or 8.
int corner_count(TecplotCells cells);

/// One variable in one zone.
struct TecplotVariable {
    bool centred = false; ///< a value for each cell, not for each node
    bool passive = false; ///< not in the file: 0
    int shared_with = -1; ///< zone that holds the values; -1: they are here
    std::shared_ptr<const std::vector<double>> values;
};

struct TecplotZone {
    std::size_t position = 0; ///< in the file
    std::string name;
    TecplotCells cells = TecplotCells::ordered;
    bool block = false;                 ///< variable by variable, not node by node
    std::array<Index, 3> size{1, 1, 1}; ///< nodes along i, j, k of an ordered zone
    Index nodes = 0;
    Index elements = 0;
    int strand = 0; ///< zones of one strand above 0 are one thing at several times
    double time = 0;
    bool has_neighbors = false; ///< neighbours of faces follow the connectivity
    int connectivity_of = -1;   ///< zone whose connectivity this one has too
    std::vector<TecplotVariable> variables;
    std::vector<Index> corners; ///< nodes from 0, corner_count(cells) for each element
};

/// Make up the connectivity of an ordered zone: lines, quads or bricks by how many of its sides are longer
/// than one node, i fastest.
void connect_ordered(TecplotZone& zone);

struct TecplotFile {
    std::vector<std::string> variables;
    std::vector<TecplotZone> zones;
    std::vector<ElementGroup> groups; ///< of the elements of all zones, as our own writer lists them
};

} // namespace morph
