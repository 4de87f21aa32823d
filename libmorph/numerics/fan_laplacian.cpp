#include "libmorph/numerics/fan_laplacian.h"

#include "libmorph/core/error.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// What one triangle adds to the rows of its corners.
struct Share {
    std::size_t fan;
    Index vertex;
    double entry;
};

class FanLaplacianOf {
public:
    FanLaplacianOf(const Mesh& mesh, const Triangulation& triangulation, const TriangleFans& fans,
                   const std::vector<Index>& representatives)
        : mesh_(mesh), triangulation_(triangulation), fans_(fans), representatives_(representatives)
    {
    }

    FanLaplacian run()
    {
        result_.root.resize(fans_.count());
        result_.vertex.resize(fans_.count());
        shares_.reserve(12 * triangulation_.corners.size());
        for (std::size_t t = 0; t < triangulation_.corners.size(); ++t)
            add_triangle(t);
        for (double& mass : result_.root)
            mass = std::sqrt(mass);
        collect();
        return std::move(result_);
    }

private:
    void add_triangle(std::size_t t)
    {
        const auto& corners = triangulation_.corners[t];
        std::array<Eigen::Vector2d, 3> x;
        for (std::size_t k = 0; k < 3; ++k)
            x[k] = points(mesh_).row(corners[k]).head<2>();
        const Eigen::Vector2d u = x[1] - x[0], v = x[2] - x[0];
        const double twice_area = u.x() * v.y() - u.y() * v.x();
        if (!(twice_area > 0))
            throw InputError("the elements around vertex " +
                             std::to_string(mesh_.numbering.vertex[at(corners[0])]) +
                             " are inverted: biharmonic functions need a mesh that covers its domain once");
        for (std::size_t k = 0; k < 3; ++k) {
            result_.root[fans_.fan(t, k)] += twice_area / 6;
            result_.vertex[fans_.fan(t, k)] = representatives_[at(corners[k])];
        }
        for (std::size_t k = 0; k < 3; ++k) { // the angle at k couples the other two
            const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
            const double half_cotangent = 0.5 * (x[a] - x[k]).dot(x[b] - x[k]) / twice_area;
            add_edge(t, a, b, half_cotangent);
            add_edge(t, b, a, half_cotangent);
        }
    }

    void add_edge(std::size_t t, std::size_t here, std::size_t there, double weight)
    {
        const auto vertex = [&](std::size_t k) { return representatives_[at(triangulation_.corners[t][k])]; };
        shares_.push_back({fans_.fan(t, here), vertex(here), weight});
        shares_.push_back({fans_.fan(t, here), vertex(there), -weight});
    }

    /// Sum the shares of each fan and vertex.
    void collect()
    {
        std::vector<std::size_t> end(fans_.count() + 1); // of each fan's shares, once they are in place
        for (const Share& share : shares_)
            ++end[share.fan + 1];
        std::partial_sum(end.begin(), end.end(), end.begin());
        std::vector<Share> sorted(shares_.size());
        for (const Share& share : shares_)
            sorted[end[share.fan]++] = share;
        std::size_t begin = 0;
        for (std::size_t fan = 0; fan < fans_.count(); begin = end[fan++])
            collect_fan(fan, sorted.begin() + static_cast<std::ptrdiff_t>(begin),
                        sorted.begin() + static_cast<std::ptrdiff_t>(end[fan]));
    }

    void collect_fan(std::size_t fan, std::vector<Share>::iterator next, std::vector<Share>::iterator end)
    {
        std::sort(next, end, [](const Share& a, const Share& b) { return a.vertex < b.vertex; });
        while (next != end) {
            const Index vertex = next->vertex;
            double sum = 0;
            for (; next != end && next->vertex == vertex; ++next)
                sum += next->entry;
            result_.patches.vertex.push_back(vertex);
            result_.entry.push_back(sum / result_.root[fan]);
        }
        result_.patches.close_list();
    }

    const Mesh& mesh_;
    const Triangulation& triangulation_;
    const TriangleFans& fans_;
    const std::vector<Index>& representatives_;
    std::vector<Share> shares_;
    FanLaplacian result_;
};

} // namespace

Matrix FanLaplacian::load(const Matrix& u, const Matrix& flux) const
{
    Matrix result = Matrix::Zero(u.rows(), u.cols());
    for (std::size_t p = 0; p < patches.count(); ++p) {
        Eigen::RowVectorXd w = -flux.row(static_cast<Index>(p)) / root[p];
        for (std::size_t i = patches.start[p]; i < patches.start[p + 1]; ++i)
            w += entry[i] * (u.row(patches.vertex[i]) - u.row(vertex[p]));
        for (std::size_t i = patches.start[p]; i < patches.start[p + 1]; ++i) {
            result.row(patches.vertex[i]) -= entry[i] * w;
            result.row(vertex[p]) += entry[i] * w;
        }
    }
    return result;
}

FanLaplacian fan_laplacian(const Mesh& mesh, const Triangulation& triangulation, const TriangleFans& fans,
                           const std::vector<Index>& representatives)
{
    return FanLaplacianOf(mesh, triangulation, fans, representatives).run();
}

SymmetricMatrix bilaplacian(Index vertices, const FanLaplacian& L)
{
    return assemble(vertices, 1, L.patches, [&L](std::size_t p, ElementMatrix& matrix) {
        const Eigen::Map<const Eigen::VectorXd> row(L.entry.data() + L.patches.start[p],
                                                    static_cast<Index>(L.patches.size(p)));
        matrix = row * row.transpose();
    });
}

} // namespace morph
