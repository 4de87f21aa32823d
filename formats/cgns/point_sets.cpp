#include "formats/cgns/point_sets.h"
#include "formats/text/message_text.h"

#include <array>

#include <cgnslib.h>

namespace morph {

namespace {

CgnsPlace place_of(CGNS_ENUMT(PointSetType_t) type, CGNS_ENUMT(GridLocation_t) location)
{
    if (type == CGNS_ENUMV(ElementRange) || type == CGNS_ENUMV(ElementList))
        return CgnsPlace::element;
    switch (location) {
    case CGNS_ENUMV(Vertex):
        return CgnsPlace::vertex;
    case CGNS_ENUMV(IFaceCenter):
        return CgnsPlace::i_face;
    case CGNS_ENUMV(JFaceCenter):
        return CgnsPlace::j_face;
    case CGNS_ENUMV(KFaceCenter):
        return CgnsPlace::k_face;
    case CGNS_ENUMV(FaceCenter):
    case CGNS_ENUMV(EdgeCenter):
        return CgnsPlace::any_face;
    default:
        return CgnsPlace::element;
    }
}

/// The family of the node that cg_goto() went to.
std::string family_or(const std::string& name)
{
    // the name of a family may be a path of several
    std::array<char, CG_MAX_GOTO_DEPTH * kCgnsNameRoom> family{};
    return cg_famname_read(family.data()) == CG_OK && family[0] != '\0' ? family.data() : name;
}

class SetReader {
public:
    SetReader(const CgnsFile& file, const CgnsZone& zone) : file_(file), zone_(zone) {}

    std::vector<CgnsPointSet> read()
    {
        int count = 0;
        require(cg_nbocos(file_.number(), zone_.base, zone_.number, &count), "its boundary conditions");
        for (int b = 1; b <= count; ++b)
            read_condition(b);
        if (cg_nsubregs(file_.number(), zone_.base, zone_.number, &count) != CG_OK)
            count = 0;
        for (int r = 1; r <= count; ++r)
            read_region(r);
        return std::move(sets_);
    }

private:
    void require(int status, const std::string& what) const
    {
        file_.require(status, zone_.title() + ", " + what);
    }

    void read_condition(int b)
    {
        std::array<char, kCgnsNameRoom> name{};
        CGNS_ENUMT(BCType_t) kind{};
        CGNS_ENUMT(PointSetType_t) type{};
        CGNS_ENUMT(GridLocation_t) location = CGNS_ENUMV(Vertex);
        CGNS_ENUMT(DataType_t) normal_type{};
        std::array<int, 3> normal_index{};
        int data_sets = 0;
        cgsize_t count = 0;
        cgsize_t normals = 0;
        require(cg_boco_info(file_.number(), zone_.base, zone_.number, b, name.data(), &kind, &type, &count,
                             normal_index.data(), &normals, &normal_type, &data_sets),
                "a boundary condition");
        CgnsPointSet set = begin("boundary condition", name.data(), type, count);
        std::vector<cgsize_t> points(set.points.size());
        require(cg_boco_read(file_.number(), zone_.base, zone_.number, b, points.data(), nullptr), set.what);
        if (cg_boco_gridlocation_read(file_.number(), zone_.base, zone_.number, b, &location) != CG_OK)
            location = CGNS_ENUMV(Vertex);
        if (cg_goto(file_.number(), zone_.base, "Zone_t", zone_.number, "ZoneBC_t", 1, "BC_t", b, "end") ==
            CG_OK)
            set.name = family_or(set.name);
        end(std::move(set), place_of(type, location), points);
    }

    void read_region(int r)
    {
        std::array<char, kCgnsNameRoom> name{};
        int dimension = 0;
        CGNS_ENUMT(PointSetType_t) type{};
        CGNS_ENUMT(GridLocation_t) location = CGNS_ENUMV(Vertex);
        cgsize_t count = 0;
        int of_condition = 0;
        int of_connection = 0;
        require(cg_subreg_info(file_.number(), zone_.base, zone_.number, r, name.data(), &dimension,
                               &location, &type, &count, &of_condition, &of_connection),
                "a subregion");
        if (of_condition > 0 || of_connection > 0)
            return; // its points are those of another node, which is read anyway
        CgnsPointSet set = begin("subregion", name.data(), type, count);
        std::vector<cgsize_t> points(set.points.size());
        require(cg_subreg_ptset_read(file_.number(), zone_.base, zone_.number, r, points.data()), set.what);
        if (cg_goto(file_.number(), zone_.base, "Zone_t", zone_.number, "ZoneSubRegion_t", r, "end") == CG_OK)
            set.name = family_or(set.name);
        end(std::move(set), place_of(type, location), points);
    }

    CgnsPointSet begin(const std::string& kind, const std::string& name, CGNS_ENUMT(PointSetType_t) type,
                       cgsize_t count) const
    {
        CgnsPointSet set;
        set.what = kind + " " + quoted_text(name);
        set.name = name;
        set.range = type == CGNS_ENUMV(PointRange) || type == CGNS_ENUMV(ElementRange);
        if (count < 0 || (set.range && count != 2))
            fail_of_cgns_set(file_, zone_, set, "has " + std::to_string(count) + " points");
        set.points.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(zone_.index_dimension));
        return set;
    }

    void end(CgnsPointSet set, CgnsPlace place, const std::vector<cgsize_t>& points)
    {
        set.place = place;
        set.points.assign(points.begin(), points.end());
        sets_.push_back(std::move(set));
    }

    const CgnsFile& file_;
    const CgnsZone& zone_;
    std::vector<CgnsPointSet> sets_;
};

} // namespace

std::vector<CgnsPointSet> read_cgns_point_sets(const CgnsFile& file, const CgnsZone& zone)
{
    return SetReader(file, zone).read();
}

std::vector<Index> each_once(std::vector<Index> indices, std::size_t count)
{
    std::vector<bool> seen(count, false);
    std::erase_if(indices, [&](Index i) {
        const bool again = seen[static_cast<std::size_t>(i)];
        seen[static_cast<std::size_t>(i)] = true;
        return again;
    });
    return indices;
}

void leave_out_cgns_set(const CgnsFile& file, const CgnsZone& zone, const CgnsPointSet& set,
                        const std::string& why)
{
    file.input().warn(zone.title() + ", " + set.what + " was left out: " + why);
}

void fail_of_cgns_set(const CgnsFile& file, const CgnsZone& zone, const CgnsPointSet& set,
                      const std::string& what)
{
    file.fail(zone.title() + ", " + set.what + " " + what);
}

} // namespace morph
