#include "libmorph/numerics/sparse_cholesky.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/core/progress.h"
#include "libmorph/numerics/serial_blas.h"
#include "libmorph/numerics/tree_walk.h"

#include <cblas.h>

#include <algorithm>
#include <atomic>
#include <thread>

// LAPACK's name, not ours. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" void dpotrf_(const char* triangle, const int* n, double* a, const int* stride, int* info);

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 4096; // rows a thread takes at a time

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Column j of a matrix stored by columns.
double* column_of(double* matrix, Index j, Index rows)
{
    return matrix + std::ptrdiff_t{j} * rows;
}

/// Says how far the factorisation is, from the thread that made it and some dozens of times.
class FactorProgress {
public:
    explicit FactorProgress(double total) : total_(total) {}

    void add(double work)
    {
        const double done = done_.fetch_add(work) + work;
        if (std::this_thread::get_id() != caller_ || done < next_)
            return;
        report_progress("factorisation", std::min(done / total_, 1.0));
        next_ = done + total_ / 40;
    }

private:
    std::thread::id caller_ = std::this_thread::get_id();
    std::atomic<double> done_{0};
    double total_;
    double next_ = 0; // the caller's only
};

} // namespace

/// A node seen as a dense matrix.
struct SparseCholesky::Front {
    Index begin, end; // positions of its own rows
    int own;
    int border;
    int rows; // own + border
    const std::vector<Index>& border_rows;
    double* panel;

    double* below() const { return panel + own; } // the border's rows of the panel

    /// Row of the front that holds each of these positions, which are ascending and among its rows.
    std::vector<Index> rows_of(const std::vector<Index>& positions) const
    {
        std::vector<Index> found(positions.size());
        std::size_t b = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (positions[i] < end) {
                found[i] = positions[i] - begin;
                continue;
            }
            while (border_rows[b] < positions[i])
                ++b;
            found[i] = own + static_cast<Index>(b);
        }
        return found;
    }

    double work() const { return (own + 1.0) * rows * rows; }
};

SparseCholesky::Front SparseCholesky::front(std::size_t node) const
{
    const auto& [begin, end, parent, children] = tree_.nodes[node];
    const int own = end - begin;
    const int border = static_cast<int>(border_[node].size());
    return {begin, end, own, border, own + border, border_[node], panels_.get() + panel_start_[node]};
}

SparseCholesky::SparseCholesky(const SymmetricMatrix& A, Dissection dissection)
    : tree_(std::move(dissection)), position_(tree_.order.size()), border_(tree_.nodes.size()),
      panel_start_(tree_.nodes.size() + 1)
{
    keep_blas_serial();
    for (std::size_t k = 0; k < tree_.order.size(); ++k)
        position_[at(tree_.order[k])] = static_cast<Index>(k);
    walk_up(tree_, [&](std::size_t node) { border_[node] = border_of(node, A); });
    reserve_panels();
    factor(A);
}

/// The later rows that the node's own rows have entries in, or that its children leave to it.
std::vector<Index> SparseCholesky::border_of(std::size_t i, const SymmetricMatrix& A) const
{
    const Dissection::Node& node = tree_.nodes[i];
    std::vector<Index> border;
    for (const Index child : node.children)
        if (child >= 0)
            std::copy_if(border_[at(child)].begin(), border_[at(child)].end(), std::back_inserter(border),
                         [&](Index p) { return p >= node.end; });
    for (Index k = node.begin; k < node.end; ++k) {
        const std::size_t row = at(tree_.order[at(k)]);
        for (std::size_t e = A.start[row]; e < A.start[row + 1]; ++e)
            if (const Index p = position_[at(A.column[e])]; p >= node.end)
                border.push_back(p);
    }
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    return {border.begin(), border.end()}; // no larger than needed
}

void SparseCholesky::reserve_panels()
{
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
        const std::size_t own = at(tree_.nodes[i].end - tree_.nodes[i].begin);
        panel_start_[i + 1] = panel_start_[i] + own * (own + border_[i].size());
    }
    panels_ = std::make_unique_for_overwrite<double[]>(panel_start_.back());
}

void SparseCholesky::factor(const SymmetricMatrix& A)
{
    double total = 0;
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i)
        total += front(i).work();
    FactorProgress progress(total);
    std::vector<Update> updates(tree_.nodes.size());
    walk_up(tree_, [&](std::size_t node) {
        factor_front(node, A, updates);
        progress.add(front(node).work());
    });
}

