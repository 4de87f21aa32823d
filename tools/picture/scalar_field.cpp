#include "tools/picture/scalar_field.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/quality/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morph::picture {

namespace {

constexpr const char* kComputed = "scaled_jacobian";

ScalarField computed_quality(const Mesh& mesh)
{
    const auto quality = element_quality(mesh, points(mesh));
    ScalarField field{kComputed, FieldLocation::element, Eigen::VectorXd(element_count(mesh))};
    for (std::size_t f = 0; f < quality.size(); ++f)
        field.values[static_cast<Index>(f)] = quality[f].scaled_jacobian;
    return field;
}

[[noreturn]] void refuse(const Mesh& mesh, const std::string& name)
{
    std::vector<std::string> names;
    for (const Field& field : mesh.fields)
        names.push_back(field.name);
    const std::string has = names.empty() ? "no fields" : "the fields " + joined(names);
    names.emplace_back(kComputed);
    throw InputError("field '" + name + "' is not in the mesh, which has " + has + " (" + kComputed +
                     " is always there)" + did_you_mean(name, names));
}

} // namespace

ScalarField scalar_field(const Mesh& mesh, const std::string& name)
{
    const Field* field = find_field(mesh.fields, name, FieldLocation::vertex);
    if (field == nullptr)
        field = find_field(mesh.fields, name, FieldLocation::element);
    if (field == nullptr && name == kComputed)
        return computed_quality(mesh);
    if (field == nullptr)
        refuse(mesh, name);
    if (field->values.cols() == 1)
        return {name, field->location, field->values.col(0)};
    return {"|" + name + "|", field->location, field->values.rowwise().norm()};
}

double ValueRange::fraction(double value) const
{
    return (value / 2 - low / 2) / (high / 2 - low / 2); // halves: the range may be that of all doubles
}

ValueRange common_range(const std::vector<ScalarField>& fields)
{
    ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const ScalarField& field : fields)
        for (const double value : field.values)
            if (std::isfinite(value)) {
                range.low = std::min(range.low, value);
                range.high = std::max(range.high, value);
            }
    if (!(range.low <= range.high))
        return {};
    const double least = std::max(1e-12 * std::max(std::abs(range.low), std::abs(range.high)), 1e-300);
    if (range.high - range.low < least) {
        range.low -= range.low == 0 ? 0.5 : 0.05 * std::abs(range.low);
        range.high += range.high == 0 ? 0.5 : 0.05 * std::abs(range.high);
    }
    return range;
}

} // namespace morph::picture
