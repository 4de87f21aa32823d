#include "tools/deform/extension_methods.h"

#include "libmorph/core/error.h"
#include "libmorph/weights/biharmonic.h"
#include "libmorph/weights/damping.h"
#include "libmorph/weights/elasticity.h"
#include "libmorph/weights/harmonic.h"
#include "libmorph/weights/idw.h"
#include "libmorph/weights/rbf_greedy.h"
#include "libmorph/weights/spring.h"

#include <map>

namespace morph::tools {

namespace {

AnyExtension make_harmonic(const ExtensionSetup& setup)
{
    static const std::map<std::string, Diffusivity> kDiffusivities{
        {"uniform", Diffusivity::uniform},
        {"inverse-distance", Diffusivity::inverse_distance},
        {"inverse-area", Diffusivity::inverse_area},
    };
    return harmonic_extension(setup.mesh, setup.held, kDiffusivities.at(setup.deform.diffusivity));
}

AnyExtension make_rbf(const ExtensionSetup& setup)
{
    static const std::map<std::string, RadialFunction> kFunctions{
        {"wendland-c0", RadialFunction::wendland_c0},
        {"wendland-c2", RadialFunction::wendland_c2},
        {"wendland-c4", RadialFunction::wendland_c4},
        {"thin-plate", RadialFunction::thin_plate},
        {"gauss", RadialFunction::gauss},
    };
    const MethodOptions::Rbf& told = setup.deform.options.rbf;
    const RbfOptions options{kFunctions.at(told.function), told.support, told.linear};
    if (!told.tolerance && std::ssize(setup.held.vertices) <= kMostCentres)
        return rbf_extension(setup.mesh, setup.held, options);
    GreedyOptions greedy;
    greedy.tolerance = told.tolerance.value_or(greedy.tolerance);
    return rbf_extension(setup.mesh, setup.held, options,
                         greedy_centres(setup.mesh, setup.held, setup.values, options, greedy));
}

AnyExtension make_idw(const ExtensionSetup& setup)
{
    const MethodOptions::Idw& told = setup.deform.options.idw;
    IdwOptions options;
    options.far_exponent = told.far_exponent.value_or(options.far_exponent);
    options.near_exponent = told.near_exponent.value_or(options.near_exponent);
    options.reach = told.reach.value_or(options.reach);
    options.stiffness = told.stiffness.value_or(options.stiffness);
    return idw_extension(setup.mesh, setup.held, options);
}

AnyExtension make_damping(const ExtensionSetup& setup)
{
    return damping_extension(setup.mesh, setup.held);
}

AnyExtension make_elasticity(const ExtensionSetup& setup)
{
    static const std::map<std::string, YoungsModulus> kModuli{
        {"uniform", YoungsModulus::uniform},
        {"inverse-distance", YoungsModulus::inverse_distance},
        {"inverse-area", YoungsModulus::inverse_area},
    };
    const MethodOptions::Elasticity& told = setup.deform.options.elasticity;
    return elastic_extension(setup.mesh, setup.held, {kModuli.at(told.modulus), told.poisson_ratio});
}

bool braces(const DeformEntry& deform)
{
    return deform.options.spring.bracing != "none";
}

AnyExtension make_spring(const ExtensionSetup& setup)
{
    const MethodOptions::Spring& told = setup.deform.options.spring;
    const auto stiffness = told.stiffness == "inverse-length" ? SpringStiffness::inverse_length
                                                              : SpringStiffness::inverse_length_squared;
    if (!braces(setup.deform))
        return spring_extension(setup.mesh, setup.held, stiffness);
    return braced_spring_extension(setup.mesh, setup.held, stiffness,
                                   told.bracing == "torsion" ? SpringBracing::torsion
                                                             : SpringBracing::ball_vertex);
}

bool is_conformal(const DeformEntry& deform)
{
    return deform.options.biharmonic.condition == "conformal";
}

AnyExtension make_biharmonic(const ExtensionSetup& setup)
{
    if (is_conformal(setup.deform))
        return conformal_biharmonic_extension(setup.mesh, setup.held);
    return biharmonic_extension(setup.mesh, setup.held);
}

bool never(const DeformEntry&)
{
    return false;
}

bool always(const DeformEntry&)
{
    return true;
}

} // namespace

const std::vector<ExtensionMethod>& extension_methods()
{
    static const std::vector<ExtensionMethod> table{
        {"harmonic", "harmonic functions", make_harmonic, never},
        {"rbf", "radial basis functions", make_rbf, never},
        {"idw", "inverse distance weighting", make_idw, never},
        {"damping", "the nearest boundary's move, damped with distance", make_damping, never},
        {"elasticity", "the mesh as an elastic solid", make_elasticity, always},
        {"spring", "springs along the edges and at the corners", make_spring, braces},
        {"biharmonic", "biharmonic functions", make_biharmonic, is_conformal},
    };
    return table;
}

const ExtensionMethod& extension_method(const DeformEntry& deform)
{
    for (const ExtensionMethod& method : extension_methods())
        if (method.name == deform.method)
            return method;
    throw InputError("method '" + deform.method + "' does not carry a boundary's move into the mesh");
}

} // namespace morph::tools
