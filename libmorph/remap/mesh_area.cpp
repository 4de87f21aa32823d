#include "libmorph/remap/mesh_area.h"

#include "libmorph/core/parallel.h"
#include "libmorph/remap/clip.h"

#include <vector>

namespace morph {

double mesh_area(const Mesh& mesh)
{
    constexpr std::size_t kGrain = 8192;
    const auto faces = static_cast<std::size_t>(element_count(mesh));
    std::vector<double> sums((faces + kGrain - 1) / kGrain);
    parallel_for(faces, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const PlaneElement element = plane_element(mesh, static_cast<Index>(f));
            const ElementParts parts = parts_of(element, element.corner[0], Parts::convex);
            for (int i = 0; i < parts.count; ++i)
                sums[begin / kGrain] += area(parts.part[static_cast<std::size_t>(i)].polygon);
        }
    });
    double total = 0;
    for (const double sum : sums)
        total += sum;
    return total;
}

} // namespace morph
