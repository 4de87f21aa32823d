#pragma once

#include "tools/picture/scalar_field.h"
#include "tools/picture/view.h"

#include <string>
#include <vector>

namespace morph::picture {

/// How the elements of a mesh are shown.
struct MeshStyle {
    const ScalarField* field = nullptr; ///< null: one pale colour
    ValueRange range;
    bool edges = true;
    std::vector<std::string> markers; ///< names in the order of their colours
};

/// The elements in a view, their edges, the markers as thick lines, and the inverted elements in red, which
/// get a ring where they are too small to be seen.
///
/// Edges fade where elements come near a pixel in size, so that dense parts show as a tone, not a blot.
/// @param inverted  elements of the mesh to be drawn red
/// @throws InputError  an SVG would get too many elements to be opened
void draw_mesh(Canvas& canvas, const View& view, const FlatMesh& flat, const MeshStyle& style,
               const std::vector<Index>& inverted);

/// The markers of a planar mesh as lines, in the colours of their place among @p names.
void draw_markers(Canvas& canvas, const View& view, const FlatMesh& flat,
                  const std::vector<std::string>& names, double width);

} // namespace morph::picture
