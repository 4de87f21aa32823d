#include "formats/cgns/writer.h"

#include "formats/cgns/fields.h"
#include "formats/cgns/file.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>

#include <cgnslib.h>

namespace morph {

namespace {

constexpr int kBase = 1;
constexpr int kZone = 1;

void require(int status)
{
    if (status != CG_OK)
        throw SolverError(std::string("libcgns cannot write the mesh: ") + cg_get_error());
}

bool all_of_corners(const std::vector<Element>& elements, int corners)
{
    return std::all_of(elements.begin(), elements.end(),
                       [&](const Element& element) { return corner_count(element) == corners; });
}

class CgnsWriter {
public:
    explicit CgnsWriter(const MeshData& mesh) : mesh_(mesh) {}

    void write(const std::string& path)
    {
        require(cg_set_file_type(CG_FILE_HDF5));
        require(cg_open(path.c_str(), CG_MODE_WRITE, &file_));
        int number = 0;
        require(cg_base_write(file_, "Base", 2, mesh_.dimension, &number));
        if (mesh_.points.rows() > 0)
            write_zone();
        require(cg_close(file_));
    }

private:
    void write_zone()
    {
        const std::array<cgsize_t, 3> size{static_cast<cgsize_t>(mesh_.points.rows()),
                                           static_cast<cgsize_t>(mesh_.elements.size()), 0};
        int number = 0;
        require(cg_zone_write(file_, kBase, "Zone", size.data(), CGNS_ENUMV(Unstructured), &number));
        write_points();
        write_elements();
        for (const Marker& marker : mesh_.markers)
            write_marker(marker);
        for (const ElementGroup& group : mesh_.groups)
            if (!group.elements.empty())
                write_group(group);
        write_fields(FieldLocation::vertex);
        if (!mesh_.elements.empty())
            write_fields(FieldLocation::element);
    }

    void write_points()
    {
        std::vector<double> values(static_cast<std::size_t>(mesh_.points.rows()));
        for (int axis = 0; axis < mesh_.dimension; ++axis) {
            Eigen::Map<Eigen::VectorXd>(values.data(), mesh_.points.rows()) = mesh_.points.col(axis);
            int number = 0;
            require(cg_coord_write(file_, kBase, kZone, CGNS_ENUMV(RealDouble),
                                   (std::string("Coordinate") + "XYZ"[axis]).c_str(), values.data(),
                                   &number));
        }
    }

    /// In their order, whatever they are: of one type as such, otherwise each with its type.
    void write_elements()
    {
        const auto count = static_cast<cgsize_t>(mesh_.elements.size());
        if (count == 0)
            return;
        const bool triangles = all_of_corners(mesh_.elements, 3);
        const bool mixed = !triangles && !all_of_corners(mesh_.elements, 4);
        std::vector<cgsize_t> numbers;
        std::vector<cgsize_t> offsets{0};
        numbers.reserve(mesh_.elements.size() * (triangles ? 3 : mixed ? 5 : 4));
        for (const Element& element : mesh_.elements) {
            if (mixed)
                numbers.push_back(corner_count(element) == 3 ? CGNS_ENUMV(TRI_3) : CGNS_ENUMV(QUAD_4));
            for (int k = 0; k < corner_count(element); ++k)
                numbers.push_back(element[static_cast<std::size_t>(k)] + 1);
            if (mixed)
                offsets.push_back(static_cast<cgsize_t>(numbers.size()));
        }
        section_names_.emplace_back("Elements");
        int number = 0;
        if (mixed)
            require(cg_poly_section_write(file_, kBase, kZone, "Elements", CGNS_ENUMV(MIXED), 1, count, 0,
                                          numbers.data(), offsets.data(), &number));
        else
            require(cg_section_write(file_, kBase, kZone, "Elements",
                                     triangles ? CGNS_ENUMV(TRI_3) : CGNS_ENUMV(QUAD_4), 1, count, 0,
                                     numbers.data(), &number));
        last_element_ = count;
    }

