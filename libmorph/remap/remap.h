#pragma once

#include "libmorph/core/names.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/remap/conserve_fields.h"
#include "libmorph/remap/corner_weights.h"
#include "libmorph/remap/inverse_distance.h"
#include "libmorph/remap/target_locations.h"

#include <optional>
#include <span>
#include <vector>

namespace morph {

/// Where targets outside the source get their values from.
enum class Outside {
    idw,     ///< the nearest targets inside, by inverse distance (thesis, 4.3)
    nearest, ///< the nearest vertex of the source (element fields: the nearest element)
    project, ///< the closest point of the source
    fail,    ///< nowhere: it is an error
};

template <>
inline constexpr auto kEnumNames<Outside> = std::to_array<EnumName<Outside>>({
    {Outside::idw, "idw"},
    {Outside::nearest, "nearest"},
    {Outside::project, "project"},
    {Outside::fail, "fail"},
});

struct RemapSettings {
    std::optional<Outside> outside; ///< default: idw for a planar source, project for a surface
    InverseDistance inverse_distance;
    QuadRule quads = QuadRule::bilinear;
    bool conserve_nodal = false;    ///< keep the integrals of nodal fields instead of interpolating
    bool conserve_elements = false; ///< keep those of element fields instead of sampling at centres
};

/// Transfers fields from one mesh to another. It keeps where the targets lie, so that further fields cost the
/// interpolation only.
///
/// Nodal fields go to the vertices of the target and element fields to its elements, which take the value of
/// the source element at their centre (mean of the corners). A target without elements takes both at its
/// points.
class Remapper {
public:
    /// @param source,target  outlive the remapper and are not moved while it lives
    /// @param settings       what happens outside, and what is conserved
    /// @throws InputError  the source has no element, the target no vertex; a planar source and a target in space
    Remapper(const Locator& source, const Mesh& target, const RemapSettings& settings = {});

    /// The field each as it is on the target, in the same order; fields of the source in its own numbering.
    ///
    /// @throws InputError  a value is not finite (named with its id in the file); no target lies in the
    /// source;
    ///                     targets lie outside and settings.outside is fail; one name for a nodal and an
    ///                     element field, and the target has no elements
    std::vector<Field> transfer(std::span<const Field* const> fields);

    /// What came of keeping integrals in the last transfer(), for the fields of that location.
    const std::optional<Conservation>& conservation(FieldLocation location) const;

    /// Where the vertices or the element centres of the target lie. Found when first asked for.
    const TargetLocations& locations(FieldLocation location);

private:
    FieldLocation place_of(const Field& field) const;
    std::vector<Matrix> values_at(FieldLocation location, std::span<const Field* const> fields);
    std::vector<Matrix> interpolated(FieldLocation location, std::span<const Field* const> fields);
    void fill_outside(const TargetLocations& targets, std::span<const Field* const> fields,
                      std::vector<Matrix>& values);
    Outside outside() const;

    const Locator& source_;
    const Mesh& target_;
    RemapSettings settings_;
    std::optional<TargetLocations> vertices_;
    std::optional<TargetLocations> centres_;
    std::optional<Conservation> nodal_conservation_;
    std::optional<Conservation> element_conservation_;
};

} // namespace morph
