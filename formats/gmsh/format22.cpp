// Version 2.2 of Gmsh's mesh format, which many solvers read and newer versions did not replace there.
// An element of several groups is repeated for each of them, as Gmsh does.
#include "formats/gmsh/cells.h"
#include "formats/gmsh/output.h"
#include "formats/gmsh/read.h"
#include "formats/gmsh/surfaces.h"

#include <algorithm>

namespace morph {

namespace {

class Gmsh22Writer {
public:
    Gmsh22Writer(const MeshData& mesh, GmshOutput& out)
        : mesh_(mesh), out_(out), surfaces_(gmsh_surfaces(mesh))
    {
        for (const Marker& marker : mesh.markers)
            lines_ += static_cast<std::int64_t>(marker.edges.size());
    }

    void write()
    {
        write_gmsh_header(out_, "2.2");
        write_gmsh_names(out_, mesh_, surfaces_.no_group);
        write_nodes();
        write_elements();
        write_gmsh_fields(out_, mesh_, faces_);
    }

private:
    void write_nodes()
    {
        out_.line("$Nodes\n" + std::to_string(mesh_.points.rows()));
        for (Eigen::Index v = 0; v < mesh_.points.rows(); ++v) {
            out_.begin_record();
            out_.integer(v + 1);
            for (int k = 0; k < 3; ++k)
                out_.real(mesh_.points(v, k));
            out_.end_record();
        }
        out_.end_numbers();
        out_.line("$EndNodes");
    }

    /// Of the physical groups.
    const std::vector<Index>& tags_of(std::size_t element) const
    {
        return surfaces_.tags[static_cast<std::size_t>(surfaces_.of_element[element])];
    }

    /// How often an element is written.
    std::size_t copies(std::size_t element) const
    {
        return std::max<std::size_t>(1, tags_of(element).size());
    }

    void write_elements()
    {
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            faces_.insert(faces_.end(), copies(e), static_cast<Index>(e));
        out_.line("$Elements\n" + std::to_string(lines_ + static_cast<std::int64_t>(faces_.size())));
        write_lines();
        for (std::size_t begin = 0, end = 0; begin < mesh_.elements.size(); begin = end) {
            std::int64_t rows = 0;
            for (; end < mesh_.elements.size() &&
                   corner_count(mesh_.elements[end]) == corner_count(mesh_.elements[begin]);
                 ++end)
                rows += static_cast<std::int64_t>(copies(end));
            begin_block(corner_count(mesh_.elements[begin]) == 3 ? kGmshTriangle : kGmshQuad, rows);
            for (std::size_t e = begin; e < end; ++e)
                write_face(e);
        }
        out_.end_numbers();
        out_.line("$EndElements");
    }

    /// Type and number of the elements that follow, and of their tags.
    void begin_block(int type, std::int64_t rows)
    {
        type_ = type;
        if (!out_.binary() || rows == 0)
            return;
        out_.begin_record();
        out_.integer(type);
        out_.integer(rows);
        out_.integer(kTags);
        out_.end_record();
    }

    void write_lines()
    {
        begin_block(kGmshLine, lines_);
        for (std::size_t m = 0; m < mesh_.markers.size(); ++m)
            for (const auto& edge : mesh_.markers[m].edges)
                write_row(static_cast<Index>(m) + 1, static_cast<Index>(m) + 1, edge.data(), 2);
    }

    void write_face(std::size_t e)
    {
        const std::vector<Index>& tags = tags_of(e);
        for (std::size_t copy = 0; copy < copies(e); ++copy)
            write_row(tags.empty() ? 0 : tags[copy], surfaces_.of_element[e] + 1, mesh_.elements[e].data(),
                      corner_count(mesh_.elements[e]));
    }

    void write_row(Index physical, Index entity, const Index* vertices, int count)
    {
        out_.begin_record();
        out_.integer(next_tag_++);
        if (!out_.binary()) {
            out_.integer(type_);
            out_.integer(kTags);
        }
        out_.integer(physical);
        out_.integer(entity);
        for (int k = 0; k < count; ++k)
            out_.integer(std::int64_t{vertices[k]} + 1);
        out_.end_record();
    }

    static constexpr int kTags = 2; ///< physical group and entity

    const MeshData& mesh_;
    GmshOutput& out_;
    GmshSurfaces surfaces_;
    std::int64_t lines_ = 0;
    std::int64_t next_tag_ = 1;
    std::vector<Index> faces_; ///< elements with their copies
    int type_ = 0;             ///< of the rows
};

void write_gmsh22(const MeshData& mesh, const WriteOptions& options, OutputFile& file)
{
    GmshOutput out(file, options.binary);
    Gmsh22Writer(mesh, out).write();
}

} // namespace

extern const Format gmsh22_format;

const Format gmsh22_format{
    .name = "gmsh22",
    .extensions = {".msh2"},
    .description = "Gmsh mesh of version 2.2",
    .holds = {.surface = true,
              .markers = true,
              .groups = true,
              .vertex_fields = true,
              .element_fields = true,
              .binary = true,
              .volume = true},
    .read = read_gmsh,
    .write = write_gmsh22,
};

} // namespace morph
