#include "formats/vtk/vtu_array.h"

#include "formats/binary/base64.h"
#include "formats/binary/compression.h"
#include "formats/text/text_scanner.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>

namespace morph {

namespace {

/// For decoded(): the array says itself how long it is.
constexpr std::size_t kAnyLength = std::numeric_limits<std::size_t>::max();

std::string value_of(const XmlElement& element, std::string_view attribute, const std::string& otherwise)
{
    const std::string* value = element.attribute(attribute);
    return value ? *value : otherwise;
}

std::string name_of(const XmlElement& array)
{
    return value_of(array, "Name", "");
}

} // namespace

VtuArrays::VtuArrays(const InputBytes& file, const XmlDocument& document) : file_(file)
{
    const XmlElement& root = document.root;
    const std::string order = value_of(root, "byte_order", "LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian")
        fail(root, "byte_order '" + order + "' is neither LittleEndian nor BigEndian");
    swapped_ = (order == "LittleEndian") != (std::endian::native == std::endian::little);

    const std::string header = value_of(root, "header_type", "UInt32");
    if (header != "UInt32" && header != "UInt64")
        fail(root, "header_type '" + header + "' is neither UInt32 nor UInt64");
    word_ = header == "UInt32" ? 4 : 8;

    const std::string compressor = value_of(root, "compressor", "");
    compressor_ = find_compressor(compressor);
    if (!compressor.empty() && !compressor_)
        fail(root, "compressor '" + compressor +
                       "' is not supported; vtkZLibDataCompressor, vtkLZ4DataCompressor and none are");

    const XmlElement* appended = root.child("AppendedData");
    if (!appended)
        return;
    const std::string encoding = value_of(*appended, "encoding", "base64");
    if (encoding != "raw" && encoding != "base64")
        fail(*appended, "encoding '" + encoding + "' of the appended data is neither raw nor base64");
    appended_base64_ = encoding == "base64";
    const std::size_t mark = document.appended.find_first_not_of(" \t\r\n");
    if (mark == std::string_view::npos || document.appended[mark] != '_')
        fail(*appended, "appended data does not start with '_'");
    appended_ = document.appended.substr(mark + 1);
    if (appended_base64_)
        appended_ = appended_.substr(0, appended_.find('<'));
}

std::string VtuArrays::coding(const XmlElement& array) const
{
    const std::string format = value_of(array, "format", "ascii");
    if (format == "ascii")
        return format;
    const std::string compressed = compressor_ ? ", " + std::string(compressor_->name) : "";
    return (format == "binary" ? "inline base64"
            : appended_base64_ ? "appended base64"
                               : "appended raw") +
           compressed;
}

void VtuArrays::fail(const XmlElement& element, const std::string& what) const
{
    throw xml_error(file_, element.offset, what);
}

void VtuArrays::fail_array(const XmlElement& array, const std::string& what) const
{
    fail(array, "array '" + name_of(array) + "' " + what);
}

/// The text of the element; runs of it that a comment or VTK's <InformationKey> parts are joined.
std::string_view VtuArrays::only_text(const XmlElement& array)
{
    if (array.text.size() == 1)
        return array.text[0];
    text_.clear();
    for (const std::string_view run : array.text)
        (text_ += run) += ' ';
    return text_;
}

/// Up to @p limit numbers of the element's text.
void VtuArrays::read_ascii(const XmlElement& array, std::size_t limit)
{
    numbers_.clear();
    for (const std::string_view run : array.text) {
        const auto begin = static_cast<std::size_t>(run.data() - file_.bytes.data());
        TextScanner scanner(file_.path, file_.bytes.substr(0, begin + run.size()));
        scanner.seek(begin);
        if (!read_numbers(scanner, limit, numbers_))
            scanner.fail_expected("number " + std::to_string(numbers_.size()) + " of array '" +
                                  name_of(array) + "'");
    }
}

NumberArray VtuArrays::ascii(const XmlElement& array, std::size_t count)
{
    std::size_t length = 0;
    for (const std::string_view run : array.text)
        length += run.size();
    if (count > length / 2 + 1)
        fail_array(array, "should have " + std::to_string(count) + " numbers, but its text is only " +
                              std::to_string(length) + " bytes long");
    numbers_.reserve(count);
    read_ascii(array, count + 1);
    if (numbers_.size() != count)
        fail_array(array, "has " + (numbers_.size() > count ? "more" : std::to_string(numbers_.size())) +
                              " numbers, expected " + std::to_string(count));
    return view_of(NumberType::float64, numbers_.data(), numbers_.size());
}

NumberArray VtuArrays::numbers(const XmlElement& array, std::size_t count)
{
    const std::string type_text = value_of(array, "type", "");
    const auto type = number_type(type_text);
    if (!type)
        fail_array(array, "is of type '" + type_text + "', expected Int8 to UInt64, Float32 or Float64");
    if (count > std::numeric_limits<std::size_t>::max() / 16)
        fail_array(array, "should have " + std::to_string(count) + " numbers, more than any file holds");
    if (value_of(array, "format", "ascii") == "ascii")
        return ascii(array, count);
    return {*type, decoded(array, count * size_of(*type)), swapped_};
}

std::vector<std::string> VtuArrays::strings(const XmlElement& array)
{
    std::string bytes;
    if (value_of(array, "format", "ascii") == "ascii") {
        read_ascii(array, kAnyLength);
        for (const double code : numbers_) {
            if (!(code >= -128 && code < 256))
                fail_array(array, "is of strings but has a number that is no character code");
            bytes += static_cast<char>(static_cast<int>(code));
        }
    } else {
        bytes = decoded(array, kAnyLength);
    }
    std::vector<std::string> strings;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = std::min(bytes.find('\0', at), bytes.size());
        strings.push_back(bytes.substr(at, end - at));
        at = end + 1;
    }
    return strings;
}

