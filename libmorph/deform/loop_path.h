#pragma once

#include "libmorph/core/types.h"

#include <complex>
#include <vector>

namespace morph {

/// The way of a closed polygon from one shape to another on which its lengths and angles change evenly
/// [Sederberg, Gao, Wang and Mu 1993, Computer Graphics (SIGGRAPH) 27, 15-18]. What then is missing for it to
/// close each edge gives by the same part of its length, as a surveyor closes a traverse.
///
/// A corner whose angle is 5 degrees in the end and 355 in the beginning opens on the way and does not turn
/// over, as it can where places change evenly. The polygon may cross itself.
///
/// The mean direction of the edges turns by less than half a turn; the mean of the corners goes straight.
class LoopPath {
public:
    /// @param from  c corners, c >= 3, of a simple polygon
    /// @param to    c corners of one that runs around as @p from does
    LoopPath(std::vector<std::complex<double>> from, std::vector<std::complex<double>> to);

    /// The corners after the part @p f of the way.
    std::vector<std::complex<double>> at(double f) const;

private:
    std::vector<std::complex<double>> from_;
    std::vector<std::complex<double>> to_;
    std::vector<double> turn_; ///< of each edge from one shape to the other, radians
};

} // namespace morph
