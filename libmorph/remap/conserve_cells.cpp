#include "libmorph/remap/conserve_cells.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/remap/supermesh.h"

#include <numeric>
#include <string>
#include <vector>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 1024; // elements of the target

void require_a_row_each(const Mesh& source, const Matrix& values)
{
    if (values.rows() != element_count(source))
        throw InputError("there are " + std::to_string(values.rows()) +
                         " rows of element values, but the source has " +
                         std::to_string(element_count(source)) + " elements");
}

/// Means over one element of the target after the other.
class Mean {
public:
    explicit Mean(const Matrix& values) : values_(values) {}

    /// Start again where the target is another element than before.
    void go_to(Index target)
    {
        if (target_ != target)
            area_ = 0;
        target_ = target;
    }

    void add(const Overlap& overlap)
    {
        const auto row = values_.row(overlap.face);
        if (area_ == 0) {
            first_ = low_ = high_ = row;
            sum_.setZero(row.cols());
        }
        area_ += overlap.area;
        // From the first value, so that equal ones stay what they are; the difference could overflow.
        sum_ += overlap.area * row - overlap.area * first_;
        low_ = low_.cwiseMin(row);
        high_ = high_.cwiseMax(row);
    }

    double area() const { return area_; }

    /// The mean, if the area is not 0; rounding is kept within the range of the values.
    template <typename Row>
    void write_to(Row&& row) const
    {
        row = (first_ + sum_ / area_).cwiseMax(low_).cwiseMin(high_);
    }

private:
    const Matrix& values_;
    Eigen::RowVectorXd first_, low_, high_, sum_;
    double area_ = 0;
    Index target_ = -1;
};

} // namespace

Transfer conserve_cells(const Locator& source, const Mesh& target, const Matrix& values)
{
    require_a_row_each(source.source(), values);
    const Supermesh overlaps(source, target, Cut::where_dented);
    const auto faces = static_cast<std::size_t>(element_count(target));
    Transfer transfer;
    transfer.values = Matrix::Zero(element_count(target), values.cols());
    transfer.covered.assign(faces, 0);
    std::vector<Eigen::RowVectorXd> integrals((faces + kRowsPerBlock - 1) / kRowsPerBlock);
    parallel_for(faces, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        Mean mean(values);
        Eigen::RowVectorXd& integral = integrals[begin / kRowsPerBlock];
        integral.setZero(values.cols());
        overlaps.visit(begin, end, [&](const SupermeshCell& piece) {
            mean.go_to(piece.face);
            for (const Overlap& overlap : piece.covers) {
                mean.add(overlap);
                integral += overlap.area * values.row(overlap.face);
            }
            transfer.covered[static_cast<std::size_t>(piece.face)] = mean.area();
            if (mean.area() > 0)
                mean.write_to(transfer.values.row(piece.face));
        });
    });
    transfer.source_integral.setZero(values.cols());
    for (const Eigen::RowVectorXd& integral : integrals)
        transfer.source_integral += integral;
    transfer.covered_area = std::accumulate(transfer.covered.begin(), transfer.covered.end(), 0.0);
    transfer.target_area = total_area(target);
    transfer.source_area = total_area(source.source());
    return transfer;
}

} // namespace morph
