#include "formats/tecplot/nodes.h"

#include <cstdint>
#include <cstring>

namespace morph {

std::size_t TecplotNodes::PlaceHash::operator()(const Place& place) const
{
    constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;
    std::uint64_t hash = 0;
    for (const double coordinate : place) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &coordinate, sizeof bits);
        hash = (hash ^ bits) * kOdd;
        hash ^= hash >> 29;
    }
    return hash;
}

TecplotNodes::Place TecplotNodes::place(const TecplotZone& zone, const TecplotCoordinates& xyz,
                                        std::size_t node)
{
    Place place{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
        if (xyz[k] < zone.variables.size())
            place[k] = (*zone.variables[xyz[k]].values)[node];
    return place;
}

std::array<const void*, 3> TecplotNodes::identity(const TecplotZone& zone, const TecplotCoordinates& xyz)
{
    std::array<const void*, 3> values{nullptr, nullptr, nullptr};
    for (std::size_t k = 0; k < 3; ++k)
        if (xyz[k] < zone.variables.size())
            values[k] = zone.variables[xyz[k]].values.get();
    return values;
}

std::size_t TecplotNodes::find(const TecplotZone& zone, const TecplotCoordinates& xyz) const
{
    std::size_t n = 0;
    while (n < numberings_.size() && numberings_[n].coordinates != identity(zone, xyz))
        ++n;
    return n;
}

void TecplotNodes::add_zone(std::size_t z, const TecplotZone& zone, const TecplotCoordinates& xyz)
{
    const std::size_t known = find(zone, xyz);
    numbering_of_[z] = known;
    if (known < numberings_.size())
        return;
    TecplotNumbering numbering{identity(zone, xyz), count(), {}};
    const auto nodes = static_cast<std::size_t>(zone.nodes);
    points_.reserve(points_.size() + nodes);
    if (!numberings_.empty()) {
        index_places();
        numbering.vertices.resize(nodes);
    }
    for (std::size_t node = 0; node < nodes; ++node) {
        const Place here = place(zone, xyz, node);
        const Index vertex = numberings_.empty() ? -1 : vertex_at(here);
        if (!numberings_.empty())
            numbering.vertices[node] = vertex < 0 ? count() : vertex;
        if (vertex < 0)
            points_.push_back(here);
        else
            ++joined_;
    }
    numberings_.push_back(std::move(numbering));
}

std::vector<Index> TecplotNodes::vertices_at(const TecplotZone& zone, const TecplotCoordinates& xyz)
{
    std::vector<Index> vertices(static_cast<std::size_t>(zone.nodes));
    const std::size_t known = find(zone, xyz);
    if (known == numberings_.size())
        index_places();
    for (std::size_t node = 0; node < vertices.size(); ++node)
        vertices[node] = known < numberings_.size() ? numberings_[known].vertex(static_cast<Index>(node))
                                                    : vertex_at(place(zone, xyz, node));
    return vertices;
}

void TecplotNodes::index_places()
{
    vertex_of_.reserve(points_.size());
    for (; indexed_ < points_.size(); ++indexed_) {
        Place place = points_[indexed_];
        for (double& coordinate : place)
            coordinate += 0.0; // -0 is the place 0
        vertex_of_.try_emplace(place, static_cast<Index>(indexed_));
    }
}

Index TecplotNodes::vertex_at(const Place& place) const
{
    const auto found = vertex_of_.find({place[0] + 0.0, place[1] + 0.0, place[2] + 0.0});
    return found == vertex_of_.end() ? -1 : found->second;
}

Points TecplotNodes::take_points()
{
    Points points(count(), 3);
    for (std::size_t v = 0; v < points_.size(); ++v)
        points.row(static_cast<Eigen::Index>(v)) << points_[v][0], points_[v][1], points_[v][2];
    points_ = {};
    return points;
}

} // namespace morph
