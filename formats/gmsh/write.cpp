#include "formats/gmsh/write.h"

#include "formats/gmsh/cells.h"
#include "formats/gmsh/output.h"
#include "formats/gmsh/surfaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace morph {

namespace {

std::int64_t line_count(const MeshData& mesh)
{
    std::int64_t count = 0;
    for (const Marker& marker : mesh.markers)
        count += static_cast<std::int64_t>(marker.edges.size());
    return count;
}

std::size_t corners_of(const Element& element)
{
    return static_cast<std::size_t>(corner_count(element));
}

int type_of(const Element& element)
{
    return corner_count(element) == 3 ? kGmshTriangle : kGmshQuad;
}

class GmshWriter {
public:
    GmshWriter(const MeshData& mesh, GmshOutput& out) : mesh_(mesh), out_(out), surfaces_(gmsh_surfaces(mesh))
    {
        if (surfaces_.tags.empty()) // somewhere the nodes have to be
            surfaces_.tags.emplace_back();
    }

    void write()
    {
        write_gmsh_header(out_, "4.1");
        write_gmsh_names(out_, mesh_, surfaces_.no_group);
        write_entities();
        write_nodes();
        write_elements();
        std::vector<Index> faces(mesh_.elements.size());
        std::iota(faces.begin(), faces.end(), 0);
        write_gmsh_fields(out_, mesh_, faces);
    }

private:
    using Box = Eigen::AlignedBox3d;

    void record(std::initializer_list<std::int64_t> integers, std::initializer_list<std::int64_t> sizes)
    {
        out_.begin_record();
        for (const std::int64_t value : integers)
            out_.integer(value);
        for (const std::int64_t value : sizes)
            out_.size(value);
        out_.end_record();
    }

    template <std::size_t N>
    void extend(Box& box, const std::array<Index, N>& vertices, std::size_t count) const
    {
        for (std::size_t k = 0; k < count; ++k)
            box.extend(mesh_.points.row(vertices[k]).transpose());
    }

    void write_entities()
    {
        std::vector<Box> boxes(surfaces_.tags.size());
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            extend(boxes[static_cast<std::size_t>(surfaces_.of_element[e])], mesh_.elements[e],
                   corners_of(mesh_.elements[e]));
        out_.line("$Entities");
        record({}, {0, static_cast<std::int64_t>(mesh_.markers.size()),
                    static_cast<std::int64_t>(boxes.size()), 0});
        for (std::size_t m = 0; m < mesh_.markers.size(); ++m) {
            Box box;
            for (const auto& edge : mesh_.markers[m].edges)
                extend(box, edge, 2);
            write_entity(m + 1, box, {static_cast<Index>(m) + 1});
        }
        for (std::size_t s = 0; s < boxes.size(); ++s)
            write_entity(s + 1, boxes[s], surfaces_.tags[s]);
        out_.end_numbers();
        out_.line("$EndEntities");
    }

    /// Tag, box, physical groups and, of no use here, entities around it.
    void write_entity(std::size_t tag, const Box& box, const std::vector<Index>& physicals)
    {
        out_.begin_record();
        out_.integer(static_cast<std::int64_t>(tag));
        for (const auto& corner : {box.min(), box.max()})
            for (const double x : corner)
                out_.real(box.isEmpty() ? 0 : x);
        out_.size(static_cast<std::int64_t>(physicals.size()));
        for (const Index physical : physicals) {
            out_.next_part();
            out_.integer(physical);
        }
        out_.size(0);
        out_.end_record();
    }

    void write_nodes()
    {
        const std::int64_t count = mesh_.points.rows();
        out_.line("$Nodes");
        record({}, {count > 0 ? 1 : 0, count, count > 0 ? 1 : 0, count});
        if (count > 0)
            record({2, 1, 0}, {count});
        for (std::int64_t v = 1; v <= count; ++v)
            record({}, {v});
        for (Eigen::Index v = 0; v < count; ++v) {
            out_.begin_record();
            for (int k = 0; k < 3; ++k)
                out_.real(mesh_.points(v, k));
            out_.end_record();
        }
        out_.end_numbers();
        out_.line("$EndNodes");
    }

    /// Behind the last element of the block that starts with element @p begin.
    std::size_t block_end(std::size_t begin) const
    {
        std::size_t end = begin;
        while (end < mesh_.elements.size() && surfaces_.of_element[end] == surfaces_.of_element[begin] &&
               type_of(mesh_.elements[end]) == type_of(mesh_.elements[begin]))
            ++end;
        return end;
    }

    std::int64_t block_count() const
    {
        std::int64_t blocks = std::count_if(mesh_.markers.begin(), mesh_.markers.end(),
                                            [](const Marker& marker) { return !marker.edges.empty(); });
        for (std::size_t e = 0; e < mesh_.elements.size(); e = block_end(e))
            ++blocks;
        return blocks;
    }

    void write_elements()
    {
        const std::int64_t total = line_count(mesh_) + static_cast<std::int64_t>(mesh_.elements.size());
        out_.line("$Elements");
        record({}, {block_count(), total, total > 0 ? 1 : 0, total});
        for (std::size_t m = 0; m < mesh_.markers.size(); ++m) {
            const auto& edges = mesh_.markers[m].edges;
            if (!edges.empty())
                record({1, static_cast<std::int64_t>(m) + 1, kGmshLine},
                       {static_cast<std::int64_t>(edges.size())});
            for (const auto& edge : edges)
                write_element(edge, 2);
        }
        for (std::size_t begin = 0, end = 0; begin < mesh_.elements.size(); begin = end) {
            end = block_end(begin);
            record({2, surfaces_.of_element[begin] + 1, type_of(mesh_.elements[begin])},
                   {static_cast<std::int64_t>(end - begin)});
            for (std::size_t e = begin; e < end; ++e)
                write_element(mesh_.elements[e], corners_of(mesh_.elements[e]));
        }
        out_.end_numbers();
        out_.line("$EndElements");
    }

    template <std::size_t N>
    void write_element(const std::array<Index, N>& vertices, std::size_t count)
    {
        out_.begin_record();
        out_.size(next_tag_++);
        for (std::size_t k = 0; k < count; ++k)
            out_.size(std::int64_t{vertices[k]} + 1);
        out_.end_record();
    }

    const MeshData& mesh_;
    GmshOutput& out_;
    GmshSurfaces surfaces_;
    std::int64_t next_tag_ = 1;
};

} // namespace

void write_gmsh(const MeshData& mesh, const WriteOptions& options, OutputFile& file)
{
    GmshOutput out(file, options.binary);
    GmshWriter(mesh, out).write();
}

} // namespace morph
