#include "libmorph/remap/mass_matrix.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/remap/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <utility>

namespace morph {

namespace {

constexpr std::size_t kRows = 4096; // in a block
constexpr double kTolerance = 1e-15;
constexpr int kMostIterations = 1000;

/// Entry i, j of a triangle's mass.
double entry(const TriangleMass& mass, std::size_t i, std::size_t j)
{
    constexpr std::array<std::array<std::size_t, 3>, 3> kPlace{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
    return mass[kPlace[i][j]];
}

/// The row of one vertex; the first entry is the diagonal.
class Row {
public:
    void start(Index vertex)
    {
        columns.assign(1, vertex);
        values.assign(1, 0);
    }

    void add(Index column, double value)
    {
        const auto found = std::find(columns.begin(), columns.end(), column);
        if (found != columns.end()) {
            values[static_cast<std::size_t>(found - columns.begin())] += value;
            return;
        }
        columns.push_back(column);
        values.push_back(value);
    }

    /// Add what a triangle has at the vertex, if that is one of its corners.
    void add_triangle(const std::array<Index, 4>& corners, const TriangleMass& mass)
    {
        for (std::size_t i = 0; i < 3; ++i)
            if (corners[i] == columns[0])
                for (std::size_t j = 0; j < 3; ++j)
                    if (entry(mass, i, j) != 0)
                        add(corners[j], entry(mass, i, j));
    }

    std::vector<Index> columns;
    std::vector<double> values;
};

/// The power of two below the largest magnitude in each column; divided by it, squares neither overflow nor
/// vanish.
Eigen::RowVectorXd column_sizes(const Matrix& R)
{
    Eigen::RowVectorXd sizes = Eigen::RowVectorXd::Ones(R.cols());
    for (Eigen::Index k = 0; k < R.cols() && R.rows() > 0; ++k)
        if (const double most = R.col(k).cwiseAbs().maxCoeff(); most > 0)
            sizes[k] = std::ldexp(1.0, std::ilogb(most));
    return sizes;
}

std::size_t block_count(std::size_t rows)
{
    return (rows + kRows - 1) / kRows;
}

} // namespace

MassMatrix::MassMatrix(const Mesh& mesh, const std::vector<Index>& first_piece,
                       const std::vector<TriangleMass>& masses)
{
    const auto n = static_cast<std::size_t>(vertex_count(mesh));
    blocks_.resize(block_count(n));
    row_sums_.assign(n, 0);
    parallel_for(n, kRows, [&](std::size_t begin, std::size_t end) {
        RowBlock& block = blocks_[begin / kRows];
        block.start.assign(1, 0);
        Row row;
        for (std::size_t v = begin; v < end; ++v) {
            row.start(static_cast<Index>(v));
            for (const FaceHandle face : mesh.kernel.vf_range(VertexHandle(static_cast<Index>(v)))) {
                auto number = static_cast<std::size_t>(first_piece[static_cast<std::size_t>(face.idx())]);
                for (const ConvexParts pieces = split_convex(mesh, face.idx(), Cut::triangles);
                     const ConvexPart& piece : pieces.all())
                    row.add_triangle(piece.vertices, masses[number++]);
            }
            const double sum = std::accumulate(row.values.begin(), row.values.end(), 0.0);
            if (row.values[0] > 0 && sum > 0) {
                block.column.insert(block.column.end(), row.columns.begin(), row.columns.end());
                block.value.insert(block.value.end(), row.values.begin(), row.values.end());
                row_sums_[v] = sum;
            }
            block.start.push_back(block.column.size());
        }
    });
}

/// Conjugate gradients on K columns at once, each with steps of its own.
class MassMatrix::Iteration {
public:
    Iteration(const MassMatrix& M, const Matrix& R)
        : M_(M), columns_(static_cast<std::size_t>(R.cols())), X_(Matrix::Zero(R.rows(), R.cols())), R_(R),
          P_(X_), Q_(X_)
    {
        goal_ = kTolerance * kTolerance * residual();
        start();
    }

    bool converged() const { return (residual_.array() <= goal_.array()).all(); }
    bool finite() const { return residual_.allFinite(); }

    void step()
    {
        const Eigen::RowVectorXd energy = multiply();
        const Eigen::RowVectorXd length = ratio(residual_, energy);
        for_rows([&](std::size_t v, const Entries&) {
            for (std::size_t k = 0; k < columns_; ++k) {
                row(X_, v)[k] += length.data()[k] * row(P_, v)[k];
                row(R_, v)[k] -= length.data()[k] * row(Q_, v)[k];
            }
        });
        const Eigen::RowVectorXd before = residual_;
        residual_ = residual();
        turn(ratio(residual_, before));
    }

