#include "libmorph/numerics/conjugate_gradients.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/numerics/sparse_cholesky.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 4096; // rows a thread takes at a time

/// The part of a matrix whose rows and columns are in [begin, end).
SymmetricMatrix diagonal_block(const SymmetricMatrix& A, std::size_t begin, std::size_t end)
{
    SymmetricMatrix block;
    block.diagonal.assign(A.diagonal.begin() + static_cast<std::ptrdiff_t>(begin),
                          A.diagonal.begin() + static_cast<std::ptrdiff_t>(end));
    block.start = {0};
    for (std::size_t row = begin; row < end; ++row) {
        for (std::size_t e = A.start[row]; e < A.start[row + 1]; ++e)
            if (const auto column = static_cast<std::size_t>(A.column[e]); begin <= column && column < end) {
                block.column.push_back(static_cast<Index>(column - begin));
                block.value.push_back(A.value[e]);
            }
        block.start.push_back(block.column.size());
    }
    return block;
}

/// Stands for A by its diagonal blocks.
class BlockFactors {
public:
    BlockFactors(const SymmetricMatrix& A, const Eigen::Ref<const Matrix>& where, Index block)
        : rows_(A.diagonal.size()), block_(static_cast<std::size_t>(block)),
          factors_((rows_ + block_ - 1) / block_)
    {
        parallel_for(rows_, block_, [&](std::size_t begin, std::size_t end) {
            const SymmetricMatrix part = diagonal_block(A, begin, end);
            const auto places = where.middleRows(static_cast<Index>(begin), static_cast<Index>(end - begin));
            factors_[begin / block_] =
                std::make_unique<SparseCholesky>(part, nested_dissection(part, places));
        });
    }

    void solve(Matrix& r) const
    {
        parallel_for(rows_, block_, [&](std::size_t begin, std::size_t end) {
            Matrix part = r.middleRows(static_cast<Index>(begin), static_cast<Index>(end - begin));
            factors_[begin / block_]->solve(part);
            r.middleRows(static_cast<Index>(begin), static_cast<Index>(end - begin)) = part;
        });
    }

private:
    std::size_t rows_;
    std::size_t block_;
    std::vector<std::unique_ptr<SparseCholesky>> factors_;
};

/// Block by block, so that threads do not matter.
double dot(const Matrix& a, const Matrix& b)
{
    const auto n = static_cast<std::size_t>(a.rows());
    std::vector<double> partial((n + kRowsPerBlock - 1) / kRowsPerBlock);
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i)
            sum += a(static_cast<Index>(i), 0) * b(static_cast<Index>(i), 0);
        partial[begin / kRowsPerBlock] = sum;
    });
    double total = 0;
    for (const double sum : partial)
        total += sum;
    return total;
}

/// result = A x
void multiply(const SymmetricMatrix& A, const Matrix& x, Matrix& result)
{
    parallel_for(A.diagonal.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            double sum = A.diagonal[row] * x(static_cast<Index>(row), 0);
            for (std::size_t e = A.start[row]; e < A.start[row + 1]; ++e)
                sum += A.value[e] * x(A.column[e], 0);
            result(static_cast<Index>(row), 0) = sum;
        }
    });
}

} // namespace

int conjugate_gradients(const SymmetricMatrix& A, const Eigen::Ref<const Matrix>& where,
                        const ConjugateGradientOptions& options, Matrix& x)
{
    const BlockFactors factors(A, where, options.block);
    Matrix residual = x, z = x, image(x.rows(), 1);
    const double enough = options.tolerance * std::sqrt(dot(x, x));
    x.setZero();
    factors.solve(z);
    Matrix direction = z;
    double product = dot(residual, z);
    for (int iteration = 1; product > 0; ++iteration) {
        multiply(A, direction, image);
        const double curvature = dot(direction, image);
        if (!(curvature > 0))
            throw SolverError("the matrix of conjugate gradients is not positive definite");
        const double length = product / curvature;
        x += length * direction;
        residual -= length * image;
        if (iteration >= options.iterations || std::sqrt(dot(residual, residual)) <= enough)
            return iteration;
        z = residual;
        factors.solve(z);
        const double next = dot(residual, z);
        direction = z + (next / product) * direction;
        product = next;
    }
    return 0;
}

} // namespace morph
