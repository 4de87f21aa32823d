#pragma once

#include "libmorph/quality/quality.h"

#include <vector>

namespace morph::tools {

/// Every metric of every element as an element field with one component, in the order of the file, its
/// corners too: those of ElementQuality, and in a mesh with markers those of the elements beside them
/// (WallCell), NaN elsewhere. Of an element beside several edges the smallest height, the largest angle and
/// the largest changes.
/// @param reference  positions before the move: adds size-skew and the changes beside walls; or null
std::vector<Field> element_metrics(const Mesh& mesh, const PositionsView* reference);

} // namespace morph::tools