    Matrix take() { return std::move(X_); }

private:
    /// The entries of a row that is not empty, the diagonal first.
    struct Entries {
        std::span<const Index> column;
        std::span<const double> value;
    };

    double* row(Matrix& A, std::size_t v) const { return A.data() + v * columns_; }

    template <typename Work>
    void for_rows(const Work& work) const
    {
        parallel_for(M_.row_sums_.size(), kRows, [&](std::size_t begin, std::size_t end) {
            const RowBlock& block = M_.blocks_[begin / kRows];
            for (std::size_t v = begin; v < end; ++v) {
                const std::size_t first = block.start[v - begin], count = block.start[v - begin + 1] - first;
                if (count > 0)
                    work(v, Entries{{&block.column[first], count}, {&block.value[first], count}});
            }
        });
    }

    /// Sum of what @p work adds to a row of K sums, block by block.
    template <typename Work>
    Eigen::RowVectorXd sum(const Work& work) const
    {
        Matrix sums =
            Matrix::Zero(static_cast<Eigen::Index>(M_.blocks_.size()), static_cast<Eigen::Index>(columns_));
        for_rows([&](std::size_t v, const Entries& entries) { work(v, entries, row(sums, v / kRows)); });
        return sums.colwise().sum();
    }

    /// Squares of the residuals in the norm of the preconditioner.
    Eigen::RowVectorXd residual()
    {
        return sum([this](std::size_t v, const Entries& entries, double* squares) {
            for (std::size_t k = 0; k < columns_; ++k)
                squares[k] += row(R_, v)[k] * row(R_, v)[k] / entries.value[0];
        });
    }

    /// Start from the solution of the lumped matrix, which has the integral of the exact one and is exact for
    /// a constant.
    void start()
    {
        for_rows([this](std::size_t v, const Entries&) {
            for (std::size_t k = 0; k < columns_; ++k)
                row(P_, v)[k] = row(X_, v)[k] = row(R_, v)[k] / M_.row_sums_[v];
        });
        multiply();
        R_ -= Q_;
        residual_ = residual();
        turn(Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(columns_)));
    }

    /// Q = M P; returns the products of their columns.
    Eigen::RowVectorXd multiply()
    {
        return sum([this](std::size_t v, const Entries& entries, double* products) {
            double* q = row(Q_, v);
            std::fill(q, q + columns_, 0.0);
            for (std::size_t i = 0; i < entries.column.size(); ++i) {
                const double* p = row(P_, static_cast<std::size_t>(entries.column[i]));
                for (std::size_t k = 0; k < columns_; ++k)
                    q[k] += entries.value[i] * p[k];
            }
            for (std::size_t k = 0; k < columns_; ++k)
                products[k] += row(P_, v)[k] * q[k];
        });
    }

    /// The next directions: the preconditioned residuals and a part of the directions before.
    void turn(const Eigen::RowVectorXd& part)
    {
        for_rows([&](std::size_t v, const Entries& entries) {
            for (std::size_t k = 0; k < columns_; ++k)
                row(P_, v)[k] = row(R_, v)[k] / entries.value[0] + part.data()[k] * row(P_, v)[k];
        });
    }

    /// a / b, and 0 for the columns that have converged.
    Eigen::RowVectorXd ratio(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) const
    {
        return (residual_.array() <= goal_.array())
            .select(Eigen::RowVectorXd::Zero(a.cols()), a.cwiseQuotient(b));
    }

    const MassMatrix& M_;
    std::size_t columns_;
    Matrix X_, R_, P_, Q_;
    Eigen::RowVectorXd goal_, residual_;
};

Matrix MassMatrix::solve(const Matrix& R) const
{
    const Eigen::RowVectorXd sizes = column_sizes(R);
    Iteration iteration(*this, R.array().rowwise() / sizes.array());
    int steps = 0;
    while (!iteration.converged() && iteration.finite() && steps < kMostIterations) {
        iteration.step();
        ++steps;
    }
    if (!iteration.converged())
        throw SolverError("the projection onto the target has not converged after " + std::to_string(steps) +
                          " iterations");
    return iteration.take().array().rowwise() * sizes.array();
}

} // namespace morph
