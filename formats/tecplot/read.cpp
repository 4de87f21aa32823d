#include "formats/tecplot/read.h"

#include "formats/tecplot/header.h"
#include "formats/tecplot/text.h"
#include "formats/text/message_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace morph {

namespace {

/// Repetition (1000*0.5), sharing and passive variables make values of few bytes; no mesh makes more than
/// this of one byte.
constexpr std::int64_t kMostValuesOfAByte = 16;

const std::set<std::string> kDrawings{"TEXT", "GEOMETRY", "CUSTOMLABELS", "LABELS"};
const std::set<std::string> kRecords{"TITLE",      "VARIABLES", "FILETYPE", "ZONE",         "DATASETAUXDATA",
                                     "VARAUXDATA", "GEOMETRY",  "TEXT",     "CUSTOMLABELS", "LABELS"};

class TecplotReader {
public:
    explicit TecplotReader(const InputBytes& input) : input_(input), in_(input.path, input.bytes, '#') {}

    TecplotFile read()
    {
        require_text();
        while (in_.skip_white())
            read_record();
        if (file_.zones.empty())
            throw InputError(input_.path + ": no ZONE in it, so this is no Tecplot file with a mesh");
        return std::move(file_);
    }

private:
    void require_text() const
    {
        for (const std::string_view magic : {"#!TDV", "#!SZPLT"})
            if (input_.bytes.starts_with(magic))
                throw InputError(input_.path + ": byte 0: a binary Tecplot file (" +
                                 std::string(input_.bytes.substr(0, magic == "#!TDV" ? 8 : 7)) +
                                 "), but ASCII was expected; save it as ASCII (.dat)");
    }

    void read_record()
    {
        const std::size_t start = in_.position();
        const std::string word = try_tecplot_word(in_);
        if (word == "ZONE")
            read_zone(start);
        else if (word == "VARIABLES")
            read_variables();
        else if (word == "TITLE" || word == "FILETYPE")
            read_title(word);
        else if (word == "DATASETAUXDATA")
            read_group(start);
        else if (word == "VARAUXDATA")
            in_.skip_line();
        else if (kDrawings.count(word) != 0)
            skip_drawing(word, start);
        else {
            in_.seek(start);
            in_.fail_expected("a record such as VARIABLES or ZONE");
        }
    }

    void read_title(const std::string& word)
    {
        if (!try_tecplot_equals(in_))
            in_.fail_expected("'=' after " + word);
        const std::size_t position = in_.position();
        const std::string value = read_tecplot_value(in_, "a value after " + word + "=");
        if (word == "FILETYPE" && (value == "SOLUTION" || value == "solution"))
            in_.fail_at(position, "FILETYPE=SOLUTION has no coordinates; FULL or GRID was expected");
    }

    void read_variables()
    {
        if (!try_tecplot_equals(in_))
            in_.fail_expected("'=' after VARIABLES");
        file_.variables.clear();
        while (skip_tecplot_white(in_)) {
            const std::size_t start = in_.position();
            const bool record = kRecords.count(try_tecplot_word(in_)) != 0;
            in_.seek(start);
            if (record)
                break;
            file_.variables.push_back(read_tecplot_value(in_, "the name of a variable"));
        }
        if (!file_.zones.empty())
            in_.fail("VARIABLES= must stand before the first ZONE");
    }

    /// Groups of elements that no zones can hold, as our own writer puts them; other auxiliary data are none
    /// of ours.
    void read_group(std::size_t start)
    {
        const auto [name, value] = read_tecplot_auxiliary(in_);
        if (name.starts_with("morph_group_name_"))
            file_.groups.push_back({value, {}});
        else if (name.starts_with("morph_group_elements_") && !file_.groups.empty())
            for (const Index e : tecplot_numbers(in_, start, value, static_cast<Index>(in_.text().size()),
                                                 "the elements of a group"))
                file_.groups.back().elements.push_back(e - 1);
    }

    void skip_drawing(const std::string& word, std::size_t start)
    {
        input_.warn("line " + std::to_string(in_.line_of(start)) + ": " + word + " was left out");
        for (in_.skip_line(); in_.skip_white(); in_.skip_line()) {
            const std::size_t line = in_.position();
            const bool record = kRecords.count(try_tecplot_word(in_)) != 0;
            in_.seek(line);
            if (record)
                return;
        }
    }

    void read_zone(std::size_t start)
    {
        if (file_.variables.size() < 2)
            in_.fail_at(start, "VARIABLES= must name two variables or more before the first ZONE");
        TecplotZone zone = read_tecplot_zone_header(in_, file_, start, input_);
        name_ = "zone " + std::to_string(file_.zones.size() + 1) +
                (zone.name.empty() ? "" : " " + quoted_text(zone.name));
        read_values(zone);
        if (zone.cells == TecplotCells::ordered)
            connect_ordered(zone);
        else if (zone.connectivity_of >= 0)
            share_connectivity(zone);
        else
            read_connectivity(zone);
        if (zone.has_neighbors)
            skip_numbers();
        file_.zones.push_back(std::move(zone));
    }

