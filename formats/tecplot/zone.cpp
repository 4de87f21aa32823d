#include "formats/tecplot/zone.h"

namespace morph {

int corner_count(TecplotCells cells)
{
    constexpr std::array<int, 5> counts{2, 3, 4, 4, 8};
    return counts.at(static_cast<std::size_t>(cells));
}

void connect_ordered(TecplotZone& zone)
{
    std::vector<Index> lengths;
    std::vector<Index> steps; // from a node to its neighbour along each long side
    Index step = 1;
    for (const Index length : zone.size) {
        if (length > 1) {
            lengths.push_back(length - 1);
            steps.push_back(step);
        }
        step *= length;
    }
    constexpr std::array<TecplotCells, 4> cells_of{TecplotCells::lines, TecplotCells::lines,
                                                   TecplotCells::quads, TecplotCells::bricks};
    zone.cells = cells_of.at(lengths.size());
    zone.elements = lengths.empty() ? 0 : zone.elements;
    lengths.resize(3, 1);
    steps.resize(3, 0);
    const auto corners = static_cast<std::size_t>(corner_count(zone.cells));
    zone.corners.reserve(static_cast<std::size_t>(zone.elements) * corners);
    if (zone.elements == 0)
        return;
    for (Index k = 0; k < lengths[2]; ++k)
        for (Index j = 0; j < lengths[1]; ++j)
            for (Index i = 0; i < lengths[0]; ++i) {
                const Index first = i * steps[0] + j * steps[1] + k * steps[2];
                const Index above = first + steps[1];
                const std::array<Index, 8> brick{first,
                                                 first + steps[0],
                                                 above + steps[0],
                                                 above,
                                                 first + steps[2],
                                                 first + steps[0] + steps[2],
                                                 above + steps[0] + steps[2],
                                                 above + steps[2]};
                zone.corners.insert(zone.corners.end(), brick.begin(),
                                    brick.begin() + static_cast<std::ptrdiff_t>(corners));
            }
}

} // namespace morph
