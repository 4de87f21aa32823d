#include "libmorph/pipeline/detail/constraint_setup.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/deform/mirror_pairs.h"
#include "libmorph/mesh/chain.h"
#include "libmorph/pipeline/detail/pull_setup.h"

#include <algorithm>

namespace morph {

namespace {

std::string what(const std::string& where)
{
    return where + "[constraints] ";
}

/// Puts the settings into the terms of satisfy_constraints().
class Builder {
public:
    Builder(const Mesh& mesh, const ConstraintSettings& settings, const PreparedMotion& motion,
            const Matrix& displacements)
        : mesh_(mesh), settings_(settings), motion_(motion), displacements_(displacements)
    {
        set_.held = motion.held();
    }

    ConstraintSet build(const std::optional<PullOutcome>& pull)
    {
        for (const std::string& name : settings_.area)
            set_.areas.push_back({"area of '" + name + "'", boundary(name, settings_.where)});
        for (const ThicknessSettings& thickness : settings_.thicknesses)
            add_thickness(thickness);
        fix("fixed points",
            named_vertices(mesh_, settings_.fixed_vertices, settings_.fixed_points,
                           what(settings_.where) + "fixed_vertices"),
            {});
        if (pull)
            add_pulled(*pull);
        for (const TieSettings& tie : settings_.ties)
            add_tie(tie);
        for (const MirrorSettings& mirror : settings_.mirrors)
            add_mirror(mirror);
        keep_ends_together();
        return std::move(set_);
    }

private:
    [[noreturn]] static void fail(const std::string& where, const std::string& reason)
    {
        throw InputError(what(where) + reason);
    }

    ControlledPoints controlled(const std::vector<Index>& vertices) const
    {
        return controlled_vertices(motion_.rows(), points(mesh_), vertices);
    }

    /// The number of a closed boundary in the set.
    std::size_t boundary(const std::string& name, const std::string& where)
    {
        for (std::size_t b = 0; b < set_.boundaries.size(); ++b)
            if (set_.boundaries[b].name == name)
                return b;
        const auto found = std::find_if(mesh_.markers.begin(), mesh_.markers.end(),
                                        [&](const Marker& marker) { return marker.name == name; });
        if (found == mesh_.markers.end())
            fail(where, "the mesh has no marker '" + name + "'");
        const Chain chain = marker_chain(*found, mesh_.numbering);
        if (!chain.closed)
            fail(where, "marker '" + name + "' is not closed, so it has neither area nor thickness");
        set_.boundaries.push_back({name, controlled(chain.vertices)});
        return set_.boundaries.size() - 1;
    }

    void add_thickness(const ThicknessSettings& entry)
    {
        const auto kind = entry.at_least ? Bound::Kind::at_least : Bound::Kind::equal;
        for (const double x : entry.at) {
            Thickness thickness;
            thickness.name = "thickness of '" + entry.boundary + "' at x = " + short_number(x);
            thickness.boundary = boundary(entry.boundary, entry.where);
            thickness.at = {x, 0};
            thickness.bound = {kind, entry.value, entry.relative};
            set_.thicknesses.push_back(thickness);
        }
    }

    void fix(const std::string& name, const std::vector<Index>& vertices, const Matrix& displacements)
    {
        if (!vertices.empty())
            set_.fixed.push_back({name, controlled(vertices), displacements});
    }

    /// What a pull could not reach it need not reach now.
    void add_pulled(const PullOutcome& pull)
    {
        const std::vector<Index> vertices = named_vertices(mesh_, pull.vertices, Matrix::Zero(0, 3), "");
        const ControlledPoints pulled = controlled(vertices);
        set_.fixed.push_back({"[[pull]]", pulled, pulled.weights * displacements_});
    }

    bool of_lattice() const
    {
        return !motion_.columns().empty() && motion_.columns()[0].boundary == kLatticeName;
    }

    /// The number within its boundary or lattice.
    Index number_of(const std::array<Index, 3>& point) const
    {
        if (!of_lattice())
            return point[0];
        const std::array<Index, 3>& points = motion_.lattice->lattice.definition().points;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (point[axis] < 0 || point[axis] >= points[axis])
                return -1;
        return point[0] + points[0] * (point[1] + points[1] * point[2]);
    }

