#include "formats/abaqus/model.h"
#include "formats/mesh/volume_cells.h"
#include "formats/text/message_text.h"
#include "formats/text/surface_text.h"

#include <algorithm>
#include <charconv>
#include <unordered_set>

namespace morph {

namespace {

bool is_face(AbaqusShape shape)
{
    return shape == AbaqusShape::triangle || shape == AbaqusShape::quad;
}

std::uint64_t edge_key(Index a, Index b)
{
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint64_t>(std::max(a, b));
}

class MeshMaker {
public:
    MeshMaker(AbaqusModel model, const InputBytes& input)
        : model_(std::move(model)), input_(input), in_(input.path, input.bytes)
    {
    }

    MeshData make()
    {
        set_points(volume_.mesh, model_.xyz);
        model_.xyz = {};
        model_.nodes = {};
        for (const AbaqusBlock& block : model_.blocks)
            add_block(block);
        for (const AbaqusSets::Set& set : model_.element_sets.sets())
            add_element_set(set);
        for (const AbaqusSurface& surface : model_.surfaces)
            add_surface(surface);
        add_loose_lines();
        for (const AbaqusSets::Set& set : model_.node_sets.sets())
            add_node_set(set);
        return surface_of(std::move(volume_), input_);
    }

private:
    void add_block(const AbaqusBlock& block)
    {
        const auto count = static_cast<std::size_t>(corner_count(block.type.shape));
        first_face_.push_back(static_cast<Index>(volume_.mesh.elements.size()));
        for (std::size_t at = 0; at < block.corners.size(); at += count) {
            const Index* const c = block.corners.data() + at;
            if (is_face(block.type.shape)) {
                volume_.mesh.elements.push_back({c[0], c[1], c[2], count == 4 ? c[3] : -1});
            } else if (block.type.shape != AbaqusShape::line) {
                constexpr int first = static_cast<int>(AbaqusShape::tetrahedron);
                VolumeCell cell{static_cast<VolumeShape>(static_cast<int>(block.type.shape) - first), {}};
                std::copy_n(c, count, cell.corners.begin());
                volume_.cells.push_back(cell);
            }
        }
    }

    std::string full_name(const std::string& name) const
    {
        const auto found = model_.names.find(upper_case(name));
        return found == model_.names.end() ? name : found->second;
    }

    const Index* corners(Index element, const AbaqusBlock& block) const
    {
        return block.corners.data() +
               static_cast<std::size_t>((element - block.begin) * corner_count(block.type.shape));
    }

    /// The mesh element that a triangle or quad of the file is.
    Index face(Index element, const AbaqusBlock& block) const
    {
        return first_face_[static_cast<std::size_t>(&block - model_.blocks.data())] + element - block.begin;
    }

    /// Faces of the set are a group, lines a marker; a set without members is what its *ELEMENT has, or a
    /// group.
    void add_element_set(const AbaqusSets::Set& set)
    {
        ElementGroup group{full_name(set.name), {}};
        Marker marker{group.name, {}};
        std::size_t cells = 0;
        in_set_.resize(static_cast<std::size_t>(model_.elements.count()));
        for (const Index element : set.members) {
            in_set_[static_cast<std::size_t>(element)] = true;
            const AbaqusBlock& block = model_.block_of(element);
            const Index* const c = corners(element, block);
            if (block.type.shape == AbaqusShape::line)
                marker.edges.push_back({c[0], c[1]});
            else if (is_face(block.type.shape))
                group.elements.push_back(face(element, block));
            else
                ++cells;
        }
        if (cells > 0)
            input_.warn(std::to_string(cells) + " cell(s) of the set " + quoted_text(set.name) +
                        " were left out");
        if (!marker.edges.empty() || set.is_lines)
            volume_.mesh.markers.push_back(std::move(marker));
        if (!group.elements.empty() || (set.members.empty() && !set.is_lines))
            volume_.mesh.groups.push_back(std::move(group));
    }

    /// Lines in no set are one marker.
    void add_loose_lines()
    {
        Marker marker{"lines", {}};
        in_set_.resize(static_cast<std::size_t>(model_.elements.count()));
        for (const AbaqusBlock& block : model_.blocks)
            for (std::size_t i = 0; block.type.shape == AbaqusShape::line && i < block.corners.size(); i += 2)
                if (!in_set_[static_cast<std::size_t>(block.begin) + i / 2])
                    marker.edges.push_back({block.corners[i], block.corners[i + 1]});
        if (!marker.edges.empty())
            volume_.mesh.markers.push_back(std::move(marker));
    }

    void add_surface(const AbaqusSurface& surface)
    {
        Marker marker{full_name(surface.name), {}};
        ElementGroup group{marker.name, {}};
        for (const AbaqusSide& side : surface.sides)
            for (const Index element : elements_of(surface, side))
                add_side(side, element, marker, group);
        if (!marker.edges.empty())
            volume_.mesh.markers.push_back(std::move(marker));
        if (!group.elements.empty())
            volume_.mesh.groups.push_back(std::move(group));
    }

