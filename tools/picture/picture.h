#pragma once

#include "libmorph/mesh/mesh.h"
#include "tools/picture/canvas.h"
#include "tools/picture/view.h"

#include <optional>
#include <string>
#include <vector>

namespace morph::picture {

/// A mesh and what is written above it.
struct Subject {
    const Mesh* mesh = nullptr;
    std::string caption;
};

struct PictureOptions {
    std::string field;       ///< colours the elements; empty: none
    std::string title;       ///< empty: none
    std::optional<Box> zoom; ///< default: the bodies, with the whole domain as an inset
    bool edges = true;
    bool close_up = false; ///< show the worst element from near though none is inverted
    int width = 0;         ///< pixels (PNG) or points (SVG); 0: a good one
};

/// Smallest and largest width of a picture.
inline constexpr int kNarrowest = 200;
inline constexpr int kWidest = 12000;

/// A picture of one mesh, or of two side by side in the same view, as the bytes of an image file.
///
/// Elements are pale or coloured by a field, markers are thick lines, inverted elements are red. Where there
/// are any, a second row (for one mesh a second column) shows the worst of them from near.
///
/// @param subjects  one or two meshes
/// @throws InputError  a mesh without elements or without the field; a zoom that shows nothing; too many
///                     elements for an SVG
std::string draw_picture(const std::vector<Subject>& subjects, const PictureOptions& options, ImageKind kind);

} // namespace morph::picture
