#include "tools/convert/transform.h"

#include "tools/common/run.h"

#include <charconv>
#include <cmath>
#include <vector>

namespace morph::tools {

namespace {

/// Finite numbers with commas between; empty when it is anything else.
std::vector<double> numbers_of(const std::string& text)
{
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (;;) {
        double value = 0;
        const auto [stop, error] = std::from_chars(at, end, value);
        if (error != std::errc() || !std::isfinite(value) || (stop != end && *stop != ','))
            return {};
        numbers.push_back(value);
        if (stop == end)
            return numbers;
        at = stop + 1;
    }
}

Eigen::Vector3d factors(const std::string& text)
{
    std::vector<double> numbers = numbers_of(text);
    if (numbers.size() == 1)
        numbers.assign(3, numbers[0]);
    if (numbers.size() == 2)
        numbers.push_back(1);
    if (numbers.size() != 3 || !(numbers[0] > 0 && numbers[1] > 0 && numbers[2] > 0))
        throw UsageError(
            "--scale needs one positive factor, or one for each axis with commas between, not '" + text +
            "'");
    return {numbers[0], numbers[1], numbers[2]};
}

Eigen::RowVector3d lengths(const std::string& text)
{
    const std::vector<double> numbers = numbers_of(text);
    if (numbers.size() != 2 && numbers.size() != 3)
        throw UsageError("--translate needs two or three lengths with commas between, not '" + text + "'");
    return {numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0};
}

Eigen::Matrix3d rotation_of(const std::string& text)
{
    int axis = 2;
    std::string degrees = text;
    if (text.size() > 2 && text[1] == ':' && text[0] >= 'x' && text[0] <= 'z') {
        axis = text[0] - 'x';
        degrees = text.substr(2);
    }
    const std::vector<double> numbers = numbers_of(degrees);
    if (numbers.size() != 1)
        throw UsageError("--rotate needs degrees about the z axis, or an axis in front as in x:90, not '" +
                         text + "'");
    return rotation(axis, numbers[0]);
}

} // namespace

std::optional<Transform> make_transform(const std::string& scale, const std::string& rotate,
                                        const std::string& translate)
{
    if (scale.empty() && rotate.empty() && translate.empty())
        return std::nullopt;
    Transform transform;
    if (!scale.empty())
        transform.linear = factors(scale).asDiagonal();
    if (!rotate.empty())
        transform.linear = rotation_of(rotate) * transform.linear;
    if (!translate.empty())
        transform.shift = lengths(translate);
    return transform;
}

} // namespace morph::tools
