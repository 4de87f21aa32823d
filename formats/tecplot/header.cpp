#include "formats/tecplot/header.h"

#include "formats/tecplot/text.h"
#include "formats/text/message_text.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace morph {

namespace {

/// Keys that say nothing about the mesh.
const std::set<std::string> kIgnored{"C", "DT", "PARENTZONE", "FACENEIGHBORMODE", "FEFACENEIGHBORSCOMPLETE"};

constexpr std::array<std::pair<std::string_view, TecplotCells>, 11> kTypes{{
    {"ORDERED", TecplotCells::ordered},
    {"FELINESEG", TecplotCells::lines},
    {"LINESEG", TecplotCells::lines},
    {"FETRIANGLE", TecplotCells::triangles},
    {"TRIANGLE", TecplotCells::triangles},
    {"FEQUADRILATERAL", TecplotCells::quads},
    {"QUADRILATERAL", TecplotCells::quads},
    {"FETETRAHEDRON", TecplotCells::tetrahedra},
    {"TETRAHEDRON", TecplotCells::tetrahedra},
    {"FEBRICK", TecplotCells::bricks},
    {"BRICK", TecplotCells::bricks},
}};

std::string upper(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

class HeaderReader {
public:
    HeaderReader(TextScanner& in, const TecplotFile& file, std::size_t position, const InputBytes& input)
        : in_(in), file_(file), input_(input)
    {
        zone_.position = position;
        zone_.variables.resize(file.variables.size());
    }

    TecplotZone read()
    {
        while (skip_tecplot_white(in_)) {
            const std::size_t start = in_.position();
            const std::string key = try_tecplot_word(in_);
            if (key == "AUXDATA") {
                read_tecplot_auxiliary(in_);
            } else if (!key.empty() && try_tecplot_equals(in_)) {
                read_key(key);
            } else {
                in_.seek(start);
                break;
            }
        }
        finish();
        return std::move(zone_);
    }

private:
    void read_key(const std::string& key)
    {
        in_.skip_white();
        value_position_ = in_.position();
        value_ = read_tecplot_value(in_, "a value after " + key + "=");
        if (key == "T")
            zone_.name = value_;
        else if (!read_layout(key) && !read_size(key) && !read_sharing(key) && kIgnored.count(key) == 0)
            input_.warn("line " + std::to_string(in_.line_of(value_position_)) + ": the key " + key +
                        " of a zone was passed over");
    }

    bool read_layout(const std::string& key)
    {
        if (key == "ZONETYPE" || key == "ET")
            set_type();
        else if (key == "DATAPACKING" || key == "F")
            set_packing();
        else if (key == "VARLOCATION")
            set_locations();
        else if (key == "STRANDID")
            zone_.strand = static_cast<int>(whole(key));
        else if (key == "SOLUTIONTIME")
            set_time();
        else
            return false;
        return true;
    }

    void set_type()
    {
        const std::string name = upper(value_);
        const auto* const found =
            std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& type) { return type.first == name; });
        if (found == kTypes.end())
            fail("zones of the type " + quoted_text(value_) +
                 " are not supported; supported are ORDERED, FELINESEG, FETRIANGLE, FEQUADRILATERAL, "
                 "FETETRAHEDRON and FEBRICK");
        zone_.cells = found->second;
    }

    void set_time()
    {
        TextScanner time(in_.path(), value_);
        if (!time.try_real(zone_.time))
            fail("SOLUTIONTIME must be a number, found " + quoted_text(value_));
    }

    void set_packing()
    {
        const std::string name = upper(value_);
        if (name != "POINT" && name != "BLOCK" && name != "FEPOINT" && name != "FEBLOCK")
            fail("data are packed as " + quoted_text(value_) +
                 ", but POINT or BLOCK (FEPOINT, FEBLOCK) was expected");
        packed_ = true;
        zone_.block = name.ends_with("BLOCK");
    }

    /// A list such as ([4-6]=CELLCENTERED,[7]=NODAL) or one name for each variable.
    void set_locations()
    {
        const std::string list = upper(value_);
        std::size_t at = list.find('[');
        if (at == std::string::npos) {
            TextScanner words(in_.path(),
                              std::string_view(list).substr(std::min<std::size_t>(1, list.size())));
            for (TecplotVariable& variable : zone_.variables) {
                if (!skip_tecplot_white(words))
                    break;
                variable.centred = try_tecplot_word(words) == "CELLCENTERED";
            }
        }
        for (; at != std::string::npos; at = list.find('[', at + 1)) {
            const std::size_t close = list.find(']', at);
            const std::size_t name = list.find_first_not_of("]= \t\r\n", close);
            for (const Index v : variables(list.substr(at, close - at), "VARLOCATION"))
                zone_.variables[static_cast<std::size_t>(v - 1)].centred =
                    name != std::string::npos && list.compare(name, 12, "CELLCENTERED") == 0;
        }
    }

    bool read_size(const std::string& key)
    {
        if (key == "N" || key == "NODES")
            set_nodes(key);
        else if (key == "E" || key == "ELEMENTS")
            zone_.elements = whole(key);
        else if (key == "I" || key == "J" || key == "K" || key == "IMAX" || key == "JMAX" || key == "KMAX")
            set_size(key);
        else if (key == "FACENEIGHBORCONNECTIONS")
            zone_.has_neighbors = whole(key) > 0;
        else if (key == "NV")
            nodal_ = whole(key);
        else
            return false;
        return true;
    }

