#include "formats/cgns/reader.h"

#include "formats/cgns/fields.h"
#include "formats/cgns/merge_zones.h"
#include "formats/cgns/zone.h"
#include "formats/text/message_text.h"
#include "libmorph/core/names.h"

#include <charconv>
#include <limits>

#include <cgnslib.h>

namespace morph {

namespace {

/// For messages, in which a list of names has no quotes.
std::string printable(const std::string& name)
{
    const std::string quoted = quoted_text(name);
    return quoted.substr(1, quoted.size() - 2);
}

class CgnsReader {
public:
    CgnsReader(const InputBytes& input, const std::string& path) : file_(input, path) {}

    VolumeFile read()
    {
        const int zones = choose_base();
        const std::vector<int> wanted = wanted_zones(zones);
        std::vector<CgnsZone> read;
        read.reserve(wanted.size());
        for (const int z : wanted)
            read.push_back(zone(z));
        return merge_cgns_zones(std::move(read), families(), file_.input());
    }

private:
    /// @return its number of zones
    int choose_base()
    {
        int bases = 0;
        int zones = 0;
        file_.require(cg_nbases(file_.number(), &bases), "the number of bases");
        for (int b = 1; b <= bases; ++b) {
            std::array<char, kCgnsNameRoom> name{};
            int physical = 0;
            int count = 0;
            int cells = 0;
            file_.require(cg_base_read(file_.number(), b, name.data(), &cells, &physical), "a base");
            file_.require(cg_nzones(file_.number(), b, &count), "a base");
            if (zones == 0) {
                base_ = b;
                cell_dimension_ = cells;
                zones = count;
            } else if (count > 0) {
                file_.input().warn("base " + quoted_text(name.data()) + " was left out: only one is read");
            }
        }
        if (bases == 0)
            file_.fail("a CGNS file without a base");
        return zones;
    }

    /// Those that the options ask for.
    std::vector<int> wanted_zones(int zones) const
    {
        const std::string& wanted = file_.input().options.zone;
        std::vector<std::string> names;
        std::vector<int> all;
        for (int z = 1; z <= zones; ++z) {
            std::array<char, kCgnsNameRoom> name{};
            std::array<cgsize_t, 9> size{};
            file_.require(cg_zone_read(file_.number(), base_, z, name.data(), size.data()), "a zone");
            names.push_back(printable(name.data()));
            all.push_back(z);
            if (wanted == name.data())
                return {z};
        }
        if (wanted.empty())
            return all;
        int number = 0;
        const auto [stop, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
        if (error == std::errc() && stop == wanted.data() + wanted.size() && number >= 1 && number <= zones)
            return {number};
        file_.fail("has no zone " + quoted_text(wanted) + "; its zones are " + joined(names) +
                   did_you_mean(wanted, names));
    }

    CgnsZone zone(int number) const
    {
        CgnsZone zone = head(number);
        read_coordinates(zone);
        if (zone.structured())
            make_cgns_grid(zone);
        else
            read_cgns_sections(file_, zone);
        read_cgns_boundaries(file_, zone);
        read_cgns_solutions(file_, zone);
        warn_of_interfaces(zone);
        return zone;
    }

    void warn_of_interfaces(const CgnsZone& zone) const
    {
        int matching = 0;
        int others = 0;
        file_.require(cg_n1to1(file_.number(), base_, zone.number, &matching), zone.title());
        file_.require(cg_nconns(file_.number(), base_, zone.number, &others), zone.title());
        if (matching + others > 0)
            file_.input().warn(zone.title() + " has " + std::to_string(matching + others) +
                               " interface(s), at which vertices of both sides are kept");
    }

    CgnsZone head(int number) const
    {
        CgnsZone zone;
        zone.base = base_;
        zone.number = number;
        std::array<char, kCgnsNameRoom> name{};
        std::array<cgsize_t, 9> size{};
        CGNS_ENUMT(ZoneType_t) type{};
        file_.require(cg_zone_read(file_.number(), base_, number, name.data(), size.data()), "a zone");
        zone.name = name.data();
        file_.require(cg_zone_type(file_.number(), base_, number, &type), zone.title());
        if (type == CGNS_ENUMV(Structured))
            zone.index_dimension = cell_dimension_;
        else if (type != CGNS_ENUMV(Unstructured))
            file_.fail(zone.title() + " is neither structured nor unstructured");
        if (zone.index_dimension < 1 || zone.index_dimension > 3 ||
            (type == CGNS_ENUMV(Structured) && zone.index_dimension < 2))
            file_.fail(zone.title() + " is of dimension " + std::to_string(cell_dimension_) +
                       ", expected 2 or 3");
        std::int64_t vertices = 1;
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(zone.index_dimension); ++axis) {
            if (size[axis] < 1)
                file_.fail(zone.title() + " has " + std::to_string(size[axis]) + " vertices");
            file_.require_plausible(vertices *= size[axis], zone.title(), "vertices");
            zone.size[axis] = static_cast<Index>(size[axis]);
        }
        set_cell_count(zone, size[1]);
        return zone;
    }

