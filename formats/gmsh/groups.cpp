#include "formats/gmsh/groups.h"

#include <algorithm>
#include <cstdlib>

namespace morph {

namespace {

constexpr int kCurve = 1;
constexpr int kSurface = 2;
constexpr int kVolume = 3;

std::int64_t magnitude(std::int64_t tag)
{
    return std::abs(std::max(tag, -INT64_MAX));
}

} // namespace

GmshGroups::GmshGroups(GmshScanner& in, const GmshNames& names, MeshData& mesh)
    : in_(in), long_names_(names), mesh_(mesh)
{
}

void GmshGroups::read_names()
{
    TextScanner& text = in_.text();
    text.skip_white();
    const Index count = text.index("the number of physical names");
    for (Index i = 0; i < count; ++i) {
        text.skip_white();
        const std::pair<int, std::int64_t> key{text.index("the dimension of a physical group"),
                                               text.integer("the tag of a physical group")};
        const std::size_t start = text.position();
        const std::string_view name = text.rest_of_line();
        if (name.size() < 2 || name.front() != '"' || name.back() != '"') {
            text.seek(start);
            text.at_line_end();
            text.fail_expected("the name of a physical group in double quotes");
        }
        const std::string plain(name.substr(1, name.size() - 2));
        const std::string* full = long_names_.physical(key.first, key.second);
        if (key.first == kSurface && !full && plain == kGmshNoGroup)
            no_groups_.push_back(key.second);
        else if (names_.try_emplace(key, full ? *full : plain).second)
            order_.push_back(key);
    }
    in_.leave();
}

void GmshGroups::read_entities(bool partitioned)
{
    in_.begin_numbers();
    if (partitioned) {
        in_.size("the number of partitions");
        for (std::int64_t ghosts = in_.size("the number of ghost entities"); ghosts > 0; --ghosts) {
            in_.integer("the tag of a ghost entity");
            in_.integer("the partition of a ghost entity");
        }
    }
    std::array<std::int64_t, 4> counts{};
    for (std::int64_t& count : counts)
        count = in_.size("the number of entities");
    for (int dimension = 0; dimension <= kVolume; ++dimension)
        for (std::int64_t i = 0; i < counts.at(static_cast<std::size_t>(dimension)); ++i)
            read_entity(dimension, partitioned);
    in_.leave();
}

void GmshGroups::read_entity(int dimension, bool partitioned)
{
    const std::int64_t tag = in_.integer("the tag of an entity");
    Entity entity;
    if (partitioned) {
        entity.interface = in_.integer("the dimension of a parent") > dimension;
        in_.integer("the tag of a parent");
        for (std::int64_t n = in_.size("the number of partitions of an entity"); n > 0; --n)
            in_.integer("a partition");
    }
    const bool one_point = dimension == 0 && !in_.is_version_4_0();
    for (int k = 0; k < (one_point ? 3 : 6); ++k)
        in_.real("a coordinate of an entity");
    for (std::int64_t n = in_.size("the number of physical groups of an entity"); n > 0; --n)
        entity.physicals.push_back(in_.integer("the tag of a physical group"));
    if (dimension > 0)
        for (std::int64_t n = in_.size("the number of entities around an entity"); n > 0; --n)
            in_.integer("the tag of an entity around an entity");
    entities_.at(static_cast<std::size_t>(dimension)).insert_or_assign(tag, std::move(entity));
}

void GmshGroups::begin()
{
    for (const auto& [dimension, tag] : order_)
        if (dimension == kCurve || dimension == kSurface)
            number_of(dimension, tag, {});
}

std::size_t GmshGroups::number_of(int dimension, std::int64_t physical, const std::string& unnamed)
{
    const std::size_t next = dimension == kCurve ? mesh_.markers.size() : mesh_.groups.size();
    const auto [entry, is_new] = numbers_.try_emplace({dimension, physical}, next);
    if (!is_new)
        return entry->second;
    const auto named = names_.find({dimension, physical});
    const std::string& name = named == names_.end() ? unnamed : named->second;
    if (dimension == kCurve)
        mesh_.markers.push_back({name, {}});
    else
        mesh_.groups.push_back({name, {}});
    return next;
}

const GmshGroups::Place& GmshGroups::place(int dimension, std::int64_t entity, std::int64_t physical)
{
    const auto [entry, is_new] = places_.try_emplace({dimension, entity, physical});
    Place& place = entry->second;
    if (!is_new)
        return place;
    const auto& entities = entities_.at(static_cast<std::size_t>(dimension));
    const auto known = entities.find(entity);
    place.left_out = known != entities.end() && known->second.interface;
    if (place.left_out) // it has the physical groups of what it parts
        return place;
    if (physical != 0)
        add_physicals(place, dimension, {magnitude(physical)});
    else if (known != entities.end())
        add_physicals(place, dimension, known->second.physicals);
    if (place.numbers.empty() && dimension == kCurve) {
        mesh_.markers.push_back({"curve_" + std::to_string(entity), {}});
        place.numbers = {mesh_.markers.size() - 1};
        place.reversed = {false};
    }
    return place;
}

void GmshGroups::add_physicals(Place& place, int dimension, const std::vector<std::int64_t>& physicals)
{
    for (const std::int64_t physical : physicals) {
        const std::int64_t tag = magnitude(physical);
        if (dimension == kSurface && std::find(no_groups_.begin(), no_groups_.end(), tag) != no_groups_.end())
            continue;
        const std::size_t number = number_of(dimension, tag, std::to_string(tag));
        if (std::find(place.numbers.begin(), place.numbers.end(), number) == place.numbers.end()) {
            place.numbers.push_back(number);
            place.reversed.push_back(physical < 0);
        }
    }
}

} // namespace morph
