#pragma once

#include "formats/ply/header.h"

#include <bit>
#include <cstring>
#include <string>
#include <vector>

namespace morph {

/// The numbers behind the header of a PLY file, one after another.
class PlyRows {
public:
    explicit PlyRows(TextScanner& in) : in_(in), header_(read_ply_header(in))
    {
        text_ = header_.coding == PlyCoding::ascii;
        const bool little = header_.coding == PlyCoding::little_endian;
        swapped_ = little != (std::endian::native == std::endian::little);
    }

    const PlyHeader& header() const { return header_; }

    /// The next number; NaN and infinity count here.
    /// @throws InputError  there is none
    double number(NumberType type) { return text_ ? text_number(type) : binary_number(type); }

    /// The next list, of any length; valid until the next one is read.
    /// @throws InputError  its length is none, or more than the file could hold
    const std::vector<double>& list(const PlyProperty& property);

    /// Where the next number is, for messages.
    std::size_t position();

    /// @throws InputError  always: with the line of text, or the byte
    [[noreturn]] void fail(std::size_t position, const std::string& what) const;

private:
    double text_number(NumberType type);
    double binary_number(NumberType type);
    template <class T>
    double load(const char* from) const;

    TextScanner& in_;
    PlyHeader header_;
    bool text_ = false;
    bool swapped_ = false; ///< in the byte order that is not this machine's
    std::vector<double> list_;
};

} // namespace morph
