#pragma once

#include "formats/binary/number_array.h"
#include "formats/text/xml.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

struct Compressor;

/// The data arrays of one VTK XML file: finds, decodes and decompresses what a <DataArray> speaks of.
///
/// Formats: ascii, binary (inline base64), appended (raw or base64), each of the last two plain or
/// compressed in blocks, with lengths in UInt32 or UInt64 and either byte order.
class VtuArrays {
public:
    /// @throws InputError  byte order, header type, compressor or encoding unknown
    VtuArrays(const InputBytes& file, const XmlDocument& document);

    /// Exactly @p count numbers of an array. The view is valid until the next call.
    /// @throws InputError  "path:line: array 'x' …": an unknown type, broken encoding, more or fewer
    ///                     numbers; nothing is allocated beyond what the bytes of the file can stand for
    NumberArray numbers(const XmlElement& array, std::size_t count);

    /// The strings of an array of type String, each ended by a zero.
    std::vector<std::string> strings(const XmlElement& array);

    /// How the array is written: "ascii", "inline base64, zlib", "appended raw", …
    std::string coding(const XmlElement& array) const;

    [[noreturn]] void fail(const XmlElement& element, const std::string& what) const;

private:
    /// Bytes of the file that hold an array, still encoded.
    struct Encoded {
        std::string_view bytes;
        bool base64;
    };

    [[noreturn]] void fail_array(const XmlElement& array, const std::string& what) const;
    std::string_view only_text(const XmlElement& array);
    void read_ascii(const XmlElement& array, std::size_t limit);
    NumberArray ascii(const XmlElement& array, std::size_t count);
    Encoded encoded(const XmlElement& array);
    std::string_view front(const XmlElement& array, const Encoded& data, std::size_t count);
    std::uint64_t header_word(std::string_view bytes, std::size_t position) const;
    std::string_view decoded(const XmlElement& array, std::size_t expected);
    std::string_view decompressed(const XmlElement& array, const Encoded& data, std::size_t expected);

    InputBytes file_;
    std::string_view appended_;
    bool appended_base64_ = false;
    bool swapped_ = false;
    std::size_t word_ = 4; ///< bytes of a length
    const Compressor* compressor_ = nullptr;

    std::string text_;            ///< runs of text joined
    std::string raw_;             ///< decoded from base64
    std::string plain_;           ///< decompressed
    std::vector<double> numbers_; ///< read from ASCII
};

} // namespace morph
