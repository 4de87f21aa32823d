#include "formats/medit/source.h"
#include "formats/text/text_scanner.h"

#include <cctype>

namespace morph {

namespace {

class MeditText : public MeditSource {
public:
    explicit MeditText(const InputBytes& file) : in_(file.path, file.bytes, '#')
    {
        require_keyword("MeshVersionFormatted");
        version_ = static_cast<int>(word("a version after MeshVersionFormatted"));
        if (version_ > 4)
            in_.fail("version " + std::to_string(version_) + ", expected 0 to 4");
        require_keyword("Dimension");
        dimension_ = static_cast<int>(word("2 or 3 after Dimension"));
        if (dimension_ != 2 && dimension_ != 3)
            in_.fail("Dimension " + std::to_string(dimension_) + ", expected 2 or 3");
    }

    bool next() override
    {
        if (!section_.empty() && !at_keyword() && counted_)
            in_.fail_expected("a keyword after the lines of " + section_);
        pass_over();
        if (!in_.skip_white())
            return false;
        section_position_ = in_.position();
        section_ = in_.word("a keyword");
        counted_ = false;
        return section_ != "End";
    }

    std::size_t count() override
    {
        counted_ = true;
        return static_cast<std::size_t>(word("the number of lines of " + section_));
    }

    void require_room(std::size_t lines, std::size_t integers, std::size_t reals) override
    {
        if (lines > 0 && (in_.rest().size() + 1) / 2 / lines < integers + reals)
            in_.fail_at(section_position_, section_ + " has " + std::to_string(lines) +
                                               " lines by its count, but the file ends before");
    }

    std::int64_t word(std::string_view what) override
    {
        in_.skip_white();
        return in_.index(what);
    }

    bool try_integer(std::int64_t& value) override
    {
        in_.skip_white();
        Index small = 0;
        if (!in_.try_index(small))
            return in_.try_integer(value);
        value = small;
        return true;
    }

    bool try_real(double& value) override
    {
        in_.skip_white();
        if (in_.try_real(value))
            return true;
        std::vector<double> unusual; // what is not finite
        if (!read_numbers(in_, 1, unusual) || unusual.empty())
            return false;
        value = unusual.front();
        return true;
    }

    std::size_t position() override
    {
        in_.skip_white();
        return in_.position();
    }

    std::string_view comments() const override { return in_.text(); }
    void fail_at(std::size_t position, const std::string& what) const override
    {
        in_.fail_at(position, what);
    }
    void fail_expected(const std::string& what) const override { in_.fail_expected(what); }

private:
    void require_keyword(std::string_view keyword)
    {
        in_.skip_white();
        const std::size_t position = in_.position();
        if (in_.at_line_end() || in_.word("a keyword") != keyword) {
            in_.seek(position);
            in_.fail_expected("the keyword " + std::string(keyword));
        }
    }

    bool at_keyword()
    {
        return !in_.skip_white() || std::isalpha(static_cast<unsigned char>(in_.rest().front())) != 0;
    }

    /// Skip numbers, and strings in quotes, which some sections hold.
    void pass_over()
    {
        while (!at_keyword())
            if (in_.rest().front() == '"')
                in_.skip_line();
            else
                in_.word("a number");
    }

    TextScanner in_;
    bool counted_ = false; ///< the lines of this section are being read, not passed over
};

} // namespace

std::unique_ptr<MeditSource> open_medit_text(const InputBytes& file)
{
    return std::make_unique<MeditText>(file);
}

} // namespace morph
