#include "libmorph/deform/move_in_steps.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/rigid_frames.h"
#include "libmorph/quality/safe_step.h"

#include <Eigen/Geometry>

#include <string>

namespace morph {

namespace {

constexpr double kSafeStepShare = 0.5; // of the safe step is taken: beyond it elements are thin already

/// The way of the held vertices.
class BoundaryPath {
public:
    BoundaryPath(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)
        : held_(held), displacement_(displacement), frames_(boundary_frames(mesh, held, displacement)),
          start_(held.vertices.size(), 2)
    {
        for (std::size_t i = 0; i < held.vertices.size(); ++i)
            start_.row(static_cast<Index>(i)) = points(mesh).row(held.vertices[i]).head<2>();
    }

    /// Where they are after the part @p f of it, k x 2.
    Points2 at(double f) const
    {
        if (f == 1)
            return start_ + displacement_;
        Points2 there = start_ + f * displacement_;
        for (std::size_t i = 0; i < held_.vertices.size(); ++i)
            if (frames_.body[i] >= 0)
                there.row(static_cast<Index>(i)) = on_body(i, f);
        return there;
    }

    const DirichletBoundary& held() const { return held_; }

private:
    Eigen::RowVector2d on_body(std::size_t i, double f) const
    {
        const auto row = static_cast<Index>(i);
        const Eigen::RowVector2d pivot = frames_.pivot.row(frames_.body[i]);
        const Eigen::Rotation2Dd turn(f * frames_.angle[i]);
        const Eigen::Vector2d arm = (start_.row(row) - pivot).transpose();
        return pivot + f * frames_.translation.row(row) + (turn * arm).transpose();
    }

    const DirichletBoundary& held_;
    const Matrix& displacement_;
    BoundaryFrames frames_;
    Points2 start_;
};

/// Where all vertices go when the held ones go to @p there.
Points moved_to(const Mesh& mesh, const DirichletBoundary& held, const Points2& there,
                const BoundaryMove& move)
{
    Matrix displacement(there.rows(), 2);
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        displacement.row(static_cast<Index>(i)) =
            there.row(static_cast<Index>(i)) - points(mesh).row(held.vertices[i]).head<2>();
    Points after = points(mesh);
    after.leftCols<2>() += move(mesh, held, displacement);
    for (std::size_t i = 0; i < held.vertices.size(); ++i) // without the rounding of difference and sum
        after.row(held.vertices[i]).head<2>() = there.row(static_cast<Index>(i));
    return after;
}

int move_evenly(Mesh& mesh, const BoundaryPath& path, const BoundaryMove& move, int steps)
{
    for (int s = 1; s <= steps; ++s)
        points(mesh) = moved_to(mesh, path.held(), path.at(static_cast<double>(s) / steps), move);
    return steps;
}

int move_as_safe(Mesh& mesh, const BoundaryPath& path, const BoundaryMove& move)
{
    double done = 0;
    for (int step = 1;; ++step) {
        const Points whole = moved_to(mesh, path.held(), path.at(1), move);
        const double safe = safe_step(mesh, points(mesh), whole).step;
        if (safe == 1 || safe == 0 || step == kMostAutoSteps) {
            points(mesh) = whole;
            return step;
        }
        done += kSafeStepShare * safe * (1 - done);
        points(mesh) = moved_to(mesh, path.held(), path.at(done), move);
    }
}

} // namespace

int move_in_steps(Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement,
                  const BoundaryMove& move, int steps)
{
    if (steps < 0)
        throw InputError("a move takes at least 1 step, not " + std::to_string(steps));
    const BoundaryPath path(mesh, held, displacement);
    return steps == kAutoSteps ? move_as_safe(mesh, path, move) : move_evenly(mesh, path, move, steps);
}

} // namespace morph