    void set_cell_count(CgnsZone& zone, std::int64_t unstructured) const
    {
        zone.cell_count = static_cast<Index>(unstructured);
        if (!zone.structured())
            return;
        zone.cell_count = 1;
        for (const Index size : zone.size)
            zone.cell_count *= std::max<Index>(size - 1, 1);
    }

    void read_coordinates(CgnsZone& zone) const
    {
        require_cartesian(zone);
        const std::array<cgsize_t, 3> low{1, 1, 1};
        const std::array<cgsize_t, 3> high{zone.size[0], zone.size[1], zone.size[2]};
        std::vector<double> values(static_cast<std::size_t>(zone.vertex_count()));
        zone.mesh.points = Points::Zero(zone.vertex_count(), 3);
        for (int axis = 0; axis < 3; ++axis) {
            const std::string name = std::string("Coordinate") + "XYZ"[axis];
            if (!has_coordinate(zone, name))
                continue;
            file_.require(cg_coord_read(file_.number(), base_, zone.number, name.c_str(),
                                        CGNS_ENUMV(RealDouble), low.data(), high.data(), values.data()),
                          zone.title() + ", " + name);
            zone.mesh.points.col(axis) =
                Eigen::Map<const Eigen::VectorXd>(values.data(), zone.vertex_count());
        }
        if (!zone.mesh.points.allFinite())
            file_.fail(zone.title() + " has a coordinate that is not a finite number");
    }

    std::vector<std::string> coordinates(const CgnsZone& zone) const
    {
        int count = 0;
        file_.require(cg_ncoords(file_.number(), base_, zone.number, &count), zone.title());
        std::vector<std::string> names;
        for (int c = 1; c <= count; ++c) {
            std::array<char, kCgnsNameRoom> name{};
            CGNS_ENUMT(DataType_t) type{};
            file_.require(cg_coord_info(file_.number(), base_, zone.number, c, &type, name.data()),
                          "a coordinate of " + zone.title());
            names.emplace_back(name.data());
        }
        return names;
    }

    bool has_coordinate(const CgnsZone& zone, const std::string& name) const
    {
        const std::vector<std::string> names = coordinates(zone);
        return std::find(names.begin(), names.end(), name) != names.end();
    }

    void require_cartesian(const CgnsZone& zone) const
    {
        if (!has_coordinate(zone, "CoordinateX") || !has_coordinate(zone, "CoordinateY"))
            file_.fail(zone.title() + " has the coordinates " + printable(joined(coordinates(zone))) +
                       ", expected CoordinateX, CoordinateY and perhaps CoordinateZ");
    }

    std::vector<CgnsFamily> families() const
    {
        int count = 0;
        file_.require(cg_nfamilies(file_.number(), base_, &count), "the number of families");
        std::vector<CgnsFamily> families;
        for (int f = 1; f <= count; ++f) {
            std::array<char, kCgnsNameRoom> name{};
            int conditions = 0;
            int geometries = 0;
            file_.require(cg_family_read(file_.number(), base_, f, name.data(), &conditions, &geometries),
                          "a family");
            CgnsFamily& family = families.emplace_back();
            family.node = family.name = name.data();
            if (cg_goto(file_.number(), base_, "Family_t", f, "end") == CG_OK)
                if (const std::string text = CgnsFile::descriptor(kCgnsLongName); !text.empty())
                    family.name = cgns_decoded(text);
            for (int c = 1; c <= conditions; ++c) {
                CGNS_ENUMT(BCType_t) type{};
                if (cg_fambc_read(file_.number(), base_, f, c, name.data(), &type) == CG_OK &&
                    std::string(kCgnsNoEdges) == name.data())
                    family.no_edges = true;
            }
        }
        return families;
    }

    CgnsFile file_;
    int base_ = 1;
    int cell_dimension_ = 2;
};

} // namespace

VolumeFile read_cgns(const InputBytes& input, const std::string& path)
{
    return CgnsReader(input, path).read();
}

} // namespace morph
