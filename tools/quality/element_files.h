#pragma once

#include "formats/output_file.h"
#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph::tools {

/// Elements of a mesh as a table, one a line: id, type, centroid and the metrics; a cell is empty where there
/// is no value.
/// @param metrics        element fields with one component, see element_metrics()
/// @param inverted_only  only those whose metric "inverted" is 1
void write_elements(OutputFile& file, const MeshData& data, const std::vector<Field>& metrics,
                    bool inverted_only);

/// Add the metrics to the fields of a mesh, in the place of fields of these names that it had.
void add_metric_fields(MeshData& data, std::vector<Field> metrics);

} // namespace morph::tools
