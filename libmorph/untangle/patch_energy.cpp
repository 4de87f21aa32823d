#include "libmorph/untangle/patch_energy.h"

#include "libmorph/core/parallel.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 1024; // corners or vertices a thread takes at a time

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Adds the second derivatives of a corner by vertices k and l of it, 2 x 2, to a block.
struct Block {
    double xx = 0, xy = 0, yx = 0, yy = 0;

    void add(const TargetCorner& corner, const CornerModel& m, std::size_t k, std::size_t l)
    {
        // A vertex moved by d changes u + i v by a d, and s + i t by b d.
        const std::complex<double> ak = std::conj(m.a_along) * corner.slope[k];
        const std::complex<double> al = std::conj(m.a_along) * corner.slope[l];
        const std::complex<double> bk = std::conj(m.b_along * corner.slope[k]);
        const std::complex<double> bl = std::conj(m.b_along * corner.slope[l]);
        const std::complex<double> along_l = m.aa * std::conj(al) + m.ab * std::conj(bl);
        const std::complex<double> along_b = m.ab * std::conj(al) + m.bb * std::conj(bl);
        // conj(a) is the gradient of u, i conj(a) that of v.
        const std::complex<double> across_a = m.across_a * std::complex<double>(0, 1) * std::conj(al);
        const std::complex<double> across_b = m.across_b * std::complex<double>(0, 1) * std::conj(bl);
        const auto outer = [&](std::complex<double> left, std::complex<double> right) {
            xx += corner.weight * left.real() * right.real();
            xy += corner.weight * left.real() * right.imag();
            yx += corner.weight * left.imag() * right.real();
            yy += corner.weight * left.imag() * right.imag();
        };
        outer(std::conj(ak), along_l);
        outer(std::conj(bk), along_b);
        outer(std::complex<double>(0, 1) * std::conj(ak), across_a);
        outer(std::complex<double>(0, 1) * std::conj(bk), across_b);
    }
};

} // namespace

PatchEnergy::PatchEnergy(const Patch& patch, const EnergyWeights& weights)
    : patch_(patch), weights_(weights), start_(at(patch.free) + 1), neighbour_start_(at(patch.free) + 1)
{
    for (const TargetCorner& corner : patch.corners)
        for (const Index v : corner.vertex)
            if (v < patch.free)
                ++start_[at(v) + 1];
    for (std::size_t v = 1; v < start_.size(); ++v)
        start_[v] += start_[v - 1];
    uses_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t c = 0; c < patch.corners.size(); ++c)
        for (std::size_t k = 0; k < 3; ++k)
            if (const Index v = patch.corners[c].vertex[k]; v < patch.free)
                uses_[next[at(v)]++] = static_cast<Index>(3 * c + k);
    std::vector<Index> row;
    for (Index v = 0; v < patch.free; ++v) {
        row.clear();
        for (std::size_t u = start_[at(v)]; u < start_[at(v) + 1]; ++u)
            for (const Index w : patch.corners[at(uses_[u]) / 3].vertex)
                if (w < patch.free && w != v)
                    row.push_back(w);
        std::sort(row.begin(), row.end());
        neighbours_.insert(neighbours_.end(), row.begin(), std::unique(row.begin(), row.end()));
        neighbour_start_[at(v) + 1] = neighbours_.size();
    }
}

PatchEnergy::Value PatchEnergy::value(const PlanePositions& x, double eps) const
{
    const std::size_t n = patch_.corners.size();
    std::vector<Value> partial((n + kRowsPerBlock - 1) / kRowsPerBlock, {0, HUGE_VAL});
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        Value& sum = partial[begin / kRowsPerBlock];
        for (std::size_t c = begin; c < end; ++c) {
            const CornerMap map = patch_.corners[c].map(x);
            sum.energy += patch_.corners[c].weight * corner_energy(map, eps, weights_);
            sum.min_determinant = std::min(sum.min_determinant, map.determinant());
        }
    });
    Value total{0, HUGE_VAL};
    for (const Value& part : partial) {
        total.energy += part.energy;
        total.min_determinant = std::min(total.min_determinant, part.min_determinant);
    }
    return total;
}

std::vector<CornerModel> PatchEnergy::corner_models(const PlanePositions& x, double eps) const
{
    std::vector<CornerModel> models(patch_.corners.size());
    parallel_for(models.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c)
            models[c] = corner_model(patch_.corners[c].map(x), eps, weights_);
    });
    return models;
}

PatchEnergy::Model PatchEnergy::model(const PlanePositions& x, double eps) const
{
    const std::vector<CornerModel> models = corner_models(x, eps);
    const std::size_t n = at(patch_.free);
    Model model;
    model.gradient.resize(n);
    SymmetricMatrix& A = model.second;
    A.diagonal.resize(2 * n);
    A.start.resize(2 * n + 1);
    for (std::size_t v = 0; v < n; ++v) {
        const std::size_t row = 2 * (neighbour_start_[v + 1] - neighbour_start_[v]) + 1;
        A.start[2 * v + 1] = A.start[2 * v] + row;
        A.start[2 * v + 2] = A.start[2 * v + 1] + row;
    }
    A.column.resize(A.start.back());
    A.value.resize(A.start.back());
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::vector<Block> row;
        for (std::size_t v = begin; v < end; ++v) {
            const Index* first = neighbours_.data() + neighbour_start_[v];
            const Index* last = neighbours_.data() + neighbour_start_[v + 1];
            row.assign(static_cast<std::size_t>(last - first), {});
            Block self;
            std::complex<double> gradient = 0;
            for (std::size_t u = start_[v]; u < start_[v + 1]; ++u) {
                const std::size_t c = at(uses_[u]) / 3, k = at(uses_[u]) % 3;
                const TargetCorner& corner = patch_.corners[c];
                gradient += corner.weight * (models[c].a_gradient * std::conj(corner.slope[k]) +
                                             models[c].b_gradient * corner.slope[k]);
                for (std::size_t l = 0; l < 3; ++l)
                    if (l == k)
                        self.add(corner, models[c], k, k);
                    else if (const Index w = corner.vertex[l]; w < patch_.free)
                        row[static_cast<std::size_t>(std::lower_bound(first, last, w) - first)].add(
                            corner, models[c], k, l);
            }
            model.gradient[v] = gradient;
            A.diagonal[2 * v] = self.xx;
            A.diagonal[2 * v + 1] = self.yy;
            std::size_t x_row = A.start[2 * v], y_row = A.start[2 * v + 1];
            const auto put = [&](std::size_t& entry, Index column, double value) {
                A.column[entry] = column;
                A.value[entry++] = value;
            };
            put(x_row, static_cast<Index>(2 * v + 1), self.xy);
            put(y_row, static_cast<Index>(2 * v), self.yx);
            for (const Index* w = first; w != last; ++w) {
                const Block& block = row[static_cast<std::size_t>(w - first)];
                put(x_row, 2 * *w, block.xx);
                put(x_row, 2 * *w + 1, block.xy);
                put(y_row, 2 * *w, block.yx);
                put(y_row, 2 * *w + 1, block.yy);
            }
        }
    });
    return model;
}

} // namespace morph
