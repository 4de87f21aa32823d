#pragma once

#include "libmorph/basis/curve.h"
#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <string>
#include <vector>

namespace morph {

/// A closed curve to be meshed around; its inside stays empty.
struct DomainCurve {
    std::string name; ///< of the marker it becomes
    Curve curve;
    Index nodes = 0; ///< at least 3: C(i / nodes) are vertices of the mesh
};

/// What is to be meshed: a box without the insides of closed curves.
struct DomainSpec {
    std::array<double, 4> box{}; ///< xmin, ymin, xmax, ymax; it becomes the marker kFarfield
    double size = 0;             ///< target edge length on the box
    std::vector<DomainCurve> curves;
    double growth = 0.2;             ///< how much the edge length may grow per unit of length
    Index max_vertices = 20'000'000; ///< beyond it the size is taken for a slip
};

inline constexpr const char* kFarfield = "farfield";

/// No angle of the mesh is smaller, in degrees, except near input corners below kSmallCorner.
inline constexpr double kMinMeshAngle = 25;

/// Corners of the input with a smaller angle on the side of the mesh, in degrees, bound the angles near them.
inline constexpr double kSmallCorner = 60;

/// Mesh the domain between a box and closed curves with triangles, graded from the node spacing on the
/// curves to the size on the box.
///
/// Delaunay refinement [Chew 1993, Guaranteed-quality mesh generation for curved surfaces; Shewchuk 2002,
/// Delaunay refinement algorithms for triangular mesh generation]. Where a good angle needs another node
/// on a curve, it is put on the curve itself, not on the chord. The same spec gives the same bytes.
///
/// Vertices come curve by curve in order of the parameter, then the box from its lower left corner
/// counter-clockwise, then the inside. Triangles run counter-clockwise; the edges of every marker have
/// the domain on their left, one following the other.
///
/// @throws InputError   a box without area; size not positive or so small that the mesh would exceed
///                      max_vertices; a name given twice or that of the box; an open curve; fewer than 3
///                      nodes; a curve that crosses or touches itself, another or the box, that is outside
///                      the box or inside another curve
/// @throws SolverError  an angle below kMinMeshAngle was left away from small corners
MeshData mesh_domain(const DomainSpec& spec);

} // namespace morph
