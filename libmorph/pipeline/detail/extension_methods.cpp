#include "libmorph/pipeline/detail/extension_methods.h"

#include "libmorph/core/error.h"
#include "libmorph/weights/damping.h"
#include "libmorph/weights/rbf_greedy.h"

namespace morph {

namespace {

std::unique_ptr<BoundaryExtension> make_rbf(const Mesh& mesh, const DirichletBoundary& boundary,
                                            const DeformSettings& deform, const Matrix& values)
{
    if (!deform.rbf_tolerance && std::ssize(boundary.vertices) <= kMostCentres)
        return rbf_extension(mesh, boundary, deform.rbf);
    GreedyOptions greedy;
    greedy.tolerance = deform.rbf_tolerance.value_or(greedy.tolerance);
    return rbf_extension(mesh, boundary, deform.rbf,
                         greedy_centres(mesh, boundary, values, deform.rbf, greedy));
}

std::unique_ptr<BoundaryExtension> make_spring(const Mesh& mesh, const DirichletBoundary& boundary,
                                               const SpringOptions& spring)
{
    if (spring.bracing == SpringBracing::none)
        return spring_extension(mesh, boundary, spring.stiffness);
    return braced_spring_extension(mesh, boundary, spring.stiffness, spring.bracing);
}

std::unique_ptr<BoundaryExtension> make_biharmonic(const Mesh& mesh, const DirichletBoundary& boundary,
                                                   BiharmonicCondition condition)
{
    if (condition == BiharmonicCondition::conformal)
        return conformal_biharmonic_extension(mesh, boundary);
    return biharmonic_extension(mesh, boundary);
}

} // namespace

std::unique_ptr<BoundaryExtension> make_extension(const Mesh& mesh, const DirichletBoundary& boundary,
                                                  const DeformSettings& deform, const Matrix& values)
{
    switch (deform.method) {
    case Method::harmonic:
        return harmonic_extension(mesh, boundary, deform.diffusivity);
    case Method::rbf:
        return make_rbf(mesh, boundary, deform, values);
    case Method::idw:
        return idw_extension(mesh, boundary, deform.idw);
    case Method::damping:
        return damping_extension(mesh, boundary);
    case Method::elasticity:
        return elastic_extension(mesh, boundary, deform.elasticity);
    case Method::spring:
        return make_spring(mesh, boundary, deform.spring);
    case Method::biharmonic:
        return make_biharmonic(mesh, boundary, deform.biharmonic);
    case Method::ffd:
        break;
    }
    throw InputError("method '" + to_string(deform.method) +
                     "' does not carry a boundary's move into the mesh");
}

bool couples_directions(const DeformSettings& deform)
{
    switch (deform.method) {
    case Method::elasticity:
        return true;
    case Method::spring:
        return deform.spring.bracing != SpringBracing::none;
    case Method::biharmonic:
        return deform.biharmonic == BiharmonicCondition::conformal;
    default:
        return false;
    }
}

} // namespace morph
