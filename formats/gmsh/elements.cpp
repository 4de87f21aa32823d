#include "formats/gmsh/elements.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kBlockText = 8; ///< "1 1 1 0\n", the shortest block
constexpr std::size_t kBlockBytes = 16;

VolumeShape shape_of(std::int64_t type)
{
    constexpr std::array<VolumeShape, 4> shapes{VolumeShape::tetrahedron, VolumeShape::hexahedron,
                                                VolumeShape::prism, VolumeShape::pyramid};
    return shapes.at(static_cast<std::size_t>(type - 4));
}

} // namespace

void GmshElements::read()
{
    if (in_.is_version_2())
        read_elements_2(in_.first_count("the number of elements", 6, 12));
    else
        read_blocks();
    in_.leave();
}

GmshCell GmshElements::require_known(std::int64_t type, std::size_t position) const
{
    const GmshCell cell = gmsh_cell(type);
    if (cell.dimension < 0)
        in_.fail_at(position, "an element is " + gmsh_cell_name(type) +
                                  ", but only linear lines, triangles, quads and cells are supported");
    return cell;
}

void GmshElements::read_blocks()
{
    const Index blocks = in_.first_count("the number of blocks of elements", kBlockText, kBlockBytes);
    const Index total = in_.count("the number of elements", 4, 8);
    volume_.mesh.elements.reserve(static_cast<std::size_t>(total));
    if (!in_.is_version_4_0()) {
        in_.size("the smallest tag of an element");
        in_.size("the largest tag of an element");
    }
    for (Index b = 0; b < blocks; ++b) {
        Block block;
        std::int64_t dimension = in_.integer("the dimension of an entity");
        block.entity = in_.integer("the tag of an entity");
        if (in_.is_version_4_0())
            std::swap(dimension, block.entity);
        const std::size_t position = in_.position();
        block.type = in_.integer("the type of elements");
        block.cell = require_known(block.type, position);
        const Index count = in_.count("the number of elements of a block", 4, 8);
        for (Index i = 0; i < count; ++i)
            read_corners(block, in_.tag("the tag of an element"));
    }
}

void GmshElements::read_elements_2(Index count)
{
    volume_.mesh.elements.reserve(static_cast<std::size_t>(count));
    for (Index done = 0; done < count;)
        done += read_rows_2(count - done);
}

/// One element, or in a binary file one block of them; returns how many.
Index GmshElements::read_rows_2(Index left)
{
    Block block;
    std::int64_t tag = in_.binary() ? 0 : in_.integer("the number of an element");
    const std::size_t position = in_.position();
    block.type = in_.integer("the type of an element");
    block.cell = require_known(block.type, position);
    const Index rows = in_.binary() ? in_.count("the number of elements of a block", 4, 8) : 1;
    if (rows < 1 || rows > left)
        in_.fail_at(position, "a block has " + std::to_string(rows) + " elements, expected 1 to " +
                                  std::to_string(left));
    const std::int64_t tags = in_.integer("the number of tags");
    for (Index row = 0; row < rows; ++row) {
        if (in_.binary())
            tag = in_.integer("the number of an element");
        read_tags_2(block, tags);
        read_corners(block, tag);
    }
    return rows;
}

/// Physical group, entity and partitions.
void GmshElements::read_tags_2(Block& block, std::int64_t count)
{
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t tag = in_.integer("a tag of an element");
        if (i == 0)
            block.physical = tag;
        else if (i == 1)
            block.entity = tag;
    }
}

Index GmshElements::node(std::int64_t element)
{
    const std::size_t position = in_.position();
    const std::int64_t tag = in_.tag("the tag of a node");
    const Index vertex = nodes_.find(tag);
    if (vertex < 0)
        in_.fail_at(position, "element " + std::to_string(element) + " names node " + std::to_string(tag) +
                                  ", which is not among the nodes");
    return vertex;
}

void GmshElements::read_corners(const Block& block, std::int64_t tag)
{
    std::array<Index, 8> corners;
    for (int k = 0; k < block.cell.corners; ++k)
        corners[static_cast<std::size_t>(k)] = node(tag);
    add(block, tag, corners);
}

void GmshElements::add(const Block& block, std::int64_t tag, const std::array<Index, 8>& corners)
{
    if (block.cell.dimension == 0)
        return;
    if (block.cell.dimension < 3 && place(block).left_out) {
        ++left_out_;
        return;
    }
    if (block.cell.dimension == 1) {
        const GmshGroups::Place& to = place(block);
        for (std::size_t m = 0; m < to.numbers.size(); ++m)
            volume_.mesh.markers[to.numbers[m]].edges.push_back(
                to.reversed[m] ? std::array{corners[1], corners[0]} : std::array{corners[0], corners[1]});
    } else if (block.cell.dimension == 2) {
        add_face(block, tag, {corners[0], corners[1], corners[2], block.type == kGmshQuad ? corners[3] : -1});
    } else {
        VolumeCell cell{shape_of(block.type), {}};
        std::copy_n(corners.begin(), block.cell.corners, cell.corners.begin());
        add_cell(block, cell);
    }
}

/// Files of version 2 repeat an element for each physical group that it is in, right behind it.
void GmshElements::add_face(const Block& block, std::int64_t tag, const Element& face)
{
    std::vector<Element>& faces = volume_.mesh.elements;
    const bool repeated = block.physical != last_physical_ && !faces.empty() &&
                          std::is_permutation(face.begin(), face.end(), faces.back().begin());
    last_physical_ = block.physical;
    if (!repeated) {
        faces.push_back(face);
        tags_.add(tag);
    }
    const auto number = static_cast<Index>(faces.size() - 1);
    for (const std::size_t g : place(block).numbers)
        if (std::vector<Index>& members = volume_.mesh.groups[g].elements;
            members.empty() || members.back() != number)
            members.push_back(number);
}

void GmshElements::add_cell(const Block& block, const VolumeCell& cell)
{
    const bool repeated =
        block.physical != last_physical_ && !volume_.cells.empty() &&
        volume_.cells.back().shape == cell.shape &&
        std::is_permutation(cell.corners.begin(), cell.corners.end(), volume_.cells.back().corners.begin());
    last_physical_ = block.physical;
    if (!repeated)
        volume_.cells.push_back(cell);
}

const GmshGroups::Place& GmshElements::place(const Block& block)
{
    const std::array<std::int64_t, 3> key{block.cell.dimension, block.entity, block.physical};
    if (!place_ || key != place_key_) {
        place_ = &groups_.place(block.cell.dimension, block.entity, block.physical);
        place_key_ = key;
    }
    return *place_;
}

} // namespace morph
