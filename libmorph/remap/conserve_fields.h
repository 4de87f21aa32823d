#pragma once

#include "libmorph/remap/locate.h"

#include <span>
#include <string>
#include <vector>

namespace morph {

/// What came of keeping the integrals of fields. Areas in length unit squared, of elements that each count as
/// positive.
struct Conservation {
    struct Integrals {
        std::string field;
        Eigen::RowVectorXd source; ///< over the common region
        Eigen::RowVectorXd target;
    };
    double common_area = 0;
    double source_area = 0;
    double target_area = 0;
    std::size_t uncovered = 0; ///< elements (nodal fields: vertices) of the target that nothing covers
    std::vector<Integrals> fields;
};

/// Fields of one location transferred together, see conserve_cells() and conserve_nodes().
struct ConservedFields {
    std::vector<Matrix> values;   ///< for each field, rows of the target
    std::vector<Index> uncovered; ///< rows to be filled from elsewhere, ascending
    Conservation summary;
};

/// @param source  planar mesh of the fields
/// @param target  planar mesh that gets them
/// @param fields  all nodal, or all of elements
/// @throws InputError  a surface in space, a target without elements, no area in common
/// @throws SolverError  see conserve_nodes()
ConservedFields conserve_fields(const Locator& source, const Mesh& target,
                                std::span<const Field* const> fields);

} // namespace morph