    void read_values(TecplotZone& zone)
    {
        std::vector<std::vector<double>> values(zone.variables.size());
        std::vector<std::size_t> own;
        for (std::size_t v = 0; v < zone.variables.size(); ++v) {
            const TecplotVariable& variable = zone.variables[v];
            if (variable.shared_with >= 0)
                continue;
            const Index count = variable.centred ? zone.elements : zone.nodes;
            spend(zone, count);
            if (variable.passive)
                values[v].assign(static_cast<std::size_t>(count), 0.0);
            else
                own.push_back(v);
        }
        if (zone.block)
            for (const std::size_t v : own)
                read_column(values[v], zone.variables[v].centred ? zone.elements : zone.nodes, v);
        else
            read_rows(values, own, zone.nodes);
        if (repeats_ > 0)
            in_.fail("a value is repeated beyond the last one of " + name_);
        for (std::size_t v = 0; v < zone.variables.size(); ++v)
            store(zone, v, std::move(values[v]));
    }

    /// Values that cost no bytes are limited all the same.
    void spend(const TecplotZone& zone, Index count)
    {
        values_ += count;
        if (values_ > kMostValuesOfAByte * static_cast<std::int64_t>(in_.text().size()))
            in_.fail_at(zone.position, name_ + " brings the values to " + std::to_string(values_) +
                                           ", but the file has " + std::to_string(in_.text().size()) +
                                           " bytes only");
    }

    void read_column(std::vector<double>& column, Index count, std::size_t variable)
    {
        column.reserve(static_cast<std::size_t>(count));
        for (Index i = 0; i < count; ++i)
            column.push_back(next_value(variable));
    }

    void read_rows(std::vector<std::vector<double>>& values, const std::vector<std::size_t>& own, Index nodes)
    {
        for (const std::size_t v : own)
            values[v].reserve(static_cast<std::size_t>(nodes));
        for (Index i = 0; i < nodes; ++i)
            for (const std::size_t v : own)
                values[v].push_back(next_value(v));
    }

    double next_value(std::size_t variable)
    {
        if (repeats_ > 0) {
            --repeats_;
            return repeated_;
        }
        double value = 0;
        if (!skip_tecplot_white(in_) || !in_.try_real(value))
            in_.fail_expected("a value of " + quoted_text(file_.variables[variable]) + " in " + name_);
        if (in_.position() < in_.text().size() && in_.text()[in_.position()] == '*')
            return repeated_value(value);
        return value;
    }

    /// 3*0.5 stands for 0.5 0.5 0.5.
    double repeated_value(double times)
    {
        if (!(times >= 1 && times <= INT32_MAX && times == static_cast<Index>(times)))
            in_.fail("a value must be repeated a whole number of times");
        in_.seek(in_.position() + 1);
        repeats_ = static_cast<Index>(times) - 1;
        repeated_ = in_.real("a value behind '*'");
        return repeated_;
    }

    void store(TecplotZone& zone, std::size_t v, std::vector<double> values) const
    {
        TecplotVariable& variable = zone.variables[v];
        const Index count = variable.centred ? zone.elements : zone.nodes;
        if (variable.shared_with < 0)
            variable.values = std::make_shared<const std::vector<double>>(std::move(values));
        else
            variable.values = file_.zones[static_cast<std::size_t>(variable.shared_with)].variables[v].values;
        if (variable.values->size() != static_cast<std::size_t>(count))
            in_.fail_at(zone.position, name_ + " has " + std::to_string(count) + " values of " +
                                           quoted_text(file_.variables[v]) + ", but zone " +
                                           std::to_string(variable.shared_with + 1) +
                                           ", whose values it shares, " +
                                           std::to_string(variable.values->size()));
    }

    void read_connectivity(TecplotZone& zone)
    {
        const int corners = corner_count(zone.cells);
        const std::size_t most = (in_.rest().size() + 1) / 2; // "1 "
        zone.corners.reserve(
            std::min(most, static_cast<std::size_t>(zone.elements) * static_cast<std::size_t>(corners)));
        for (Index e = 0; e < zone.elements; ++e)
            for (int k = 0; k < corners; ++k)
                zone.corners.push_back(next_node(zone, e) - 1);
    }

    Index next_node(const TecplotZone& zone, Index element)
    {
        Index node = 0;
        if (!skip_tecplot_white(in_) || !in_.try_index(node))
            in_.fail_expected("a node of element " + std::to_string(element + 1) + " of " + name_);
        if (node < 1 || node > zone.nodes)
            in_.fail("element " + std::to_string(element + 1) + " of " + name_ + " names node " +
                     std::to_string(node) + ", but the zone has " + std::to_string(zone.nodes));
        return node;
    }

    /// The corners stay with the zone that has them.
    void share_connectivity(TecplotZone& zone) const
    {
        const TecplotZone& from = file_.zones[static_cast<std::size_t>(zone.connectivity_of)];
        if (from.cells != zone.cells || from.nodes != zone.nodes || from.elements != zone.elements)
            in_.fail_at(zone.position, name_ + " shares the connectivity of zone " +
                                           std::to_string(zone.connectivity_of + 1) +
                                           ", but has another type or size");
        if (from.connectivity_of >= 0)
            zone.connectivity_of = from.connectivity_of;
    }

    void skip_numbers()
    {
        while (in_.skip_white() && std::isdigit(static_cast<unsigned char>(in_.text()[in_.position()])) != 0)
            in_.skip_line();
    }

    const InputBytes& input_;
    TextScanner in_;
    TecplotFile file_;
    std::string name_; ///< of the zone being read, for messages
    std::int64_t values_ = 0;
    Index repeats_ = 0;
    double repeated_ = 0;
};

} // namespace

TecplotFile read_tecplot_file(const InputBytes& input)
{
    return TecplotReader(input).read();
}

} // namespace morph
