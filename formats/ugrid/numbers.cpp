#include "formats/ugrid/numbers.h"

#include "libmorph/core/error.h"

#include <bit>
#include <cstring>

namespace morph {

namespace {

std::uint32_t swapped(std::uint32_t word)
{
    return __builtin_bswap32(word);
}

std::uint64_t swapped(std::uint64_t word)
{
    return __builtin_bswap64(word);
}

} // namespace

UgridNumbers::UgridNumbers(const InputBytes& file, const UgridLayout& layout)
    : in_(file.path, file.bytes), layout_(layout)
{
}

UgridCounts UgridNumbers::counts()
{
    skip_record_length(static_cast<std::int64_t>(7 * layout_.number_size));
    UgridCounts counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::string what =
            "the number of " +
            (i == 0 ? std::string("vertices") : "type " + std::string(kUgridBlocks[i - 1].name));
        const std::size_t at = position();
        if (!try_integer(counts.at(i)))
            fail_expected(what);
        if (counts.at(i) < 0 || counts.at(i) > INT32_MAX)
            fail_at(at, what + " is " + std::to_string(counts.at(i)) + ", expected 0 to 2^31 - 1");
    }
    skip_record_length(static_cast<std::int64_t>(7 * layout_.number_size));
    skip_record_length(-1);
    require_room(counts);
    return counts;
}

void UgridNumbers::require_room(const UgridCounts& counts)
{
    const auto reals = 3 * static_cast<std::uint64_t>(counts[0]);
    const std::uint64_t numbers = ugrid_whole_numbers(counts);
    const std::uint64_t least =
        layout_.binary ? reals * layout_.real_size + numbers * layout_.number_size : 2 * (reals + numbers);
    const std::uint64_t rest = in_.rest().size() + (layout_.binary ? 0 : 1); // a last line end may be missing
    if (least > rest)
        fail_at(0, "the counts need " + std::to_string(reals + numbers) +
                       " numbers behind them, but the file ends before");
}

/// Fortran's length of a record in bytes, in 4 bytes.
/// @param expected  -1: any, as not all writers count the second record right
void UgridNumbers::skip_record_length(std::int64_t expected)
{
    if (!layout_.records)
        return;
    const std::size_t at = position();
    std::uint32_t word = 0;
    if (!try_word(word))
        fail_expected("the length of a record");
    const auto length = static_cast<std::int32_t>(word);
    if (expected >= 0 && length != expected && length != 2 * expected) // meshio counts 8 bytes for each
        fail_at(at,
                "a record has " + std::to_string(length) + " bytes, expected " + std::to_string(expected));
    if (length < 0)
        fail_at(at, "a record in several parts is not supported; write the file as .b8.ugrid");
}

template <class Word>
bool UgridNumbers::try_word(Word& word)
{
    const std::string_view rest = in_.rest();
    if (rest.size() < sizeof word)
        return false;
    std::memcpy(&word, rest.data(), sizeof word);
    if (layout_.little_endian != (std::endian::native == std::endian::little))
        word = swapped(word);
    in_.seek(in_.position() + sizeof word);
    return true;
}

bool UgridNumbers::try_integer(std::int64_t& value)
{
    if (!layout_.binary) {
        in_.skip_white();
        Index small = 0;
        if (!in_.try_index(small))
            return in_.try_integer(value);
        value = small;
        return true;
    }
    std::uint32_t word = 0;
    std::uint64_t wide = 0;
    const bool taken = layout_.number_size == 4 ? try_word(word) : try_word(wide);
    value = layout_.number_size == 4 ? static_cast<std::int32_t>(word) : static_cast<std::int64_t>(wide);
    return taken;
}

bool UgridNumbers::try_real(double& value)
{
    if (!layout_.binary) {
        in_.skip_white();
        return in_.try_real(value);
    }
    std::uint32_t word = 0;
    std::uint64_t wide = 0;
    const bool taken = layout_.real_size == 4 ? try_word(word) : try_word(wide);
    value = layout_.real_size == 4 ? static_cast<double>(std::bit_cast<float>(word))
                                   : std::bit_cast<double>(wide);
    return taken;
}

std::size_t UgridNumbers::position()
{
    if (!layout_.binary)
        in_.skip_white();
    return in_.position();
}

void UgridNumbers::fail_at(std::size_t position, const std::string& what) const
{
    if (!layout_.binary)
        in_.fail_at(position, what);
    throw InputError(in_.path() + ": byte " + std::to_string(position) + ": " + what);
}

void UgridNumbers::fail_expected(const std::string& what) const
{
    if (!layout_.binary)
        in_.fail_expected(what);
    fail_at(in_.position(), "expected " + what + ", found the end of the file");
}

} // namespace morph
