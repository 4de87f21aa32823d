#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/quality/metrics.h"

#include <array>
#include <optional>
#include <vector>

namespace morph {

/// The metrics of one element; metrics.h says what each is.
struct ElementQuality {
    bool inverted = false;
    double area = 0;
    std::array<double, 4> jacobian{}; ///< of each corner; those of a triangle are the same
    double min_jacobian = 0;
    double scaled_jacobian = 0;
    double min_angle = 0;
    double max_angle = 0;
    double aspect_ratio = 0;
    double size_skew = 0; ///< with a reference only
};

/// One of the worst elements of a mesh.
struct WorstElement {
    Index element = 0; ///< file number
    Index face = 0;    ///< in the numbering of the mesh
    ElementQuality quality;
};

/// How many of the worst elements a report has.
inline constexpr std::size_t kWorstElements = 10;

/// f_ss of all elements against a reference mesh, see size_skew().
struct SizeSkewSummary {
    double min = 0;
    double mean = 0;
};

/// What is wrong with a mesh, and how good the rest of it is. All numbers are 0 for a mesh without elements;
/// none is ever NaN or infinite.
struct QualityReport {
    Index vertices = 0; ///< as the file counts them
    Index triangles = 0;
    Index quads = 0;
    Index inverted = 0;                   ///< elements with a corner Jacobian <= 0, decided exactly
    Index negative_area = 0;              ///< elements that run clockwise (planar meshes only)
    std::vector<Index> inverted_elements; ///< file numbers, ascending, the first kListedElements
    double min_scaled_jacobian = 0;
    double mean_scaled_jacobian = 0;
    double min_angle = 0; ///< degrees
    double max_angle = 0; ///< degrees
    double max_aspect_ratio = 0;
    std::array<Index, 10> scaled_jacobian_counts{}; ///< elements not inverted, by tenths from 0 to 1
    std::array<Index, 9> min_angle_counts{}; ///< elements not inverted, by tens of degrees from 0 to 90
    std::vector<WorstElement> worst; ///< those of least scaled Jacobian, least first, then by file number
    std::optional<SizeSkewSummary> size_skew; ///< with a reference only
};

/// How many inverted elements a report lists.
inline constexpr std::size_t kListedElements = 1000;

/// Quality of a mesh where it is. The same for any number of threads, bit for bit.
QualityReport quality_report(const Mesh& mesh);

/// Quality the mesh would have with its vertices at @p positions (n x 3).
/// @throws InputError  positions has another number of rows than the mesh has vertices
QualityReport quality_report(const Mesh& mesh, const PositionsView& positions);

/// As above, with f_ss against the same mesh at @p reference (n x 3).
/// @throws InputError  positions or reference has a wrong number of rows
QualityReport quality_report(const Mesh& mesh, const PositionsView& positions,
                             const PositionsView& reference);

/// The metrics of every element (m entries, in the numbering of the mesh).
/// @param mesh       m elements
/// @param positions  n x 3, where the vertices are
/// @param reference  positions f_ss is against, or null
/// @throws InputError  positions or reference has a wrong number of rows
std::vector<ElementQuality> element_quality(const Mesh& mesh, const PositionsView& positions,
                                            const PositionsView* reference = nullptr);

/// The elements with a corner Jacobian <= 0 at @p positions, ascending in the numbering of the mesh.
/// @throws InputError  positions has a wrong number of rows
std::vector<Index> inverted_elements(const Mesh& mesh, const PositionsView& positions);

/// Smallest angle inside the elements of a planar mesh that is not built yet, degrees; 180 without elements.
double min_angle(const MeshData& mesh);

} // namespace morph
