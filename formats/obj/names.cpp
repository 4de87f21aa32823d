#include "formats/obj/names.h"

#include "formats/text/names_in_text.h"

#include <algorithm>

namespace morph {

namespace {

/// A single percent sign stands for a name without characters.
std::string decoded(std::string_view name)
{
    return name == "%" ? "" : percent_decoded(name);
}

/// Number of the thing called @p name in @p all, which gets it at its end if it is new.
std::size_t number_of(const std::string& name, auto& all, auto& numbers)
{
    const auto [entry, is_new] = numbers.try_emplace(name, all.size());
    if (is_new)
        all.push_back({name, {}});
    return entry->second;
}

void keep_once(std::vector<std::size_t>& numbers)
{
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // namespace

void ObjNames::set_groups(const std::vector<std::string_view>& names)
{
    group_names_.clear();
    for (const std::string_view name : names)
        group_names_.push_back(decoded(name));
    groups_known_ = markers_known_ = false;
}

void ObjNames::set_object(std::string_view name)
{
    object_.clear();
    if (!name.empty())
        object_.push_back(decoded(name));
    groups_known_ = markers_known_ = false;
}

void ObjNames::set_material(std::string_view name)
{
    material_.clear();
    if (!name.empty())
        material_.push_back(decoded(name));
    groups_known_ = false;
}

void ObjNames::add_element(Index element)
{
    if (!groups_known_)
        find_groups();
    for (const std::size_t group : current_groups_)
        groups_[group].elements.push_back(element);
}

void ObjNames::add_edge(const std::array<Index, 2>& edge)
{
    if (!markers_known_)
        find_markers();
    for (const std::size_t marker : current_markers_)
        markers_[marker].edges.push_back(edge);
}

/// Only names with an element below them become groups.
void ObjNames::find_groups()
{
    current_groups_.clear();
    for (const auto* names : {&object_, &group_names_, &material_})
        for (const std::string& name : *names)
            current_groups_.push_back(number_of(name, groups_, group_numbers_));
    keep_once(current_groups_);
    groups_known_ = true;
}

void ObjNames::find_markers()
{
    const std::vector<std::string> unnamed{"lines"};
    const auto& names = !group_names_.empty() ? group_names_ : !object_.empty() ? object_ : unnamed;
    current_markers_.clear();
    for (const std::string& name : names)
        current_markers_.push_back(number_of(name, markers_, marker_numbers_));
    keep_once(current_markers_);
    markers_known_ = true;
}

} // namespace morph
