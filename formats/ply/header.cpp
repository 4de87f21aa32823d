#include "formats/ply/header.h"

#include <array>
#include <utility>

namespace morph {

namespace {

NumberType type_called(TextScanner& in)
{
    constexpr std::array<std::pair<std::string_view, NumberType>, 16> types{
        {{"char", NumberType::int8},
         {"int8", NumberType::int8},
         {"uchar", NumberType::uint8},
         {"uint8", NumberType::uint8},
         {"short", NumberType::int16},
         {"int16", NumberType::int16},
         {"ushort", NumberType::uint16},
         {"uint16", NumberType::uint16},
         {"int", NumberType::int32},
         {"int32", NumberType::int32},
         {"uint", NumberType::uint32},
         {"uint32", NumberType::uint32},
         {"float", NumberType::float32},
         {"float32", NumberType::float32},
         {"double", NumberType::float64},
         {"float64", NumberType::float64}}};
    const std::size_t position = in.position();
    const std::string_view word = in.word("a type of numbers such as double");
    for (const auto& [name, type] : types)
        if (name == word)
            return type;
    in.seek(position);
    in.fail_expected("a type of numbers such as double");
}

PlyCoding coding(TextScanner& in)
{
    constexpr std::array<std::pair<std::string_view, PlyCoding>, 3> codings{
        {{"ascii", PlyCoding::ascii},
         {"binary_little_endian", PlyCoding::little_endian},
         {"binary_big_endian", PlyCoding::big_endian}}};
    const std::size_t position = in.position();
    const std::string_view word = in.word("ascii or binary_little_endian");
    for (const auto& [name, value] : codings)
        if (name == word)
            return value;
    in.seek(position);
    in.fail_expected("ascii, binary_little_endian or binary_big_endian");
}

PlyProperty property(TextScanner& in)
{
    PlyProperty result;
    const std::size_t position = in.position();
    if (in.word("a type of numbers or list") == "list")
        result.length_type = type_called(in);
    else
        in.seek(position);
    result.type = type_called(in);
    result.name = in.word("the name of a property");
    return result;
}

/// Bytes that a row takes at least; as text each number takes two.
std::size_t least_bytes(const PlyElement& element, PlyCoding file_coding)
{
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += file_coding == PlyCoding::ascii ? 2 : size_of(property.length_type.value_or(property.type));
    return bytes;
}

void require_room(const PlyHeader& header, const TextScanner& in)
{
    const std::size_t left = in.rest().size() + 1; // text may do without the last line end
    for (const PlyElement& element : header.elements) {
        const std::size_t least = least_bytes(element, header.coding);
        if (least > 0 && element.count > left / least)
            in.fail("there should be " + std::to_string(element.count) + " rows of the element '" +
                    element.name + "', but only " + std::to_string(in.rest().size()) +
                    " bytes follow the header");
    }
}

} // namespace

PlyHeader read_ply_header(TextScanner& in)
{
    if (in.word("'ply'") != "ply") {
        in.seek(0);
        in.fail_expected("'ply'");
    }
    PlyHeader header;
    for (bool has_format = false;;) {
        in.skip_line();
        in.skip_white();
        const std::size_t position = in.position();
        const std::string_view word = in.word("a line of a PLY header");
        if (word == "end_header" && has_format)
            break;
        if (word == "format") {
            header.coding = coding(in);
            has_format = true;
        } else if (word == "element") {
            PlyElement& element = header.elements.emplace_back();
            element.name = in.word("the name of an element");
            element.count = static_cast<std::size_t>(
                in.index("the number of rows of the element '" + element.name + "'"));
        } else if (word == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(property(in));
        } else if (word == "comment") {
            header.comments.emplace_back(in.rest_of_line());
        } else if (word != "obj_info") {
            in.seek(position);
            in.fail_expected("a line of a PLY header such as 'element vertex 8', behind 'format ascii 1.0'");
        }
    }
    in.skip_line();
    require_room(header, in);
    return header;
}

} // namespace morph
