#include "libmorph/pipeline/lattice_settings.h"

#include "libmorph/core/error.h"

namespace morph {

Lattice make_lattice(const LatticeSettings& settings)
{
    try {
        if (settings.box)
            return lattice_in_box(settings.box->low, settings.box->high, settings.shape);
        if (settings.axes)
            return lattice_on_axes(settings.axes->origin, settings.axes->axes, settings.shape);
        return Lattice(settings.shape);
    } catch (const InputError& error) {
        throw InputError(settings.where + "[lattice] " + error.what());
    }
}

} // namespace morph
