#pragma once

#include "tools/picture/canvas.h"

#include <string>

namespace morph::picture {

/// Extension of a file with its dot, in lower case.
std::string lower_extension(const std::string& path);

/// What kind of image a file is to be, by its extension.
/// @throws InputError  it is neither .png nor .svg
ImageKind image_kind(const std::string& path);

} // namespace morph::picture
