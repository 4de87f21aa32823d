#include "formats/abaqus/write.h"

#include "formats/abaqus/lines.h"
#include "formats/text/names_in_text.h"
#include "formats/text/number_text.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace morph {

namespace {

constexpr std::size_t kIdsInALine = 16; // the most Abaqus takes
constexpr std::size_t kLongestName = 80;

class AbaqusWriter {
public:
    AbaqusWriter(const MeshData& mesh, OutputFile& out) : mesh_(mesh), out_(out) {}

    void write()
    {
        out_.append("*HEADING\n*NODE\n");
        for (Eigen::Index v = 0; v < mesh_.points.rows(); ++v)
            write_node(v);
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            write_element(e);
        for (const ElementGroup& group : mesh_.groups)
            write_group(group);
        for (const Marker& marker : mesh_.markers)
            write_marker(marker);
    }

private:
    void write_node(Eigen::Index v)
    {
        char* to = number_text(out_.room(4 * kLongestNumber), v + 1, ',');
        for (int k = 0; k < mesh_.dimension; ++k)
            to = number_text(to, mesh_.points(v, k), k + 1 < mesh_.dimension ? ',' : '\n');
        out_.advance_to(to);
    }

    void write_element(std::size_t e)
    {
        const Element& element = mesh_.elements[e];
        const int corners = corner_count(element);
        if (e == 0 || corners != corner_count(mesh_.elements[e - 1]))
            out_.append((mesh_.dimension == 3 ? "*ELEMENT, TYPE=S" : "*ELEMENT, TYPE=CPS") +
                        std::to_string(corners) + "\n");
        char* to = number_text(out_.room(5 * kLongestNumber), e + 1, ',');
        for (int k = 0; k < corners; ++k)
            to = number_text(to, element[static_cast<std::size_t>(k)] + 1, k + 1 < corners ? ',' : '\n');
        out_.advance_to(to);
    }

    void write_group(const ElementGroup& group)
    {
        const std::string name = set_name(group.name);
        out_.append("*ELSET, ELSET=" + name + "\n");
        for (std::size_t i = 0; i < group.elements.size(); ++i) {
            const bool last = i + 1 == group.elements.size() || i % kIdsInALine == kIdsInALine - 1;
            out_.advance_to(number_text(out_.room(kLongestNumber), group.elements[i] + 1, last ? '\n' : ','));
        }
    }

    void write_marker(const Marker& marker)
    {
        const std::string name = set_name(marker.name);
        out_.append((mesh_.dimension == 3 ? "*ELEMENT, TYPE=T3D2, ELSET=" : "*ELEMENT, TYPE=T2D2, ELSET=") +
                    name + "\n");
        for (const auto& [from, to_vertex] : marker.edges) {
            char* to = number_text(out_.room(3 * kLongestNumber), mesh_.elements.size() + ++lines_, ',');
            to = number_text(to, from + 1, ',');
            out_.advance_to(number_text(to, to_vertex + 1, '\n'));
        }
    }

    /// The name if Abaqus takes it and no other set has it, else a plainer one with a comment.
    std::string set_name(const std::string& full)
    {
        std::string plain = full.substr(0, kLongestName - 8); // room for a number
        std::replace_if(
            plain.begin(), plain.end(),
            [](unsigned char c) { return c > 127 || (std::isalnum(c) == 0 && c != '_' && c != '-'); }, '_');
        if (plain.empty() || std::isalpha(static_cast<unsigned char>(plain[0])) == 0)
            plain.insert(0, "Set_");
        std::string name = plain;
        for (int number = 2; !taken_.insert(upper_case(name)).second; ++number)
            name = plain + "_" + std::to_string(number);
        if (name != full)
            out_.append("** name " + name + " " + line_name(full) + "\n");
        return name;
    }

    const MeshData& mesh_;
    OutputFile& out_;
    std::size_t lines_ = 0;       ///< written so far; their ids follow those of the elements
    std::set<std::string> taken_; ///< names of sets in upper case
};

} // namespace

void write_abaqus(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    AbaqusWriter(mesh, out).write();
}

} // namespace morph
