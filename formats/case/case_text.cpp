#include "formats/case/case_text.h"

#include "formats/text/number_text.h"
#include "libmorph/pipeline/deform_settings.h"

#include <array>
#include <cstdio>

namespace morph {

namespace {

constexpr std::size_t kKnotsPerLine = 6;

std::string number(double value)
{
    std::array<char, kLongestNumber> text{};
    std::string digits(text.data(), number_text(text.data(), value));
    if (digits.find_first_of(".e") == std::string::npos)
        digits += ".0"; // TOML distinguishes floats from integers
    return digits;
}

std::string pair(double x, double y)
{
    return "    [" + number(x) + ", " + number(y) + "],";
}

std::string control_point_lines(const BoundaryText& boundary)
{
    const Points2& points = boundary.curve.control_points;
    std::string text = "control_points = [\n";
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        text += pair(points(i, 0), points(i, 1));
        for (const auto& [row, words] : boundary.point_notes)
            if (row == i)
                text += " # " + words;
        text += '\n';
    }
    return text + "]\n";
}

std::string number_lines(const std::string& key, const std::vector<double>& values)
{
    std::string text = key + " = [";
    for (std::size_t i = 0; i < values.size(); ++i)
        text += (i % kKnotsPerLine == 0 ? "\n    " : " ") + number(values[i]) + ",";
    return text + "\n]\n";
}

std::string displacement_lines(Eigen::Index count)
{
    std::string text = "displacements = [\n";
    for (Eigen::Index i = 0; i < count; ++i)
        text += pair(0, 0) + " # " + std::to_string(i + 1) + '\n';
    return text + "]\n";
}

std::string boundary_text(const BoundaryText& boundary)
{
    const CurveDefinition& curve = boundary.curve;
    std::string text = "[[boundary]]\n# The marker of the mesh that this curve carries.\n";
    text += "name = " + toml_string(boundary.name) + '\n';
    text += "# Of the polynomial pieces, 1 to 7; 3 joins them with continuous curvature.\n";
    text += "degree = " + std::to_string(curve.degree) + '\n';
    text += "# true: the curve is a loop; false: it starts and ends at its end control points.\n";
    text += curve.closed ? "closed = true\n" : "closed = false\n";
    text += "# " + boundary.note + '\n' + control_point_lines(boundary);
    if (!curve.knots.empty()) {
        text += "# Where the pieces meet in the parameter u, closer where the shape asks for it; a value\n"
                "# repeated `degree` times is a corner (0 and 1 are one value of a closed curve).\n";
        text += number_lines("knots", curve.knots);
    }
    if (!curve.weights.empty())
        text += "# Of the control points (NURBS).\n" + number_lines("weights", curve.weights);
    text += "# How far each control point moves, dx and dy in the unit of the mesh: edit these.\n";
    return text + displacement_lines(curve.control_points.rows());
}

} // namespace

std::string toml_string(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (byte < 0x20 || byte == 0x7f) {
            std::array<char, 8> escape{};
            std::snprintf(escape.data(), escape.size(), "\\u%04X", byte);
            quoted += escape.data();
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

std::string case_text(const std::string& tool, const std::string& mesh_file, const std::string& output_mesh,
                      const std::vector<BoundaryText>& boundaries)
{
    std::string text =
        "# Made by " + tool + ". Change some displacements, then run morph-deform on this file.\n\n";
    text += "[mesh]\n# Relative to this file.\nfile = " + toml_string(mesh_file) + "\n\n";
    for (const BoundaryText& boundary : boundaries)
        text += boundary_text(boundary) + '\n';
    text += "[deform]\n# The control points' influence is spread into the mesh by one linear solve.\n"
            "method = " +
            toml_string(to_string(Method::harmonic)) +
            "\n# Stiffer near the moving boundaries, so that small elements there move along rather than\n"
            "# fold; \"uniform\" is Laplace's equation, \"inverse-area\" stiffens small elements.\n"
            "diffusivity = " +
            toml_string(to_string(Diffusivity::inverse_distance)) +
            "\n# Report inverted elements; \"none\" does not look.\n"
            "guard = " +
            toml_string(to_string(Guard::check)) +
            "\n# Markers without a [[boundary]] stay where they are; to hold only some, list them:\n"
            "# fixed = [\"farfield\"]\n\n";
    return text +
           "[output]\n# Relative to this file; -o of morph-deform wins.\nmesh = " + toml_string(output_mesh) +
           '\n';
}

} // namespace morph
