#include "libmorph/remesh/surface_curvature.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <vector>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// The smooth parts around each vertex, counted over all of them: for each halfedge that of its triangle's
/// corner at the halfedge's start.
struct SmoothParts {
    std::vector<Index> of_corner; ///< 3m
    Index count = 0;
};

SmoothParts smooth_parts(const CornerTable& table)
{
    SmoothParts parts{std::vector<Index>(table.from.size(), -1), 0};
    std::vector<Index> outs;
    for (std::size_t v = 0; v < table.vertices.size(); ++v) {
        if (table.vertices[v].out < 0)
            continue;
        outs.clear();
        table.around(static_cast<Index>(v), [&](Index h) { outs.push_back(h); });
        const auto starts = [&](Index h) { return table.tag[at(h)] != kNoTag; };
        const auto first = std::find_if(outs.begin(), outs.end(), starts);
        if (first != outs.end())
            std::rotate(outs.begin(), first, outs.end());
        Index part = parts.count++;
        for (std::size_t i = 0; i < outs.size(); ++i) {
            if (i > 0 && starts(outs[i]))
                part = parts.count++;
            parts.of_corner[at(outs[i])] = part;
        }
    }
    return parts;
}

Eigen::Vector3d side(const CornerTable& table, Index h)
{
    return table.point(table.to(h)) - table.point(table.from[at(h)]);
}

/// Unit normal of each part, of its triangles weighted so that it is exact on a sphere [Max 1999, Weights for
/// computing vertex normals from facet normals, J. Graphics Tools 4(2)].
Points part_normals(const CornerTable& table, const SmoothParts& parts)
{
    Points normals = Points::Zero(parts.count, 3);
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h) {
        const Eigen::Vector3d ahead = side(table, h), back = -side(table, CornerTable::previous(h));
        const double lengths = ahead.squaredNorm() * back.squaredNorm();
        if (lengths > 0)
            normals.row(parts.of_corner[at(h)]) += ahead.cross(back) / lengths;
    }
    normals.rowwise().normalize();
    return normals;
}

/// Second fundamental form of a triangle as a matrix of space.
Eigen::Matrix3d fitted_form(const CornerTable& table, Index t, const std::array<Eigen::Vector3d, 3>& normal)
{
    const Eigen::Vector3d u = side(table, 3 * t).normalized();
    const Eigen::Vector3d v = side(table, 3 * t).cross(side(table, 3 * t + 1)).cross(u).normalized();
    Eigen::Matrix<double, 6, 3> sides = Eigen::Matrix<double, 6, 3>::Zero();
    Eigen::Matrix<double, 6, 1> turns;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const Eigen::Vector3d along = side(table, 3 * t + static_cast<Index>(k));
        const Eigen::Vector3d turn =
            normal[static_cast<std::size_t>((k + 1) % 3)] - normal[static_cast<std::size_t>(k)];
        sides.row(2 * k) << along.dot(u), along.dot(v), 0;
        sides.row(2 * k + 1) << 0, along.dot(u), along.dot(v);
        turns.segment<2>(2 * k) << turn.dot(u), turn.dot(v);
    }
    const Eigen::Vector3d form = sides.colPivHouseholderQr().solve(turns);
    return form[0] * u * u.transpose() + form[1] * (u * v.transpose() + v * u.transpose()) +
           form[2] * v * v.transpose();
}

/// Largest absolute eigenvalue.
double largest_of(const Eigen::Matrix3d& form)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(form, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseAbs()
        .maxCoeff();
}

} // namespace

Eigen::VectorXd largest_curvature(const CornerTable& table)
{
    const SmoothParts parts = smooth_parts(table);
    const Points normals = part_normals(table, parts);
    std::vector<Eigen::Matrix3d> forms(at(parts.count), Eigen::Matrix3d::Zero());
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(parts.count);
    for (Index t = 0; t < table.triangle_slots(); ++t) {
        const double area = side(table, 3 * t).cross(side(table, 3 * t + 1)).norm() / 2;
        if (!(area > 0))
            continue;
        std::array<Index, 3> part{};
        std::array<Eigen::Vector3d, 3> normal;
        for (std::size_t k = 0; k < 3; ++k) {
            part[k] = parts.of_corner[at(CornerTable::halfedge(t)) + k];
            normal[k] = normals.row(part[k]);
        }
        const Eigen::Matrix3d form = fitted_form(table, t, normal);
        for (const Index p : part) {
            forms[at(p)] += area * form;
            areas[p] += area;
        }
    }
    Eigen::VectorXd largest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table.vertices.size()));
    std::vector<bool> done(at(parts.count), false);
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h) {
        const Index part = parts.of_corner[at(h)];
        if (done[at(part)] || !(areas[part] > 0))
            continue;
        done[at(part)] = true;
        double& curvature = largest[table.from[at(h)]];
        curvature = std::max(curvature, largest_of(forms[at(part)] / areas[part]));
    }
    return largest;
}

} // namespace morph