    std::vector<Index> elements_of(const AbaqusSurface& surface, const AbaqusSide& side) const
    {
        const std::string name = without_instance(side.elements);
        Index id = 0;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), id);
        if (error == std::errc() && end == name.data() + name.size() && model_.elements.find(id) >= 0)
            return {model_.elements.find(id)};
        for (const std::string& called : {side.elements, name})
            if (const AbaqusSets::Set* set = model_.element_sets.find(called))
                return set->members;
        in_.fail_at(side.position, "the surface " + quoted_text(surface.name) + " names the elements " +
                                       quoted_text(side.elements) + ", which are not there");
    }

    void add_side(const AbaqusSide& side, Index element, Marker& marker, ElementGroup& group)
    {
        const AbaqusBlock& block = model_.block_of(element);
        const AbaqusShape shape = block.type.shape;
        const bool whole = side.side.empty() || side.side == "SPOS" || side.side == "SNEG";
        if (whole && is_face(shape) && !block.type.planar) {
            group.elements.push_back(face(element, block));
            return;
        }
        const char letter = is_face(shape) && !block.type.planar ? 'E' : 'S';
        const int number = side.side.size() == 2 && side.side[0] == letter ? side.side[1] - '0' : 0;
        const std::vector<int> local = abaqus_side(shape, number);
        if (local.empty())
            in_.fail_at(side.position, "element " + std::to_string(model_.elements.id(element)) +
                                           " has no side " + quoted_text(side.side));
        const Index* const c = corners(element, block);
        if (is_face(shape)) {
            marker.edges.push_back({c[local[0]], c[local[1]]});
            return;
        }
        group.elements.push_back(static_cast<Index>(volume_.mesh.elements.size()));
        volume_.mesh.elements.push_back(
            {c[local[0]], c[local[1]], c[local[2]], local.size() == 4 ? c[local[3]] : -1});
    }

    /// Boundary edges between nodes of the set are a marker, where they take in all of its nodes. A set of
    /// all nodes has no information.
    void add_node_set(const AbaqusSets::Set& set)
    {
        const std::string name = full_name(set.name);
        const bool all = static_cast<Eigen::Index>(set.members.size()) == volume_.mesh.points.rows();
        if (all || find_marker(volume_.mesh.markers, name) || has_group(name) || !volume_.cells.empty())
            return;
        std::vector<bool> in_set(static_cast<std::size_t>(volume_.mesh.points.rows()), false);
        for (const Index node : set.members)
            in_set[static_cast<std::size_t>(node)] = true;
        Marker marker{name, {}};
        for (const auto& [a, b] : boundary_edges())
            if (in_set[static_cast<std::size_t>(a)] && in_set[static_cast<std::size_t>(b)])
                marker.edges.push_back({a, b});
        std::unordered_set<Index> reached;
        for (const auto& [a, b] : marker.edges)
            reached.insert({a, b});
        if (reached.size() == set.members.size() && !marker.edges.empty())
            volume_.mesh.markers.push_back(std::move(marker));
        else
            input_.warn("the set of nodes " + quoted_text(set.name) +
                        " is not made of boundary edges and was left out");
    }

    bool has_group(const std::string& name) const
    {
        const std::vector<ElementGroup>& groups = volume_.mesh.groups;
        return std::any_of(groups.begin(), groups.end(),
                           [&](const ElementGroup& group) { return group.name == name; });
    }

    /// Edges of one element only, in its direction.
    const std::vector<std::array<Index, 2>>& boundary_edges()
    {
        if (!boundary_.empty())
            return boundary_;
        std::unordered_set<std::uint64_t> single;
        const auto for_each_edge = [&](const auto& visit) {
            for (const Element& element : volume_.mesh.elements)
                for (int k = 0, n = corner_count(element); k < n; ++k)
                    visit(element[static_cast<std::size_t>(k)],
                          element[static_cast<std::size_t>((k + 1) % n)]);
        };
        for_each_edge([&](Index a, Index b) {
            if (!single.insert(edge_key(a, b)).second)
                single.erase(edge_key(a, b));
        });
        for_each_edge([&](Index a, Index b) {
            if (single.count(edge_key(a, b)) != 0)
                boundary_.push_back({a, b});
        });
        return boundary_;
    }

    AbaqusModel model_;
    const InputBytes& input_;
    TextScanner in_;
    VolumeFile volume_;
    std::vector<Index> first_face_; ///< of each block, the element that its first one is
    std::vector<bool> in_set_;      ///< for each element of the file
    std::vector<std::array<Index, 2>> boundary_;
};

} // namespace

MeshData abaqus_mesh(AbaqusModel model, const InputBytes& input)
{
    return MeshMaker(std::move(model), input).make();
}

} // namespace morph
