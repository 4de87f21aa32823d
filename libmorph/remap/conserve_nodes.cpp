#include "libmorph/remap/conserve.h"

#include "libmorph/core/parallel.h"
#include "libmorph/remap/corner_weights.h"
#include "libmorph/remap/mass_matrix.h"
#include "libmorph/remap/mesh_area.h"
#include "libmorph/remap/overlaps.h"

#include <algorithm>

namespace morph {

namespace {

/// Integrals over what the source covers of one target element, between its corners: of phi_i phi_j, of
/// phi_i, and of phi_i times the source.
struct ElementIntegrals {
    std::array<double, 16> mass{};
    std::array<double, 4> lumped{};
    double area = 0;   ///< of the element
    double common = 0; ///< covered
};

/// Barycentric coordinates in a triangle, relative to the origin of its polygon.
std::array<double, 3> coordinates_in(const ElementPart& part, PlanePoint p)
{
    const auto corner = part.polygon.corners();
    return barycentric(corner[0], corner[1], corner[2], p);
}

/// Integrates over the pieces of one target element after the other.
class Integrator {
public:
    Integrator(const Mesh& source, const Matrix& values, std::vector<ElementIntegrals>& integrals,
               Matrix& loads)
        : source_(source), values_(values), integrals_(integrals), loads_(loads)
    {
    }

    void add(const TargetOverlaps& found) const
    {
        ElementIntegrals& sums = integrals_[static_cast<std::size_t>(found.target)];
        for (int i = 0; i < found.parts->count; ++i)
            sums.area += area(found.parts->part[static_cast<std::size_t>(i)].polygon);
        for (const Overlap& overlap : found.overlaps) {
            const auto corner = overlap.piece.corners();
            for (std::size_t k = 2; k < corner.size(); ++k)
                add_triangle(found.target, overlap, {corner[0], corner[k - 1], corner[k]});
        }
    }

private:
    /// The rule of the three midpoints, exact for the products of linear functions.
    void add_triangle(Index target, const Overlap& overlap, const std::array<PlanePoint, 3>& corner) const
    {
        ConvexPolygon triangle;
        for (const PlanePoint p : corner)
            triangle.add(p);
        const double third = area(triangle) / 3;
        ElementIntegrals& sums = integrals_[static_cast<std::size_t>(target)];
        sums.common += 3 * third;
        const Element source_corners = element_corners(source_, overlap.source);
        for (std::size_t k = 0; k < 3; ++k) {
            const PlanePoint a = corner[k], b = corner[(k + 1) % 3];
            const PlanePoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
            const auto phi = coordinates_in(*overlap.target_part, middle);
            const auto psi = coordinates_in(overlap.source_part, middle);
            Eigen::RowVectorXd value = Eigen::RowVectorXd::Zero(values_.cols());
            for (std::size_t s = 0; s < 3; ++s)
                value += psi[s] *
                         values_.row(source_corners[static_cast<std::size_t>(overlap.source_part.corner[s])]);
            add_point(sums, target, overlap.target_part->corner, phi, third, value);
        }
    }

    void add_point(ElementIntegrals& sums, Index target, const std::array<int, 4>& corner,
                   const std::array<double, 3>& phi, double weight, const Eigen::RowVectorXd& value) const
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = static_cast<std::size_t>(corner[i]);
            sums.lumped[row] += weight * phi[i];
            loads_.row(4 * static_cast<Eigen::Index>(target) + corner[i]) += weight * phi[i] * value;
            for (std::size_t j = 0; j < 3; ++j)
                sums.mass[4 * row + static_cast<std::size_t>(corner[j])] += weight * phi[i] * phi[j];
        }
    }

    const Mesh& source_;
    const Matrix& values_;
    std::vector<ElementIntegrals>& integrals_;
    Matrix& loads_; ///< 4 rows for each element
};

/// The integrals put together at the vertices.
struct Assembled {
    MassMatrix mass;
    Matrix loads;
    std::vector<double> lumped;
    std::vector<Index> uncovered;
};

/// Add an entry to those of a row, which are few.
void add_entry(std::vector<MassEntry>& row, Index column, double value)
{
    const auto found =
        std::find_if(row.begin(), row.end(), [column](const MassEntry& e) { return e.column == column; });
    if (found == row.end())
        row.push_back({column, value});
    else
        found->value += value;
}

Assembled assemble(const Mesh& target, const std::vector<ElementIntegrals>& integrals,
                   const Matrix& element_loads)
{
    constexpr double kCovered = 1e-10; // of what a vertex would have: less carries no information
    Assembled all;
    all.loads = Matrix::Zero(vertex_count(target), element_loads.cols());
    std::vector<MassEntry> row;
    for (const VertexHandle v : target.kernel.vertices()) {
        row.clear();
        double whole = 0, lumped = 0;
        for (const FaceHandle f : target.kernel.vf_range(v)) {
            const Element element = element_corners(target, f.idx());
            const ElementIntegrals& of_element = integrals[static_cast<std::size_t>(f.idx())];
            const auto k = static_cast<std::size_t>(std::find(element.begin(), element.end(), v.idx()) -
                                                    element.begin());
            whole += of_element.area / corner_count(element);
            lumped += of_element.lumped[k];
            all.loads.row(v.idx()) +=
                element_loads.row(4 * static_cast<Eigen::Index>(f.idx()) + static_cast<Eigen::Index>(k));
            for (std::size_t j = 0; j < static_cast<std::size_t>(corner_count(element)); ++j)
                add_entry(row, element[j], of_element.mass[4 * k + j]);
        }
        all.lumped.push_back(lumped);
        if (lumped <= kCovered * whole) {
            all.uncovered.push_back(v.idx());
            all.loads.row(v.idx()).setZero();
            row.clear();
        }
        all.mass.add_row(row);
    }
    return all;
}

} // namespace

ConservedValues conserve_nodal_values(const Locator& source, const Mesh& target, const Matrix& values)
{
    std::vector<ElementIntegrals> integrals(static_cast<std::size_t>(element_count(target)));
    Matrix loads = Matrix::Zero(4 * static_cast<Eigen::Index>(element_count(target)), values.cols());
    const Integrator integrator(source.source(), values, integrals, loads);
    for_each_overlap(source, target, Parts::triangles,
                     [&](const TargetOverlaps& found) { integrator.add(found); });

    ConservedValues result;
    result.area.source = mesh_area(source.source());
    for (const ElementIntegrals& element : integrals) {
        result.area.common += element.common;
        result.area.target += element.area;
    }
    Assembled all = assemble(target, integrals, loads);
    result.source_integral = all.loads.colwise().sum();
    // A lumped projection is a start from which few steps are left.
    Matrix start = all.loads;
    for (Eigen::Index v = 0; v < start.rows(); ++v)
        if (all.loads.row(v).any())
            start.row(v) /= all.lumped[static_cast<std::size_t>(v)];
    result.values = all.mass.solve(all.loads, std::move(start));
    result.target_integral = Eigen::RowVectorXd::Zero(values.cols());
    for (Eigen::Index v = 0; v < result.values.rows(); ++v)
        result.target_integral += all.lumped[static_cast<std::size_t>(v)] * result.values.row(v);
    result.uncovered = std::move(all.uncovered);
    return result;
}

} // namespace morph
