#pragma once

#include "tests/support/process.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace morph::test {

/// Writes small CGNS files with libcgns itself, node by node, for tests of our reader. Numbers are those of
/// the format, from 1. Every function throws std::logic_error when libcgns refuses.
class CgnsBuilder {
public:
    /// @param type  CG_FILE_HDF5 or CG_FILE_ADF
    explicit CgnsBuilder(int cell_dimension = 2, int physical_dimension = 2, int type = 2);

    int file() const { return file_; }

    /// @param size  as cg_zone_write() takes it
    void unstructured_zone(const std::string& name, int vertices, int cells);
    void structured_zone(const std::string& name, const std::vector<int>& vertices);

    /// The corners of an nx x ny grid of unit squares, i fastest; z = 0 is left out in the plane.
    void grid_points(int nx, int ny);
    void points(const std::vector<std::array<float, 3>>& xyz);

    void section(const std::string& name, int type, int first, int last, const std::vector<int>& corners);
    void mixed_section(const std::string& name, int type, int first, int last,
                       const std::vector<int>& numbers, const std::vector<int>& offsets);

    /// @param kind, location  a PointSetType_t and a GridLocation_t
    void boundary(const std::string& name, int kind, int location, const std::vector<int>& points, int count,
                  const std::string& family = "");

    /// @param location  Vertex or CellCenter; the arrays follow with field()
    int solution(const std::string& name, int location);
    void field(int solution, const std::string& name, const std::vector<double>& values);

    /// The bytes of the finished file.
    std::string bytes();

    /// The same, with the version of the file set to another.
    std::string bytes_of_version(float version);

private:
    std::unique_ptr<TemporaryFolder> folder_ = std::make_unique<TemporaryFolder>();
    std::string path_;
    int file_ = 0;
    int zone_ = 0;
    int physical_dimension_;
};

} // namespace morph::test
