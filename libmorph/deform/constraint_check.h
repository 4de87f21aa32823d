#pragma once

#include "libmorph/deform/constraints.h"

namespace morph {

/// Refuse constraints that do not fit each other or the displacements.
/// @throws InputError  names the constraint and what is wrong with it
void require_valid(const ConstraintSet& constraints, const Matrix& wanted);

} // namespace morph
