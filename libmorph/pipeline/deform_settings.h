#pragma once

#include "libmorph/core/names.h"
#include "libmorph/weights/biharmonic.h"
#include "libmorph/weights/elasticity.h"
#include "libmorph/weights/harmonic.h"
#include "libmorph/weights/idw.h"
#include "libmorph/weights/rbf.h"
#include "libmorph/weights/spring.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// How the mesh follows the control points.
enum class Method {
    harmonic,   ///< harmonic_extension()
    ffd,        ///< free-form deformation: the lattice moves every vertex inside it
    rbf,        ///< rbf_extension()
    idw,        ///< idw_extension(), with rotations unless they are switched off
    damping,    ///< damping_extension()
    elasticity, ///< elastic_extension()
    spring,     ///< springs along the edges, braced or not
    biharmonic, ///< biharmonic functions, conformal or clamped
};

template <>
inline constexpr auto kEnumNames<Method> = std::to_array<EnumName<Method>>({
    {Method::harmonic, "harmonic"},
    {Method::ffd, "ffd"},
    {Method::rbf, "rbf"},
    {Method::idw, "idw"},
    {Method::damping, "damping"},
    {Method::elasticity, "elasticity"},
    {Method::spring, "spring"},
    {Method::biharmonic, "biharmonic"},
});

/// What is done about a moved mesh that cannot be used; each does what the one before it does as well.
enum class Guard {
    none,     ///< nothing: not even looked for
    check,    ///< count inverted elements, look for boundaries that cross
    untangle, ///< repair() inverted elements
    remesh,   ///< remesh_bad_part() where elements are inverted or flat still
};

template <>
inline constexpr auto kEnumNames<Guard> = std::to_array<EnumName<Guard>>({
    {Guard::none, "none"},
    {Guard::check, "check"},
    {Guard::untangle, "untangle"},
    {Guard::remesh, "remesh"},
});

/// A marker that moves as one rigid body, or the cells next to it that move with it.
struct RigidMarker {
    std::string marker = {};
    double distance = 0; ///< of the cells, length unit of the mesh; 0: the marker itself
};

/// How the mesh follows its boundary, and what is checked and repaired after the move.
struct DeformSettings {
    std::string where = {}; ///< in front of messages about it: "case.toml:12: "
    Method method = Method::harmonic;
    Diffusivity diffusivity = Diffusivity::uniform; ///< of Method::harmonic
    Guard guard = Guard::check;

    /// Markers held still; default: all that nothing moves.
    std::optional<std::vector<std::string>> fixed = {};

    /// Extend the boundary's rotation too; default: with Method::idw only.
    std::optional<bool> rotations = {};

    int steps = 1;                       ///< 0: as many as the safe step asks for, see move_in_steps()
    std::vector<std::string> slide = {}; ///< markers whose nodes slide along them
    std::vector<RigidMarker> rigid = {};

    RbfOptions rbf = {};
    std::optional<double> rbf_tolerance = {}; ///< choose centres until they meet it; default: take all
    IdwOptions idw = {};
    Elasticity elasticity = {};
    SpringOptions spring = {};
    BiharmonicCondition biharmonic = BiharmonicCondition::conformal;
};

/// Whether the boundary's rotation is extended into the mesh too. Inverse distance weighting does so by
/// default, as in the paper it comes from.
bool uses_rotations(const DeformSettings& deform);

/// Whether weights cannot do what is asked for: rotations, steps, sliding markers, rigid markers and layers, a
/// method in which x and y influence each other.
bool needs_nonlinear_motion(const DeformSettings& deform);

/// @param deform  how the mesh is to move
/// @param source  of weights that are to be used instead of solving for them, for the message
/// @throws InputError  needs_nonlinear_motion()
void require_weights_usable(const DeformSettings& deform, const std::string& source);

} // namespace morph
