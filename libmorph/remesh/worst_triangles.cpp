#include "libmorph/remesh/local_operations.h"
#include "libmorph/remesh/smoothing.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Raises the quality of single triangles.
class Mender {
public:
    Mender(RemeshState& made, double quality) : made_(made), net_(made.net), quality_(quality) {}

    std::size_t run()
    {
        constexpr int kRounds = 6;
        std::size_t left = 0;
        for (int round = 0; round < kRounds; ++round) {
            left = 0;
            bool changed = false;
            const Index present = net_.triangle_slots(); // those that splitting makes wait for the next round
            for (Index t = 0; t < present; ++t)
                if (net_.alive(t) && triangle_quality(made_, t) < quality_) {
                    changed = mend(t) || changed;
                    left += net_.alive(t) && triangle_quality(made_, t) < quality_ ? 1U : 0U;
                }
            if (!changed || left == 0)
                break;
        }
        return left;
    }

private:
    bool mend(Index t)
    {
        bool changed = false;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (improve_by_flip(h))
                changed = true;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (net_.alive(t))
                changed = improve_place(net_.from[at(h)]) || changed;
        if (net_.alive(t) && triangle_quality(made_, t) < quality_)
            changed = improve_by_collapse(t) || improve_by_split(t) || changed;
        return changed;
    }

    /// The better of the two diagonals, by the worse of the two triangles.
    bool improve_by_flip(Index h)
    {
        const Index g = net_.twin[at(h)];
        if (g < 0 || net_.tag[at(h)] != kNoTag)
            return false;
        const Eigen::Vector3d &a = net_.point(net_.from[at(h)]), &b = net_.point(net_.to(h)),
                              &c = net_.point(net_.apex(h)), &d = net_.point(net_.apex(g));
        const Eigen::Vector3d normal = surface_normal(made_, h / 3);
        if (!may_replace(made_, c, a, d, normal) || !may_replace(made_, d, b, c, normal) || joined(h))
            return false;
        const double before = std::min(triangle_quality(made_, h / 3), triangle_quality(made_, g / 3));
        const double after =
            std::min(triangle_quality(c, a, d, made_.planar), triangle_quality(d, b, c, made_.planar));
        if (after <= before)
            return false;
        net_.flip(h);
        return true;
    }

    bool joined(Index h)
    {
        net_.neighbours(net_.apex(h), near_);
        return std::find(near_.begin(), near_.end(), net_.apex(net_.twin[at(h)])) != near_.end();
    }

    /// Pattern search for the place of a free vertex where the worst triangle around it is best.
    bool improve_place(Index v)
    {
        if (net_.vertices[at(v)].curve != kFreeVertex)
            return false;
        constexpr double kFirstStep = 0.2, kLastStep = 0.01; // of the size wanted
        const double size = net_.vertices[at(v)].size;
        double best = star_quality(made_, v, net_.point(v));
        bool moved = false;
        constexpr int kMostSteps =
            200; // the size wanted may be much smaller than the triangles that there are
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
        const Eigen::Vector3d from = net_.point(v);
        for (int axis = 0; axis < (made_.planar ? 2 : 3); ++axis)
            for (const double sign : {1.0, -1.0}) {
                TableVertex moved = net_.vertices[at(v)];
                place_free(made_, moved, from + sign * step * Eigen::Vector3d::Unit(axis));
                const double quality = star_quality(made_, v, moved.point);
                if (quality <= best + 1e-6)
                    continue;
                best = quality;
                net_.vertices[at(v)] = moved;
                return true;
            }
        return false;
    }

    bool improve_by_collapse(Index t)
    {
        constexpr double kLongest =
            1.6; // of the length wanted: a little longer for the sake of a bad triangle
        const double least = triangle_quality(made_, t) + 0.05;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            for (const Index keep : {net_.to(h), net_.from[at(h)]})
                if (try_collapse_better(h, keep, least, kLongest))
                    return true;
        return false;
    }

    bool try_collapse_better(Index h, Index keep, double least, double longest)
    {
        return collapse_quality(h, keep) >= least && try_collapse(made_, h, keep, least, longest);
    }

    /// Worst of the triangles that stay around the vertex that goes.
    double collapse_quality(Index h, Index keep) const
    {
        const Index gone = net_.from[at(h)] == keep ? net_.to(h) : net_.from[at(h)];
        const Index g = net_.twin[at(h)];
        double worst = 1;
        net_.around(gone, [&](Index out) {
            if (out / 3 != h / 3 && (g < 0 || out / 3 != g / 3))
                worst = std::min(worst, triangle_quality(net_.point(keep), net_.point(net_.to(out)),
                                                         net_.point(net_.apex(out)), made_.planar));
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
        const Index g = net_.twin[at(longest)];
        double before = triangle_quality(made_, t);
        if (g >= 0)
            before = std::min(before, triangle_quality(made_, g / 3));
        if (relative_length(net_, net_.from[at(longest)], net_.to(longest)) < 1)
            return false;
        const Index middle = try_split(made_, longest);
        if (middle < 0)
            return false;
        improve_place(middle);
        if (star_quality(made_, middle, net_.point(middle)) <= before) {
            // As it was: the triangles that are new go, or they would be looked at in turn.
            const Index half = net_.vertices[at(middle)].out;
            net_.collapse(half, net_.to(half));
            return false;
        }
        std::vector<Index> sides;
        net_.around(middle, [&](Index h) { sides.push_back(CornerTable::next(h)); });
        for (const Index side : sides)
            improve_by_flip(side);
        improve_place(middle);
        return true;
    }

    double length(Index h) const { return (net_.point(net_.to(h)) - net_.point(net_.from[at(h)])).norm(); }

    RemeshState& made_;
    CornerTable& net_;
    double quality_;
    std::vector<Index> near_;
};

} // namespace

std::size_t mend_worst(RemeshState& made, double quality)
{
    return Mender(made, quality).run();
}

} // namespace morph
