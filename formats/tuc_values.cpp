#include "formats/number_text.h"
#include "formats/text_scanner.h"
#include "formats/tuc_files.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

using CornerValues = std::array<double, 4>;

std::string exact(double value)
{
    std::array<char, kLongestNumber> text{};
    return {text.data(), number_text(text.data(), value)};
}

/// Rows of the file, and where each begins.
struct Rows {
    std::vector<CornerValues> values;
    std::vector<std::size_t> positions;
};

Rows read_rows(TextScanner& in, std::size_t elements)
{
    in.skip_white();
    const auto count = static_cast<std::size_t>(in.index("the number of elements"));
    in.end_line("the number of elements");
    if (count != elements)
        in.fail_at(0, "holds values of " + std::to_string(count) + " elements, but the mesh has " +
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
        in.fail_at(0, "holds values of " + std::to_string(count) + " elements, but " +
                          std::to_string(rows.values.size()) + " rows follow");
    return rows;
}

/// Largest difference of two values at one node that is rounding.
double tolerance_of(const std::vector<CornerValues>& rows)
{
    constexpr double kRounding = 1e-9; // of the range: the files hold some ten digits
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const CornerValues& row : rows)
        for (const double value : row) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    return rows.empty() ? 0 : kRounding * (high / 2 - low / 2) * 2;
}

} // namespace

Field read_tuc_values(const InputBytes& file, const MeshData& mesh)
{
    TextScanner in(file.path, file.bytes);
    const Rows rows = read_rows(in, mesh.elements.size());
    const double tolerance = tolerance_of(rows.values);
    Field field{"f", FieldLocation::vertex, Matrix::Zero(mesh.points.rows(), 1)};
    std::vector<Index> first(static_cast<std::size_t>(mesh.points.rows()), -1); // element that gave the value
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element element = tuc_element(mesh, e);
        for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(element)); ++k) {
            double& value = field.values(element[k], 0);
            Index& giver = first[static_cast<std::size_t>(element[k])];
            if (giver < 0) {
                giver = static_cast<Index>(e);
                value = rows.values[e][k];
            } else if (!(std::abs(value - rows.values[e][k]) <= tolerance))
                in.fail_at(rows.positions[e], "node " + std::to_string(element[k] + 1) + " has the value " +
                                                  exact(rows.values[e][k]) + " in element " +
                                                  std::to_string(e + 1) + ", but " + exact(value) +
                                                  " in element " + std::to_string(giver + 1));
        }
    }
    return field;
}

void write_tuc_values(const MeshData& mesh, const Field& field, Eigen::Index component, OutputFile& out)
{
    out.append(std::to_string(mesh.elements.size()) + "\n");
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        append_number(out, e + 1);
        for (const Index v : tuc_element(mesh, e)) {
            out.append(" ");
            append_number(out, v < 0 ? 0.0 : field.values(v, component));
        }
        out.append("\n");
    }
}

} // namespace morph
