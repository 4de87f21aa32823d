#pragma once

#include "formats/output_file.h"
#include "libmorph/quality/quality.h"

#include <string>
#include <vector>

namespace morph::tools {

/// One metric as a column of a table and a field of a mesh file.
struct Metric {
    std::string name;
    double (*value)(const ElementQuality&);
};

/// Every metric of an element; size_skew with a reference only.
std::vector<Metric> element_metrics(bool with_reference);

/// Metrics of every element in the order of the file, and of its corners in the order the file lists them.
std::vector<ElementQuality> in_file_order(const Mesh& mesh, const std::vector<ElementQuality>& quality);

/// The inverted elements, one a line: id, type, centroid and the metrics.
/// @param quality  in the order of the file, as data
void write_inverted(OutputFile& file, const MeshData& data, const std::vector<ElementQuality>& quality,
                    const std::vector<Metric>& metrics);

/// Every element, as write_inverted(), and a column that says whether it is inverted.
void write_all_elements(OutputFile& file, const MeshData& data, const std::vector<ElementQuality>& quality,
                        const std::vector<Metric>& metrics);

/// The mesh with each metric, and whether an element is inverted, as an element field. Fields of these names
/// that it had are replaced.
MeshData with_metric_fields(MeshData data, const std::vector<ElementQuality>& quality,
                            const std::vector<Metric>& metrics);

} // namespace morph::tools
