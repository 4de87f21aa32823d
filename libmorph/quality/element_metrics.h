#pragma once

#include "libmorph/quality/quality.h"

#include <vector>

namespace morph {

/// Every metric of every element as an element field with one component, in the order of the file, its
/// corners too: those of ElementQuality, and in a mesh with markers those of the elements next to them
/// (WallCell), NaN elsewhere. Of an element next to several edges the smallest height, the largest angle and
/// the largest changes.
/// @param reference  positions before the move (n x 3): adds size-skew and the changes next to walls; or null
/// @throws InputError  reference has a wrong number of rows
std::vector<Field> element_metrics(const Mesh& mesh, const PositionsView* reference = nullptr);

} // namespace morph
