#include "formats/text/number_text.h"
#include "formats/text/text_scanner.h"
#include "formats/thesis/files.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace morph {

namespace {

using CornerValues = std::array<double, 4>;

/// Rows of the file, and where each begins.
struct Rows {
    std::vector<CornerValues> values;
    std::vector<std::size_t> positions;
};

Rows read_rows(TextScanner& in, std::size_t elements)
{
    in.skip_white();
    const std::size_t position = in.position();
    const auto count = static_cast<std::size_t>(in.index("the number of elements"));
    in.end_line("the number of elements");
    if (count != elements)
        in.fail_at(position, "holds values of " + std::to_string(count) + " elements, but the mesh has " +
                                 std::to_string(elements));
    Rows rows;
    while (in.skip_white()) {
        rows.positions.push_back(in.position());
        const Index id = in.index("the number of an element");
        if (static_cast<std::size_t>(id) != rows.values.size() + 1)
            in.fail_at(rows.positions.back(), "element " + std::to_string(rows.values.size() + 1) +
                                                  " was expected, found " + std::to_string(id));
        for (double& value : rows.values.emplace_back())
            value = in.real("the value at a corner");
        in.end_line("four values");
    }
    if (rows.values.size() != elements)
        in.fail_at(position, "holds values of " + std::to_string(count) + " elements, but " +
                                 std::to_string(rows.values.size()) + " rows follow");
    return rows;
}

/// Largest difference of two values at one node that is rounding.
double tolerance_of(const std::vector<CornerValues>& rows, const MeshData& mesh)
{
    constexpr double kRounding = 1e-9; // of the range: the files hold some ten digits
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (std::size_t e = 0; e < rows.size(); ++e) {
        const auto corners = corner_count(mesh.elements[e]); // what stands behind them is no value
        const auto [least, most] = std::minmax_element(rows[e].begin(), rows[e].begin() + corners);
        low = std::min(low, *least);
        high = std::max(high, *most);
    }
    return rows.empty() ? 0 : kRounding * (high / 2 - low / 2) * 2;
}

/// Values of the vertices, and where each comes from.
struct NodalValues {
    std::vector<double> value;
    std::vector<Index> element; ///< the first with that vertex; -1: none

    explicit NodalValues(std::size_t vertices) : value(vertices), element(vertices, -1) {}
};

/// Two elements that disagree about a vertex.
struct Clash {
    Index vertex = 0;
    std::size_t element = 0;
    double value = 0;
};

/// Bring the values of the corners to the vertices, up to the first two that do not agree.
/// @param as_written  corners in the order of thesis_element(), not as the mesh lists them
std::optional<Clash> gather(const Rows& rows, const MeshData& mesh, bool as_written, NodalValues& nodal)
{
    const double tolerance = tolerance_of(rows.values, mesh);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element element = as_written ? thesis_element(mesh, e) : mesh.elements[e];
        for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(element)); ++k) {
            const auto v = static_cast<std::size_t>(element[k]);
            if (nodal.element[v] < 0) {
                nodal.element[v] = static_cast<Index>(e);
                nodal.value[v] = rows.values[e][k];
            } else if (!(std::abs(nodal.value[v] - rows.values[e][k]) <= tolerance)) {
                return Clash{element[k], e, rows.values[e][k]};
            }
        }
    }
    return std::nullopt;
}

[[noreturn]] void fail(const TextScanner& in, const Rows& rows, const MeshData& mesh,
                       const NodalValues& nodal, const Clash& clash)
{
    const auto v = static_cast<std::size_t>(clash.vertex);
    in.fail_at(rows.positions[clash.element],
               "vertex " + std::to_string(v) + " at " + exact_text(mesh.points(clash.vertex, 0)) + " " +
                   exact_text(mesh.points(clash.vertex, 1)) + " has the value " + exact_text(clash.value) +
                   " in element " + std::to_string(clash.element + 1) + ", but " +
                   exact_text(nodal.value[v]) + " in element " + std::to_string(nodal.element[v] + 1));
}

/// The values in whichever of the two orders of corners fits the whole file.
NodalValues nodal_values(const TextScanner& in, const Rows& rows, const MeshData& mesh)
{
    const auto vertices = static_cast<std::size_t>(mesh.points.rows());
    NodalValues as_listed(vertices);
    const std::optional<Clash> clash = gather(rows, mesh, false, as_listed);
    if (!clash)
        return as_listed;
    NodalValues as_written(vertices);
    if (!gather(rows, mesh, true, as_written))
        return as_written;
    fail(in, rows, mesh, as_listed, *clash);
}

} // namespace

Field read_thesis_values(const InputBytes& file, const MeshData& mesh)
{
    TextScanner in(file.path, file.bytes);
    const Rows rows = read_rows(in, mesh.elements.size());
    const NodalValues nodal = nodal_values(in, rows, mesh);
    const auto loose = std::find(nodal.element.begin(), nodal.element.end(), -1);
    if (loose != nodal.element.end())
        throw InputError(file.path + ": holds values at the corners of elements, but vertex " +
                         std::to_string(loose - nodal.element.begin()) + " of the mesh belongs to none");
    return {"f", FieldLocation::vertex,
            Eigen::Map<const Eigen::VectorXd>(nodal.value.data(), mesh.points.rows())};
}

void write_thesis_values(const MeshData& mesh, const Field& field, Eigen::Index component, OutputFile& out)
{
    out.append(std::to_string(mesh.elements.size()) + "\n");
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element element = thesis_element(mesh, e);
        char* end = number_text(out.room(5 * kLongestNumber), e + 1, ' ');
        for (std::size_t k = 0; k < 4; ++k)
            end = number_text(end, element[k] < 0 ? 0.0 : field.values(element[k], component),
                              k < 3 ? ' ' : '\n');
        out.advance_to(end);
    }
}

} // namespace morph
