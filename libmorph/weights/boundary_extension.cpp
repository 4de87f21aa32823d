#include "libmorph/weights/boundary_extension.h"

#include "libmorph/core/error.h"

#include <cassert>
#include <string>

namespace morph {

BoundaryExtension::BoundaryExtension(const DomainView& domain, const DirichletBoundary& boundary,
                                     int components)
    : held_(domain, boundary), components_(components)
{
}

Matrix BoundaryExtension::extend(const Matrix& values) const
{
    if (components_ != 1 && values.cols() != components_)
        throw InputError("the values on the boundary have " + std::to_string(values.cols()) +
                         " columns, but vectors of " + std::to_string(components_) +
                         " components are extended");
    const Matrix joined = held_.join(values);
    Matrix result = solve(joined);
    assert(result.rows() == static_cast<Eigen::Index>(held_.representatives().size()));
    assert(result.cols() == values.cols());
    held_.restore(joined, result);
    return result;
}

} // namespace morph
