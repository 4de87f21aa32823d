#include "formats/nastran/read.h"

#include "formats/mesh/volume_cells.h"
#include "formats/nastran/card.h"
#include "formats/nastran/names.h"
#include "formats/text/id_table.h"
#include "formats/text/message_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace morph {

namespace {

enum class Kind { grid, triangle, quad, line, tetrahedron, pyramid, prism, hexahedron, unsupported };

struct CardType {
    Kind kind;
    int corners;
    std::size_t first; ///< field of the first corner, from 0 behind the name
};

const std::map<std::string_view, CardType> kCards{
    {"GRID", {Kind::grid, 0, 0}},          {"CTRIA3", {Kind::triangle, 3, 2}},
    {"CTRIAR", {Kind::triangle, 3, 2}},    {"CQUAD4", {Kind::quad, 4, 2}},
    {"CQUADR", {Kind::quad, 4, 2}},        {"CSHEAR", {Kind::quad, 4, 2}},
    {"CBAR", {Kind::line, 2, 2}},          {"CBEAM", {Kind::line, 2, 2}},
    {"CROD", {Kind::line, 2, 2}},          {"CTUBE", {Kind::line, 2, 2}},
    {"CONROD", {Kind::line, 2, 1}},        {"PLOTEL", {Kind::line, 2, 1}},
    {"CTETRA", {Kind::tetrahedron, 4, 2}}, {"CPYRAM", {Kind::pyramid, 5, 2}},
    {"CPYRA", {Kind::pyramid, 5, 2}},      {"CPENTA", {Kind::prism, 6, 2}},
    {"CHEXA", {Kind::hexahedron, 8, 2}},   {"CTRIA6", {Kind::unsupported, 6, 2}},
    {"CQUAD8", {Kind::unsupported, 8, 2}}, {"CQUAD", {Kind::unsupported, 9, 2}},
    {"CTRIAX", {Kind::unsupported, 6, 2}}, {"CTRIAX6", {Kind::unsupported, 6, 2}},
    {"CQUADX", {Kind::unsupported, 8, 2}}, {"CBEAM3", {Kind::unsupported, 3, 2}},
};

/// Cards that say nothing to be missed.
const std::set<std::string_view> kSilent{"BEGIN", "ENDDATA", "PSHELL", "PCOMP",
                                         "PROD",  "PBAR",    "PSOLID", "PARAM"};

constexpr Index kNoProperty = -1;

class NastranReader {
public:
    explicit NastranReader(const InputBytes& input) : input_(input), cards_(input.path, input.bytes) {}

    MeshData read()
    {
        const bool bulk = cards_.skip_to_bulk();
        NastranCard card;
        while (cards_.next(card) && card.name != "ENDDATA")
            if (card.name.empty())
                take_comment(cards_.comment());
            else
                take(card);
        if (!bulk && ids_.count() == 0)
            throw InputError(input_.path +
                             ": neither BEGIN BULK nor a GRID in it, so this is no Nastran bulk data");
        ids_.finish(cards_.scanner(), "GRID");
        set_points(volume_.mesh, xyz_);
        xyz_ = {};
        number_corners();
        add_groups();
        add_markers();
        warn();
        return surface_of(std::move(volume_), input_);
    }

private:
    void take(const NastranCard& card)
    {
        const auto known = kCards.find(card.name);
        if (known == kCards.end())
            return pass_over(card);
        const CardType& type = known->second;
        if (type.kind == Kind::grid)
            take_grid(card);
        else if (type.kind == Kind::unsupported)
            fail(card, card.name +
                           " elements are not supported; supported are CTRIA3, CQUAD4 and lines, and the "
                           "surface of CTETRA, CPYRAM, CPENTA and CHEXA");
        else
            take_element(card, type);
    }

    void pass_over(const NastranCard& card)
    {
        if (card.name == "INCLUDE")
            fail(card, "INCLUDE is not supported; put the file in its place");
        if (card.name == "GRDSET" && cards_.index(card, 1, "a coordinate system", 0) != 0)
            fail_system(card, cards_.index(card, 1, "a coordinate system"));
        if (kSilent.count(card.name) == 0)
            ++passed_over_[card.name];
    }

    void take_grid(const NastranCard& card)
    {
        const Index id = cards_.index(card, 0, "the id of a grid point");
        if (const Index system = cards_.index(card, 1, "a coordinate system", 0); system != 0)
            fail_system(card, system);
        for (std::size_t k = 0; k < 3; ++k)
            xyz_.push_back(cards_.real(card, 2 + k, "a coordinate"));
        ids_.add(id, card.position);
        last_grid_ = id;
    }

    [[noreturn]] void fail_system(const NastranCard& card, Index system) const
    {
        fail(card, "the points are in the coordinate system " + std::to_string(system) +
                       ", but only the basic one (0) is supported");
    }

    void take_element(const NastranCard& card, const CardType& type)
    {
        const bool has_property = type.first == 2;
        cards_.index(card, 0, "the id of an element");
        const Index property = has_property ? cards_.index(card, 1, "a property", kNoProperty) : kNoProperty;
        VolumeCell cell{};
        for (std::size_t k = 0; k < static_cast<std::size_t>(type.corners); ++k)
            cell.corners[k] = cards_.index(card, type.first + k, "a grid point");
        const bool is_volume = type.kind >= Kind::tetrahedron;
        for (std::size_t k = type.first + static_cast<std::size_t>(type.corners);
             is_volume && k < card.fields.size(); ++k)
            if (!card.field(k).empty() && k < type.first + 20)
                fail(card, card.name + " has more than " + std::to_string(type.corners) +
                               " grid points: elements of higher order are not supported");
        add(card, type.kind, property, cell);
    }

