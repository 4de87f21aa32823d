#include "libmorph/remesh/corner_table_mesh.h"

#include "libmorph/remesh/features.h"
#include "libmorph/remesh/keep_numbering.h"

#include <algorithm>
#include <set>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

class MeshMaker {
public:
    MeshMaker(const RemeshState& state, const CornerTable& before, const Mesh& mesh,
              const std::vector<bool>& kept, NumberingRule rule)
        : state_(state), table_(state.table), before_(before), mesh_(mesh), kept_(kept), rule_(rule)
    {
    }

    RemeshResult run()
    {
        number_vertices();
        result_.data.dimension = mesh_.dimension;
        add_elements();
        add_markers();
        result_.data.sections = mesh_.sections;
        return std::move(result_);
    }

private:
    Index file_number(Index mesh_vertex) const { return mesh_.numbering.vertex[at(mesh_vertex)]; }

    void add_vertex(Index file, const Eigen::Vector3d& point, Index below)
    {
        if (file >= 0 && of_file_[at(file)] >= 0)
            return;
        if (file >= 0)
            of_file_[at(file)] = static_cast<Index>(points_.size());
        points_.push_back(point);
        below_.push_back(below);
        wishes_.push_back(rule_ == NumberingRule::keep_old ? file : -1);
    }

    void number_vertices()
    {
        of_file_.assign(at(mesh_.numbering.file_vertices), -1);
        const auto positions = points(mesh_);
        for (Index f = 0; f < element_count(mesh_); ++f)
            if (kept_[at(f)])
                for (const Index v : element_corners(mesh_, f))
                    if (v >= 0)
                        add_vertex(file_number(v), positions.row(v), -1);
        of_table_.assign(table_.vertices.size(), -1);
        for (std::size_t v = 0; v < table_.vertices.size(); ++v) {
            const TableVertex& vertex = table_.vertices[v];
            if (vertex.out < 0)
                continue;
            const Index file = vertex.origin < 0 ? -1 : file_number(vertex.origin);
            add_vertex(file, vertex.point, vertex.below);
            of_table_[v] = file >= 0 ? of_file_[at(file)] : static_cast<Index>(points_.size()) - 1;
        }
        const std::vector<Index> number = kept_numbers(wishes_);
        const auto renumber = [&](Index& v) { v = v < 0 ? v : number[at(v)]; };
        std::for_each(of_file_.begin(), of_file_.end(), renumber);
        std::for_each(of_table_.begin(), of_table_.end(), renumber);
        result_.data.points.resize(static_cast<Eigen::Index>(points_.size()), 3);
        result_.below.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            result_.data.points.row(number[i]) = points_[i];
            result_.below[at(number[i])] = below_[i];
        }
    }

    void add_elements()
    {
        std::vector<Element> elements;
        std::vector<Index> wishes;
        std::vector<std::pair<Index, Index>> kept_in_file; // file number, face
        for (Index f = 0; f < element_count(mesh_); ++f)
            if (kept_[at(f)])
                kept_in_file.emplace_back(mesh_.numbering.element[at(f)], f);
        std::sort(kept_in_file.begin(), kept_in_file.end());
        for (const auto& [file, f] : kept_in_file) {
            Element element = element_corners(mesh_, f);
            for (Index& v : element)
                v = v < 0 ? v : of_file_[at(file_number(v))];
            elements.push_back(element);
            wishes.push_back(rule_ == NumberingRule::keep_old ? file : -1);
        }
        for (Index t = 0; t < table_.triangle_slots(); ++t)
            if (table_.alive(t)) {
                elements.push_back({of_table_[at(table_.corner(t, 0))], of_table_[at(table_.corner(t, 1))],
                                    of_table_[at(table_.corner(t, 2))], -1});
                wishes.push_back(-1);
            }
        const std::vector<Index> number = kept_numbers(wishes);
        result_.data.elements.resize(elements.size());
        for (std::size_t i = 0; i < elements.size(); ++i)
            result_.data.elements[at(number[i])] = elements[i];
    }

    /// The halfedges along each curve, in order of its parameter.
    void order_curves()
    {
        along_.resize(state_.curves.size());
        for (Index h = 0; h < static_cast<Index>(table_.from.size()); ++h) {
            const Index mark = table_.tag[at(h)];
            if (table_.from[at(h)] < 0 || mark < 0 || mark == kKeptTag ||
                (table_.twin[at(h)] >= 0 && mark % 2 == 1))
                continue;
            const auto u = edge_parameters(state_, h);
            std::array<Index, 2> edge{of_table_[at(table_.from[at(h)])], of_table_[at(table_.to(h))]};
            if (mark % 2 == 1)
                std::swap(edge[0], edge[1]);
            along_[at(mark / 2)].push_back({std::min(u[0], u[1]), edge});
        }
        for (auto& edges : along_)
            std::sort(edges.begin(), edges.end());
    }

    void add_markers()
    {
        order_curves();
        const TableEdges find(before_, vertex_count(mesh_));
        for (const Marker& old : mesh_.markers) {
            Marker marker{old.name, {}};
            std::set<Index> done;
            for (const auto& [a, b] : old.edges) {
                const Index h = find.find(a, b);
                const Index mark = h < 0 ? kKeptTag : before_.tag[at(h)];
                if (mark == kKeptTag)
                    marker.edges.push_back({of_file_[at(file_number(a))], of_file_[at(file_number(b))]});
                else if (done.insert(mark / 2).second)
                    add_curve(marker, mark / 2,
                              (before_.vertices[at(before_.from[at(h)])].origin == a) == (mark % 2 == 0));
            }
            result_.data.markers.push_back(std::move(marker));
        }
    }

    void add_curve(Marker& marker, Index curve, bool along) const
    {
        const auto& edges = along_[at(curve)];
        if (along)
            for (const auto& [u, edge] : edges)
                marker.edges.push_back(edge);
        else
            for (auto it = edges.rbegin(); it != edges.rend(); ++it)
                marker.edges.push_back({it->second[1], it->second[0]});
    }

    const RemeshState& state_;
    const CornerTable& table_;
    const CornerTable& before_;
    const Mesh& mesh_;
    const std::vector<bool>& kept_;
    NumberingRule rule_;
    RemeshResult result_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<Index> below_, wishes_;
    std::vector<Index> of_file_, of_table_; ///< number in the result
    std::vector<std::vector<std::pair<double, std::array<Index, 2>>>> along_;
};

} // namespace

