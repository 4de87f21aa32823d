#include "formats/tecplot/write.h"

#include "formats/tecplot/text.h"
#include "formats/tecplot/variables.h"
#include "formats/text/number_text.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kLongestList = 2000; // Tecplot reads lines up to 32000 characters
constexpr Eigen::Index kValuesInALine = 8;

/// Elements that make one zone.
struct Run {
    std::string name;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The groups as runs of elements that follow one another and leave none out, or no run.
std::vector<Run> runs_of(const MeshData& mesh)
{
    std::vector<Run> runs;
    std::size_t next = 0;
    for (const ElementGroup& group : mesh.groups) {
        runs.push_back({group.name, next, next + group.elements.size()});
        for (const Index e : group.elements)
            if (e != static_cast<Index>(next++))
                return {};
        if (group.elements.empty())
            return {};
    }
    if (runs.size() < 2 || next != mesh.elements.size())
        return {};
    return runs;
}

/// Numbers from 1 as "1-3,5", in pieces that fit into lines; each number is one less in @p numbers.
std::vector<std::string> range_lists(const std::vector<Index>& numbers)
{
    std::vector<std::string> lists;
    for (std::size_t begin = 0, end = 0; begin < numbers.size(); begin = end) {
        for (end = begin + 1; end < numbers.size() && numbers[end] == numbers[end - 1] + 1;)
            ++end;
        std::string range = std::to_string(numbers[begin] + 1);
        if (end - begin > 1)
            range += "-" + std::to_string(numbers[end - 1] + 1);
        if (lists.empty() || lists.back().size() > kLongestList)
            lists.push_back(std::move(range));
        else
            lists.back() += "," + range;
    }
    return lists;
}

class TecplotWriter {
public:
    TecplotWriter(const MeshData& mesh, OutputFile& out) : mesh_(mesh), out_(out), runs_(runs_of(mesh))
    {
        listed_groups_ = runs_.empty();
        if (runs_.empty())
            runs_.push_back({"mesh", 0, mesh.elements.size()});
    }

    void write()
    {
        write_variables();
        if (listed_groups_)
            for (std::size_t g = 0; g < mesh_.groups.size(); ++g)
                write_group(mesh_.groups[g], std::to_string(g + 1));
        for (const Run& run : runs_)
            write_run(run);
        for (const Marker& marker : mesh_.markers)
            write_marker(marker);
    }

private:
    /// Coordinates, then the components of the fields.
    void write_variables()
    {
        const bool takes_z = std::any_of(mesh_.fields.begin(), mesh_.fields.end(), [](const Field& field) {
            return is_tecplot_coordinate(field.name, 2);
        });
        axes_ = mesh_.dimension == 3 || takes_z ? 3 : 2;
        out_.append("VARIABLES =");
        for (int axis = 0; axis < axes_; ++axis)
            write_variable({"XYZ"[axis]}, false);
        for (const Field& field : mesh_.fields)
            for (Eigen::Index c = 0; c < field.values.cols(); ++c)
                write_variable(field.values.cols() == 1 ? field.name : field.name + "_" + std::to_string(c),
                               field.location == FieldLocation::element);
        out_.append("\n");
    }

    void write_variable(const std::string& name, bool centred)
    {
        out_.append((variables_ == 0 ? " " : "\n") + tecplot_quoted(name));
        (centred ? centred_ : nodal_).push_back(variables_++);
    }

    void write_group(const ElementGroup& group, const std::string& number)
    {
        out_.append("DATASETAUXDATA morph_group_name_" + number + "=" + tecplot_quoted(group.name) + "\n");
        const std::vector<std::string> lists = range_lists(group.elements);
        for (std::size_t i = 0; i < lists.size(); ++i)
            out_.append("DATASETAUXDATA morph_group_elements_" + number + "_" + std::to_string(i + 1) +
                        "=\"" + lists[i] + "\"\n");
    }

