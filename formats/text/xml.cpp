#include "formats/text/xml.h"

#include "formats/text/text_scanner.h"

#include <algorithm>
#include <charconv>

namespace morph {

namespace {

constexpr int kDeepest = 32;

bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool ends_name(char c)
{
    return is_space(c) || c == '=' || c == '>' || c == '/' || c == '<' || c == '"' || c == '\'';
}

class Parser {
public:
    Parser(const InputBytes& file, std::string_view raw_element) : file_(file), raw_element_(raw_element) {}

    XmlDocument parse()
    {
        XmlDocument document;
        for (;;) {
            const std::string_view text = text_run();
            if (std::any_of(text.begin(), text.end(), [](char c) { return !is_space(c); }))
                fail(at_ - text.size(), "text before the first element of an XML file");
            if (at_ == bytes().size())
                fail(at_, "an XML file without an element");
            if (!skip_aside())
                break;
        }
        element(document.root, 0);
        document.appended = appended_;
        return document;
    }

private:
    std::string_view bytes() const { return file_.bytes; }
    std::string_view rest() const { return bytes().substr(at_); }

    [[noreturn]] void fail(std::size_t offset, const std::string& what) const
    {
        throw xml_error(file_, offset, what);
    }

    void skip_space()
    {
        while (at_ < bytes().size() && is_space(bytes()[at_]))
            ++at_;
    }

    /// Everything up to the next '<'.
    std::string_view text_run()
    {
        const std::size_t begin = at_;
        at_ = std::min(bytes().find('<', at_), bytes().size());
        return bytes().substr(begin, at_ - begin);
    }

    /// Pass over a comment, a processing instruction or a document type.
    bool skip_aside()
    {
        const auto skip = [&](std::string_view opening, std::string_view closing) {
            if (!rest().starts_with(opening))
                return false;
            const std::size_t end = bytes().find(closing, at_ + opening.size());
            if (end == std::string_view::npos)
                fail(at_, std::string(opening) + " without the " + std::string(closing) + " that ends it");
            at_ = end + closing.size();
            return true;
        };
        return skip("<!--", "-->") || skip("<?", "?>") || skip("<!", ">");
    }

    std::string name()
    {
        const std::size_t begin = at_;
        while (at_ < bytes().size() && !ends_name(bytes()[at_]))
            ++at_;
        if (at_ == begin)
            fail(begin, "a name was expected in an XML tag");
        return std::string(bytes().substr(begin, at_ - begin));
    }

    void expect(char wanted)
    {
        if (at_ == bytes().size())
            fail(at_, "the file ends inside an XML tag");
        if (bytes()[at_] != wanted)
            fail(at_,
                 std::string("'") + wanted + "' was expected in an XML tag, found '" + bytes()[at_] + "'");
        ++at_;
    }

    /// '&' … ';' at the front of @p text, as one byte; @p text then starts behind it.
    char entity(std::string_view& text, std::size_t offset) const
    {
        const std::size_t end = text.find(';');
        const std::string_view code = text.substr(1, end == std::string_view::npos ? 0 : end - 1);
        text.remove_prefix(end == std::string_view::npos ? 0 : end + 1);
        constexpr std::pair<std::string_view, char> named[] = {
            {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
        for (const auto& [known, character] : named)
            if (code == known)
                return character;
        if (code.size() > 1 && code[0] == '#') {
            const bool hexadecimal = code[1] == 'x';
            const std::string_view digits = code.substr(hexadecimal ? 2 : 1);
            unsigned value = 0;
            const auto [stop, error] =
                std::from_chars(digits.data(), digits.data() + digits.size(), value, hexadecimal ? 16 : 10);
            if (error == std::errc() && stop == digits.data() + digits.size() && value < 256)
                return static_cast<char>(value);
        }
        fail(offset, "'&' in an attribute is not the start of a known entity");
    }

    std::string value()
    {
        const char quote = at_ < bytes().size() ? bytes()[at_] : '\0';
        if (quote != '"' && quote != '\'')
            fail(at_, "an attribute value in quotes was expected");
        const std::size_t begin = ++at_;
        const std::size_t end = bytes().find(quote, begin);
        if (end == std::string_view::npos)
            fail(begin, "the quotes around an attribute value are not closed");
        at_ = end + 1;
        std::string resolved;
        for (std::string_view text = bytes().substr(begin, end - begin); !text.empty();) {
            if (text[0] == '&') {
                resolved += entity(text, begin);
                continue;
            }
            const std::string_view plain = text.substr(0, text.find('&'));
            resolved += plain;
            text.remove_prefix(plain.size());
        }
        return resolved;
    }

    /// Attributes and the end of a start tag; false when the element is empty (ends with "/>").
    bool attributes(XmlElement& element)
    {
        for (;;) {
            skip_space();
            if (rest().starts_with("/>")) {
                at_ += 2;
                return false;
            }
            if (rest().starts_with(">")) {
                ++at_;
                return true;
            }
            if (at_ == bytes().size())
                fail(element.offset, "the file ends inside the tag <" + element.name + ">");
            std::string key = name();
            skip_space();
            expect('=');
            skip_space();
            element.attributes.emplace_back(std::move(key), value());
        }
    }

    void end_tag(const XmlElement& element)
    {
        at_ += 2;
        const std::size_t begin = at_;
        if (name() != element.name)
            fail(begin, "expected </" + element.name + ">, found another end tag");
        skip_space();
        expect('>');
    }

    void element(XmlElement& element, int depth)
    {
        element.offset = at_;
        if (depth == kDeepest)
            fail(at_, "XML elements nested deeper than " + std::to_string(kDeepest));
        expect('<');
        element.name = name();
        if (!attributes(element))
            return;
        if (element.name == raw_element_) {
            appended_ = rest();
            at_ = bytes().size();
            raw_ = true;
            return;
        }
        while (!raw_) {
            const std::string_view run = text_run();
            if (std::any_of(run.begin(), run.end(), [](char c) { return !is_space(c); }))
                element.text.push_back(run);
            if (at_ == bytes().size())
                fail(element.offset, "<" + element.name + "> is not closed; the file is cut off");
            if (rest().starts_with("</"))
                return end_tag(element);
            if (!skip_aside())
                this->element(element.children.emplace_back(), depth + 1);
        }
    }

    InputBytes file_;
    std::string_view raw_element_;
    std::size_t at_ = 0;
    bool raw_ = false; ///< the rest of the file is bytes, no XML
    std::string_view appended_;
};

} // namespace

const std::string* XmlElement::attribute(std::string_view attribute_name) const
{
    for (const auto& [key, value] : attributes)
        if (key == attribute_name)
            return &value;
    return nullptr;
}

const XmlElement* XmlElement::child(std::string_view child_name) const
{
    for (const XmlElement& candidate : children)
        if (candidate.name == child_name)
            return &candidate;
    return nullptr;
}

XmlDocument read_xml(const InputBytes& file, std::string_view raw_element)
{
    return Parser(file, raw_element).parse();
}

std::string xml_escaped(std::string_view value)
{
    std::string escaped;
    for (const char c : value) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 32 || c == '<' || c == '>' || c == '&' || c == '"')
            escaped += "&#" + std::to_string(code) + ";";
        else
            escaped += c;
    }
    return escaped;
}

InputError xml_error(const InputBytes& file, std::size_t offset, std::string what)
{
    std::replace_if(
        what.begin(), what.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, '?');
    const std::size_t line = TextScanner(file.path, file.bytes).line_of(offset);
    return InputError(file.path + ":" + std::to_string(line) + ": " + what);
}

} // namespace morph
