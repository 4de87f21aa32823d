#include "tests/support/cgns_builder.h"

#include <stdexcept>

#include <cgns_io.h>
#include <cgnslib.h>

namespace morph::test {

namespace {

void require(int status)
{
    if (status != CG_OK)
        throw std::logic_error(cg_get_error());
}

} // namespace

CgnsBuilder::CgnsBuilder(int cell_dimension, int physical_dimension, int type)
    : path_(folder_->file("built.cgns")), physical_dimension_(physical_dimension)
{
    require(cg_set_file_type(type));
    require(cg_open(path_.c_str(), CG_MODE_WRITE, &file_));
    int base = 0;
    require(cg_base_write(file_, "Base", cell_dimension, physical_dimension, &base));
}

void CgnsBuilder::unstructured_zone(const std::string& name, int vertices, int cells)
{
    const std::array<cgsize_t, 3> size{vertices, cells, 0};
    require(cg_zone_write(file_, 1, name.c_str(), size.data(), Unstructured, &zone_));
}

void CgnsBuilder::structured_zone(const std::string& name, const std::vector<int>& vertices)
{
    std::vector<cgsize_t> size(vertices.begin(), vertices.end());
    for (const int count : vertices)
        size.push_back(count - 1);
    size.resize(3 * vertices.size(), 0);
    require(cg_zone_write(file_, 1, name.c_str(), size.data(), Structured, &zone_));
}

void CgnsBuilder::grid_points(int nx, int ny)
{
    std::vector<std::array<float, 3>> xyz;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            xyz.push_back({static_cast<float>(i), static_cast<float>(j), 0});
    points(xyz);
}

void CgnsBuilder::points(const std::vector<std::array<float, 3>>& xyz)
{
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(physical_dimension_); ++axis) {
        std::vector<float> values;
        for (const auto& point : xyz)
            values.push_back(point[axis]);
        int number = 0;
        require(cg_coord_write(file_, 1, zone_, RealSingle, (std::string("Coordinate") + "XYZ"[axis]).c_str(),
                               values.data(), &number));
    }
}

void CgnsBuilder::section(const std::string& name, int type, int first, int last,
                          const std::vector<int>& corners)
{
    int number = 0;
    require(cg_section_write(file_, 1, zone_, name.c_str(), static_cast<ElementType_t>(type), first, last, 0,
                             corners.data(), &number));
}

void CgnsBuilder::mixed_section(const std::string& name, int type, int first, int last,
                                const std::vector<int>& numbers, const std::vector<int>& offsets)
{
    int number = 0;
    require(cg_poly_section_write(file_, 1, zone_, name.c_str(), static_cast<ElementType_t>(type), first,
                                  last, 0, numbers.data(), offsets.data(), &number));
}

void CgnsBuilder::boundary(const std::string& name, int kind, int location, const std::vector<int>& points,
                           int count, const std::string& family)
{
    int number = 0;
    require(cg_boco_write(file_, 1, zone_, name.c_str(), BCWall, static_cast<PointSetType_t>(kind), count,
                          points.data(), &number));
    if (kind == PointList || kind == PointRange)
        require(cg_boco_gridlocation_write(file_, 1, zone_, number, static_cast<GridLocation_t>(location)));
    if (family.empty())
        return;
    require(cg_goto(file_, 1, "Zone_t", zone_, "ZoneBC_t", 1, "BC_t", number, "end"));
    require(cg_famname_write(family.c_str()));
}

int CgnsBuilder::solution(const std::string& name, int location)
{
    int number = 0;
    require(cg_sol_write(file_, 1, zone_, name.c_str(), static_cast<GridLocation_t>(location), &number));
    return number;
}

void CgnsBuilder::field(int solution, const std::string& name, const std::vector<double>& values)
{
    int number = 0;
    require(cg_field_write(file_, 1, zone_, solution, RealDouble, name.c_str(), values.data(), &number));
}

std::string CgnsBuilder::bytes()
{
    if (file_ != 0)
        require(cg_close(file_));
    file_ = 0;
    return read_text(path_);
}

std::string CgnsBuilder::bytes_of_version(float version)
{
    bytes();
    int file = 0;
    double root = 0;
    double node = 0;
    require(cgio_open_file(path_.c_str(), CGIO_MODE_MODIFY, CGIO_FILE_NONE, &file));
    require(cgio_get_root_id(file, &root));
    require(cgio_get_node_id(file, root, "CGNSLibraryVersion", &node));
    require(cgio_write_all_data(file, node, &version));
    require(cgio_close_file(file));
    return bytes();
}

} // namespace morph::test
