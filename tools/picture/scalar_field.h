#pragma once

#include "libmorph/mesh/mesh.h"

#include <string>
#include <vector>

namespace morph::picture {

/// One number per vertex or element, to be shown as a colour.
struct ScalarField {
    std::string label;
    FieldLocation location = FieldLocation::vertex;
    Eigen::VectorXd values;
};

/// The field of that name (nodal before element); of several components their length, "|name|". The name
/// scaled_jacobian is computed when the mesh has no such field.
/// @throws InputError  there is none; lists those there are
ScalarField scalar_field(const Mesh& mesh, const std::string& name);

/// From the smallest to the largest finite value.
struct ValueRange {
    double low = 0;
    double high = 1;

    /// 0 at the low end, 1 at the high end.
    double fraction(double value) const;
};

/// The range of all the fields together; a width is made up when there is but one value.
ValueRange common_range(const std::vector<ScalarField>& fields);

} // namespace morph::picture
