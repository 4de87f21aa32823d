#include "libmorph/pipeline/detail/check_and_repair.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/repair.h"
#include "libmorph/pipeline/detail/polygon_crossings.h"

#include <algorithm>

namespace morph {

namespace {

Mesh at_positions(const Mesh& mesh, const Points& positions)
{
    Mesh moved = mesh;
    points(moved) = positions;
    return moved;
}

void untangle_moved(const Mesh& mesh, MoveResult& result)
{
    result.tangled = static_cast<Index>(inverted_elements(mesh, result.positions).size());
    if (result.tangled == 0)
        return;
    Mesh moved = at_positions(mesh, result.positions);
    result.untangled = repair(moved, points(mesh));
    result.positions = points(moved);
    for (std::vector<Index>* list : {&result.untangled->inverted, &result.untangled->unrepairable}) {
        for (Index& element : *list)
            element = mesh.numbering.element[static_cast<std::size_t>(element)];
        std::sort(list->begin(), list->end());
    }
}

/// The last resort, for what positions alone cannot repair.
void remesh_moved(const Mesh& mesh, MoveResult& result)
{
    Mesh moved = at_positions(mesh, result.positions);
    try {
        result.remeshed = remesh_bad_part(moved, points(mesh));
    } catch (const InputError& error) {
        result.warnings.emplace_back(error.what());
    }
    if (!result.remeshed)
        return;
    result.positions = points(moved);
    result.mesh = std::move(moved);
}

} // namespace

void check_and_repair(const Mesh& mesh, const PlacedBoundaries& placed, const Matrix& curve_displacements,
                      Guard guard, MoveResult& result)
{
    if (guard == Guard::none)
        return;
    result.crossings = boundary_crossings(placed, curve_displacements);
    if (result.crossings.empty() && mesh.dimension == 2)
        result.crossings = polygon_crossings(mesh, points(mesh), result.positions);
    result.before = quality_report(mesh);
    if ((guard == Guard::untangle || guard == Guard::remesh) && result.crossings.empty())
        untangle_moved(mesh, result);
    if (guard == Guard::remesh && result.crossings.empty() && mesh.dimension == 2)
        remesh_moved(mesh, result);
    result.after = result.mesh ? quality_report(*result.mesh) : quality_report(mesh, result.positions);
}

} // namespace morph
