#pragma once

#include "libmorph/geometry/hausdorff.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/features.h"
#include "libmorph/remesh/near_marker.h"
#include "libmorph/remesh/size_settings.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace morph {

/// How a mesh is to be remeshed.
struct RemeshJob {
    SizeSettings sizes = {};
    FeatureSettings features = {};
    double only_bad = 0;              ///< only triangles of less quality and two rings around them; 0: all
    std::vector<KeptZone> zones = {}; ///< elements that stay, besides quads
    double hausdorff = 0; ///< largest distance from the input, see remesh_within(); not together with
                          ///  sizes.vertices; 0: any
    int iterations = 5;   ///< see RemeshSettings
    bool fresh = false;   ///< see RemeshSettings; not together with only_bad
    bool transfer_fields = true;
    std::string where = {}; ///< in front of messages about the mesh, as in "wing.su2: "
};

/// What was cut out and triangulated before a planar mesh with inverted elements could be remeshed.
struct CutOut {
    Index inverted = 0;          ///< elements
    Index elements = 0;          ///< all that were cut out: these and those in two rings around them
    Index vertices_left_out = 0; ///< file vertices that are gone
};

/// The target sizes of a remeshed mesh, at its n vertices.
struct RemeshTargets {
    Eigen::VectorXd sizes;    ///< target edge lengths
    Eigen::VectorXd possible; ///< what curved boundaries and kept elements leave of them
    Index vertices = 0;       ///< target number; 0: any
};

/// A mesh after remeshing, with markers, groups and fields.
struct RemeshedMesh {
    Mesh mesh;
    std::optional<CutOut> cut_out;
    RemeshTargets targets;
    std::vector<std::string> left_out; ///< OpaqueSection::what of those that may name vertices that are gone
    double remesh_seconds = 0;
    double transfer_seconds = 0; ///< of groups and fields
};

/// Remesh a domain: cut out inverted elements (planar meshes), take the target sizes, remesh with edges along the
/// borders between groups, and transfer groups and fields. With a target number of vertices the sizes are
/// corrected up to four times, until the number is within 2 %.
///
/// The same bytes for any number of threads. See check_remeshing() for what came of it.
/// @throws InputError  as target_sizes(), keep_zones(), retriangulate(), remesh() and remesh_within()
RemeshedMesh remesh(const Mesh& mesh, const RemeshJob& job);

/// Quality of the triangles of a mesh, which is what remeshing improves: see triangle_qualities().
struct TriangleSummary {
    double min = 1;
    double mean = 1;
    Index worst = -1; ///< the triangle of the least, in the numbering of the mesh
};

/// Quality of the triangles; none where there is no triangle.
std::optional<TriangleSummary> triangle_summary(const Mesh& mesh);

/// Why an edge is much shorter than its target size, as far as that is known.
enum class ShortEdgeCause {
    none,    ///< it is not, or nothing known explains it
    limited, ///< a boundary that is curved there, or a kept element, asks for less
    held,    ///< the boundary or kept elements next to it hold both of its ends
};

/// How well the edges have their target sizes, see edge_conformity().
struct SizeCheck {
    double share = 1;          ///< of the edges: between 0.7 and 1.4 times the target size
    double possible_share = 1; ///< the same against RemeshTargets::possible
    std::array<Index, 2> worst{-1,
                               -1}; ///< ends of the edge farthest from its target size; -1: all have theirs
    double relative_length = 1;     ///< of the worst edge: its length over the target size
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< of the worst edge
    ShortEdgeCause cause = ShortEdgeCause::none;
    double possible_part = 1; ///< cause limited: what is possible there over the target size
};

/// What came of remeshing.
struct RemeshCheck {
    QualityReport before;
    QualityReport after;
    std::optional<TriangleSummary> triangles_before; ///< none where there are no triangles
    std::optional<TriangleSummary> triangles_after;
    std::optional<SizeCheck> sizes; ///< none where the new mesh has no triangles
    Index isolated_left_out = 0;    ///< vertices of no element that are gone
    HausdorffDistance distance;     ///< the first mesh is the old one
    std::vector<Index> folded;      ///< elements of a surface that are folded over, see folded_triangles()
};

/// Look at a mesh after remeshing: quality before and after, how well the target sizes are met, how far it is
/// from the old one, and what is folded over.
/// @param old      the mesh before remeshing
/// @param mesh     the remeshed one
/// @param targets  at the vertices of @p mesh
/// @throws InputError  as hausdorff_distance()
RemeshCheck check_remeshing(const Mesh& old, const Mesh& mesh, const RemeshTargets& targets);

/// No element is inverted, no triangle folded over.
bool is_valid(const RemeshCheck& check);

} // namespace morph
