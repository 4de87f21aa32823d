#include "formats/ugrid/read.h"

#include "formats/mesh/volume_cells.h"
#include "formats/text/element_order.h"
#include "formats/text/numbered_names.h"
#include "formats/text/surface_text.h"
#include "formats/ugrid/names.h"
#include "formats/ugrid/numbers.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

UgridLayout layout_of(const InputBytes& file)
{
    const UgridLayout named = ugrid_layout_of_name(file.path);
    if (named.binary)
        return named;
    const auto found = ugrid_layout_of_bytes(file.bytes);
    if (!found)
        throw InputError(file.path +
                         ": is neither text nor as long as its counts say in any binary layout; name "
                         "the layout, as in x.b8.ugrid or x.lb8.ugrid");
    return *found;
}

class UgridReader {
public:
    explicit UgridReader(const InputBytes& file) : file_(file), layout_(layout_of(file)), in_(file, layout_)
    {
    }

    MeshData read()
    {
        counts_ = in_.counts();
        read_points();
        for (const std::size_t block : {0U, 1U})
            read_faces(block);
        for (const std::size_t block : {0U, 1U})
            read_references(block);
        for (std::size_t block = 2; block < kUgridBlocks.size(); ++block)
            read_cells(block);
        name_groups();
        file_.set_version(layout_.binary ? "binary (" + std::string(layout_.extension.substr(1)) + ")"
                                         : "text");
        return surface();
    }

private:
    void read_points()
    {
        Points& points = volume_.mesh.points;
        points.resize(counts_[0], 3);
        for (std::int64_t v = 0; v < counts_[0]; ++v)
            for (Eigen::Index k = 0; k < 3; ++k) {
                const std::size_t position = in_.position();
                if (!in_.try_real(points(v, k)))
                    in_.fail_expected("a coordinate of vertex " + std::to_string(v + 1));
                if (!std::isfinite(points(v, k)))
                    in_.fail_at(position,
                                "a coordinate of vertex " + std::to_string(v + 1) + " is not finite");
            }
        volume_.mesh.dimension = dimension_of(points);
    }

    Index read_corner(std::size_t block, std::int64_t i)
    {
        const auto owner = [&] {
            return std::string(kUgridBlocks.at(block).name) + " " + std::to_string(i + 1);
        };
        const std::size_t position = in_.position();
        std::int64_t number = 0;
        if (!in_.try_integer(number))
            in_.fail_expected("a vertex of " + owner());
        if (number < 1 || number > counts_[0])
            in_.fail_at(position, owner() + " names vertex " + std::to_string(number) + ", expected 1 to " +
                                      std::to_string(counts_[0]));
        return static_cast<Index>(number - 1);
    }

    void read_faces(std::size_t block)
    {
        std::vector<Element>& faces = faces_.at(block);
        faces.resize(static_cast<std::size_t>(counts_.at(block + 1)), {-1, -1, -1, -1});
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (std::size_t k = 0; k < kUgridBlocks.at(block).corners; ++k)
                faces[i].at(k) = read_corner(block, static_cast<std::int64_t>(i));
    }

    void read_references(std::size_t block)
    {
        std::vector<std::int64_t>& references = references_.at(block);
        references.resize(faces_.at(block).size());
        for (std::size_t i = 0; i < references.size(); ++i)
            if (!in_.try_integer(references[i]))
                in_.fail_expected("the surface of " + std::string(kUgridBlocks.at(block).name) + " " +
                                  std::to_string(i + 1));
    }

    void read_cells(std::size_t block)
    {
        // The quadrilateral of a pyramid is 1 4 5 2 in such a file, its apex 3.
        constexpr std::array<std::size_t, 5> pyramid{1, 0, 4, 2, 3};
        constexpr std::array<VolumeShape, 4> shapes{VolumeShape::tetrahedron, VolumeShape::pyramid,
                                                    VolumeShape::prism, VolumeShape::hexahedron};
        const VolumeShape shape = shapes.at(block - 2);
        volume_.cells.reserve(volume_.cells.size() + static_cast<std::size_t>(counts_.at(block + 1)));
        for (std::int64_t i = 0; i < counts_.at(block + 1); ++i) {
            VolumeCell cell{shape, {}};
            for (std::size_t k = 0; k < kUgridBlocks.at(block).corners; ++k)
                cell.corners.at(shape == VolumeShape::pyramid ? pyramid.at(k) : k) = read_corner(block, i);
            volume_.cells.push_back(cell);
        }
    }

    /// Join the faces, with the groups that the numbers of their surfaces say.
    void name_groups()
    {
        UgridNames names = read_ugrid_names_beside(file_.path);
        MeshData& mesh = volume_.mesh;
        std::vector<std::int64_t> references = join_faces(faces_, references_, names.text, mesh.elements);
        mesh.groups = groups_from(references, names.groups);
        mesh.sections = std::move(names.sections);
    }

    MeshData surface()
    {
        if (!volume_.cells.empty() && !file_.options.surface)
            file_.warn(std::to_string(volume_.cells.size()) +
                       " volume cell(s) were left out; the mesh is their boundary");
        InputBytes boundary = file_;
        boundary.options.surface = true;
        return surface_of(std::move(volume_), boundary);
    }

    const InputBytes& file_;
    UgridLayout layout_;
    UgridNumbers in_;
    UgridCounts counts_{};
    VolumeFile volume_;
    std::array<std::vector<Element>, 2> faces_; ///< triangles, quads
    std::array<std::vector<std::int64_t>, 2> references_;
};

} // namespace

MeshData read_ugrid(const InputBytes& file)
{
    return UgridReader(file).read();
}

} // namespace morph
