#pragma once

#include "formats/su2_carried.h"
#include "formats/su2_sections.h"
#include "libmorph/mesh/mesh_data.h"

#include <unordered_map>

namespace morph {

/// Reads the MARKER_TAG blocks of an SU2 file. Edges of blocks of one name become one marker; blocks
/// that SU2 uses for its halo, and single vertices, are carried.
class Su2Markers {
public:
    explicit Su2Markers(Su2CarriedSections& carried) : carried_(carried) {}

    /// Read a block whose key, at @p start, has just been read.
    /// @throws InputError  "path:line: …"
    void read(TextScanner& in, std::size_t start);

    /// @throws InputError  an edge names a vertex that the mesh does not have
    void check_vertices(TextScanner& in, Index vertices) const;

    Index blocks() const { return blocks_; }
    std::vector<Marker> take() { return std::move(markers_); }

private:
    struct Block {
        std::string name;
        Su2Section lines;
    };
    void read_lines(TextScanner& in, const Block& block);
    bool read_line(TextScanner& in, const Block& block, std::size_t i,
                   std::vector<std::array<Index, 2>>& edges);
    Marker& marker_called(const std::string& name);

    Su2CarriedSections& carried_;
    std::vector<Marker> markers_;
    std::unordered_map<std::string, std::size_t> numbers_; ///< of the markers, by name
    std::vector<Block> blocks_with_edges_;
    Index blocks_ = 0;
    Index largest_vertex_ = -1;
};

} // namespace morph
