#pragma once

#include "libmorph/core/names.h"

#include <Eigen/Core>

namespace morph {

/// Radial functions phi(q), q = distance / support radius.
///
/// Those of Wendland [1995, Advances in Computational Mathematics 4, 389-396] are positive definite in the
/// plane and in space and 0 from q = 1 on. The smoother one is, the better it reproduces smooth moves, and the
/// worse conditioned are its systems: the smallest eigenvalue falls with the spacing of the centres to the
/// power 1, 3 and 5.
enum class RadialFunction {
    wendland_c0, ///< (1 - q)^2
    wendland_c2, ///< (1 - q)^4 (4 q + 1)
    wendland_c4, ///< (1 - q)^6 (35 q^2 + 18 q + 3) / 3
    thin_plate,  ///< q^2 log q: needs linear terms, which make the support radius irrelevant
    gauss        ///< exp(-9 q^2), 1e-4 at q = 1; works for some dozens of centres only
};

template <>
inline constexpr auto kEnumNames<RadialFunction> = std::to_array<EnumName<RadialFunction>>({
    {RadialFunction::wendland_c0, "wendland-c0"},
    {RadialFunction::wendland_c2, "wendland-c2"},
    {RadialFunction::wendland_c4, "wendland-c4"},
    {RadialFunction::thin_plate, "thin-plate"},
    {RadialFunction::gauss, "gauss"},
});

/// phi of squared relative distances q^2, in place.
void apply_radial(RadialFunction function, Eigen::Ref<Eigen::ArrayXd> squared);

/// phi is 0 from q = 1 on.
bool has_compact_support(RadialFunction function);

} // namespace morph
