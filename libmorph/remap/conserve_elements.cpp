#include "libmorph/remap/conserve.h"

#include "libmorph/remap/mesh_area.h"
#include "libmorph/remap/overlaps.h"

namespace morph {

ConservedValues conserve_element_values(const Locator& source, const Mesh& target, const Matrix& values)
{
    constexpr double kCovered = 1e-12; // of an element's area: less is rounding at a side that only touches
    const auto elements = static_cast<std::size_t>(element_count(target));
    ConservedValues result;
    result.values = Matrix::Zero(element_count(target), values.cols());
    std::vector<double> covered(elements), areas(elements);
    for_each_overlap(source, target, Parts::convex, [&](const TargetOverlaps& found) {
        const auto t = static_cast<std::size_t>(found.target);
        for (int i = 0; i < found.parts->count; ++i)
            areas[t] += area(found.parts->part[static_cast<std::size_t>(i)].polygon);
        auto sum = result.values.row(found.target);
        for (const Overlap& overlap : found.overlaps) {
            const double common = area(overlap.piece);
            covered[t] += common;
            sum += common * values.row(overlap.source);
        }
        if (covered[t] > kCovered * areas[t])
            return;
        covered[t] = 0;
        sum.setZero();
    });

    result.source_integral = Eigen::RowVectorXd::Zero(values.cols());
    result.target_integral = Eigen::RowVectorXd::Zero(values.cols());
    result.area.source = mesh_area(source.source());
    for (std::size_t t = 0; t < elements; ++t) {
        const auto row = static_cast<Index>(t);
        result.area.common += covered[t];
        result.area.target += areas[t];
        if (covered[t] == 0) {
            result.uncovered.push_back(row);
            continue;
        }
        result.source_integral += result.values.row(row);
        result.values.row(row) /= covered[t];
        result.target_integral += covered[t] * result.values.row(row);
    }
    return result;
}

} // namespace morph
