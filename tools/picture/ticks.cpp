#include "tools/picture/ticks.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace morph::picture {

double round_length(double length)
{
    const double power = std::pow(10, std::floor(std::log10(length)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= length)
            return factor * power;
    return power;
}

std::vector<double> ticks(double low, double high, int wanted)
{
    std::vector<double> values;
    const double step = round_length((high - low) / std::max(wanted - 1, 1));
    if (!(step > 0))
        return values;
    const double slack = 1e-9 * step; // so that an end that is itself a round value is not lost to rounding
    for (double i = std::ceil((low - slack) / step); i * step <= high + slack; ++i)
        values.push_back(i * step + 0.0); // + 0.0: no "-0"
    return values;
}

std::string tick_label(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

} // namespace morph::picture
