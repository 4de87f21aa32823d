#include "tools/picture/image_kind.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace morph::picture {

std::string lower_extension(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

ImageKind image_kind(const std::string& path)
{
    const std::string extension = lower_extension(path);
    if (extension == ".png")
        return ImageKind::png;
    if (extension == ".svg")
        return ImageKind::svg;
    throw InputError(path + ": pictures are written as .png or .svg, not '" + extension + "'");
}

} // namespace morph::picture
