#pragma once

#include <string>
#include <vector>

namespace morph::picture {

/// The largest of 1, 2, 5 times a power of ten that is at most @p length (> 0, finite).
double round_length(double length);

/// Round values inside [low, high] (low < high), evenly spaced, about @p wanted of them.
std::vector<double> ticks(double low, double high, int wanted);

/// A tick as short as it can be written.
std::string tick_label(double value);

} // namespace morph::picture
