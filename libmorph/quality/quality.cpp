#include "libmorph/quality/quality.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/quality/quality_accumulator.h"

#include <algorithm>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kBlock = 4096; // elements; sums are formed block by block in a fixed order

ElementShape shape_at(const Mesh& mesh, const Element& element, const PositionsView& positions)
{
    CornerPoints points;
    const int corners = corner_count(element);
    for (int k = 0; k < corners; ++k)
        points[static_cast<std::size_t>(k)] = positions.row(element[static_cast<std::size_t>(k)]);
    return mesh.dimension == 2 ? planar_shape(points, corners) : surface_shape(points, corners);
}

void require_rows(const Mesh& mesh, const PositionsView& positions, const char* what)
{
    if (positions.rows() != vertex_count(mesh))
        throw InputError(std::string(what) + " has " + std::to_string(positions.rows()) +
                         " rows, but the mesh has " + std::to_string(vertex_count(mesh)) + " vertices");
}

/// Checks what every public function takes and hands out blocks of elements.
class ElementLoop {
public:
    ElementLoop(const Mesh& mesh, const PositionsView& positions, const PositionsView* reference)
        : mesh_(mesh), positions_(positions), reference_(reference)
    {
        require_rows(mesh, positions, "the matrix of positions");
        if (reference != nullptr)
            require_rows(mesh, *reference, "the matrix of reference positions");
    }

    std::size_t elements() const { return mesh_.kernel.n_faces(); }
    std::size_t blocks() const { return (elements() + kBlock - 1) / kBlock; }

    /// Call body(block, face, corner count, quality) for each element, blocks in parallel.
    template <class Body>
    void each(const Body& body) const
    {
        parallel_for(elements(), kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
                const Element element = element_corners(mesh_, static_cast<Index>(f));
                body(begin / kBlock, static_cast<Index>(f), corner_count(element), quality(element));
            }
        });
    }

private:
    ElementQuality quality(const Element& element) const
    {
        const ElementShape shape = shape_at(mesh_, element, positions_);
        const AngleRange angles = angle_range(shape);
        ElementQuality q;
        q.inverted = is_inverted(shape);
        q.area = shape.area;
        q.jacobian = shape.jacobian;
        if (shape.corners == 3)
            q.jacobian[3] = shape.jacobian[2];
        q.min_jacobian = min_jacobian(shape);
        q.scaled_jacobian = scaled_jacobian(shape);
        q.min_angle = angles.min;
        q.max_angle = angles.max;
        q.aspect_ratio = aspect_ratio(shape);
        if (reference_ != nullptr)
            q.size_skew = size_skew(shape, shape_at(mesh_, element, *reference_).area);
        return q;
    }

    const Mesh& mesh_;
    const PositionsView& positions_;
    const PositionsView* reference_;
};

QualityAccumulator accumulate(const Mesh& mesh, const ElementLoop& loop)
{
    std::vector<QualityAccumulator> partial(loop.blocks());
    loop.each([&](std::size_t block, Index face, int corners, const ElementQuality& q) {
        partial[block].add({mesh.numbering.element[static_cast<std::size_t>(face)], face, q}, corners);
    });
    QualityAccumulator total;
    for (const QualityAccumulator& part : partial)
        total.add(part);
    return total;
}

std::vector<Index> listed_file_numbers(const Mesh& mesh, const std::vector<Index>& faces)
{
    std::vector<Index> numbers;
    numbers.reserve(faces.size());
    for (const Index f : faces)
        numbers.push_back(mesh.numbering.element[static_cast<std::size_t>(f)]);
    std::sort(numbers.begin(), numbers.end());
    numbers.resize(std::min(numbers.size(), kListedElements));
    return numbers;
}

QualityReport report(const Mesh& mesh, const PositionsView& positions, const PositionsView* reference)
{
    const ElementLoop loop(mesh, positions, reference);
    QualityReport report;
    report.vertices = mesh.numbering.file_vertices;
    if (reference != nullptr)
        report.size_skew.emplace();
    if (loop.elements() == 0)
        return report;
    const QualityAccumulator total = accumulate(mesh, loop);
    const auto elements = static_cast<double>(loop.elements());
    report.triangles = total.triangles;
    report.quads = element_count(mesh) - total.triangles;
    report.inverted = static_cast<Index>(total.inverted.size());
    report.negative_area = total.negative_area;
    report.inverted_elements = listed_file_numbers(mesh, total.inverted);
    report.min_scaled_jacobian = total.min_scaled_jacobian;
    report.mean_scaled_jacobian = total.sum_scaled_jacobian / elements;
    report.min_angle = total.min_angle;
    report.max_angle = total.max_angle;
    report.max_aspect_ratio = total.max_aspect_ratio;
    report.scaled_jacobian_counts = total.scaled_jacobian_counts;
    report.min_angle_counts = total.min_angle_counts;
    report.worst = total.worst;
    if (reference != nullptr)
        report.size_skew = SizeSkewSummary{total.min_size_skew, total.sum_size_skew / elements};
    return report;
}

} // namespace

QualityReport quality_report(const Mesh& mesh)
{
    return report(mesh, points(mesh), nullptr);
}

QualityReport quality_report(const Mesh& mesh, const PositionsView& positions)
{
    return report(mesh, positions, nullptr);
}

QualityReport quality_report(const Mesh& mesh, const PositionsView& positions, const PositionsView& reference)
{
    return report(mesh, positions, &reference);
}

std::vector<ElementQuality> element_quality(const Mesh& mesh, const PositionsView& positions,
                                            const PositionsView* reference)
{
    const ElementLoop loop(mesh, positions, reference);
    std::vector<ElementQuality> all(loop.elements());
    loop.each([&](std::size_t, Index face, int, const ElementQuality& q) {
        all[static_cast<std::size_t>(face)] = q;
    });
    return all;
}

std::vector<Index> inverted_elements(const Mesh& mesh, const PositionsView& positions)
{
    return accumulate(mesh, ElementLoop(mesh, positions, nullptr)).inverted;
}

double min_angle(const MeshData& mesh)
{
    double smallest = 180;
    for (const Element& element : mesh.elements) {
        const int corners = corner_count(element);
        CornerPoints at;
        for (std::size_t i = 0; i < static_cast<std::size_t>(corners); ++i)
            at[i] = mesh.points.row(element[i]);
        smallest = std::min(smallest, angle_range(planar_shape(at, corners)).min);
    }
    return smallest;
}

} // namespace morph