    void add(const NastranCard& card, Kind kind, Index property, VolumeCell& cell)
    {
        const auto& c = cell.corners;
        if (kind == Kind::line) {
            lines_.push_back({{c[0], c[1]}, property, card.position, card.name});
        } else if (kind == Kind::triangle || kind == Kind::quad) {
            volume_.mesh.elements.push_back({c[0], c[1], c[2], kind == Kind::quad ? c[3] : -1});
            properties_.push_back(property);
            element_positions_.push_back(card.position);
        } else {
            constexpr int first = static_cast<int>(Kind::tetrahedron);
            cell.shape = static_cast<VolumeShape>(static_cast<int>(kind) - first);
            volume_.cells.push_back(cell);
            cell_positions_.push_back(card.position);
        }
    }

    /// "$ exact 1.234…" behind a GRID has the digits of our own writer that no field can hold. They count
    /// only as long as they agree with the card.
    void take_comment(std::string_view comment)
    {
        constexpr std::string_view exact = "$ exact ";
        if (!comment.starts_with(exact))
            return names_.take(comment);
        TextScanner numbers(input_.path, comment.substr(exact.size()));
        Index id = 0;
        if (!numbers.try_index(id) || id != last_grid_ || xyz_.size() < 3)
            return;
        for (std::size_t at = xyz_.size() - 3; at < xyz_.size(); ++at) {
            constexpr double digits_of_field = 1e-7; // "-1.2345678-300" has the fewest
            double value = 0;
            if (!numbers.try_real(value))
                return;
            if (std::abs(value - xyz_[at]) <= digits_of_field * std::abs(value))
                xyz_[at] = value;
        }
    }

    void number_corners()
    {
        for (std::size_t e = 0; e < volume_.mesh.elements.size(); ++e)
            for (int k = 0; k < corner_count(volume_.mesh.elements[e]); ++k)
                number(volume_.mesh.elements[e][static_cast<std::size_t>(k)], element_positions_[e]);
        for (std::size_t c = 0; c < volume_.cells.size(); ++c)
            for (int k = 0; k < corner_count(volume_.cells[c].shape); ++k)
                number(volume_.cells[c].corners[static_cast<std::size_t>(k)], cell_positions_[c]);
        for (Line& line : lines_)
            for (Index& end : line.ends)
                number(end, line.position);
    }

    /// From the id of a grid point to the number of its vertex.
    void number(Index& corner, std::size_t position) const
    {
        const Index vertex = ids_.find(corner);
        if (vertex < 0)
            cards_.scanner().fail_at(position, "the element names grid point " + std::to_string(corner) +
                                                   ", but there is none of this id");
        corner = vertex;
    }

    std::string property_name(Index property) const
    {
        return names_.name(property).value_or("property " + std::to_string(property));
    }

    void add_groups()
    {
        std::map<Index, ElementGroup> groups;
        for (const auto& [property, name] : names_.groups())
            groups[property].name = name;
        for (std::size_t e = 0; e < properties_.size(); ++e) {
            if (properties_[e] == kNoProperty || names_.is_ungrouped(properties_[e]))
                continue;
            const auto [group, is_new] = groups.try_emplace(properties_[e]);
            if (is_new)
                group->second.name = property_name(properties_[e]);
            group->second.elements.push_back(static_cast<Index>(e));
        }
        const bool telling =
            groups.size() != 1 || !names_.groups().empty() || names_.name(groups.begin()->first);
        for (auto& [property, group] : groups)
            if (telling)
                volume_.mesh.groups.push_back(std::move(group));
    }

    void add_markers()
    {
        std::map<Index, Marker> markers;
        std::map<std::string, Marker> without_property;
        for (const auto& [property, name] : names_.markers())
            markers[property].name = name;
        for (const Line& line : lines_) {
            Marker& marker =
                line.property == kNoProperty ? without_property[line.card] : markers[line.property];
            if (marker.edges.empty() && names_.markers().count(line.property) == 0)
                marker.name = line.property == kNoProperty ? line.card : property_name(line.property);
            marker.edges.push_back(line.ends);
        }
        for (auto& [property, marker] : markers)
            volume_.mesh.markers.push_back(std::move(marker));
        for (auto& [card, marker] : without_property)
            volume_.mesh.markers.push_back(std::move(marker));
    }

    void warn() const
    {
        std::vector<std::string> cards;
        for (const auto& [name, count] : passed_over_)
            cards.push_back(quoted_text(name) + " (" + std::to_string(count) + ")");
        if (!cards.empty())
            input_.warn("cards that are no mesh were left out: " + joined(cards));
    }

    [[noreturn]] void fail(const NastranCard& card, const std::string& message) const
    {
        cards_.scanner().fail_at(card.position, message);
    }

    struct Line {
        std::array<Index, 2> ends;
        Index property;
        std::size_t position;
        std::string card;
    };

    const InputBytes& input_;
    NastranCards cards_;
    NastranNames names_;
    IdTable ids_;
    Index last_grid_ = -1;
    std::vector<double> xyz_;
    VolumeFile volume_;
    std::vector<Index> properties_; ///< of the elements
    std::vector<std::size_t> element_positions_, cell_positions_;
    std::vector<Line> lines_;
    std::map<std::string, Index> passed_over_;
};

} // namespace

MeshData read_nastran(const InputBytes& input)
{
    return NastranReader(input).read();
}

} // namespace morph
