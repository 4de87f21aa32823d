#include "formats/ply/names.h"

#include "formats/text/names_in_text.h"
#include "formats/text/text_scanner.h"

#include <algorithm>

namespace morph {

namespace {

constexpr int kMostComponents = 9;

void add_field_name(TextScanner& in, std::map<std::string, PlyNames::FieldName>& fields)
{
    if (in.at_line_end())
        return;
    const std::string property(in.word("a property"));
    Index components = 0;
    if (in.try_index(components) && components >= 1 && components <= kMostComponents)
        fields[property] = {components, percent_decoded(in.rest_of_line())};
}

void add_numbered(TextScanner& in, std::map<Index, std::string>& names)
{
    Index number = 0;
    if (in.try_index(number))
        names[number] = percent_decoded(in.rest_of_line());
}

} // namespace

PlyNames ply_names(const std::vector<std::string>& comments)
{
    PlyNames names;
    for (const std::string& comment : comments) {
        TextScanner in("", comment);
        if (in.at_line_end())
            continue;
        const std::string_view word = in.word("a word");
        if (word == "vertex_field")
            add_field_name(in, names.vertex_fields);
        else if (word == "face_field")
            add_field_name(in, names.face_fields);
        else if (word == "group")
            add_numbered(in, names.groups);
        else if (word == "marker")
            add_numbered(in, names.markers);
    }
    return names;
}

bool is_ply_group(const std::string& property)
{
    return property == "group" ||
           (property.starts_with("group_") && property.size() > 6 &&
            std::all_of(property.begin() + 6, property.end(), [](char c) { return c >= '0' && c <= '9'; }));
}

} // namespace morph
