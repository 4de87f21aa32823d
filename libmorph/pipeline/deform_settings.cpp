#include "libmorph/pipeline/deform_settings.h"

#include "libmorph/core/error.h"
#include "libmorph/pipeline/detail/extension_methods.h"

namespace morph {

bool uses_rotations(const DeformSettings& deform)
{
    return deform.rotations.value_or(deform.method == Method::idw);
}

bool needs_nonlinear_motion(const DeformSettings& deform)
{
    return couples_directions(deform) || uses_rotations(deform) || deform.steps != 1 ||
           !deform.slide.empty() || !deform.rigid.empty();
}

void require_weights_usable(const DeformSettings& deform, const std::string& source)
{
    if (needs_nonlinear_motion(deform))
        throw InputError(deform.where +
                         "[deform] rotations, steps, slide, rigid and methods that couple x and y move the "
                         "mesh by more than weights, so they cannot use those of " +
                         source);
}

} // namespace morph
