#pragma once

#include "formats/format.h"
#include "libmorph/core/error.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace morph {

/// One element of an XML file with what is in it. Views point into the bytes it was read from.
struct XmlElement {
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes; ///< values with entities resolved
    std::vector<std::string_view> text;                          ///< runs of text between the tags, not blank
    std::vector<XmlElement> children;
    std::size_t offset = 0; ///< of its '<' in the file

    /// The value, or null.
    const std::string* attribute(std::string_view attribute_name) const;
    /// The first child of that name, or null.
    const XmlElement* child(std::string_view child_name) const;
};

/// A file of XML; VTK's files append bytes that are no XML to it.
struct XmlDocument {
    XmlElement root;
    std::string_view appended; ///< what follows the start tag called @p raw_element, to the end of the file
};

/// Read the elements of an XML file up to the end of its root element, or up to an element called
/// @p raw_element, whose attributes are read and whose content is left as bytes.
///
/// Comments, processing instructions and a document type are passed over; entities in attribute
/// values are resolved (the five named ones and numbers up to 255, which stand for bytes).
/// @throws InputError  "path:line: …" for what is not well formed, or nested deeper than 32
XmlDocument read_xml(const InputBytes& file, std::string_view raw_element);

/// An attribute value with what XML reserves, and control characters, as entities.
std::string xml_escaped(std::string_view value);

/// "path:line: what" with the line of a byte; what the file put into @p what stays on one line.
InputError xml_error(const InputBytes& file, std::size_t offset, std::string what);

} // namespace morph
