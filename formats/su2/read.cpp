#include "formats/su2/read.h"

#include "formats/su2/sections.h"
#include "formats/su2/zone.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <map>
#include <set>

namespace morph {

namespace {

/// The zones of a file with NZONE= 2 or more: where each begins, behind its IZONE= line, and ends.
struct ZoneText {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// NZONE= of the file; 1 without it. It stands before all zones, as SU2 has it.
std::int64_t zone_count(TextScanner& in)
{
    const auto dimension = find_su2_key(in, "NDIME", 0);
    TextScanner head(in.path(), in.text().substr(0, dimension.value_or(in.text().size())), '%');
    const auto key = find_su2_key(head, "NZONE", 0);
    if (!key)
        return 1;
    in.seek(head.position());
    const std::int64_t zones = in.integer("a number of zones after NZONE=");
    in.end_line("NZONE= " + std::to_string(zones));
    if (zones < 1)
        in.fail_at(*key, "NZONE= " + std::to_string(zones) + ", expected 1 or more");
    return zones;
}

std::vector<ZoneText> zone_texts(TextScanner& in, std::int64_t count)
{
    std::vector<ZoneText> zones;
    std::size_t from = 0;
    while (const auto key = find_su2_key(in, "IZONE", from)) {
        if (!zones.empty())
            zones.back().end = *key;
        const std::int64_t number = in.integer("the number of a zone after IZONE=");
        if (number != static_cast<std::int64_t>(zones.size()) + 1)
            in.fail_at(*key,
                       "IZONE= " + std::to_string(number) + ", expected " + std::to_string(zones.size() + 1));
        in.end_line("IZONE= " + std::to_string(number));
        from = in.position();
        zones.push_back({from, in.text().size()});
    }
    if (static_cast<std::int64_t>(zones.size()) != count)
        throw InputError(in.path() + ": NZONE= " + std::to_string(count) + ", but " +
                         std::to_string(zones.size()) + " zone(s) begin with IZONE=");
    return zones;
}

std::string zone_name(std::size_t zone)
{
    return "zone_" + std::to_string(zone + 1);
}

/// The zone to be read, by its number or name.
std::size_t wanted_zone(const InputBytes& file, std::size_t count)
{
    const std::string& wanted = file.options.zone;
    for (std::size_t zone = 0; zone < count; ++zone)
        if (wanted == zone_name(zone) || wanted == std::to_string(zone + 1))
            return zone;
    throw InputError(file.path + ": has no zone '" + wanted + "', but " + std::to_string(count) +
                     " zone(s), which are called by their number from 1");
}

/// Puts zones behind one another. What several have by one name keeps its zone in its name.
class ZoneMerger {
public:
    ZoneMerger(std::vector<VolumeFile> zones, const InputBytes& file) : zones_(std::move(zones)), file_(file)
    {
        for (const VolumeFile& zone : zones_) {
            for (const Marker& marker : zone.mesh.markers)
                ++uses_[marker.name];
            for (const ElementGroup& group : zone.mesh.groups)
                ++uses_[group.name];
        }
    }

    VolumeFile merge()
    {
        for (std::size_t z = 0; z < zones_.size(); ++z)
            all_.mesh.groups.push_back({unique_name(zone_name(z)), {}});
        for (std::size_t z = 0; z < zones_.size(); ++z)
            add(z);
        set_points(all_.mesh, xyz_);
        return std::move(all_);
    }

private:
    void add(std::size_t z)
    {
        MeshData& mesh = zones_[z].mesh;
        const auto vertex = static_cast<Index>(xyz_.size() / 3);
        const auto element = static_cast<Index>(all_.mesh.elements.size());
        if (mesh.points.rows() + std::int64_t{vertex} > INT32_MAX)
            throw InputError(file_.path + ": the zones together have more than 2147483647 vertices");
        xyz_.insert(xyz_.end(), mesh.points.data(), mesh.points.data() + mesh.points.size());
        for (Element e : mesh.elements) {
            for (Index& v : e)
                v = v < 0 ? v : v + vertex;
            all_.mesh.groups[z].elements.push_back(static_cast<Index>(all_.mesh.elements.size()));
            all_.mesh.elements.push_back(e);
        }
        for (VolumeCell cell : zones_[z].cells) {
            for (Index& v : cell.corners)
                v += vertex;
            all_.cells.push_back(cell);
        }
        for (Marker& marker : mesh.markers)
            add_marker(std::move(marker), z, vertex);
        for (ElementGroup& group : mesh.groups)
            add_group(std::move(group), z, element);
        for (const OpaqueSection& carried : mesh.sections)
            file_.warn(carried.what + " of zone " + std::to_string(z + 1) +
                       " left out of the joined zones; take a zone alone to keep it");
        mesh = {};
    }

    void add_marker(Marker marker, std::size_t zone, Index vertex)
    {
        marker.name = distinct_name(marker.name, zone);
        for (auto& [from, to] : marker.edges) {
            from += vertex;
            to += vertex;
        }
        all_.mesh.markers.push_back(std::move(marker));
    }

    void add_group(ElementGroup group, std::size_t zone, Index element)
    {
        group.name = distinct_name(group.name, zone);
        for (Index& e : group.elements)
            e += element;
        all_.mesh.groups.push_back(std::move(group));
    }

    std::string distinct_name(const std::string& name, std::size_t zone)
    {
        return unique_name(uses_[name] > 1 ? name + "_" + zone_name(zone) : name);
    }

    /// A name that nothing else has got so far.
    std::string unique_name(std::string name)
    {
        while (!taken_.insert(name).second)
            name += "_";
        return name;
    }

    std::vector<VolumeFile> zones_;
    const InputBytes& file_;
    std::map<std::string, int> uses_; ///< by how many zones
    std::set<std::string> taken_;
    VolumeFile all_;
    std::vector<double> xyz_;
};

VolumeFile read_zones(const InputBytes& file, TextScanner& in, std::int64_t count)
{
    const std::vector<ZoneText> texts = zone_texts(in, count);
    const auto read_zone = [&](std::size_t z) {
        return read_su2_zone(file.path, file.bytes.substr(0, texts[z].end), texts[z].begin);
    };
    if (!file.options.zone.empty())
        return read_zone(wanted_zone(file, texts.size()));
    std::vector<VolumeFile> zones;
    for (std::size_t z = 0; z < texts.size(); ++z)
        zones.push_back(read_zone(z));
    return ZoneMerger(std::move(zones), file).merge();
}

} // namespace

MeshData read_su2(const InputBytes& file)
{
    TextScanner in(file.path, file.bytes, '%');
    const std::int64_t zones = zone_count(in);
    file.set_version(zones == 1 ? "ASCII" : std::to_string(zones) + " zones, ASCII");
    if (zones > 1)
        return surface_of(read_zones(file, in, zones), file);
    if (!file.options.zone.empty())
        wanted_zone(file, 1);
    return surface_of(read_su2_zone(file.path, file.bytes, 0), file);
}

} // namespace morph
