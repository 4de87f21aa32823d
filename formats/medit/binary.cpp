#include "formats/medit/keywords.h"
#include "formats/medit/source.h"
#include "libmorph/core/error.h"

#include <bit>
#include <cstring>

namespace morph {

namespace {

constexpr std::int32_t kSwappedOne = 0x01000000;

std::uint32_t swapped(std::uint32_t word)
{
    return __builtin_bswap32(word);
}

std::uint64_t swapped(std::uint64_t word)
{
    return __builtin_bswap64(word);
}

/// Versions 1 to 4: reals in 4 bytes in version 1, else 8; places in the file in 8 bytes from version 3 on;
/// whole numbers in 8 bytes in version 4.
class MeditBinary : public MeditSource {
public:
    explicit MeditBinary(const InputBytes& file) : path_(file.path), bytes_(file.bytes)
    {
        const auto one = take<std::int32_t>("the number 1, which marks the byte order");
        swap_ = one == kSwappedOne;
        version_ = take<std::int32_t>("the version");
        if (version_ < 1 || version_ > 4)
            fail_at(4, "version " + std::to_string(version_) + ", expected 1 to 4");
        if (!next() || section_ != "Dimension")
            fail_at(8, "expected the keyword Dimension (3)");
        dimension_ = take<std::int32_t>("the dimension");
        if (dimension_ != 2 && dimension_ != 3)
            fail_at(at_ - 4, "dimension " + std::to_string(dimension_) + ", expected 2 or 3");
    }

    bool next() override
    {
        if (at_ > next_)
            fail_at(section_position_, section_ + " should end at byte " + std::to_string(next_) +
                                           ", but its lines go on to byte " + std::to_string(at_));
        at_ = section_.empty() ? at_ : next_;
        if (at_ == bytes_.size()) // some writers leave End out
            return false;
        section_position_ = at_;
        const auto code = take<std::int32_t>("a keyword");
        section_ = medit_keyword(code);
        const std::int64_t next =
            version_ < 3 ? take<std::int32_t>("a place") : take<std::int64_t>("a place");
        if (code == kMeditEnd)
            return false;
        next_ = next == 0 ? bytes_.size() : static_cast<std::size_t>(next);
        if (next != 0 && (next < static_cast<std::int64_t>(at_) || next_ > bytes_.size()))
            fail_at(section_position_, section_ + " should end at byte " + std::to_string(next) +
                                           ", but begins here and the file has " +
                                           std::to_string(bytes_.size()) + " bytes");
        return true;
    }

    std::size_t count() override
    {
        const std::size_t position = at_;
        std::int64_t lines = 0;
        if (!try_integer(lines) || lines < 0)
            fail_at(position, section_ + " has an impossible number of lines");
        return static_cast<std::size_t>(lines);
    }

    void require_room(std::size_t lines, std::size_t integers, std::size_t reals) override
    {
        const std::size_t line = integers * (version_ == 4 ? 8 : 4) + reals * (version_ == 1 ? 4 : 8);
        if (line > 0 && (bytes_.size() - at_) / line < lines)
            fail_at(section_position_, section_ + " has " + std::to_string(lines) +
                                           " lines by its count, but the file ends before");
    }

    std::int64_t word(std::string_view what) override { return take<std::int32_t>(what); }

    bool try_integer(std::int64_t& value) override
    {
        if (version_ == 4)
            return try_take(value);
        std::int32_t small = 0;
        const bool taken = try_take(small);
        value = small;
        return taken;
    }

    bool try_real(double& value) override
    {
        if (version_ > 1)
            return try_take(value);
        float small = 0;
        const bool taken = try_take(small);
        value = static_cast<double>(small);
        return taken;
    }

    std::size_t position() override { return at_; }
    std::string_view comments() const override { return section_ == "End" ? bytes_.substr(at_) : ""; }
    void fail_at(std::size_t position, const std::string& what) const override
    {
        throw InputError(path_ + ": byte " + std::to_string(position) + ": " + what);
    }
    void fail_expected(const std::string& what) const override
    {
        fail_at(at_, "expected " + what + ", found the end of the file");
    }

private:
    template <class Number>
    bool try_take(Number& number)
    {
        using Word = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
        if (bytes_.size() - at_ < sizeof(Number))
            return false;
        Word word = 0;
        std::memcpy(&word, bytes_.data() + at_, sizeof word);
        number = std::bit_cast<Number>(swap_ ? swapped(word) : word);
        at_ += sizeof word;
        return true;
    }

    template <class Number>
    Number take(std::string_view what)
    {
        Number number{};
        if (!try_take(number))
            fail_expected(std::string(what));
        return number;
    }

    std::string path_;
    std::string_view bytes_;
    std::size_t at_ = 0;
    std::size_t next_ = SIZE_MAX; ///< where this section ends
    bool swap_ = false;
};

} // namespace

std::unique_ptr<MeditSource> open_medit_binary(const InputBytes& file)
{
    return std::make_unique<MeditBinary>(file);
}

std::unique_ptr<MeditSource> open_medit(const InputBytes& file)
{
    const std::string_view start = file.bytes.substr(0, 4);
    const bool binary = start == std::string_view("\1\0\0\0", 4) || start == std::string_view("\0\0\0\1", 4);
    return binary ? open_medit_binary(file) : open_medit_text(file);
}

} // namespace morph
