#pragma once

#include "libmorph/untangle/patch.h"

namespace morph {

/// What a minimisation came to.
struct PatchResult {
    int iterations = 0;
    bool positive = false; ///< every corner of the patch, in floating point
};

/// Move the free vertices of a patch until every corner is positive, and then until the energy with a
/// vanishing eps hardly falls any more; from then on no corner is let go again.
///
/// Projected Newton steps with a line search; after each one eps shrinks by the rule of the paper, section
/// 2.3 [Garanzha et al. 2021].
///
/// @param x  places of the vertices of the patch; those of its rim stay
PatchResult minimize(const Patch& patch, const EnergyWeights& weights, int max_iterations, PlanePositions& x);

} // namespace morph
