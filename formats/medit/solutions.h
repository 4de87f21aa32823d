#pragma once

#include "formats/format.h"

#include <string>
#include <vector>

namespace morph {

/// Solutions are fields in a file next to a MEDIT mesh (.sol, in binary .solb), at vertices, triangles and
/// quadrilaterals. A solution is a scalar, a vector, a symmetric matrix (its lower triangle, row by row) or a
/// matrix of the dimension of the mesh. A field of another number of components is several scalars. Names are
/// in comments behind the last section: "# vertex field 1 = pressure", "# vertex field 2 to 6 = stress".

/// Read the solutions next to the mesh file @p file, if there are any, as fields of @p mesh: of x.mesh x.sol
/// or else x.solb, of x.meshb the other way round. A file for another number of vertices or faces is warned
/// of.
/// @throws InputError  "path:line: …": what is wrong in the file of solutions
void read_medit_solutions_beside(const InputBytes& file, MeshData& mesh);

/// Add the solutions of a file to the fields of @p mesh.
/// @throws InputError  as above
void read_medit_solutions(const InputBytes& file, MeshData& mesh);

/// The file of the fields of @p mesh; none when it has no fields.
std::vector<Companion> medit_solutions(const MeshData& mesh);

} // namespace morph
