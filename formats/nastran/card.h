#pragma once

#include "formats/text/text_scanner.h"

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// One entry of Nastran's bulk data with its continuation lines.
struct NastranCard {
    std::string name; ///< in upper case, without '*'
    std::size_t position = 0;
    std::vector<std::string_view> fields; ///< behind the name, without blanks at their ends

    /// Field @p i, empty beyond the last.
    std::string_view field(std::size_t i) const { return i < fields.size() ? fields[i] : std::string_view(); }
};

/// Reads bulk data card by card: small field (8 columns), large field (16, `*`) and free field (commas), also
/// mixed; continuation lines follow their card and begin with a blank field, `+` or `*`.
class NastranCards {
public:
    NastranCards(const std::string& path, std::string_view text) : in_(path, text) {}

    /// Go behind the line BEGIN BULK. False, and nothing is skipped, when there is none: all is bulk data
    /// then.
    bool skip_to_bulk();

    /// The next card, or the next comment (its text behind the `$`, the card's name empty); false at the end.
    /// @throws InputError  a continuation line without a card before it
    bool next(NastranCard& card);

    /// @throws InputError  "path:line: expected WHAT in field 3 of GRID, found '…'"
    Index index(const NastranCard& card, std::size_t field, std::string_view what) const;
    /// As index(); an empty field has the value @p otherwise.
    Index index(const NastranCard& card, std::size_t field, std::string_view what, Index otherwise) const;
    /// Also with an exponent without letter (1.5-3) or with D; an empty field is 0.
    double real(const NastranCard& card, std::size_t field, std::string_view what) const;

    std::string_view comment() const { return comment_; }
    const TextScanner& scanner() const { return in_; }

private:
    std::string_view line();
    bool continues(std::string_view line) const;
    void take_name(NastranCard& card, std::string_view line) const;
    void take_fields(NastranCard& card, std::string_view line) const;
    void take_free_fields(NastranCard& card, std::string_view line) const;
    std::string_view expanded(std::string_view line);
    [[noreturn]] void fail(const NastranCard& card, std::size_t field, std::string_view what) const;

    TextScanner in_;
    std::string_view comment_;
    std::deque<std::string> expanded_; ///< lines of this card that have tabs
};

} // namespace morph
