#pragma once

#include "libmorph/numerics/nested_dissection.h"
#include "libmorph/untangle/patch.h"

namespace morph {

/// Sum of the corner energies of a patch over the places of its free vertices, unknowns 2 i and 2 i + 1 being
/// x and y of vertex i. Every sum is taken in an order that depends on the patch only.
class PatchEnergy {
public:
    PatchEnergy(const Patch& patch, const EnergyWeights& weights);

    struct Value {
        double energy = 0;
        double min_determinant = 0; ///< of all corners, relative to their targets
    };
    Value value(const PlanePositions& x, double eps) const;

    /// Gradient by the free vertices, x in the real part, and a positive semidefinite stand-in for the second
    /// derivatives, see CornerModel.
    struct Model {
        PlanePositions gradient;
        SymmetricMatrix second;
    };
    Model model(const PlanePositions& x, double eps) const;

private:
    std::vector<CornerModel> corner_models(const PlanePositions& x, double eps) const;

    const Patch& patch_;
    EnergyWeights weights_;
    std::vector<std::size_t> start_; // by free vertex, in uses_
    std::vector<Index> uses_;        // 3 corner + place in the corner
    std::vector<std::size_t> neighbour_start_;
    std::vector<Index> neighbours_; // free vertices that share a corner, ascending, by free vertex
};

} // namespace morph
