#include "libmorph/remesh/worst_triangles.h"

#include "libmorph/remesh/local_operations.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Raises the quality of single triangles.
class Improver {
public:
    Improver(RemeshState& state, double quality) : state_(state), table_(state.table), quality_(quality) {}

    std::size_t run()
    {
        constexpr int kRounds = 6;
        std::size_t left = 0;
        for (int round = 0; round < kRounds; ++round) {
            left = 0;
            bool changed = false;
            const Index present =
                table_.triangle_slots(); // those that splitting makes wait for the next round
            for (Index t = 0; t < present; ++t)
                if (table_.alive(t) && triangle_quality(state_, t) < quality_) {
                    changed = improve(t) || changed;
                    left += table_.alive(t) && triangle_quality(state_, t) < quality_ ? 1U : 0U;
                }
            if (!changed || left == 0)
                break;
        }
        return left;
    }

private:
    bool improve(Index t)
    {
        bool changed = false;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (improve_by_flip(h))
                changed = true;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (table_.alive(t))
                changed = improve_place(table_.from[at(h)]) || changed;
        if (table_.alive(t) && triangle_quality(state_, t) < quality_)
            changed = improve_by_collapse(t) || improve_by_split(t) || changed;
        return changed;
    }

    /// The better of the two diagonals, by the worse of the two triangles.
    bool improve_by_flip(Index h)
    {
        const Index g = table_.twin[at(h)];
        if (g < 0 || table_.tag[at(h)] != kNoTag)
            return false;
        const Eigen::Vector3d &a = table_.point(table_.from[at(h)]), &b = table_.point(table_.to(h)),
                              &c = table_.point(table_.apex(h)), &d = table_.point(table_.apex(g));
        const Eigen::Vector3d normal = surface_normal(state_, h / 3);
        if (!may_replace(state_, c, a, d, normal) || !may_replace(state_, d, b, c, normal) || joined(h))
            return false;
        const double before = std::min(triangle_quality(state_, h / 3), triangle_quality(state_, g / 3));
        const double after =
            std::min(triangle_quality(c, a, d, state_.planar), triangle_quality(d, b, c, state_.planar));
        if (after <= before)
            return false;
        table_.flip(h);
        return true;
    }

    bool joined(Index h)
    {
        table_.neighbours(table_.apex(h), near_);
        return std::find(near_.begin(), near_.end(), table_.apex(table_.twin[at(h)])) != near_.end();
    }

    /// Pattern search for the place of a free vertex where the worst triangle around it is best.
    bool improve_place(Index v)
    {
        if (table_.vertices[at(v)].curve != kFreeVertex)
            return false;
        constexpr double kFirstStep = 0.2, kLastStep = 0.01; // of the target size
        const double size = table_.vertices[at(v)].size;
        double best = star_quality(state_, v, table_.point(v));
        bool moved = false;
        constexpr int kMostSteps =
            200; // the target size may be much smaller than the triangles that there are
        double step = kFirstStep;
        for (int i = 0; i < kMostSteps && step >= kLastStep; ++i) {
            const bool better = best < 1 && step_from(v, step * size, best);
            moved = moved || better;
            step = better ? step : step / 2;
        }
        return moved;
    }

    bool step_from(Index v, double step, double& best)
    {
        const Eigen::Vector3d from = table_.point(v);
        for (int axis = 0; axis < (state_.planar ? 2 : 3); ++axis)
            for (const double sign : {1.0, -1.0}) {
                TableVertex moved = table_.vertices[at(v)];
                put_at(state_, moved, from + sign * step * Eigen::Vector3d::Unit(axis));
                const double quality = star_quality(state_, v, moved.point);
                if (quality <= best + 1e-6)
                    continue;
                best = quality;
                table_.vertices[at(v)] = moved;
                return true;
            }
        return false;
    }

    bool improve_by_collapse(Index t)
    {
        constexpr double kLongest =
            1.6; // of the target length: a little longer for the sake of a bad triangle
        const double least = triangle_quality(state_, t) + 0.05;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            for (const Index keep : {table_.to(h), table_.from[at(h)]})
                if (try_collapse_better(h, keep, least, kLongest))
                    return true;
        return false;
    }

    bool try_collapse_better(Index h, Index keep, double least, double longest)
    {
        return collapse_quality(h, keep) >= least && try_collapse(state_, h, keep, least, longest);
    }

    /// Worst of the triangles that stay around the vertex that goes.
    double collapse_quality(Index h, Index keep) const
    {
        const Index gone = table_.from[at(h)] == keep ? table_.to(h) : table_.from[at(h)];
        const Index g = table_.twin[at(h)];
        double worst = 1;
        table_.around(gone, [&](Index out) {
            if (out / 3 != h / 3 && (g < 0 || out / 3 != g / 3))
                worst = std::min(worst, triangle_quality(table_.point(keep), table_.point(table_.to(out)),
                                                         table_.point(table_.apex(out)), state_.planar));
        });
        return worst;
    }

    /// Split the longest edge and let the new vertex find its place, if that is an improvement.
    bool improve_by_split(Index t)
    {
        Index longest = 3 * t;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (length(h) > length(longest))
                longest = h;
        const Index g = table_.twin[at(longest)];
        double before = triangle_quality(state_, t);
        if (g >= 0)
            before = std::min(before, triangle_quality(state_, g / 3));
        if (relative_length(table_, table_.from[at(longest)], table_.to(longest)) < 1)
            return false;
        const Index middle = try_split(state_, longest);
        if (middle < 0)
            return false;
        improve_place(middle);
        if (star_quality(state_, middle, table_.point(middle)) <= before) {
            // As it was: the triangles that are new go, or they would be looked at in turn.
            const Index half = table_.vertices[at(middle)].out;
            table_.collapse(half, table_.to(half));
            return false;
        }
        std::vector<Index> sides;
        table_.around(middle, [&](Index h) { sides.push_back(CornerTable::next(h)); });
        for (const Index side : sides)
            improve_by_flip(side);
        improve_place(middle);
        return true;
    }

    double length(Index h) const
    {
        return (table_.point(table_.to(h)) - table_.point(table_.from[at(h)])).norm();
    }

    RemeshState& state_;
    CornerTable& table_;
    double quality_;
    std::vector<Index> near_;
};

} // namespace

std::size_t improve_worst(RemeshState& state, double quality)
{
    return Improver(state, quality).run();
}

} // namespace morph
