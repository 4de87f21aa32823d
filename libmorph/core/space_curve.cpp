#include "libmorph/core/space_curve.h"

#include "libmorph/core/parallel.h"
#include "libmorph/core/radix_sort.h"

#include <array>
#include <cmath>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 16384;

/// One step of the Hilbert curve in N dimensions, from a cell to the 2^N cells within it, as a table:
/// by how the curve lies in the cell and which of the cells within is meant, the place of that one
/// along the curve and how the curve lies in it.
///
/// The curve lies in a cell in one of N 2^N ways, given by the corner where it enters and the axis along
/// which it leaves [Hamilton & Rau-Chaplin 2008, Information Processing Letters 105(5), 155-163; the
/// functions below are theirs].
template <unsigned N>
class HilbertTable {
public:
    static constexpr unsigned kCells = 1U << N;

    constexpr HilbertTable()
    {
        for (unsigned corner = 0; corner < kCells; ++corner)
            for (unsigned axis = 0; axis < N; ++axis)
                for (unsigned cell = 0; cell < kCells; ++cell)
                    steps_[way(corner, axis)][cell] = step(corner, axis, cell);
    }

    /// The place along the curve of the cell whose coordinates have @p bits bits each.
    std::uint64_t key(const std::array<std::uint32_t, N>& cell, unsigned bits) const
    {
        std::uint64_t key = 0;
        unsigned way = 0;
        for (unsigned bit = bits; bit-- > 0;) {
            unsigned child = 0;
            for (unsigned axis = 0; axis < N; ++axis)
                child |= ((cell[axis] >> bit) & 1U) << axis;
            const Step& next = steps_[way][child];
            key = key << N | next.place;
            way = next.way;
        }
        return key;
    }

private:
    struct Step {
        std::uint8_t place = 0;
        std::uint8_t way = 0;
    };

    static constexpr unsigned way(unsigned corner, unsigned axis) { return corner * N + axis; }
    static constexpr unsigned gray(unsigned i) { return i ^ (i >> 1); }

    static constexpr unsigned gray_inverse(unsigned code)
    {
        unsigned i = code;
        for (unsigned shift = 1; shift < N; ++shift)
            i ^= code >> shift;
        return i;
    }

    /// Towards the higher bits, around within N bits.
    static constexpr unsigned rotate(unsigned bits, unsigned by)
    {
        by %= N;
        return (bits << by | bits >> (N - by)) & (kCells - 1);
    }

    static constexpr unsigned entry_corner(unsigned place)
    {
        return place == 0 ? 0 : gray((place - 1) / 2 * 2);
    }

    static constexpr unsigned inner_axis(unsigned place)
    {
        const unsigned odd = place == 0 ? 0 : (place - 1) | 1U;
        unsigned trailing_ones = 0;
        while (place != 0 && (odd >> trailing_ones & 1U) != 0)
            ++trailing_ones;
        return trailing_ones % N;
    }

    static constexpr Step step(unsigned corner, unsigned axis, unsigned cell)
    {
        const unsigned place = gray_inverse(rotate(cell ^ corner, N - (axis + 1) % N));
        const unsigned inner_corner = corner ^ rotate(entry_corner(place), axis + 1);
        return {static_cast<std::uint8_t>(place),
                static_cast<std::uint8_t>(way(inner_corner, (axis + inner_axis(place) + 1) % N))};
    }

    std::array<std::array<Step, kCells>, std::size_t{N} * kCells> steps_{};
};

/// A cube around the points, cut into 2^bits cells a side. Halves are subtracted, because the whole
/// extent of finite coordinates may overflow.
struct Grid {
    Eigen::RowVector3d half_low;
    double half_extent = 0;
    unsigned bits = 0;

    Grid(const Eigen::Ref<const Points>& points, int dimension, unsigned bits_a_side) : bits(bits_a_side)
    {
        half_low = points.colwise().minCoeff() / 2;
        half_extent = (points.colwise().maxCoeff() / 2 - half_low).head(dimension).maxCoeff();
    }

    std::uint32_t cell(double x, int axis) const
    {
        const double cells = std::ldexp(1.0, static_cast<int>(bits));
        const double ratio = half_extent > 0 ? (x / 2 - half_low[axis]) / half_extent : 0;
        return static_cast<std::uint32_t>(std::min(ratio * cells, cells - 1));
    }
};

template <unsigned N>
std::vector<Index> order_along_curve(const Eigen::Ref<const Points>& points, unsigned bits)
{
    static constexpr HilbertTable<N> table;
    const Grid grid(points, N, bits);
    std::vector<Keyed<std::uint64_t>> keyed(static_cast<std::size_t>(points.rows()));
    parallel_for(keyed.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto row = static_cast<Index>(i);
            std::array<std::uint32_t, N> cell{};
            for (unsigned axis = 0; axis < N; ++axis)
                cell[axis] = grid.cell(points(row, axis), static_cast<int>(axis));
            keyed[i] = {table.key(cell, bits), row};
        }
    });
    radix_sort(keyed, static_cast<int>(N * bits));
    std::vector<Index> order(keyed.size());
    std::transform(keyed.begin(), keyed.end(), order.begin(), [](const auto& k) { return k.item; });
    return order;
}

} // namespace

std::vector<Index> hilbert_order(const Eigen::Ref<const Points>& points, int dimension)
{
    if (points.rows() == 0)
        return {};
    constexpr unsigned kPlaneBits = 31;
    constexpr unsigned kSpaceBits = 21;
    return dimension == 2 ? order_along_curve<2>(points, kPlaneBits)
                          : order_along_curve<3>(points, kSpaceBits);
}

} // namespace morph
