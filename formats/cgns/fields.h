#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>
#include <vector>

namespace morph {

/// An array of a solution: one number for each vertex or cell.
struct CgnsArray {
    std::string name;
    std::vector<double> values;
};

/// Fields of the arrays of one solution, in their order. Which belong together is in @p table (the text of
/// cgns_field_table()); of the others, arrays called nX, nY and perhaps nZ are the components of a field n.
/// Locations are left to the caller.
std::vector<Field> fields_of_cgns_arrays(std::vector<CgnsArray> arrays, const std::string& table);

/// Names of the arrays that fields become, of at most 32 characters and all different: one list for each
/// field. Fields of one component keep their name, those of two and three end in X, Y, Z, others in _1, _2,
/// ….
std::vector<std::vector<std::string>> cgns_array_names(const std::vector<const Field*>& fields);

/// A line for each field: its name and those of its arrays, percent-encoded, separated by blanks.
std::string cgns_field_table(const std::vector<const Field*>& fields);

/// A name that a node can have: at most 32 printable characters without '/', not one of @p taken, to which
/// it is added.
std::string cgns_node_name(const std::string& name, std::vector<std::string>& taken);

/// A name as text without blanks and control characters, which is never empty, and back.
std::string cgns_encoded(const std::string& name);
std::string cgns_decoded(const std::string& text);

} // namespace morph
