#include "libmorph/remap/conserve_nodes.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/remap/mass_matrix.h"
#include "libmorph/remap/mixed_mass.h"
#include "libmorph/remap/supermesh.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 1024; // elements of the target

// Share of a triangle that must be covered for it to be taken consistently.
constexpr double kConsistent = 0.5;

void require_a_row_each(const Mesh& source, const Matrix& values)
{
    if (values.rows() != vertex_count(source))
        throw InputError("there are " + std::to_string(values.rows()) +
                         " rows of nodal values, but the source has " + std::to_string(vertex_count(source)) +
                         " vertices");
}

/// What a block of elements adds to the right-hand side.
class BlockSum {
public:
    BlockSum() = default;
    BlockSum(const Mesh& mesh, std::size_t begin, std::size_t end, Eigen::Index columns)
    {
        for (std::size_t f = begin; f < end; ++f)
            for (const VertexHandle v : mesh.kernel.fv_range(FaceHandle(static_cast<Index>(f))))
                vertices_.push_back(v.idx());
        std::sort(vertices_.begin(), vertices_.end());
        vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
        sums_ = Matrix::Zero(static_cast<Eigen::Index>(vertices_.size()), columns);
    }

    double* row(Index vertex)
    {
        const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
        return sums_.row(found - vertices_.begin()).data();
    }

    void add_to(Matrix& R) const
    {
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            R.row(vertices_[i]) += sums_.row(static_cast<Eigen::Index>(i));
    }

private:
    std::vector<Index> vertices_; ///< ascending
    Matrix sums_;
};

/// The matrices of the triangles and the right-hand side, as the overlaps come.
class Assembly {
public:
    Assembly(const Supermesh& overlaps, const Mesh& target, const Matrix& values)
        : overlaps_(overlaps), target_(target), values_(values)
    {
        const auto faces = static_cast<std::size_t>(element_count(target));
        masses_.assign(static_cast<std::size_t>(overlaps.first_piece().back()), {});
        areas_.assign((faces + kRowsPerBlock - 1) / kRowsPerBlock, 0);
        sums_.resize(areas_.size());
        parallel_for(faces, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            BlockSum sum(target_, begin, end, values_.cols());
            overlaps_.visit(begin, end, [&](const SupermeshCell& piece) {
                areas_[begin / kRowsPerBlock] += piece.area;
                add(piece, sum);
            });
            sums_[begin / kRowsPerBlock] = std::move(sum);
        });
    }

    const std::vector<TriangleMass>& masses() const { return masses_; }
    double area() const { return std::accumulate(areas_.begin(), areas_.end(), 0.0); }

    Matrix right_hand_side() const
    {
        Matrix R = Matrix::Zero(vertex_count(target_), values_.cols());
        for (const BlockSum& sum : sums_)
            sum.add_to(R);
        return R;
    }

private:
    void add(const SupermeshCell& covered, BlockSum& sum)
    {
        const bool consistent = covered.area >= kConsistent * covered.piece.area;
        Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
        std::array<double*, 3> rows{};
        for (std::size_t i = 0; i < 3; ++i)
            rows[i] = sum.row(covered.piece.vertices[i]);
        for (const Overlap& overlap : covered.covers) {
            const MixedMass mass =
                consistent ? mixed_mass(covered.piece, overlap) : lumped_mixed_mass(covered.piece, overlap);
            own += mass.own;
            add(mass, overlap.source.vertices, rows);
        }
        masses_[static_cast<std::size_t>(covered.number)] = {own(0, 0), own(0, 1), own(0, 2),
                                                             own(1, 1), own(1, 2), own(2, 2)};
    }

    /// As the first corner's value and the differences from it, so that what is constant stays so.
    void add(const MixedMass& mass, const std::array<Index, 4>& vertices, const std::array<double*, 3>& rows)
    {
        const double* first = values_.row(vertices[0]).data();
        const double* second = values_.row(vertices[1]).data();
        const double* third = values_.row(vertices[2]).data();
        const Eigen::Vector3d integrals = mass.own.rowwise().sum();
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index k = 0; k < values_.cols(); ++k)
                rows[static_cast<std::size_t>(i)][k] += integrals[i] * first[k] +
                                                        mass.mixed(i, 1) * (second[k] - first[k]) +
                                                        mass.mixed(i, 2) * (third[k] - first[k]);
    }

    const Supermesh& overlaps_;
    const Mesh& target_;
    const Matrix& values_;
    std::vector<TriangleMass> masses_;
    std::vector<double> areas_;  ///< covered, by block
    std::vector<BlockSum> sums_; ///< by block
};

/// M u = R.
struct System {
    MassMatrix M;
    Matrix R;
    double area; ///< of the common region
};

/// What it takes to get there is gone once it is made, before the memory for solving is needed.
System assemble(const Locator& source, const Mesh& target, const Matrix& values)
{
    const Supermesh overlaps(source, target, Cut::triangles);
    const Assembly assembly(overlaps, target, values);
    return {MassMatrix(target, overlaps.first_piece(), assembly.masses()), assembly.right_hand_side(),
            assembly.area()};
}

} // namespace

Transfer conserve_nodes(const Locator& source, const Mesh& target, const Matrix& values)
{
    require_a_row_each(source.source(), values);
    const System system = assemble(source, target, values);
    Transfer transfer;
    transfer.values = system.M.solve(system.R);
    transfer.covered = system.M.row_sums();
    transfer.source_integral = system.R.colwise().sum();
    transfer.covered_area = system.area;
    transfer.target_area = total_area(target);
    transfer.source_area = total_area(source.source());
    return transfer;
}

} // namespace morph
