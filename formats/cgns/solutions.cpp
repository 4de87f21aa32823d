#include "formats/cgns/fields.h"
#include "formats/cgns/zone.h"
#include "formats/text/message_text.h"

#include <cgnslib.h>

namespace morph {

namespace {

class SolutionReader {
public:
    SolutionReader(const CgnsFile& file, CgnsZone& zone) : file_(file), zone_(zone) {}

    void read()
    {
        int count = 0;
        file_.require(cg_nsols(file_.number(), zone_.base, zone_.number, &count), zone_.title());
        for (int s = 1; s <= count; ++s)
            read(s);
    }

private:
    void leave_out(const std::string& why) const { file_.input().warn(title() + " was left out: " + why); }
    std::string title() const { return zone_.title() + ", solution " + quoted_text(name_); }

    void read(int s)
    {
        std::array<char, kCgnsNameRoom> name{};
        CGNS_ENUMT(GridLocation_t) location{};
        file_.require(cg_sol_info(file_.number(), zone_.base, zone_.number, s, name.data(), &location),
                      "a solution of " + zone_.title());
        name_ = name.data();
        CGNS_ENUMT(PointSetType_t) points{};
        cgsize_t count = 0;
        if (cg_sol_ptset_info(file_.number(), zone_.base, zone_.number, s, &points, &count) == CG_OK &&
            points != CGNS_ENUMV(PointSetTypeNull))
            return leave_out("it is for some points only");
        if (location == CGNS_ENUMV(Vertex))
            read_arrays(s, FieldLocation::vertex, zone_.vertex_count());
        else if (location != CGNS_ENUMV(CellCenter))
            leave_out(std::string("its values are at ") + cg_GridLocationName(location));
        else if (!zone_.cells.empty())
            leave_out("its values are those of the volume's cells");
        else if (zone_.cell_count != static_cast<Index>(zone_.mesh.elements.size()))
            leave_out("it has values for " + std::to_string(zone_.cell_count) +
                      " cells, but the zone lists " + std::to_string(zone_.mesh.elements.size()));
        else
            read_arrays(s, FieldLocation::element, zone_.cell_count);
    }

    void read_arrays(int s, FieldLocation location, Index rows)
    {
        int count = 0;
        file_.require(cg_nfields(file_.number(), zone_.base, zone_.number, s, &count), title());
        std::vector<CgnsArray> arrays;
        for (int f = 1; f <= count; ++f)
            arrays.push_back(array(s, f, location, rows));
        std::string table;
        if (cg_goto(file_.number(), zone_.base, "Zone_t", zone_.number, "FlowSolution_t", s, "end") == CG_OK)
            table = CgnsFile::descriptor(kCgnsFieldTable);
        for (Field& field : fields_of_cgns_arrays(std::move(arrays), table)) {
            field.location = location;
            if (find_field(zone_.mesh.fields, field.name, location))
                field.name = name_ + "/" + field.name;
            zone_.mesh.fields.push_back(std::move(field));
        }
    }

    CgnsArray array(int s, int f, FieldLocation location, Index rows) const
    {
        std::array<char, kCgnsNameRoom> name{};
        CGNS_ENUMT(DataType_t) type{};
        file_.require(cg_field_info(file_.number(), zone_.base, zone_.number, s, f, &type, name.data()),
                      "an array of " + title());
        CgnsArray array{name.data(), std::vector<double>(static_cast<std::size_t>(rows))};
        if (rows == 0)
            return array;
        const cgsize_t at_cells = location == FieldLocation::element && zone_.structured() ? 1 : 0;
        const std::array<cgsize_t, 3> low{1, 1, 1};
        std::array<cgsize_t, 3> high{rows, 1, 1};
        for (std::size_t axis = 0; zone_.structured() && axis < 3; ++axis)
            high[axis] = std::max<cgsize_t>(zone_.size[axis] - at_cells, 1);
        file_.require(cg_field_read(file_.number(), zone_.base, zone_.number, s, name.data(),
                                    CGNS_ENUMV(RealDouble), low.data(), high.data(), array.values.data()),
                      title() + ", array " + quoted_text(name.data()));
        return array;
    }

    const CgnsFile& file_;
    CgnsZone& zone_;
    std::string name_; ///< of the solution
};

} // namespace

void read_cgns_solutions(const CgnsFile& file, CgnsZone& zone)
{
    SolutionReader(file, zone).read();
}

} // namespace morph
