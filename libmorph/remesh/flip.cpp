#include "libmorph/core/predicates.h"
#include "libmorph/remesh/local_operations.h"

#include <Eigen/Geometry>

#include <cmath>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Cosine of the angle at @p p and, as second number, its sine, both times the lengths.
Eigen::Vector2d angle_at(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return {(a - p).dot(b - p), (a - p).cross(b - p).norm()};
}

/// Flips edges of one corner table.
class Flipper {
public:
    explicit Flipper(RemeshState& state) : state_(state), table_(state.table) {}

    std::size_t run()
    {
        std::size_t flips = 0;
        for (Index h = 0; h < static_cast<Index>(table_.from.size()); ++h) {
            if (table_.from[at(h)] < 0 || table_.twin[at(h)] < h)
                continue;
            pending_.push_back(h);
            // On a surface rounding could let an edge be flipped to and fro.
            for (int steps = 0; !pending_.empty() && steps < kLongestCascade; ++steps) {
                const Index edge = pending_.back();
                pending_.pop_back();
                if (!is_better(edge))
                    continue;
                flip(edge);
                ++flips;
            }
            pending_.clear();
        }
        return flips;
    }

private:
    static constexpr int kLongestCascade = 100000;

    bool is_better(Index h) const
    {
        const Index g = table_.twin[at(h)];
        if (g < 0 || table_.tag[at(h)] != kNoTag)
            return false;
        const Eigen::Vector3d &a = table_.point(table_.from[at(h)]), &b = table_.point(table_.to(h)),
                              &c = table_.point(table_.apex(h)), &d = table_.point(table_.apex(g));
        return state_.planar ? in_circle({a.x(), a.y()}, {b.x(), b.y()}, {c.x(), c.y()}, {d.x(), d.y()}) > 0
                             : is_better_on_surface(h, a, b, c, d);
    }

    bool is_better_on_surface(Index h, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c, const Eigen::Vector3d& d) const
    {
        constexpr double kMargin = 1e-9; // of the sine of the sum of both angles
        const Eigen::Vector2d p = angle_at(c, a, b), q = angle_at(d, a, b);
        const double sine = p.y() * q.x() + p.x() * q.y();
        if (sine >= -kMargin * p.norm() * q.norm())
            return false;
        const Eigen::Vector3d m = surface_normal(state_, h / 3),
                              n = surface_normal(state_, table_.twin[at(h)] / 3);
        return may_replace(state_, c, a, d, m) && may_replace(state_, c, a, d, n) &&
               may_replace(state_, d, b, c, m) && may_replace(state_, d, b, c, n) &&
               !joined(table_.apex(h), table_.apex(table_.twin[at(h)]));
    }

    bool joined(Index c, Index d) const
    {
        bool found = false;
        Index last = -1;
        table_.around(c, [&](Index out) {
            found = found || table_.to(out) == d;
            last = out;
        });
        return found || table_.apex(last) == d;
    }

    void flip(Index h)
    {
        const Index s = h - h % 3, t = table_.twin[at(h)] - table_.twin[at(h)] % 3;
        table_.flip(h);
        for (const Index side : {s, s + 1, t, t + 1})
            pending_.push_back(side);
    }

    RemeshState& state_;
    CornerTable& table_;
    std::vector<Index> pending_;
};

} // namespace

std::size_t flip_edges(RemeshState& state)
{
    return Flipper(state).run();
}

} // namespace morph