CornerTable corner_table_of(const Mesh& mesh, const std::vector<bool>& kept)
{
    const auto positions = points(mesh);
    std::vector<Index> number(at(vertex_count(mesh)), -1);
    std::vector<bool> fixed(number.size(), false);
    std::vector<std::array<Index, 3>> triangles;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element element = element_corners(mesh, f);
        for (const Index v : element)
            if (v >= 0 && kept[at(f)])
                fixed[at(v)] = true;
        if (!kept[at(f)])
            triangles.push_back({element[0], element[1], element[2]});
    }
    for (const auto& triangle : triangles)
        for (const Index v : triangle)
            number[at(v)] = 0;
    std::vector<TableVertex> vertices;
    for (std::size_t v = 0; v < number.size(); ++v)
        if (number[v] == 0) {
            number[v] = static_cast<Index>(vertices.size());
            TableVertex vertex;
            vertex.point = positions.row(static_cast<Index>(v));
            vertex.origin = static_cast<Index>(v);
            vertex.curve = fixed[v] ? kFixedVertex : kFreeVertex;
            vertices.push_back(vertex);
        }
    for (auto& triangle : triangles)
        for (Index& v : triangle)
            v = number[at(v)];
    CornerTable table(std::move(vertices), triangles);
    for (std::size_t h = 0; h < table.from.size(); ++h) {
        const auto half = static_cast<Index>(h);
        if (table.twin[h] >= 0)
            continue;
        const Index a = table.vertices[at(table.from[h])].origin,
                    b = table.vertices[at(table.to(half))].origin;
        const HalfedgeHandle edge = mesh.kernel.find_halfedge(VertexHandle(a), VertexHandle(b));
        if (mesh.kernel.face_handle(mesh.kernel.opposite_halfedge_handle(edge)).is_valid())
            table.tag[h] = kKeptTag;
    }
    for (TableVertex& vertex : table.vertices)
        vertex.below = vertex.out / 3;
    return table;
}

RemeshResult mesh_of(const RemeshState& state, const CornerTable& before, const Mesh& mesh,
                     const std::vector<bool>& kept, NumberingRule rule)
{
    return MeshMaker(state, before, mesh, kept, rule).run();
}

} // namespace morph
