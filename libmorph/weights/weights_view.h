#pragma once

#include "libmorph/weights/weights.h"

namespace morph {

/// Weights row by row, whether all of them are stored or only those that are not zero: what is written once
/// for every method reads them through this. A view: the weights must outlive it.
class WeightsView {
public:
    WeightsView(const Weights& weights) : dense_(&weights.values) {}
    WeightsView(const SparseWeights& weights) : sparse_(&weights.values) {}

    Eigen::Index rows() const { return dense_ ? dense_->rows() : sparse_->rows(); } ///< n, vertices
    Eigen::Index cols() const { return dense_ ? dense_->cols() : sparse_->cols(); } ///< K, control points

    /// Memory of the weights.
    std::size_t bytes() const
    {
        if (dense_)
            return sizeof(double) * static_cast<std::size_t>(dense_->size());
        return (sizeof(double) + sizeof(Index)) * static_cast<std::size_t>(sparse_->nonZeros()) +
               sizeof(Index) * static_cast<std::size_t>(sparse_->rows() + 1);
    }

    /// Call use(column, value) for the weights of row @p row, columns ascending.
    template <typename Use>
    void for_each(Eigen::Index row, const Use& use) const
    {
        if (dense_) {
            const double* values = dense_->data() + row * dense_->cols();
            for (Eigen::Index k = 0; k < dense_->cols(); ++k)
                use(k, values[k]);
            return;
        }
        using Row = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>::InnerIterator;
        for (Row weight(*sparse_, row); weight; ++weight)
            use(Eigen::Index{weight.col()}, weight.value());
    }

private:
    const Matrix* dense_ = nullptr;
    const Eigen::SparseMatrix<double, Eigen::RowMajor, Index>* sparse_ = nullptr;
};

} // namespace morph
