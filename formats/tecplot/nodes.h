#pragma once

#include "formats/tecplot/zone.h"
#include "libmorph/core/types.h"

#include <map>
#include <unordered_map>

namespace morph {

/// Which variables are x, y and z; beyond the last variable: there is no z.
using TecplotCoordinates = std::array<std::size_t, 3>;

/// The vertices that the nodes of a zone are.
struct TecplotNumbering {
    std::array<const void*, 3> coordinates; ///< the values it was made from
    Index first = 0;
    std::vector<Index> vertices; ///< empty: from first on, in order

    Index vertex(Index node) const
    {
        return vertices.empty() ? first + node : vertices[static_cast<std::size_t>(node)];
    }
};

/// Numbers the nodes of zones as vertices of one mesh. Zones that share coordinates share vertices; so do
/// nodes of different zones at one place (never two of one zone: a seam stays a seam).
class TecplotNodes {
public:
    /// @param z  number of the zone, to ask for its vertices later
    void add_zone(std::size_t z, const TecplotZone& zone, const TecplotCoordinates& xyz);

    /// Of a zone that was added; the same object for zones that share coordinates.
    const TecplotNumbering& numbering(std::size_t z) const { return numberings_[numbering_of_.at(z)]; }

    /// For each node of a zone that was not added the vertex at its place, or -1.
    std::vector<Index> vertices_at(const TecplotZone& zone, const TecplotCoordinates& xyz);

    Index count() const { return static_cast<Index>(points_.size()); }
    /// How many nodes became a vertex of an earlier zone.
    Index joined() const { return joined_; }
    Points take_points();

private:
    using Place = std::array<double, 3>;
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };
    static Place place(const TecplotZone& zone, const TecplotCoordinates& xyz, std::size_t node);
    static std::array<const void*, 3> identity(const TecplotZone& zone, const TecplotCoordinates& xyz);
    /// The numbering made from the coordinates of a zone, or the number of numberings.
    std::size_t find(const TecplotZone& zone, const TecplotCoordinates& xyz) const;
    void index_places();
    Index vertex_at(const Place& place) const;

    std::vector<Place> points_;
    std::vector<TecplotNumbering> numberings_;
    std::map<std::size_t, std::size_t> numbering_of_; ///< by zone
    std::unordered_map<Place, Index, PlaceHash> vertex_of_;
    std::size_t indexed_ = 0; ///< points in vertex_of_
    Index joined_ = 0;
};

} // namespace morph
