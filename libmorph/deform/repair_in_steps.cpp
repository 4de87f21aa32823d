#include "libmorph/deform/repair_in_steps.h"

#include "libmorph/deform/loop_path.h"
#include "libmorph/mesh/boundary_loops.h"
#include "libmorph/weights/harmonic.h"

#include <algorithm>

namespace morph {

namespace {

constexpr double kFirstStep = 0.25;       // part of the way
constexpr double kLeastStep = 1.0 / 1024; // shorter ones are not tried
constexpr double kGrowth = 1.5;           // of a step after one that went well
constexpr int kIterations = 40;           // for each patch: a shorter step costs less than more of them

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// The way of the held vertices.
class BoundaryPath {
public:
    BoundaryPath(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)
        : from_(displacement.rows(), 2), to_(displacement.rows(), 2), row_(held.vertices.size())
    {
        const std::vector<Index> first = representatives(mesh.numbering);
        std::vector<Index> row_of(first.size(), -1);
        for (std::size_t i = held.vertices.size(); i-- > 0;) {
            const Index v = held.vertices[i];
            row_of[at(v)] = static_cast<Index>(i);
            from_.row(static_cast<Index>(i)) = points(mesh).row(v).head<2>();
            to_.row(static_cast<Index>(i)) =
                from_.row(static_cast<Index>(i)) + displacement.row(static_cast<Index>(i));
        }
        for (std::size_t i = 0; i < row_.size(); ++i)
            row_[i] = row_of[at(first[at(held.vertices[i])])];
        for (std::vector<Index>& loop : boundary_loops(mesh)) {
            for (Index& v : loop)
                v = row_of[at(v)];
            add(std::move(loop));
        }
    }

    /// Where they are after the part @p f of the way, k x 2.
    Points2 at_part(double f) const
    {
        Points2 there = f == 1 ? to_ : Points2(from_ + f * (to_ - from_));
        for (const Loop& loop : loops_) {
            const auto corners = loop.path.at(f);
            for (std::size_t i = 0; i < corners.size(); ++i)
                there.row(loop.rows[i]) << corners[i].real(), corners[i].imag();
        }
        for (std::size_t i = 0; i < row_.size(); ++i)
            if (row_[i] >= 0)
                there.row(static_cast<Index>(i)) = there.row(row_[i]);
        return there;
    }

private:
    struct Loop {
        std::vector<Index> rows;
        LoopPath path;
    };

    void add(std::vector<Index> rows)
    {
        if (std::all_of(rows.begin(), rows.end(), [&](Index i) { return from_.row(i) == to_.row(i); }))
            return;
        const auto from = corners(from_, rows), to = corners(to_, rows);
        if (has_flat_edge(from) || has_flat_edge(to))
            return;
        loops_.push_back({std::move(rows), LoopPath(from, to)});
    }

    static bool has_flat_edge(const std::vector<std::complex<double>>& corners)
    {
        return corners.front() == corners.back() ||
               std::adjacent_find(corners.begin(), corners.end()) != corners.end();
    }

    static std::vector<std::complex<double>> corners(const Points2& places, const std::vector<Index>& rows)
    {
        std::vector<std::complex<double>> list(rows.size());
        std::transform(rows.begin(), rows.end(), list.begin(),
                       [&](Index i) { return std::complex<double>(places(i, 0), places(i, 1)); });
        return list;
    }

    Points2 from_;
    Points2 to_;
    std::vector<Index> row_; // of the first copy of each held vertex
    std::vector<Loop> loops_;
};

/// Where all vertices go when the held ones go to @p there.
Points carried(const Mesh& mesh, const DirichletBoundary& held, const Points2& there)
{
    Points2 increment(there.rows(), 2);
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        increment.row(static_cast<Index>(i)) =
            there.row(static_cast<Index>(i)) - points(mesh).row(held.vertices[i]).head<2>();
    Points after = points(mesh);
    after.leftCols<2>() += harmonic_extension(mesh, held, Diffusivity::inverse_area)->extend(increment);
    for (std::size_t i = 0; i < held.vertices.size(); ++i) // without the rounding of difference and sum
        after.row(held.vertices[i]).head<2>() = there.row(static_cast<Index>(i));
    return after;
}

} // namespace

Points repair_in_steps(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement,
                       UntangleResult& work)
{
    const BoundaryPath path(mesh, held, displacement);
    UntangleOptions options;
    options.iterations = kIterations;
    options.reinitialize = false;
    Mesh moving = mesh;
    double done = 0, step = kFirstStep;
    while (done < 1 && step >= kLeastStep) {
        const double next = std::min(done + step, 1.0);
        Points after = carried(moving, held, path.at_part(next));
        const UntangleResult repaired = untangle(mesh, points(mesh), held.vertices, after, options);
        work.patch_vertices += repaired.patch_vertices;
        work.iterations += repaired.iterations;
        if (repaired.valid) {
            points(moving) = after;
            done = next;
            step *= kGrowth;
        } else
            step = 0.5 * (next - done);
    }
    return done < 1 ? carried(moving, held, path.at_part(1)) : points(moving);
}

} // namespace morph
