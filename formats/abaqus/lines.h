#pragma once

#include "formats/text/text_scanner.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace morph {

/// "*ELEMENT, TYPE=S3, ELSET=wing" with its continuation lines.
struct AbaqusKeyword {
    std::string name; ///< "ELEMENT": upper case, single blanks, no star
    std::size_t position = 0;
    std::vector<std::pair<std::string, std::string>> parameters; ///< name in upper case, value as it stands

    bool has(const std::string& parameter) const { return value(parameter).has_value(); }
    /// Empty text where the parameter has no value.
    std::optional<std::string> value(const std::string& parameter) const;
};

/// The text in upper case, as Abaqus compares names.
std::string upper_case(std::string text);

/// The 7 of "Part-1-1.7", which names 7 of that instance.
std::string without_instance(const std::string& field);

/// Reads an Abaqus input file line by line: keywords, data lines with commas, comments (`**`).
class AbaqusLines {
public:
    AbaqusLines(const std::string& path, std::string_view text) : in_(path, text) {}

    /// Skip data lines up to the next keyword; false at the end of the file.
    /// @throws InputError  the line has no name
    bool next_keyword(AbaqusKeyword& keyword);

    /// Go to the next data line of this keyword; false when there is none.
    bool next_data_line();

    /// The next field of the data line is a number.
    /// @throws InputError  it is none, or the line ends here without a comma that continues it
    Index index(std::string_view what);
    double real(std::string_view what);
    /// The next field as text without blanks and quotes around it; false when the line has no more.
    bool try_field(std::string& field);
    bool at_line_end();
    /// @throws InputError  something is left on the line behind @p what
    void end_line(std::string_view what);

    /// Comments since the last call, without the stars.
    std::vector<std::string> take_comments() { return std::exchange(comments_, {}); }

    TextScanner& scanner() { return in_; }
    const TextScanner& scanner() const { return in_; }

private:
    void begin_field(std::string_view what);
    void end_field();
    bool skip_comment();

    TextScanner in_;
    std::vector<std::string> comments_;
};

} // namespace morph
