#include "libmorph/weights/radial.h"

#include <limits>

namespace morph {

void apply_radial(RadialFunction function, Eigen::Ref<Eigen::ArrayXd> squared)
{
    if (function == RadialFunction::thin_plate) {
        // log 0 is not finite, and 0 times that not a number
        squared = 0.5 * squared * squared.max(std::numeric_limits<double>::min()).log();
        return;
    }
    if (function == RadialFunction::gauss) {
        squared = (-9 * squared).exp();
        return;
    }
    const auto q = squared.min(1).sqrt().eval();
    const auto rest = (1 - q).square().eval();
    if (function == RadialFunction::wendland_c0)
        squared = rest;
    else if (function == RadialFunction::wendland_c2)
        squared = rest.square() * (4 * q + 1);
    else
        squared = rest.cube() * ((35 * q + 18) * q + 3) / 3;
}

bool has_compact_support(RadialFunction function)
{
    return function == RadialFunction::wendland_c0 || function == RadialFunction::wendland_c2 ||
           function == RadialFunction::wendland_c4;
}

} // namespace morph
