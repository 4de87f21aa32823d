#pragma once

#include "libmorph/basis/lattice.h"

#include <cstdint>
#include <string>
#include <vector>

namespace morph::test {

/// Everything of a lattice but its control points: degree and points alike in all directions but for one
/// more point along each following direction (B-splines); knots uneven; with @p rational weights between 0.5
/// and 2.
LatticeDefinition uneven_shape(int dimension, LatticeBasis basis, int degree, Index points, bool rational,
                               std::uint32_t seed = 1);

/// A lattice in a turned box of sides 2, 1.5 and 1, far from the origin, each control point moved by up to
/// @p amount of the distance to its neighbours.
Lattice deformed_lattice(const LatticeDefinition& shape, double amount, std::uint32_t seed = 1);

/// Planar and spatial lattices of each basis, of several degrees, polynomial and rational, a little deformed.
std::vector<Lattice> all_kinds_of_lattices();

/// What distinguishes it from the others, for messages.
std::string kind(const Lattice& lattice);

/// Points at random in the image of a lattice and their parameters, n x 3 each.
struct Embedded {
    Points parameters, positions;
};
Embedded random_embedded(const Lattice& lattice, Index count, std::uint32_t seed = 1);

/// The same lattice with one knot more along a direction [Boehm 1980, Computer-Aided Design 12(4), 199-201].
/// @param u  in (0, 1), less often a knot than the degree says
Lattice with_knot(const Lattice& lattice, int direction, double u);

/// The same Bernstein lattice, its degree along a direction one higher [Farin, Curves and Surfaces for
/// CAGD, 6.1].
Lattice with_degree_elevated(const Lattice& lattice, int direction);

} // namespace morph::test
