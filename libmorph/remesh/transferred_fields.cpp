#include "libmorph/remesh/transferred_fields.h"

#include "libmorph/remap/remap.h"

#include <algorithm>

namespace morph {

std::vector<Field> transferred_fields(const Locator& locator, const Mesh& mesh,
                                      const std::vector<Field>& fields)
{
    std::vector<const Field*> list(fields.size());
    std::transform(fields.begin(), fields.end(), list.begin(), [](const Field& field) { return &field; });
    RemapSettings settings;
    settings.outside = Outside::project;
    settings.conserve_elements = locator.source().dimension == 2; // in space elements do not overlap: sampled
    return Remapper(locator, mesh, settings).transfer(list);
}

} // namespace morph
