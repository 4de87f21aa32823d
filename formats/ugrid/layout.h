#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace morph {

/// How the numbers of an AFLR/UGRID file stand, which its name says before ".ugrid":
/// https://www.simcenter.msstate.edu/software/documentation/ug_io/ugc_file_formats.html.
struct UgridLayout {
    std::string_view extension; ///< ".lb8"; empty: text
    bool binary = false;
    bool little_endian = true;
    bool records = false;        ///< between the lengths that Fortran puts around a record
    std::size_t real_size = 8;   ///< bytes
    std::size_t number_size = 4; ///< bytes of a whole number
};

/// Of the file's name (a last ".gz" does not count); text when it says nothing.
UgridLayout ugrid_layout_of_name(const std::string& path);

/// Of the bytes of a file whose name says nothing: text, or the first of the binary layouts in which the
/// counts at its start make the size of the file; nothing when none does.
std::optional<UgridLayout> ugrid_layout_of_bytes(std::string_view bytes);

/// The path without ".ugrid" and the layout before it.
std::string ugrid_stem(const std::string& path);

} // namespace morph
