#pragma once

#include "libmorph/mesh/mesh.h"
#include "tools/common/report.h"

#include <string>

namespace morph::tools {

/// The mesh; where it is planar and has inverted elements, with these and two rings around them remeshed.
/// That is said and reported then.
/// @param name  of its file, for errors
/// @throws InputError  as retriangulate()
Mesh without_inverted(const Mesh& mesh, const std::string& name, Report& report);

} // namespace morph::tools
