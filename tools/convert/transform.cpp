#include "tools/convert/transform.h"

#include "formats/text/surface_text.h"
#include "tools/common/run.h"

#include <charconv>
#include <cmath>
#include <numbers>
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

/// Cosine and sine, exact at quarter turns so that a mesh turned by 90 degrees stays planar and aligned.
std::array<double, 2> direction(double degrees)
{
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters)) {
        constexpr std::array<std::array<double, 2>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        return exact.at(static_cast<std::size_t>(quarters - 4 * std::floor(quarters / 4)));
    }
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

Eigen::Matrix3d rotation(const std::string& text)
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
    const auto [cosine, sine] = direction(numbers[0]);
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn(first, first) = turn(second, second) = cosine;
    turn(second, first) = sine;
    turn(first, second) = -sine;
    return turn;
}

} // namespace

void Transform::apply(MeshData& mesh) const
{
    if (!moves)
        return;
    mesh.points = ((mesh.points * linear.transpose()).rowwise() + shift).eval();
    mesh.dimension = dimension_of(mesh.points);
}

Transform make_transform(const std::string& scale, const std::string& rotate, const std::string& translate)
{
    Transform transform;
    transform.moves = !scale.empty() || !rotate.empty() || !translate.empty();
    if (!scale.empty())
        transform.linear = factors(scale).asDiagonal();
    if (!rotate.empty())
        transform.linear = rotation(rotate) * transform.linear;
    if (!translate.empty())
        transform.shift = lengths(translate);
    return transform;
}

} // namespace morph::tools
