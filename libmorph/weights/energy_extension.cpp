#include "libmorph/weights/energy_extension.h"

namespace morph {

namespace {

/// The elements as sets of vertices, copies of a split vertex taken as one.
VertexLists element_patches(const std::vector<Element>& elements, const std::vector<Index>& representatives)
{
    VertexLists patches;
    for (const Element& corners : elements) {
        for (int i = 0; i < corner_count(corners); ++i)
            patches.vertex.push_back(
                representatives[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])]);
        patches.close_list();
    }
    return patches;
}

SymmetricMatrix stiffness(const DomainView& domain, const UniqueDirichletVertices& held,
                          const EnergyExtension::Energy& energy)
{
    const VertexLists patches = element_patches(domain.elements(), held.representatives());
    const auto x = domain.positions();
    return assemble(domain.vertex_count(), 2, patches, [&](std::size_t e, ElementMatrix& matrix) {
        ElementPoints element{static_cast<Index>(e), static_cast<int>(patches.size(e))};
        for (std::size_t i = 0; i < patches.size(e); ++i)
            element.at[i] = x.row(patches.begin(e)[i]).head<2>();
        energy(element, matrix);
    });
}

} // namespace

EnergyExtension::EnergyExtension(const DomainView& domain, const DirichletBoundary& boundary,
                                 const Energy& energy)
    : BoundaryExtension(domain, boundary, 2),
      system_(domain.coordinates(), stiffness(domain, held(), energy), 2, held().vertices())
{
}

} // namespace morph
