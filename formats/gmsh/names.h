#pragma once

#include "formats/gmsh/scanner.h"

#include <map>
#include <string>
#include <utility>

namespace morph {

/// What Gmsh files have no place for goes into a section $Comments, which other programs pass over: names
/// that do not fit between quotes, and the number of components of fields that are not 1, 3 or 9.
///
///     libmorph: what does not fit elsewhere
///     physical DIMENSION TAG NAME     the name of a physical group, percent-encoded
///     field NUMBER COMPONENTS NAME    of the NUMBER-th section of data, from 1
class GmshNames {
public:
    struct FieldNote {
        Index components = 0;
        std::string name;
    };

    /// Take a section $Comments, which the scanner has entered; one of another kind is passed over.
    void read(TextScanner& text, std::size_t end);

    /// The full name, or null when what the file says elsewhere is all there is.
    const std::string* physical(int dimension, std::int64_t tag) const;
    const FieldNote* field(Index number) const;

private:
    std::map<std::pair<int, std::int64_t>, std::string> physicals_;
    std::map<Index, FieldNote> fields_;
};

/// The first line of the section.
inline constexpr std::string_view kGmshNamesTitle = "libmorph: what does not fit elsewhere";

/// Name of the physical group of the elements that are in no other. A group of this name that is not ours
/// has it in $Comments too.
inline constexpr std::string_view kGmshNoGroup = "no group";

/// True when a name can stand between quotes: 1 to 127 bytes, none of them a quote or a control character.
bool fits_gmsh_quotes(std::string_view name);

/// The name with what does not fit replaced by `_` or cut off.
std::string gmsh_quotable(std::string_view name);

} // namespace morph
