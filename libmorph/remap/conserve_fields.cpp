#include "libmorph/remap/conserve_fields.h"

#include "libmorph/core/error.h"
#include "libmorph/remap/conserve_cells.h"
#include "libmorph/remap/conserve_nodes.h"

namespace morph {

namespace {

/// The values of all fields side by side, so that the meshes are clipped against each other once.
Matrix side_by_side(std::span<const Field* const> fields)
{
    Eigen::Index columns = 0;
    for (const Field* field : fields)
        columns += field->values.cols();
    Matrix values(fields.front()->values.rows(), columns);
    for (Eigen::Index first = 0; const Field* field : fields) {
        values.middleCols(first, field->values.cols()) = field->values;
        first += field->values.cols();
    }
    return values;
}

/// The integral over the common region, by what is covered of each row's element or basis function.
Eigen::RowVectorXd integral_of(const Transfer& transfer)
{
    Eigen::RowVectorXd integral = Eigen::RowVectorXd::Zero(transfer.values.cols());
    for (Eigen::Index row = 0; row < transfer.values.rows(); ++row)
        integral += transfer.covered[static_cast<std::size_t>(row)] * transfer.values.row(row);
    return integral;
}

} // namespace

ConservedFields conserve_fields(const Locator& source, const Mesh& target,
                                std::span<const Field* const> fields)
{
    if (element_count(target) == 0)
        throw InputError("integrals are kept between meshes, but the target has no elements");
    const Matrix values = side_by_side(fields);
    const Transfer transfer = fields.front()->location == FieldLocation::vertex
                                  ? conserve_nodes(source, target, values)
                                  : conserve_cells(source, target, values);
    if (!(transfer.covered_area > 0))
        throw InputError("source and target have no area in common");

    ConservedFields result;
    for (std::size_t row = 0; row < transfer.covered.size(); ++row)
        if (transfer.covered[row] == 0)
            result.uncovered.push_back(static_cast<Index>(row));
    result.summary.common_area = transfer.covered_area;
    result.summary.source_area = transfer.source_area;
    result.summary.target_area = transfer.target_area;
    result.summary.uncovered = result.uncovered.size();
    const Eigen::RowVectorXd target_integral = integral_of(transfer);
    for (Eigen::Index first = 0; const Field* field : fields) {
        const Eigen::Index count = field->values.cols();
        result.values.emplace_back(transfer.values.middleCols(first, count));
        result.summary.fields.push_back({field->name, transfer.source_integral.segment(first, count),
                                         target_integral.segment(first, count)});
        first += count;
    }
    return result;
}

} // namespace morph
