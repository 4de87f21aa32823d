#include "libmorph/remesh/hessian_recovery.h"

#include "libmorph/core/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// The vertices that share an edge with each vertex.
class Neighbours {
public:
    explicit Neighbours(const Mesh& mesh) : first_(at(vertex_count(mesh)) + 1, 0)
    {
        const auto edges = static_cast<Index>(mesh.kernel.n_edges());
        const auto end = [&](Index halfedge) {
            return at(mesh.kernel.to_vertex_handle(HalfedgeHandle(halfedge)).idx());
        };
        for (Index h = 0; h < 2 * edges; ++h)
            ++first_[end(h) + 1];
        for (std::size_t v = 1; v < first_.size(); ++v)
            first_[v] += first_[v - 1];
        of_.resize(at(2 * edges));
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (Index h = 0; h < 2 * edges; ++h)
            of_[next[end(h)]++] = static_cast<Index>(end(h % 2 == 0 ? h + 1 : h - 1));
    }

    /// Two rings around a vertex, ascending, without itself; replaces what is in @p patch. Not the further
    /// ring of a vertex that has many neighbours: one of them alone would make patches of the whole mesh.
    void two_rings(Index v, std::vector<Index>& patch) const
    {
        patch.clear();
        append(v, patch);
        const std::size_t ring = patch.size();
        for (std::size_t i = 0; i < ring && ring < kMaxNeighbours; ++i)
            if (first_[at(patch[i]) + 1] - first_[at(patch[i])] < kMaxNeighbours)
                append(patch[i], patch);
        std::sort(patch.begin(), patch.end());
        patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
        std::erase(patch, v);
    }

private:
    static constexpr std::size_t kMaxNeighbours = 30;

    void append(Index v, std::vector<Index>& patch) const
    {
        for (std::size_t i = first_[at(v)]; i < first_[at(v) + 1]; ++i)
            patch.push_back(of_[i]);
    }

    std::vector<std::size_t> first_;
    std::vector<Index> of_;
};

Points vertex_normals(const Mesh& mesh)
{
    Points normals = Points::Zero(vertex_count(mesh), 3);
    const auto place = points(mesh);
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        const Index last = e[3] < 0 ? e[2] : e[3];
        const Eigen::RowVector3d one = place.row(e[2]) - place.row(e[0]),
                                 two = place.row(last) - place.row(e[1]);
        for (const Index v : e)
            if (v >= 0)
                normals.row(v) += one.cross(two); // of the diagonals, or of two sides
    }
    return normals;
}

/// A patch in the plane: x and y of each vertex from the one in its middle.
using Layout = Eigen::Matrix<double, Eigen::Dynamic, 2>;

class Recovery {
public:
    Recovery(const Mesh& mesh, const Eigen::VectorXd& values)
        : place_(points(mesh)), values_(values), neighbours_(mesh)
    {
        if (mesh.dimension == 3)
            normals_ = vertex_normals(mesh);
    }

    /// Of a range of vertices.
    void run(Index begin, Index end, Eigen::VectorXd& largest) const
    {
        std::vector<Index> patch;
        for (Index v = begin; v < end; ++v) {
            neighbours_.two_rings(v, patch);
            largest[v] = patch.empty() ? 0 : at_vertex(v, patch);
        }
    }

private:
    Layout laid_out(Index v, const std::vector<Index>& patch) const
    {
        Layout layout(static_cast<Eigen::Index>(patch.size()), 2);
        Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
        if (normals_.rows() > 0 && normals_.row(v).norm() > 0) {
            const Eigen::Vector3d normal = normals_.row(v).normalized();
            x = normal.unitOrthogonal();
            y = normal.cross(x);
        }
        for (std::size_t i = 0; i < patch.size(); ++i) {
            const Eigen::Vector3d away = place_.row(patch[i]) - place_.row(v);
            Eigen::RowVector2d flat(away.dot(x), away.dot(y));
            if (normals_.rows() > 0 && flat.norm() > 0)
                flat *= away.norm() / flat.norm();
            layout.row(static_cast<Eigen::Index>(i)) = flat;
        }
        return layout;
    }

    double at_vertex(Index v, const std::vector<Index>& patch) const
    {
        constexpr double kLeastAxisRatio =
            1e-12; // the patch's narrow axis by its long one, below which it is a line
        const Layout layout = laid_out(v, patch);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(layout.transpose() * layout /
                                                                  static_cast<double>(patch.size()));
        const Eigen::Vector2d extent = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
        if (!(extent[0] > kLeastAxisRatio * extent[1]))
            return 0;
        const Eigen::Matrix2d scaling = axes.eigenvectors() * extent.cwiseInverse().asDiagonal();
        const Eigen::Matrix2d hessian = scaling * fitted(layout * scaling, v, patch) * scaling.transpose();
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(hessian, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .cwiseAbs()
            .maxCoeff();
    }

    /// Hessian of the quadratic fitted to a patch of extent 1 along both axes. Normal equations do, and a
    /// small multiple of the identity takes the least solution where a patch has too few vertices.
    Eigen::Matrix2d fitted(const Layout& layout, Index v, const std::vector<Index>& patch) const
    {
        constexpr double kRegularization = 1e-10; // of the trace
        using Row = Eigen::Matrix<double, 5, 1>;
        Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
        Row right = Row::Zero();
        for (Eigen::Index i = 0; i < layout.rows(); ++i) {
            const double x = layout(i, 0), y = layout(i, 1);
            const double distance2 = x * x + y * y;
            if (!(distance2 > 0))
                continue;
            Row row;
            row << x, y, x * x / 2, x * y, y * y / 2;
            normal += row * row.transpose() / distance2;
            right += (values_[patch[static_cast<std::size_t>(i)]] - values_[v]) / distance2 * row;
        }
        normal.diagonal().array() += kRegularization * normal.trace();
        const Row found = normal.ldlt().solve(right);
        Eigen::Matrix2d hessian;
        hessian << found[2], found[3], found[3], found[4];
        return hessian;
    }

    Eigen::Map<const Points> place_;
    const Eigen::VectorXd& values_;
    Neighbours neighbours_;
    Points normals_; ///< of a surface; not scaled
};

} // namespace

Eigen::VectorXd largest_second_derivative(const Mesh& mesh, const Eigen::VectorXd& values)
{
    constexpr std::size_t kBlock = 1024;
    const Recovery recovery(mesh, values);
    Eigen::VectorXd largest(vertex_count(mesh));
    parallel_for(at(vertex_count(mesh)), kBlock, [&](std::size_t begin, std::size_t end) {
        recovery.run(static_cast<Index>(begin), static_cast<Index>(end), largest);
    });
    return largest;
}

} // namespace morph
