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

/// Flips edges of one net.
class Flipper {
public:
    explicit Flipper(RemeshState& made) : made_(made), net_(made.net) {}

    std::size_t run()
    {
        std::size_t flips = 0;
        for (Index h = 0; h < static_cast<Index>(net_.from.size()); ++h) {
            if (net_.from[at(h)] < 0 || net_.twin[at(h)] < h)
                continue;
            pending_.push_back(h);
            // On a surface rounding could let an edge be flipped to and fro.
            for (int steps = 0; !pending_.empty() && steps < kLongestCascade; ++steps) {
                const Index edge = pending_.back();
                pending_.pop_back();
                if (!wanted(edge))
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

    bool wanted(Index h) const
    {
        const Index g = net_.twin[at(h)];
        if (g < 0 || net_.tag[at(h)] != kNoTag)
            return false;
        const Eigen::Vector3d &a = net_.point(net_.from[at(h)]), &b = net_.point(net_.to(h)),
                              &c = net_.point(net_.apex(h)), &d = net_.point(net_.apex(g));
        return made_.planar ? in_circle({a.x(), a.y()}, {b.x(), b.y()}, {c.x(), c.y()}, {d.x(), d.y()}) > 0
                            : wanted_on_surface(h, a, b, c, d);
    }

    bool wanted_on_surface(Index h, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c, const Eigen::Vector3d& d) const
    {
        constexpr double kMargin = 1e-9; // of the sine of the sum of both angles
        const Eigen::Vector2d p = angle_at(c, a, b), q = angle_at(d, a, b);
        const double sine = p.y() * q.x() + p.x() * q.y();
        if (sine >= -kMargin * p.norm() * q.norm())
            return false;
        const Eigen::Vector3d m = surface_normal(made_, h / 3),
                              n = surface_normal(made_, net_.twin[at(h)] / 3);
        return may_replace(made_, c, a, d, m) && may_replace(made_, c, a, d, n) &&
               may_replace(made_, d, b, c, m) && may_replace(made_, d, b, c, n) &&
               !joined(net_.apex(h), net_.apex(net_.twin[at(h)]));
    }

    bool joined(Index c, Index d) const
    {
        bool found = false;
        Index last = -1;
        net_.around(c, [&](Index out) {
            found = found || net_.to(out) == d;
            last = out;
        });
        return found || net_.apex(last) == d;
    }

    void flip(Index h)
    {
        const Index s = h - h % 3, t = net_.twin[at(h)] - net_.twin[at(h)] % 3;
        net_.flip(h);
        for (const Index side : {s, s + 1, t, t + 1})
            pending_.push_back(side);
    }

    RemeshState& made_;
    CornerTable& net_;
    std::vector<Index> pending_;
};

} // namespace

std::size_t flip_edges(RemeshState& made)
{
    return Flipper(made).run();
}

} // namespace morph
