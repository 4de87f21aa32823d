#include "libmorph/weights/lattice_weights.h"

#include "libmorph/core/parallel.h"

namespace morph {

SparseWeights lattice_weights(const Lattice& lattice, const Embedding& embedding)
{
    constexpr std::size_t kRowsPerBlock = 4096;
    const std::size_t rows = embedding.inside.size();
    SparseWeights weights;
    for (Index k = 0; k < lattice.control_point_count(); ++k)
        weights.columns.push_back({"lattice", k});
    std::vector<std::vector<Eigen::Triplet<double, Index>>> blocks((rows + kRowsPerBlock - 1) /
                                                                   kRowsPerBlock);
    parallel_for(rows, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            if (embedding.inside[v] == 0)
                continue;
            const auto row = static_cast<Index>(v);
            const LatticeRow basis = lattice.basis(embedding.parameters.row(row).transpose());
            for (std::size_t i = 0; i < basis.control.size(); ++i)
                blocks[begin / kRowsPerBlock].emplace_back(row, basis.control[i], basis.value[i]);
        }
    });
    auto& values = weights.values;
    values.resize(static_cast<Index>(rows), lattice.control_point_count());
    std::size_t entries = 0;
    for (const auto& block : blocks)
        entries += block.size();
    values.reserve(static_cast<Eigen::Index>(entries));
    Index row = 0;
    for (const auto& block : blocks)
        for (const auto& entry : block) { // by ascending row and column
            while (row <= entry.row())
                values.startVec(row++);
            values.insertBack(entry.row(), entry.col()) = entry.value();
        }
    while (row < values.rows())
        values.startVec(row++);
    values.finalize();
    return weights;
}

} // namespace morph
