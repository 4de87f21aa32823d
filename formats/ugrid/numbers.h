#pragma once

#include "formats/format.h"
#include "formats/text/text_scanner.h"
#include "formats/ugrid/counts.h"
#include "formats/ugrid/layout.h"

#include <cstdint>
#include <string>

namespace morph {

/// The numbers of an AFLR/UGRID file, front to back, as text or binary.
class UgridNumbers {
public:
    UgridNumbers(const InputBytes& file, const UgridLayout& layout);

    /// The counts at the start. Afterwards the coordinates are read next.
    /// @throws InputError  a count is negative or above 2^31 - 1; the file is too short for all they count
    UgridCounts counts();

    bool try_integer(std::int64_t& value);
    bool try_real(double& value);

    /// Of what is read next.
    std::size_t position();
    /// @throws InputError  "path:line: …", in binary "path: byte 12: …"
    [[noreturn]] void fail_at(std::size_t position, const std::string& what) const;
    [[noreturn]] void fail_expected(const std::string& what) const;

private:
    template <class Word>
    bool try_word(Word& word);
    void require_room(const UgridCounts& counts);
    void skip_record_length(std::int64_t expected);

    TextScanner in_;
    UgridLayout layout_;
};

} // namespace morph
