#pragma once

#include "formats/abaqus/sets.h"
#include "formats/abaqus/types.h"
#include "formats/format.h"

namespace morph {

/// Elements of one *ELEMENT keyword.
struct AbaqusBlock {
    AbaqusType type;
    Index begin = 0;            ///< first of its elements in the table of elements
    std::vector<Index> corners; ///< ids of nodes, later numbers of vertices
};

/// A line of *SURFACE: sides of an element or of a set of elements.
struct AbaqusSide {
    std::string elements; ///< an id or a set
    std::string side;     ///< "S2", "E1", "SPOS"; may be empty
    std::size_t position;
};

struct AbaqusSurface {
    std::string name;
    std::vector<AbaqusSide> sides;
};

/// An input file as it stands.
struct AbaqusModel {
    std::vector<double> xyz;
    IdTable nodes;
    IdTable elements; ///< in the order of the blocks
    std::vector<AbaqusBlock> blocks;
    AbaqusSets element_sets, node_sets;
    std::vector<AbaqusSurface> surfaces;
    std::map<std::string, std::string>
        names; ///< of our own comments: full names by those of sets, in upper case

    /// The block that an element of the table is in.
    const AbaqusBlock& block_of(Index element) const;
};

/// Read nodes, elements, sets and surfaces of an Abaqus input file; ids are resolved.
/// @throws InputError  "path:line: …": what is read from other files or generated, coordinates in other
/// systems,
///                     several parts with nodes, element types of higher order, unknown ids and sets
AbaqusModel read_abaqus_model(const InputBytes& input);

/// One mesh from that (see read_abaqus() for what becomes of sets).
MeshData abaqus_mesh(AbaqusModel model, const InputBytes& input);

} // namespace morph
