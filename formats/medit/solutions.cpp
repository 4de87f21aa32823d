#include "formats/medit/solutions.h"

#include "formats/binary/gzip.h"
#include "formats/input_file.h"
#include "formats/medit/source.h"
#include "formats/text/message_text.h"
#include "formats/text/numbered_names.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace morph {

namespace {

/// The sections of solutions that belong to vertices and faces.
constexpr std::array<std::string_view, 3> kSections{"SolAtVertices", "SolAtTriangles", "SolAtQuadrilaterals"};

/// One of them.
struct Solutions {
    bool found = false;
    std::vector<Index> sizes; ///< components of each solution
    Matrix values;            ///< a row for each vertex or face, the solutions side by side
};

class SolutionReader {
public:
    SolutionReader(const InputBytes& file, MeshData& mesh) : file_(file), mesh_(mesh), in_(open_medit(file))
    {
    }

    void read()
    {
        while (in_->next()) {
            const auto* const section = std::find(kSections.begin(), kSections.end(), in_->section());
            if (section != kSections.end())
                read_section(solutions_.at(static_cast<std::size_t>(section - kSections.begin())));
            else if (in_->section().starts_with("Sol"))
                file_.warn("the section " + quoted_text(in_->section()) + " was left out");
        }
        names_ = read_names(in_->comments());
        add_vertex_fields();
        add_element_fields();
    }

private:
    void read_section(Solutions& solutions)
    {
        if (solutions.found)
            in_->fail_at(in_->section_position(), in_->section() + " is given again");
        solutions.found = true;
        const std::size_t rows = in_->count();
        read_sizes(solutions);
        const Index columns = components(solutions.sizes, 0, solutions.sizes.size());
        in_->require_room(rows, 0, static_cast<std::size_t>(columns));
        if (columns == 0)
            return;
        solutions.values.resize(static_cast<Eigen::Index>(rows), columns);
        for (std::size_t i = 0; i < static_cast<std::size_t>(solutions.values.size()); ++i)
            if (!in_->try_real(solutions.values.data()[i]))
                in_->fail_expected("a value of line " +
                                   std::to_string(i / static_cast<std::size_t>(columns) + 1) + " of " +
                                   in_->section());
    }

    void read_sizes(Solutions& solutions)
    {
        const std::int64_t count = in_->word("the number of solutions");
        for (std::int64_t i = 0; i < count; ++i) {
            const std::size_t position = in_->position();
            const std::int64_t type = in_->word("the type of a solution");
            if (type < 1 || type > 4)
                in_->fail_at(position, "solution " + std::to_string(i + 1) + " is of type " +
                                           std::to_string(type) +
                                           ", expected 1 (scalar), 2 (vector), 3 (symmetric) or 4 (matrix)");
            const auto d = static_cast<Index>(in_->dimension());
            const std::array<Index, 4> sizes{1, d, d * (d + 1) / 2, d * d};
            solutions.sizes.push_back(sizes.at(static_cast<std::size_t>(type - 1)));
        }
    }

    /// @return whether the section is there and has as many lines as the mesh has vertices or faces
    bool fits(std::size_t section, std::size_t count)
    {
        const Solutions& solutions = solutions_.at(section);
        if (solutions.values.size() == 0)
            return false;
        if (static_cast<std::size_t>(solutions.values.rows()) == count)
            return true;
        file_.warn(std::string(kSections.at(section)) + " was left out: it has " +
                   std::to_string(solutions.values.rows()) + " lines, but the mesh has " +
                   std::to_string(count));
        return false;
    }

    void add_vertex_fields()
    {
        if (fits(0, static_cast<std::size_t>(mesh_.points.rows())))
            add_fields(solutions_[0].values, solutions_[0].sizes, FieldLocation::vertex);
    }

    void add_element_fields()
    {
        std::array<std::size_t, 2> counts{0, 0};
        for (const Element& element : mesh_.elements)
            ++counts.at(corner_count(element) == 3 ? 0 : 1);
        const std::array<bool, 2> fit{fits(1, counts[0]), fits(2, counts[1])};
        if (!fit[0] && !fit[1])
            return;
        for (const std::size_t kind : {0U, 1U})
            if (counts.at(kind) > 0 && !fit.at(kind))
                return file_.warn("element fields were left out: " + std::string(kSections.at(kind + 1)) +
                                  " is missing or does not fit");
        if (fit[0] && fit[1] && solutions_[1].sizes != solutions_[2].sizes)
            return file_.warn("element fields were left out: SolAtTriangles and SolAtQuadrilaterals have "
                              "other types");
        const Solutions& some = solutions_.at(fit[0] ? 1 : 2);
        Matrix values(static_cast<Eigen::Index>(mesh_.elements.size()), some.values.cols());
        std::array<Eigen::Index, 2> next{0, 0};
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
            const std::size_t kind = corner_count(mesh_.elements[e]) == 3 ? 0 : 1;
            values.row(static_cast<Eigen::Index>(e)) = solutions_.at(kind + 1).values.row(next.at(kind)++);
        }
        add_fields(values, some.sizes, FieldLocation::element);
    }

    void add_fields(const Matrix& values, const std::vector<Index>& sizes, FieldLocation location)
    {
        const std::string kind = location == FieldLocation::vertex ? "vertex field" : "element field";
        Index column = 0;
        for (std::size_t first = 0, count = 0; first < sizes.size(); first += count) {
            const NumberedName name = name_of(kind, first, sizes);
            count = static_cast<std::size_t>(name.last - name.first) + 1;
            const Index columns = components(sizes, first, count);
            mesh_.fields.push_back({name.name, location, values.middleCols(column, columns)});
            column += columns;
        }
    }

    /// The line of the table that starts with a solution; a name of its own when none fits.
    NumberedName name_of(const std::string& kind, std::size_t first, const std::vector<Index>& sizes) const
    {
        constexpr Index most_components = 9;
        const auto number = static_cast<std::int64_t>(first) + 1;
        for (const NumberedName& row : names_)
            if (row.kind == kind && row.first == number &&
                row.last <= static_cast<std::int64_t>(sizes.size()) &&
                components(sizes, first, static_cast<std::size_t>(row.last - row.first) + 1) <=
                    most_components)
                return row;
        return {kind, number, number, "solution_" + std::to_string(number)};
    }

    static Index components(const std::vector<Index>& sizes, std::size_t first, std::size_t count)
    {
        Index sum = 0;
        for (std::size_t i = first; i < first + count; ++i)
            sum += sizes[i];
        return sum;
    }

    const InputBytes& file_;
    MeshData& mesh_;
    std::unique_ptr<MeditSource> in_;
    std::array<Solutions, 3> solutions_;
    std::vector<NumberedName> names_;
};

} // namespace

void read_medit_solutions(const InputBytes& file, MeshData& mesh)
{
    SolutionReader(file, mesh).read();
}

void read_medit_solutions_beside(const InputBytes& file, MeshData& mesh)
{
    std::filesystem::path path = without_gz(file.path);
    std::array<std::string_view, 2> extensions{".sol", ".solb"};
    if (path.extension() == ".meshb")
        std::swap(extensions[0], extensions[1]);
    for (const std::string_view extension : extensions) {
        path.replace_extension(extension);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(path, ignored))
            continue;
        const InputFile solutions(path.string());
        return read_medit_solutions({path.string(), solutions.bytes(), {}, file.notes}, mesh);
    }
}

} // namespace morph
