#include "formats/medit/sink.h"

#include "formats/medit/keywords.h"
#include "formats/text/number_text.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace morph {

namespace {

class MeditTextSink : public MeditSink {
public:
    MeditTextSink(OutputFile& out, int dimension) : out_(out)
    {
        out.append("MeshVersionFormatted 2\n\nDimension " + std::to_string(dimension) + "\n");
    }

    void section(std::string_view keyword, std::size_t lines, const std::vector<int>& types,
                 std::size_t reals, std::size_t integers) override
    {
        reals_ = reals;
        integers_ = integers;
        std::string head = "\n" + std::string(keyword) + "\n" + std::to_string(lines) + "\n";
        if (!types.empty())
            head += std::to_string(types.size());
        for (const int type : types)
            head += " " + std::to_string(type);
        out_.append(head + (types.empty() ? "" : "\n"));
    }

    void line(const double* reals, const std::int64_t* integers) override
    {
        char* to = out_.room((reals_ + integers_) * kLongestNumber);
        for (std::size_t i = 0; i < reals_; ++i)
            to = number_text(to, reals[i], i + 1 == reals_ + integers_ ? '\n' : ' ');
        for (std::size_t i = 0; i < integers_; ++i)
            to = number_text(to, integers[i], i + 1 == integers_ ? '\n' : ' ');
        out_.advance_to(to);
    }

    void end(std::string_view comments) override
    {
        out_.append("\nEnd\n");
        out_.append(comments);
    }

private:
    OutputFile& out_;
    std::size_t reals_ = 0;
    std::size_t integers_ = 0;
};

class MeditBinarySink : public MeditSink {
public:
    MeditBinarySink(OutputFile& out, int dimension, std::size_t bytes)
        : out_(out), wide_places_(bytes > INT32_MAX)
    {
        append_word(1);
        append_word(wide_places_ ? 3 : 2);
        append_word(kMeditDimension);
        written_ = 12;
        append_place(written_ + place_size() + 4);
        append_word(dimension);
        written_ += place_size() + 4;
    }

    void section(std::string_view keyword, std::size_t lines, const std::vector<int>& types,
                 std::size_t reals, std::size_t integers) override
    {
        reals_ = reals;
        integers_ = integers;
        const std::size_t head = 8 + place_size() + (types.empty() ? 0 : 4 + 4 * types.size());
        written_ += head + lines * (8 * reals + 4 * integers);
        append_word(medit_code(keyword));
        append_place(written_);
        append_word(static_cast<std::int32_t>(lines));
        if (!types.empty())
            append_word(static_cast<std::int32_t>(types.size()));
        for (const int type : types)
            append_word(type);
    }

    void line(const double* reals, const std::int64_t* integers) override
    {
        char* to = out_.room(8 * reals_ + 4 * integers_);
        to = std::copy_n(reinterpret_cast<const char*>(reals), 8 * reals_, to);
        for (std::size_t i = 0; i < integers_; ++i) {
            const auto number = static_cast<std::int32_t>(integers[i]);
            std::memcpy(to, &number, sizeof number);
            to += sizeof number;
        }
        out_.advance_to(to);
    }

    void end(std::string_view comments) override
    {
        append_word(kMeditEnd);
        append_place(0);
        out_.append(comments);
    }

private:
    std::size_t place_size() const { return wide_places_ ? 8 : 4; }

    void append_word(std::int32_t word) { append_raw(word); }

    void append_place(std::size_t place)
    {
        if (wide_places_)
            append_raw(static_cast<std::int64_t>(place));
        else
            append_raw(static_cast<std::int32_t>(place));
    }

    void append_raw(auto number)
    {
        char* const to = out_.room(sizeof number);
        std::memcpy(to, &number, sizeof number);
        out_.advance_to(to + sizeof number);
    }

    OutputFile& out_;
    bool wide_places_;
    std::size_t written_ = 0; ///< bytes, up to the end of this section
    std::size_t reals_ = 0;
    std::size_t integers_ = 0;
};

} // namespace

std::unique_ptr<MeditSink> medit_sink(OutputFile& out, bool binary, int dimension, std::size_t bytes)
{
    if (binary)
        return std::make_unique<MeditBinarySink>(out, dimension, bytes);
    return std::make_unique<MeditTextSink>(out, dimension);
}

bool is_binary_medit(const std::string& path, bool wanted)
{
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension == ".meshb" || extension == ".solb")
        return true;
    return wanted && extension != ".mesh" && extension != ".sol";
}

} // namespace morph
