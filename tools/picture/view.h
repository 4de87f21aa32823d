#pragma once

#include "libmorph/mesh/mesh.h"
#include "tools/picture/canvas.h"

#include <optional>
#include <vector>

namespace morph::picture {

/// Part of the plane, in the length unit of the mesh.
struct Box {
    double xmin = 0;
    double ymin = 0;
    double xmax = 0;
    double ymax = 0;

    double width() const { return xmax - xmin; }
    double height() const { return ymax - ymin; }
};

/// The smallest box around two.
Box joined(const Box& a, const Box& b);

/// The box enlarged by a fraction of its larger side, all around.
Box with_margin(const Box& box, double fraction);

/// The box made wider or higher, about its centre, until width / height is @p aspect.
Box with_aspect(const Box& box, double aspect);

/// Maps the plane onto a rectangle of the canvas; the box has the aspect of the rectangle.
struct View {
    Box box;
    Rectangle area;

    double scale() const { return area.width / box.width(); } ///< canvas units per length unit
    Pixel place(double x, double y) const
    {
        return {area.x + (x - box.xmin) * scale(), area.y + (box.ymax - y) * scale()};
    }
};

/// A mesh as it is drawn: where every vertex lies on the paper, and how near each is to the reader.
struct FlatMesh {
    const Mesh* mesh = nullptr;
    Points2 place;            ///< n x 2: x, y of a planar mesh, else the projection
    Eigen::VectorXd nearness; ///< n, of a surface only: the larger the nearer
    std::vector<Element> elements;
    Box box;                               ///< around all elements
    std::vector<std::vector<Index>> loops; ///< boundary loops
};

/// Planar meshes as they are; surfaces in parallel projection from the front, right and above.
/// @throws InputError  there is no element, or the coordinates span more than can be drawn
FlatMesh flattened(const Mesh& mesh);

/// The box around the bodies inside the domain: every boundary loop but the outermost. Empty when there is
/// none, or they fill so much of the domain that a view of their own shows nothing more.
std::optional<Box> bodies_box(const FlatMesh& flat);

} // namespace morph::picture