    void write_zone(const std::string& name, std::size_t elements, std::string_view type)
    {
        out_.append("ZONE T=" + tecplot_quoted(name) + "\nNODES=" + std::to_string(mesh_.points.rows()) +
                    ", ELEMENTS=" + std::to_string(elements) +
                    ", DATAPACKING=BLOCK, ZONETYPE=" + std::string(type) + "\n");
    }

    void write_list(std::string_view before, const std::vector<Index>& variables, std::string_view behind)
    {
        const std::vector<std::string> lists = range_lists(variables);
        if (lists.empty())
            return;
        out_.append(before);
        for (std::size_t i = 0; i < lists.size(); ++i)
            out_.append((i == 0 ? "" : ",\n") + lists[i]);
        out_.append(behind);
    }

    void write_run(const Run& run)
    {
        const auto begin = mesh_.elements.begin() + static_cast<std::ptrdiff_t>(run.begin);
        const auto end = mesh_.elements.begin() + static_cast<std::ptrdiff_t>(run.end);
        const bool quads = std::any_of(begin, end, [](const Element& e) { return e[3] >= 0; });
        write_zone(run.name, run.end - run.begin, quads ? "FEQUADRILATERAL" : "FETRIANGLE");
        write_list("VARLOCATION=([", centred_, "]=CELLCENTERED)\n");
        if (run.begin > 0)
            write_list("VARSHARELIST=([", nodal_, "]=1)\n");
        else
            for (int axis = 0; axis < axes_; ++axis)
                write_values(mesh_.points.rows(), [&](Eigen::Index v) { return mesh_.points(v, axis); });
        for (const Field& field : mesh_.fields)
            write_field(field, run);
        for (auto element = begin; element != end; ++element)
            write_element(*element, quads);
    }

    void write_field(const Field& field, const Run& run)
    {
        const bool nodal = field.location == FieldLocation::vertex;
        if (nodal && run.begin > 0)
            return;
        const auto first = static_cast<Eigen::Index>(nodal ? 0 : run.begin);
        const Eigen::Index count = nodal ? field.values.rows() : static_cast<Eigen::Index>(run.end) - first;
        for (Eigen::Index c = 0; c < field.values.cols(); ++c)
            write_values(count, [&](Eigen::Index i) { return field.values(first + i, c); });
    }

    template <class Value>
    void write_values(Eigen::Index count, const Value& value)
    {
        for (Eigen::Index i = 0; i < count; ++i) {
            const bool last = i + 1 == count || i % kValuesInALine == kValuesInALine - 1;
            out_.advance_to(number_text(out_.room(kLongestNumber), value(i), last ? '\n' : ' '));
        }
    }

    void write_element(const Element& element, bool as_quad)
    {
        char* to = out_.room(4 * kLongestNumber);
        to = number_text(to, element[0] + 1, ' ');
        to = number_text(to, element[1] + 1, ' ');
        to = number_text(to, element[2] + 1, as_quad ? ' ' : '\n');
        if (as_quad)
            to = number_text(to, (element[3] < 0 ? element[2] : element[3]) + 1, '\n');
        out_.advance_to(to);
    }

    void write_marker(const Marker& marker)
    {
        write_zone(marker.name, marker.edges.size(), "FELINESEG");
        write_list("VARSHARELIST=([", nodal_, "]=1)\n");
        write_list("PASSIVEVARLIST=[", centred_, "]\n");
        for (const auto& [from, to_vertex] : marker.edges) {
            char* to = out_.room(2 * kLongestNumber);
            to = number_text(to, from + 1, ' ');
            out_.advance_to(number_text(to, to_vertex + 1, '\n'));
        }
    }

    const MeshData& mesh_;
    OutputFile& out_;
    std::vector<Run> runs_;
    bool listed_groups_ = false;
    int axes_ = 2;
    Index variables_ = 0;
    std::vector<Index> nodal_, centred_; ///< variables, from 0
};

} // namespace

void write_tecplot(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    TecplotWriter(mesh, out).write();
}

} // namespace morph
