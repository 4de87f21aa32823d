#pragma once

#include "formats/gmsh/cells.h"
#include "formats/gmsh/groups.h"
#include "formats/gmsh/scanner.h"
#include "formats/gmsh/tags.h"
#include "formats/mesh/volume_cells.h"

namespace morph {

/// Reads $Elements: faces become elements, lines edges of markers, cells those of a volume; points are
/// passed over.
class GmshElements {
public:
    /// @param nodes  sorted tags of the vertices
    GmshElements(GmshScanner& in, const GmshTags& nodes, GmshGroups& groups, VolumeFile& volume)
        : in_(in), nodes_(nodes), groups_(groups), volume_(volume)
    {
    }

    /// Read a section, which the scanner has entered.
    /// @throws InputError  of a type not supported, a node that is none
    void read();

    /// Of the faces, in their order; not sorted.
    GmshTags& tags() { return tags_; }
    /// Lines and faces between partitions.
    Index left_out() const { return left_out_; }

private:
    struct Block {
        std::int64_t type = 0;
        GmshCell cell;
        std::int64_t entity = 0;
        std::int64_t physical = 0; ///< in files of version 2
    };
    void read_blocks();
    void read_elements_2(Index count);
    Index read_rows_2(Index left);
    void read_tags_2(Block& block, std::int64_t count);
    GmshCell require_known(std::int64_t type, std::size_t position) const;
    void read_corners(const Block& block, std::int64_t tag);
    Index node(std::int64_t element);
    void add(const Block& block, std::int64_t tag, const std::array<Index, 8>& corners);
    void add_face(const Block& block, std::int64_t tag, const Element& face);
    void add_cell(const Block& block, const VolumeCell& cell);
    const GmshGroups::Place& place(const Block& block);

    GmshScanner& in_;
    const GmshTags& nodes_;
    GmshGroups& groups_;
    VolumeFile& volume_;
    GmshTags tags_;
    Index left_out_ = 0;
    std::array<std::int64_t, 3> place_key_{-1, 0, 0}; ///< of place_: dimension, entity, physical
    const GmshGroups::Place* place_ = nullptr;
    std::int64_t last_physical_ = 0; ///< of the face or cell before
};

} // namespace morph
