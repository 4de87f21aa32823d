#include "formats/abaqus/model.h"

#include "formats/text/message_text.h"
#include "formats/text/names_in_text.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <set>

namespace morph {

namespace {

/// Keywords that make or move parts of the mesh in ways that are not supported.
const std::set<std::string> kRefused{"INCLUDE", "NGEN",  "NFILL",  "NCOPY",
                                     "NMAP",    "ELGEN", "ELCOPY", "SYSTEM"};

/// Keywords that say nothing to be missed.
const std::set<std::string> kSilent{"HEADING",  "PREPRINT",     "PART",        "END PART",
                                    "ASSEMBLY", "END ASSEMBLY", "END INSTANCE"};

class ModelReader {
public:
    explicit ModelReader(const InputBytes& input) : input_(input), lines_(input.path, input.bytes) {}

    AbaqusModel read()
    {
        while (lines_.next_keyword(keyword_)) {
            take_names();
            take_keyword();
        }
        if (keywords_ == 0)
            throw InputError(input_.path +
                             ": no keyword such as *NODE in it, so this is no Abaqus input file");
        const TextScanner& in = lines_.scanner();
        model_.nodes.finish(in, "node");
        model_.elements.finish(in, "element");
        number_corners();
        model_.element_sets.resolve(model_.elements, in, "element");
        model_.node_sets.resolve(model_.nodes, in, "node");
        model_.elements.drop_positions();
        warn();
        return std::move(model_);
    }

private:
    void take_keyword()
    {
        ++keywords_;
        const std::string& name = keyword_.name;
        if (kRefused.count(name) != 0)
            fail("*" + name + " is not supported; write the mesh out in full");
        if (name == "NODE" || name == "ELEMENT" || name == "ELSET" || name == "NSET")
            require_here();
        if (name == "NODE")
            read_nodes();
        else if (name == "ELEMENT")
            read_elements();
        else if (name == "ELSET")
            read_set(model_.element_sets, "ELSET");
        else if (name == "NSET")
            read_set(model_.node_sets, "NSET");
        else if (name == "SURFACE")
            read_surface();
        else if (name == "INSTANCE")
            require_in_place();
        else if (kSilent.count(name) == 0)
            passed_over_.insert(name);
        if (name == "PART")
            part_has_nodes_ = false;
    }

    void require_here() const
    {
        if (const auto file = keyword_.value("INPUT"))
            fail("*" + keyword_.name + " reads the file " + quoted_text(*file) +
                 ", which is not supported; put its lines in place");
    }

    /// Data lines of *INSTANCE move or turn it.
    void require_in_place()
    {
        if (lines_.next_data_line())
            lines_.scanner().fail("instances that are moved or turned are not supported");
    }

    void read_nodes()
    {
        if (keyword_.has("SYSTEM") && upper_case(*keyword_.value("SYSTEM")) != "R")
            fail("nodes in cylindrical or spherical coordinates are not supported");
        if (!part_has_nodes_ && ++parts_ > 1)
            fail("the nodes of a second part begin here, but one part is supported");
        part_has_nodes_ = true;
        const Index begin = model_.nodes.count();
        while (lines_.next_data_line()) {
            const std::size_t position = lines_.scanner().position();
            model_.nodes.add(lines_.index("the id of a node"), position);
            for (int k = 0; k < 3; ++k)
                model_.xyz.push_back(lines_.at_line_end() ? 0.0 : lines_.real("a coordinate"));
            lines_.scanner().skip_line(); // normals may follow
        }
        if (const auto set = keyword_.value("NSET"))
            model_.node_sets.add_run(*set, begin, model_.nodes.count());
    }

