#include "libmorph/numerics/assembly.h"

#include "libmorph/core/parallel.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 1024; // vertices a thread takes at a time

std::size_t at(Eigen::Index i)
{
    return static_cast<std::size_t>(i);
}

/// The patches around each vertex, ascending.
struct PatchesOfVertices {
    std::vector<std::size_t> start;
    std::vector<std::size_t> patch;
};

PatchesOfVertices patches_of_vertices(Index vertices, const VertexLists& patches)
{
    PatchesOfVertices around;
    around.start.resize(at(vertices) + 1);
    for (const Index v : patches.vertex)
        ++around.start[at(v) + 1];
    for (Index v = 0; v < vertices; ++v)
        around.start[at(v + 1)] += around.start[at(v)];
    around.patch.resize(patches.vertex.size());
    std::vector<std::size_t> next(around.start.begin(), around.start.end() - 1);
    for (std::size_t p = 0; p < patches.count(); ++p)
        for (std::size_t i = 0; i < patches.size(p); ++i)
            around.patch[next[at(patches.begin(p)[i])]++] = p;
    return around;
}

class PatchSum {
public:
    using Fill = std::function<void(std::size_t, ElementMatrix&)>;

    PatchSum(Index vertices, Index components, const VertexLists& patches, const Fill& fill)
        : patches_(patches), fill_(fill), c_(components), around_(patches_of_vertices(vertices, patches))
    {
        const std::size_t rows = vertices * c_;
        A_.diagonal.resize(rows);
        A_.start.resize(rows + 1);
    }

    SymmetricMatrix run()
    {
        for_vertices([this](std::size_t v) { count(v); });
        for (std::size_t row = 0; row + 1 < A_.start.size(); ++row)
            A_.start[row + 1] += A_.start[row];
        A_.column.resize(A_.start.back());
        A_.value.resize(A_.start.back());
        for_vertices([this](std::size_t v) { gather(v); });
        return std::move(A_);
    }

private:
    template <typename Body>
    void for_vertices(const Body& body) const
    {
        parallel_for(around_.start.size() - 1, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                body(v);
        });
    }

    /// The vertices that vertex v shares a patch with and itself, ascending.
    std::vector<Index> neighbours(std::size_t v) const
    {
        std::vector<Index> found;
        for (std::size_t k = around_.start[v]; k < around_.start[v + 1]; ++k) {
            const std::size_t p = around_.patch[k];
            found.insert(found.end(), patches_.begin(p), patches_.begin(p) + patches_.size(p));
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    void count(std::size_t v)
    {
        const std::size_t n = neighbours(v).size();
        for (Eigen::Index k = 0; k < c_; ++k)
            A_.start[v * c_ + k + 1] = n == 0 ? 0 : n * c_ - 1;
    }

    /// The rows of vertex v.
    void gather(std::size_t v)
    {
        const std::vector<Index> columns = neighbours(v);
        Matrix rows = Matrix::Zero(c_, c_ * static_cast<Eigen::Index>(columns.size()));
        ElementMatrix dense;
        for (std::size_t k = around_.start[v]; k < around_.start[v + 1]; ++k)
            add_patch(around_.patch[k], static_cast<Index>(v), columns, dense, rows);
        for (Eigen::Index k = 0; k < c_; ++k)
            put(v * c_ + k, columns, rows.row(k));
    }

    void add_patch(std::size_t p, Index v, const std::vector<Index>& columns, ElementMatrix& dense,
                   Matrix& rows) const
    {
        const auto n = static_cast<Eigen::Index>(patches_.size(p));
        const Index* corners = patches_.begin(p);
        dense.setZero(c_ * n, c_ * n);
        fill_(p, dense);
        const Eigen::Index mine = std::find(corners, corners + n, v) - corners;
        for (Eigen::Index j = 0; j < n; ++j) {
            const Eigen::Index place =
                std::lower_bound(columns.begin(), columns.end(), corners[j]) - columns.begin();
            rows.middleCols(c_ * place, c_) += dense.block(c_ * mine, c_ * j, c_, c_);
        }
    }

    void put(std::size_t row, const std::vector<Index>& columns,
             const Eigen::Ref<const Eigen::RowVectorXd>& values)
    {
        std::size_t next = A_.start[row];
        for (Eigen::Index j = 0; j < values.size(); ++j) {
            const std::size_t column = columns[at(j / c_)] * c_ + j % c_;
            if (column == row) {
                A_.diagonal[row] = values[j];
                continue;
            }
            A_.column[next] = static_cast<Index>(column);
            A_.value[next++] = values[j];
        }
    }

    const VertexLists& patches_;
    const Fill& fill_;
    Eigen::Index c_;
    PatchesOfVertices around_;
    SymmetricMatrix A_;
};

} // namespace

SymmetricMatrix assemble(Index vertices, Index components, const VertexLists& patches,
                         const std::function<void(std::size_t p, ElementMatrix& matrix)>& fill)
{
    return PatchSum(vertices, components, patches, fill).run();
}

} // namespace morph
