#pragma once

#include "tools/picture/canvas.h"
#include "tools/picture/scalar_field.h"
#include "tools/picture/view.h"

#include <string>
#include <vector>

namespace morph::picture {

/// What the colours of a picture mean.
struct Legend {
    std::vector<std::string> markers; ///< names in the order of their colours
    bool inverted = false;            ///< there are red elements
    std::string field;                ///< label of the field; empty: none
    ValueRange range;
};

/// Height the legend takes; 0 when there is nothing to explain.
double legend_height(const Legend& legend);

/// Markers and inverted elements from the left, the colour bar with its ticks on the right.
void draw_legend(Canvas& canvas, const Rectangle& area, const Legend& legend);

/// A bar of a round length in the lower left corner of a view.
void draw_scale_bar(Canvas& canvas, const View& view);

} // namespace morph::picture