    void write_marker(const Marker& marker)
    {
        int family = 0;
        const std::string name = write_family(marker.name, family);
        int number = 0;
        if (marker.edges.empty()) {
            require(
                cg_fambc_write(file_, kBase, family, kCgnsNoEdges, CGNS_ENUMV(BCTypeUserDefined), &number));
            return;
        }
        std::vector<cgsize_t> corners;
        for (const auto& [a, b] : marker.edges) {
            corners.push_back(a + 1);
            corners.push_back(b + 1);
        }
        const std::array<cgsize_t, 2> range{last_element_ + 1,
                                            last_element_ + static_cast<cgsize_t>(marker.edges.size())};
        require(cg_section_write(file_, kBase, kZone, cgns_node_name(name, section_names_).c_str(),
                                 CGNS_ENUMV(BAR_2), range[0], range[1], 0, corners.data(), &number));
        last_element_ = range[1];
        require(cg_boco_write(file_, kBase, kZone, name.c_str(), CGNS_ENUMV(FamilySpecified),
                              CGNS_ENUMV(PointRange), 2, range.data(), &number));
        require(cg_boco_gridlocation_write(file_, kBase, kZone, number, CGNS_ENUMV(EdgeCenter)));
        require(cg_goto(file_, kBase, "Zone_t", kZone, "ZoneBC_t", 1, "BC_t", number, "end"));
        require(cg_famname_write(name.c_str()));
    }

    void write_group(const ElementGroup& group)
    {
        int family = 0;
        const std::string name = write_family(group.name, family);
        std::vector<cgsize_t> numbers;
        numbers.reserve(group.elements.size());
        for (const Index e : group.elements)
            numbers.push_back(e + 1);
        int number = 0;
        require(cg_subreg_ptset_write(file_, kBase, kZone, name.c_str(), 2, CGNS_ENUMV(CellCenter),
                                      CGNS_ENUMV(PointList), static_cast<cgsize_t>(numbers.size()),
                                      numbers.data(), &number));
        require(cg_goto(file_, kBase, "Zone_t", kZone, "ZoneSubRegion_t", number, "end"));
        require(cg_famname_write(name.c_str()));
    }

    /// @return the name of its node, which no other family has
    std::string write_family(const std::string& name, int& number)
    {
        std::string node = cgns_node_name(name, family_names_);
        require(cg_family_write(file_, kBase, node.c_str(), &number));
        if (node != name) {
            require(cg_goto(file_, kBase, "Family_t", number, "end"));
            require(cg_descriptor_write(kCgnsLongName, cgns_encoded(name).c_str()));
        }
        return node;
    }

    void write_fields(FieldLocation location)
    {
        std::vector<const Field*> fields;
        for (const Field& field : mesh_.fields)
            if (field.location == location)
                fields.push_back(&field);
        if (fields.empty())
            return;
        const bool nodal = location == FieldLocation::vertex;
        int solution = 0;
        require(cg_sol_write(file_, kBase, kZone, nodal ? "VertexSolution" : "CellSolution",
                             nodal ? CGNS_ENUMV(Vertex) : CGNS_ENUMV(CellCenter), &solution));
        const auto names = cgns_array_names(fields);
        for (std::size_t f = 0; f < fields.size(); ++f)
            write_field(solution, *fields[f], names[f]);
        require(cg_goto(file_, kBase, "Zone_t", kZone, "FlowSolution_t", solution, "end"));
        require(cg_descriptor_write(kCgnsFieldTable, cgns_field_table(fields).c_str()));
    }

    void write_field(int solution, const Field& field, const std::vector<std::string>& names)
    {
        std::vector<double> values(static_cast<std::size_t>(field.values.rows()));
        for (std::size_t c = 0; c < names.size(); ++c) {
            Eigen::Map<Eigen::VectorXd>(values.data(), field.values.rows()) =
                field.values.col(static_cast<Eigen::Index>(c));
            int number = 0;
            require(cg_field_write(file_, kBase, kZone, solution, CGNS_ENUMV(RealDouble), names[c].c_str(),
                                   values.data(), &number));
        }
    }

    const MeshData& mesh_;
    int file_ = 0;
    cgsize_t last_element_ = 0; ///< number of the last element written
    std::vector<std::string> section_names_, family_names_;
};

} // namespace

void write_cgns(const MeshData& mesh, const std::string& path)
{
    CgnsWriter(mesh).write(path);
}

} // namespace morph