VtuArrays::Encoded VtuArrays::encoded(const XmlElement& array)
{
    const std::string format = value_of(array, "format", "");
    if (format == "binary")
        return {only_text(array), true};
    if (format != "appended")
        fail_array(array, "has format '" + format + "', expected ascii, binary or appended");
    const std::string offset_text = value_of(array, "offset", "");
    std::size_t offset = 0;
    const auto [stop, error] =
        std::from_chars(offset_text.data(), offset_text.data() + offset_text.size(), offset);
    if (error != std::errc() || stop != offset_text.data() + offset_text.size())
        fail_array(array, "has the offset '" + offset_text + "', expected a number of bytes");
    if (offset >= appended_.size())
        fail_array(array, "starts at byte " + offset_text + " of the appended data, which has " +
                              std::to_string(appended_.size()));
    return {appended_.substr(offset), appended_base64_};
}

/// The first @p count bytes of the data, at most as many as the file holds.
std::string_view VtuArrays::front(const XmlElement& array, const Encoded& data, std::size_t count)
{
    const std::size_t most = data.base64 ? data.bytes.size() / 4 * 3 : data.bytes.size();
    if (count > most)
        fail_array(array, "needs " + std::to_string(count) + " bytes, but only " + std::to_string(most) +
                              " are left in the file");
    if (!data.base64)
        return data.bytes.substr(0, count);
    auto bytes = decode_base64(data.bytes, count);
    if (!bytes)
        fail_array(array, "is not base64");
    raw_ = std::move(*bytes);
    if (raw_.size() < count)
        fail_array(array,
                   "needs " + std::to_string(count) + " bytes, but has " + std::to_string(raw_.size()));
    return std::string_view(raw_).substr(0, count);
}

std::uint64_t VtuArrays::header_word(std::string_view bytes, std::size_t position) const
{
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < word_; ++i) {
        const bool big_endian = swapped_ == (std::endian::native == std::endian::little);
        const std::size_t at = position * word_ + (big_endian ? i : word_ - 1 - i);
        value = value << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return value;
}

/// The bytes of the array, which must be @p expected many.
std::string_view VtuArrays::decoded(const XmlElement& array, std::size_t expected)
{
    const Encoded data = encoded(array);
    if (compressor_)
        return decompressed(array, data, expected);
    const std::uint64_t length = header_word(front(array, data, word_), 0);
    if (expected != kAnyLength && length != expected)
        fail_array(array, "holds " + std::to_string(length) + " bytes, expected " + std::to_string(expected));
    if (length > file_.bytes.size())
        fail_array(array, "says it holds " + std::to_string(length) + " bytes, more than the file");
    return front(array, data, word_ + length).substr(word_);
}

/// Blocks, each compressed by itself, behind: count of blocks, bytes of a block before compression, bytes
/// of the last one if it is shorter (else 0), compressed bytes of each block.
std::string_view VtuArrays::decompressed(const XmlElement& array, const Encoded& data, std::size_t expected)
{
    const std::uint64_t blocks = header_word(front(array, data, word_), 0);
    if (blocks > file_.bytes.size() / word_)
        fail_array(array,
                   "says it has " + std::to_string(blocks) + " compressed blocks, more than fit the file");
    const std::size_t header = blocks == 0 ? word_ : (3 + blocks) * word_;
    std::string_view bytes = front(array, data, header);
    const std::uint64_t block = blocks == 0 ? 0 : header_word(bytes, 1);
    const std::uint64_t last = blocks == 0 ? 0 : header_word(bytes, 2);
    std::vector<std::size_t> sizes;
    std::size_t total = header;
    for (std::size_t b = 0; b < blocks; ++b) {
        sizes.push_back(header_word(bytes, 3 + b));
        if (sizes.back() > file_.bytes.size())
            fail_array(array, "has a compressed block that says it is longer than the file");
        total += sizes.back();
    }
    const auto plain_size = [&](std::size_t b) { return b + 1 == blocks && last != 0 ? last : block; };
    std::size_t plain_total = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
        if (plain_size(b) / compressor_->largest_ratio > sizes[b] + 1)
            fail_array(array, "has a block of " + std::to_string(sizes[b]) +
                                  " bytes that cannot decompress to " + std::to_string(plain_size(b)));
        plain_total += plain_size(b);
    }
    if (expected != kAnyLength && plain_total != expected)
        fail_array(array, "decompresses to " + std::to_string(plain_total) + " bytes, expected " +
                              std::to_string(expected));
    bytes = front(array, data, total);
    plain_.resize(plain_total);
    std::size_t in = header;
    std::size_t out = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
        if (!compressor_->decompress(bytes.substr(in, sizes[b]), plain_.data() + out, plain_size(b)))
            fail_array(array, "has compressed block " + std::to_string(b) + " that does not hold " +
                                  std::to_string(plain_size(b)) + " bytes");
        in += sizes[b];
        out += plain_size(b);
    }
    return plain_;
}

} // namespace morph