    void add_tie(const TieSettings& entry)
    {
        Tie tie{"tied control points of '" + entry.boundary + "'", {}};
        for (const std::array<Index, 3>& point : entry.points) {
            const ControlPoint named{entry.boundary, number_of(point)};
            const auto& columns = motion_.columns();
            const auto found = std::find(columns.begin(), columns.end(), named);
            if (found == columns.end())
                fail(entry.where,
                     "there is no such control point of '" + entry.boundary + "': " +
                         (of_lattice() ? "[" + std::to_string(point[0]) + ", " + std::to_string(point[1]) +
                                             ", " + std::to_string(point[2]) + "]"
                                       : std::to_string(point[0] + 1)));
            tie.control_points.push_back(static_cast<Index>(found - columns.begin()));
        }
        set_.ties.push_back(std::move(tie));
    }

    /// Where the control points of a boundary or lattice are.
    Matrix control_points_of(const MirrorSettings& entry) const
    {
        if (of_lattice() && entry.boundary == kLatticeName)
            return motion_.lattice->lattice.definition().control_points.leftCols(displacements_.cols());
        for (const CurveBoundary& boundary : motion_.curves.boundaries)
            if (boundary.name == entry.boundary && !of_lattice())
                return boundary.curve.definition().control_points;
        fail(entry.where, "there are no control points of '" + entry.boundary + "'");
    }

    void add_mirror(const MirrorSettings& entry)
    {
        Symmetry symmetry{"mirrored control points of '" + entry.boundary + "'", {}, entry.normal};
        const Matrix control_points = control_points_of(entry);
        try {
            symmetry.pairs = mirror_pairs(control_points, entry.at, entry.normal);
        } catch (const InputError& error) {
            fail(entry.where, error.what());
        }
        Index first = 0;
        while (motion_.columns()[static_cast<std::size_t>(first)].boundary != entry.boundary)
            ++first;
        for (auto& pair : symmetry.pairs)
            pair = {pair[0] + first, pair[1] + first};
        set_.symmetries.push_back(std::move(symmetry));
    }

    /// Curves that meet in a vertex meet there still, and one that ends on a fixed marker stays there.
    void keep_ends_together()
    {
        for (const SharedVertex& shared : motion_.curves.conditions.shared) {
            Tie tie{"the ends of boundaries at vertex " +
                        std::to_string(mesh_.numbering.vertex[static_cast<std::size_t>(shared.vertex)]),
                    {}};
            for (const SharedVertex::Claim& claim : shared.claims) {
                const Index first = motion_.curves.conditions.first_column[claim.boundary];
                const auto* values = claim.row.value.data();
                const auto end = std::max_element(values, values + claim.row.count) - values;
                tie.control_points.push_back(first + claim.row.control[static_cast<std::size_t>(end)]);
            }
            if (!shared.fixed_by.empty())
                set_.held.insert(set_.held.end(), tie.control_points.begin(), tie.control_points.end());
            else if (tie.control_points.size() > 1)
                set_.ties.push_back(std::move(tie));
        }
    }

    const Mesh& mesh_;
    const ConstraintSettings& settings_;
    const PreparedMotion& motion_;
    const Matrix& displacements_;
    ConstraintSet set_;
};

} // namespace

ConstrainedMove constrain(const Mesh& mesh, const MotionSettings& settings,
                          const std::optional<PullOutcome>& pull, const PreparedMotion& motion,
                          Matrix& displacements)
{
    const ConstraintSet set = Builder(mesh, *settings.constraints, motion, displacements).build(pull);
    const std::string place = what(settings.constraints->where);
    try {
        ConstrainedMove move = satisfy_constraints(set, displacements);
        displacements = move.displacements;
        return move;
    } catch (const InputError& error) {
        throw InputError(place + error.what());
    } catch (const SolverError& error) {
        throw SolverError(place + error.what());
    }
}

} // namespace morph