    void set_nodes(const std::string& key)
    {
        zone_.nodes = whole(key);
        has_nodes_ = true;
    }

    void set_size(const std::string& key)
    {
        zone_.size[static_cast<std::size_t>(key[0] - 'I')] = whole(key);
        has_size_ = true;
    }

    bool read_sharing(const std::string& key)
    {
        if (key == "VARSHARELIST")
            share_variables();
        else if (key == "CONNECTIVITYSHAREZONE")
            zone_.connectivity_of = earlier_zone(whole(key));
        else if (key == "D")
            share_old_way();
        else if (key == "PASSIVEVARLIST")
            for (const Index v : variables(value_, key))
                zone_.variables[static_cast<std::size_t>(v - 1)].passive = true;
        else
            return false;
        return true;
    }

    /// A list such as ([1-3]=1,[5]=2); without a zone, the one before.
    void share_variables()
    {
        for (std::size_t at = value_.find('['); at != std::string::npos; at = value_.find('[', at + 1)) {
            const std::size_t close = std::min(value_.find(']', at), value_.size());
            Index number = static_cast<Index>(file_.zones.size());
            if (close + 1 < value_.size() && value_[close + 1] == '=') {
                TextScanner zone(in_.path(), std::string_view(value_).substr(close + 2));
                if (!zone.try_index(number))
                    fail("VARSHARELIST must be like ([1-3]=1), found " + quoted_text(value_));
            }
            for (const Index v : variables(value_.substr(at, close - at), "VARSHARELIST"))
                zone_.variables[static_cast<std::size_t>(v - 1)].shared_with = earlier_zone(number);
        }
    }

    /// D=(1,2,FECONNECT): variables, and the connectivity, of the zone before.
    void share_old_way()
    {
        std::string list = upper(value_);
        const int before = earlier_zone(static_cast<Index>(file_.zones.size()));
        if (const std::size_t at = list.find("FECONNECT"); at != std::string::npos) {
            list.erase(at, 9);
            zone_.connectivity_of = before;
        }
        for (const Index v : variables(list, "D"))
            zone_.variables[static_cast<std::size_t>(v - 1)].shared_with = before;
    }

    std::vector<Index> variables(const std::string& list, const std::string& key) const
    {
        return tecplot_numbers(in_, value_position_, list, static_cast<Index>(zone_.variables.size()),
                               "the variables of " + key);
    }

    int earlier_zone(Index number) const
    {
        if (number < 1 || static_cast<std::size_t>(number) > file_.zones.size())
            fail("zone " + std::to_string(number) + " is to be shared, but " +
                 std::to_string(file_.zones.size()) + " zone(s) stand before this one");
        return number - 1;
    }

    Index whole(const std::string& key) const
    {
        TextScanner number(in_.path(), value_);
        Index value = 0;
        if (!number.try_index(value) || !number.at_line_end())
            fail(key + " must be a whole number, found " + quoted_text(value_));
        return value;
    }

    void finish()
    {
        value_position_ = zone_.position;
        const bool ordered = zone_.cells == TecplotCells::ordered;
        if (!(ordered ? has_size_ : has_nodes_))
            fail(std::string("the zone does not say how many nodes it has: ") + (ordered ? "I=" : "NODES=") +
                 " is missing");
        for (std::size_t v = static_cast<std::size_t>(nodal_); v < zone_.variables.size(); ++v)
            zone_.variables[v].centred = true;
        const bool centred = std::any_of(zone_.variables.begin(), zone_.variables.end(), [](const auto& v) {
            return v.centred && !v.passive && v.shared_with < 0;
        });
        if (!packed_)
            zone_.block = centred;
        if (centred && !zone_.block)
            fail("a zone with values at cells must be packed as BLOCK");
        if (ordered)
            count_ordered();
        const auto most = static_cast<std::int64_t>(in_.text().size());
        if (zone_.nodes > most || zone_.elements > most)
            fail("the zone counts " + std::to_string(zone_.nodes) + " nodes and " +
                 std::to_string(zone_.elements) + " elements, but the file has " + std::to_string(most) +
                 " bytes only");
    }

    void count_ordered()
    {
        const auto most = static_cast<std::int64_t>(in_.text().size());
        std::int64_t nodes = 1;
        std::int64_t elements = 1;
        for (const Index length : zone_.size) {
            nodes *= length;
            elements *= std::max(1, length - 1);
            if (length < 1 || nodes > most)
                fail("the zone is " + std::to_string(zone_.size[0]) + " x " + std::to_string(zone_.size[1]) +
                     " x " + std::to_string(zone_.size[2]) + " nodes, but the file has " +
                     std::to_string(most) + " bytes only");
        }
        zone_.nodes = static_cast<Index>(nodes);
        zone_.elements = static_cast<Index>(elements);
    }

    [[noreturn]] void fail(const std::string& message) const { in_.fail_at(value_position_, message); }

    TextScanner& in_;
    const TecplotFile& file_;
    const InputBytes& input_;
    TecplotZone zone_;
    std::string value_;
    std::size_t value_position_ = 0;
    bool has_nodes_ = false;
    bool has_size_ = false;
    bool packed_ = false;
    Index nodal_ = INT32_MAX; ///< variables from this one on are at cells
};

} // namespace

TecplotZone read_tecplot_zone_header(TextScanner& in, const TecplotFile& file, std::size_t position,
                                     const InputBytes& input)
{
    return HeaderReader(in, file, position, input).read();
}

} // namespace morph
