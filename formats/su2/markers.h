#pragma once

#include "formats/su2/opaque_sections.h"
#include "formats/su2/sections.h"
#include "libmorph/mesh/mesh_data.h"

#include <unordered_map>

namespace morph {

/// Reads the MARKER_TAG blocks of an SU2 file. Edges of blocks of one name become one marker, triangles and
/// quads, which bound volumes, one group; blocks that SU2 uses for its halo, and single vertices, are
/// carried.
class Su2Markers {
public:
    explicit Su2Markers(Su2OpaqueSections& carried) : carried_(carried) {}

    /// 2 or 3, where markers may have faces.
    void set_dimension(int dimension) { dimension_ = dimension; }

    /// Read a block whose key, at @p start, has just been read.
    /// @throws InputError  "path:line: …"
    void read(TextScanner& in, std::size_t start);

    /// @throws InputError  an edge names a vertex that the mesh does not have
    void check_vertices(TextScanner& in, Index vertices) const;

    /// @throws InputError  a marker has faces, but the mesh has no volume cells that they could bound
    void check_faces(const TextScanner& in, bool has_cells) const;

    /// Add the faces of markers to the elements and groups of @p mesh.
    void move_faces_to(MeshData& mesh);

    Index blocks() const { return blocks_; }
    std::vector<Marker> take() { return std::move(markers_); }

private:
    struct Block {
        std::string name;
        Su2Section lines;
    };
    void read_lines(TextScanner& in, const Block& block);
    struct Lines {
        std::vector<std::array<Index, 2>> edges;
        std::vector<Element> faces;
    };
    bool read_line(TextScanner& in, const Block& block, std::size_t i, Lines& lines);
    std::size_t corner_count_of(TextScanner& in, const Block& block, std::size_t i) const;
    Marker& marker_called(const std::string& name);
    void add_faces(const std::string& name, const std::vector<Element>& faces, std::size_t key);

    Su2OpaqueSections& carried_;
    int dimension_ = 2;
    std::vector<Marker> markers_;
    std::unordered_map<std::string, std::size_t> numbers_; ///< of the markers, by name
    std::vector<Element> faces_;
    std::vector<ElementGroup> groups_; ///< of faces_
    std::unordered_map<std::string, std::size_t> group_numbers_;
    std::size_t first_faces_ = 0; ///< where in the file the first block with faces is
    std::vector<Block> blocks_read_;
    Index blocks_ = 0;
    Index largest_vertex_ = -1;
};

} // namespace morph
