#pragma once

#include "formats/binary/number_array.h"
#include "formats/text/text_scanner.h"

#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// Reads the words and arrays of a legacy VTK file (.vtk), front to back: keywords and counts are text,
/// arrays are text or big-endian bytes.
class LegacyVtkScanner {
public:
    LegacyVtkScanner(const std::string& path, std::string_view bytes) : text_(path, bytes) {}

    /// Read the four lines of the header up to the kind of data set, which is returned in capitals.
    /// @throws InputError  this is no legacy VTK file, or a version not known
    std::string header();

    /// The next word in capitals, on this line or a later one; empty at the end of the file.
    std::string keyword();
    /// Stand before the word that keyword() returned last.
    void put_back() { text_.seek(before_keyword_); }
    /// Pass over a line with the name of a colour table, if that is the next one.
    void skip_lookup_table_line();

    /// A count; whether the file is long enough for it shows when numbers are read.
    std::size_t count(std::string_view what) { return static_cast<std::size_t>(text_.index(what)); }
    /// A count if one follows on this line, else @p otherwise.
    std::size_t count_or(std::size_t otherwise);
    /// A name, with VTK's %XX resolved.
    std::string name(std::string_view what);
    /// A word on this line that VTK calls a type of numbers, in capitals.
    std::string type_word();
    /// Skip a METADATA block: everything up to an empty line.
    void skip_metadata();

    /// The @p count numbers of an array of that type, which start on the next line. The view is valid
    /// until the next call.
    /// @throws InputError  the file is too short for them, one is no number, a type not known
    NumberArray numbers(const std::string& type, std::size_t count);
    /// The strings of an array of the type `string`.
    std::vector<std::string> strings(std::size_t count);

    int major_version() const { return major_version_; }
    const std::string& version() const { return version_; } ///< as the file has it
    bool binary() const { return binary_; }
    [[noreturn]] void fail(const std::string& what) const { text_.fail_at(before_keyword_, what); }
    /// @throws InputError  "expected @p what, found" the word that keyword() returned last
    [[noreturn]] void fail_expected(std::string_view what);

private:
    std::string_view bytes(std::size_t count, std::size_t size);
    std::string binary_string();

    TextScanner text_;
    std::size_t before_keyword_ = 0;
    bool binary_ = false;
    int major_version_ = 0;
    std::string version_;
    std::vector<double> numbers_; ///< read from ASCII
};

} // namespace morph
