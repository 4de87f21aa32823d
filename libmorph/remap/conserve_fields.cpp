#include "libmorph/remap/conserve_fields.h"

#include "libmorph/core/error.h"

namespace morph {

ConservedFields conserve_fields(const Locator& source, const Mesh& target,
                                std::span<const Field* const> fields)
{
    if (element_count(target) == 0)
        throw InputError("integrals are kept between meshes, but the target has no elements");
    // Side by side in one matrix, so that the meshes are clipped against each other once.
    Eigen::Index columns = 0;
    for (const Field* field : fields)
        columns += field->values.cols();
    Matrix values(fields.front()->values.rows(), columns);
    for (Eigen::Index first = 0; const Field* field : fields) {
        values.middleCols(first, field->values.cols()) = field->values;
        first += field->values.cols();
    }
    const bool nodal = fields.front()->location == FieldLocation::vertex;
    ConservedValues carried = nodal ? conserve_nodal_values(source, target, values)
                                    : conserve_element_values(source, target, values);
    if (!(carried.area.common > 0))
        throw InputError("source and target have no area in common");

    ConservedFields result;
    result.summary.area = carried.area;
    result.summary.uncovered = carried.uncovered.size();
    result.uncovered = std::move(carried.uncovered);
    for (Eigen::Index first = 0; const Field* field : fields) {
        const Eigen::Index count = field->values.cols();
        result.values.emplace_back(carried.values.middleCols(first, count));
        result.summary.fields.push_back({field->name, carried.source_integral.segment(first, count),
                                         carried.target_integral.segment(first, count)});
        first += count;
    }
    return result;
}

} // namespace morph
