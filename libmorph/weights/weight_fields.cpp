#include "libmorph/weights/weight_fields.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

namespace morph {

namespace {

std::string field_name(const ControlPoint& column)
{
    return "h_" + column.boundary + "_" + std::to_string(column.number + 1);
}

const Field& weight_field(const std::vector<Field>& fields, const std::string& name)
{
    if (const Field* field = find_field(fields, name, FieldLocation::vertex))
        return *field;
    std::vector<std::string> names;
    for (const Field& field : fields)
        if (field.location == FieldLocation::vertex)
            names.push_back(field.name);
    throw InputError("the weights have no nodal field '" + name + "', but " +
                     (names.empty() ? "none at all" : joined(names)));
}

} // namespace

std::vector<Field> weight_fields(const std::vector<ControlPoint>& columns, WeightsView weights)
{
    std::vector<Field> fields;
    for (const ControlPoint& column : columns)
        fields.push_back({field_name(column), FieldLocation::vertex, Matrix::Zero(weights.rows(), 1)});
    for (Eigen::Index row = 0; row < weights.rows(); ++row)
        weights.for_each(row, [&](Eigen::Index column, double value) {
            fields[static_cast<std::size_t>(column)].values(row, 0) = value;
        });
    return fields;
}

std::vector<Field> weight_fields(const Weights& weights)
{
    return weight_fields(weights.columns, weights);
}

Weights weights_from_fields(const std::vector<Field>& fields, const std::vector<ControlPoint>& columns)
{
    Weights weights{columns, {}};
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Field& field = weight_field(fields, field_name(columns[k]));
        if (field.values.cols() != 1)
            throw InputError("weight field '" + field.name + "' has " + std::to_string(field.values.cols()) +
                             " components, but 1 was expected");
        if (!field.values.allFinite())
            throw InputError("weight field '" + field.name + "' holds a value that is not finite");
        if (k == 0)
            weights.values.resize(field.values.rows(), static_cast<Eigen::Index>(columns.size()));
        weights.values.col(static_cast<Eigen::Index>(k)) = field.values;
    }
    return weights;
}

} // namespace morph