/// Gather the front, eliminate its own rows, and leave the rest in its update:
///     [ F11      ]   [ L11   ] [ L11^T  L21^T ]
///     [ F21  F22 ] = [ L21 I ] [        U     ]
void SparseCholesky::factor_front(std::size_t node, const SymmetricMatrix& A, std::vector<Update>& updates)
{
    const Front f = front(node);
    const std::size_t border = at(f.border);
    updates[node] = std::make_unique_for_overwrite<double[]>(border * border);
    double* update = updates[node].get();
    std::fill_n(f.panel, std::ptrdiff_t{f.own} * f.rows, 0.0);
    std::fill_n(update, border * border, 0.0);
    add_matrix(f, A);
    for (const Index child : tree_.nodes[node].children)
        if (child >= 0) {
            add_update(f, update, child, updates[at(child)].get());
            updates[at(child)].reset();
        }
    if (f.own == 0)
        return;
    int failed = 0;
    dpotrf_("L", &f.own, f.panel, &f.rows, &failed);
    if (failed != 0)
        throw SolverError("the system is not positive definite");
    if (f.border == 0)
        return;
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, f.border, f.own, 1, f.panel,
                f.rows, f.below(), f.rows);
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, f.border, f.own, -1, f.below(), f.rows, 1, update,
                f.border);
}

/// Add the entries of A in the front's own columns to its panel.
void SparseCholesky::add_matrix(const Front& f, const SymmetricMatrix& A) const
{
    for (Index k = f.begin; k < f.end; ++k) {
        const std::size_t row = at(tree_.order[at(k)]);
        double* column = column_of(f.panel, k - f.begin, f.rows);
        column[k - f.begin] = A.diagonal[row];
        for (std::size_t e = A.start[row]; e < A.start[row + 1]; ++e) {
            const Index p = position_[at(A.column[e])];
            if (p >= f.end)
                column[f.own + (std::lower_bound(f.border_rows.begin(), f.border_rows.end(), p) -
                                f.border_rows.begin())] += A.value[e];
            else if (p > k)
                column[p - f.begin] += A.value[e];
        }
    }
}

/// Add a child's update to the front: columns it owns to its panel, the others to its own update.
void SparseCholesky::add_update(const Front& f, double* update, std::size_t child, const double* childs) const
{
    const std::vector<Index> row = f.rows_of(border_[child]);
    for (std::size_t j = 0; j < row.size(); ++j) {
        double* column = row[j] < f.own ? column_of(f.panel, row[j], f.rows)
                                        : column_of(update, row[j] - f.own, f.border) - f.own;
        const double* from = childs + j * row.size();
        for (std::size_t i = j; i < row.size(); ++i)
            column[row[i]] += from[i];
    }
}

void SparseCholesky::solve(Matrix& X) const
{
    Matrix Y(X.rows(), X.cols());
    parallel_for(tree_.order.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            Y.row(static_cast<Index>(k)) = X.row(tree_.order[k]);
    });
    std::vector<Matrix> sent(tree_.nodes.size());
    walk_up(tree_, [&](std::size_t node) { eliminate(node, Y, sent); });
    walk_down(tree_, [&](std::size_t node) { substitute(node, Y); });
    parallel_for(tree_.order.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            X.row(tree_.order[k]) = Y.row(static_cast<Index>(k));
    });
}

/// Y := L^-1 Y for the node's own rows; what that takes from the border's rows is sent to the parent. Y by
/// rows is Y^T by columns, so that BLAS sees everything transposed.
void SparseCholesky::eliminate(std::size_t node, Matrix& Y, std::vector<Matrix>& sent) const
{
    const Front f = front(node);
    const int K = static_cast<int>(Y.cols());
    Matrix& out = sent[node];
    out.setZero(f.border, K);
    for (const Index child : tree_.nodes[node].children) {
        if (child < 0)
            continue;
        Matrix& in = sent[at(child)];
        const std::vector<Index> row = f.rows_of(border_[at(child)]);
        for (Index i = 0; i < in.rows(); ++i)
            if (const Index r = row[at(i)]; r < f.own)
                Y.row(f.begin + r) += in.row(i);
            else
                out.row(r - f.own) += in.row(i);
        in.resize(0, 0);
    }
    if (f.own == 0 || K == 0)
        return;
    double* y = &Y(f.begin, 0);
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, K, f.own, 1, f.panel, f.rows,
                y, K);
    if (f.border > 0)
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, K, f.border, f.own, -1, y, K, f.below(), f.rows,
                    1, out.data(), K);
}

/// Y := L^-T Y for the node's own rows, those of its border being done.
void SparseCholesky::substitute(std::size_t node, Matrix& Y) const
{
    const Front f = front(node);
    const int K = static_cast<int>(Y.cols());
    if (f.own == 0 || K == 0)
        return;
    double* y = &Y(f.begin, 0);
    if (f.border > 0) {
        Matrix later(f.border, K);
        for (Index i = 0; i < f.border; ++i)
            later.row(i) = Y.row(f.border_rows[at(i)]);
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, K, f.own, f.border, -1, later.data(), K,
                    f.below(), f.rows, 1, y, K);
    }
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasNoTrans, CblasNonUnit, K, f.own, 1, f.panel,
                f.rows, y, K);
}

} // namespace morph