    void read_elements()
    {
        const std::string name = upper_case(keyword_.value("TYPE").value_or(""));
        const std::optional<AbaqusType> type = abaqus_type(name);
        if (!type)
            fail("elements of the type " + quoted_text(name) +
                 " are not supported; supported are linear triangles, quads and lines, and the surface of "
                 "linear "
                 "cells");
        if (type->shape == AbaqusShape::point) {
            passed_over_.insert("ELEMENT, TYPE=" + name);
            return;
        }
        AbaqusBlock block{*type, model_.elements.count(), {}};
        while (lines_.next_data_line()) {
            const std::size_t position = lines_.scanner().position();
            model_.elements.add(lines_.index("the id of an element"), position);
            for (int k = 0; k < corner_count(type->shape); ++k)
                block.corners.push_back(lines_.index("a node of the element"));
            lines_.end_line("the nodes of the element");
        }
        if (const auto set = keyword_.value("ELSET"))
            model_.element_sets.add_run(*set, block.begin, model_.elements.count(),
                                        type->shape == AbaqusShape::line);
        model_.blocks.push_back(std::move(block));
    }

    void read_set(AbaqusSets& sets, const std::string& parameter)
    {
        const auto name = keyword_.value(parameter);
        if (!name || name->empty())
            fail("*" + keyword_.name + " without " + parameter + "=");
        sets.read(lines_, *name, keyword_.has("GENERATE"));
    }

    void read_surface()
    {
        const auto name = keyword_.value("NAME");
        if (!name || (keyword_.has("TYPE") && upper_case(*keyword_.value("TYPE")) != "ELEMENT")) {
            passed_over_.insert("SURFACE that is not of TYPE=ELEMENT");
            return;
        }
        AbaqusSurface surface{*name, {}};
        while (lines_.next_data_line()) {
            AbaqusSide side{"", "", lines_.scanner().position()};
            lines_.try_field(side.elements);
            lines_.try_field(side.side);
            side.side = upper_case(side.side);
            surface.sides.push_back(std::move(side));
            lines_.scanner().skip_line();
        }
        model_.surfaces.push_back(std::move(surface));
    }

    /// "** name SET full name", as our own writer puts it before a set whose name Abaqus would not take.
    void take_names()
    {
        for (const std::string& comment : lines_.take_comments()) {
            constexpr std::string_view start = "name ";
            const std::size_t blank = comment.find(' ', start.size());
            if (comment.starts_with(start))
                model_.names[upper_case(comment.substr(start.size(), blank - start.size()))] =
                    blank == std::string::npos ? "" : percent_decoded(comment.substr(blank + 1));
        }
    }

    void number_corners()
    {
        for (AbaqusBlock& block : model_.blocks) {
            const auto count = static_cast<std::size_t>(corner_count(block.type.shape));
            for (std::size_t i = 0; i < block.corners.size(); ++i) {
                const Index vertex = model_.nodes.find(block.corners[i]);
                if (vertex < 0)
                    lines_.scanner().fail_at(
                        model_.elements.position(block.begin + static_cast<Index>(i / count)),
                        "the element names node " + std::to_string(block.corners[i]) +
                            ", but there is none of this id");
                block.corners[i] = vertex;
            }
        }
    }

    void warn() const
    {
        if (passed_over_.empty())
            return;
        std::vector<std::string> names;
        for (const std::string& name : passed_over_)
            names.push_back(quoted_text("*" + name));
        input_.warn("keywords that are no mesh were left out: " + joined(names));
    }

    [[noreturn]] void fail(const std::string& message) const
    {
        lines_.scanner().fail_at(keyword_.position, message);
    }

    const InputBytes& input_;
    AbaqusLines lines_;
    AbaqusKeyword keyword_;
    AbaqusModel model_;
    std::size_t keywords_ = 0;
    int parts_ = 0; ///< that have nodes
    bool part_has_nodes_ = false;
    std::set<std::string> passed_over_;
};

} // namespace

const AbaqusBlock& AbaqusModel::block_of(Index element) const
{
    const auto behind = std::upper_bound(blocks.begin(), blocks.end(), element,
                                         [](Index e, const AbaqusBlock& block) { return e < block.begin; });
    return *(behind - 1);
}

AbaqusModel read_abaqus_model(const InputBytes& input)
{
    return ModelReader(input).read();
}

} // namespace morph
