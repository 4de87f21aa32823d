#include "libmorph/remap/inverse_distance.h"

#include "libmorph/core/error.h"
#include "libmorph/geometry/nearest_points.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

void require_valid(const InverseDistance& settings)
{
    if (settings.neighbors < 1)
        throw InputError("inverse distance weighting needs at least 1 neighbour, not " +
                         std::to_string(settings.neighbors));
    if (!(settings.power > 0) || !std::isfinite(settings.power))
        throw InputError("the power of inverse distance weighting is " + std::to_string(settings.power) +
                         ", but a positive number was expected");
}

void require_fit(Eigen::Index points, const std::vector<Index>& known, const std::vector<Index>& unknown,
                 std::span<const Matrix> values)
{
    if (known.empty())
        throw InputError("no value is known to weight by inverse distance");
    for (const auto* rows : {&known, &unknown})
        for (const Index row : *rows)
            if (row < 0 || row >= points)
                throw InputError("row " + std::to_string(row) +
                                 " of the values is asked for, but there are " + std::to_string(points) +
                                 " points");
    for (const Matrix& matrix : values)
        if (matrix.rows() != points)
            throw InputError("there are values for " + std::to_string(matrix.rows()) + " points, but " +
                             std::to_string(points) + " points");
}

/// The weights of the neighbours, nearest first, as part of the nearest's: no power of a distance can
/// overflow so. A point at the nearest's place takes its value alone.
void weigh(std::span<const NearestPoints::Neighbor> neighbors, double power, std::vector<double>& weights)
{
    const double nearest = neighbors[0].distance;
    weights.assign(neighbors.size(), 0);
    weights[0] = 1;
    for (std::size_t i = 1; i < neighbors.size() && nearest > 0; ++i)
        weights[i] = std::pow(nearest / neighbors[i].distance, power);
}

/// The weighted mean of one column, as a difference from the nearest's value so that equal values stay equal.
template <typename Column>
double mean(std::span<const NearestPoints::Neighbor> neighbors, const std::vector<double>& weights,
            const std::vector<Index>& known, const Column& column)
{
    const auto value = [&](std::size_t i) {
        return column(known[static_cast<std::size_t>(neighbors[i].point)]);
    };
    const double nearest = value(0);
    double sum = 0, weight = 1, low = nearest, high = nearest;
    for (std::size_t i = 1; i < neighbors.size() && weights[i] > 0; ++i) {
        const double other = value(i);
        sum += weights[i] * other - weights[i] * nearest;
        weight += weights[i];
        low = std::min(low, other);
        high = std::max(high, other);
    }
    return std::clamp(nearest + sum / weight, low, high);
}

} // namespace

void fill_by_inverse_distance(const Eigen::Ref<const Points>& positions, const std::vector<Index>& known,
                              const std::vector<Index>& unknown, const InverseDistance& settings,
                              std::span<Matrix> values)
{
    require_valid(settings);
    require_fit(positions.rows(), known, unknown, values);
    const NearestPoints nearest(positions(known, Eigen::all));
    nearest.nearest(positions(unknown, Eigen::all), settings.neighbors,
                    [&](Index query, std::span<const NearestPoints::Neighbor> neighbors) {
                        std::vector<double> weights;
                        weigh(neighbors, settings.power, weights);
                        const Index row = unknown[static_cast<std::size_t>(query)];
                        for (Matrix& matrix : values)
                            for (Eigen::Index c = 0; c < matrix.cols(); ++c)
                                matrix(row, c) = mean(neighbors, weights, known, matrix.col(c));
                    });
}

} // namespace morph
