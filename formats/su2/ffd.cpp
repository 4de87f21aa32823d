#include "formats/su2/ffd.h"

#include "formats/text/text_scanner.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cstdint>

namespace morph {

namespace {

constexpr int kMostPoints = 1000;                   // along one side: more is a slip
constexpr std::int64_t kMostControlPoints = 100000; // in all

/// Numbers from the lines of a section.
using Rows = std::vector<std::vector<double>>;

/// A box as its lines give it.
struct RawBox {
    std::string tag;
    std::array<int, 3> degree{0, 0, 0};
    std::array<int, 3> order{0, 0, 0};
    bool bspline = false;
    Rows corners;
    Rows control_points;
};

class BoxReader {
public:
    BoxReader(const std::string& text, const std::string& path) : in_(path, text, '%'), path_(path) {}

    std::vector<RawBox> read()
    {
        while (in_.skip_white()) {
            const std::string line(in_.rest_of_line());
            in_.skip_line();
            const std::size_t equals = line.find('=');
            if (equals == std::string::npos)
                continue;
            take(line.substr(0, equals), line.substr(equals + 1));
        }
        return std::move(boxes_);
    }

private:
    void take(const std::string& key, const std::string& value)
    {
        const auto first = value.find_first_not_of(" \t");
        const std::string text = first == std::string::npos ? "" : value.substr(first);
        if (key == "FFD_TAG") {
            boxes_.push_back({});
            boxes_.back().tag = text;
        }
        if (boxes_.empty())
            return;
        RawBox& box = boxes_.back();
        for (int axis = 0; axis < 3; ++axis) {
            const char letter = "IJK"[axis];
            if (key == std::string("FFD_DEGREE_") + letter)
                box.degree[static_cast<std::size_t>(axis)] = number(box, key, text);
            if (key == std::string("FFD_BSPLINE_ORDER_") + letter)
                box.order[static_cast<std::size_t>(axis)] = number(box, key, text);
        }
        if (key == "FFD_BLENDING")
            box.bspline = text.starts_with("BSPLINE");
        if (key == "FFD_CORNER_POINTS")
            box.corners = rows(box, key, text);
        if (key == "FFD_CONTROL_POINTS")
            box.control_points = rows(box, key, text);
    }

    int number(const RawBox& box, const std::string& key, const std::string& text) const
    {
        TextScanner scanner(path_, text);
        Index value = 0;
        if (!scanner.try_index(value) || value > kMostPoints)
            throw InputError(path_ + ": FFD box '" + box.tag + "': " + key + " must be a number up to " +
                             std::to_string(kMostPoints));
        return value;
    }

    Rows rows(const RawBox& box, const std::string& key, const std::string& text)
    {
        Rows found;
        TextScanner count_scanner(path_, text);
        Index count = 0;
        if (!count_scanner.try_index(count))
            throw InputError(path_ + ": FFD box '" + box.tag + "': " + key + " needs a count");
        for (Index i = 0; i < count; ++i) {
            std::vector<double> row;
            double value = 0;
            if (in_.skip_white())
                while (!in_.at_line_end() && in_.try_real(value))
                    row.push_back(value);
            if (row.empty())
                throw InputError(path_ + ": FFD box '" + box.tag + "': " + key + " counts " +
                                 std::to_string(count) + " points, but " + std::to_string(i) + " follow");
            in_.skip_line();
            found.push_back(std::move(row));
        }
        return found;
    }

    TextScanner in_;
    std::string path_;
    std::vector<RawBox> boxes_;
};

[[noreturn]] void fail(const std::string& path, const RawBox& box, const std::string& what)
{
    throw InputError(path + ": FFD box '" + box.tag + "': " + what);
}

/// The point of the box between its corners at part (r, s, t); corners run around the face k = 0, then around
/// the other.
Eigen::RowVector3d between_corners(const RawBox& box, double r, double s, double t)
{
    const auto corner = [&](std::size_t c) {
        Eigen::RowVector3d p = Eigen::RowVector3d::Zero();
        for (std::size_t axis = 0; axis < std::min<std::size_t>(3, box.corners[c].size()); ++axis)
            p[static_cast<Eigen::Index>(axis)] = box.corners[c][axis];
        return p;
    };
    const auto face = [&](std::size_t c) -> Eigen::RowVector3d {
        return (1 - r) * (1 - s) * corner(c) + r * (1 - s) * corner(c + 1) + r * s * corner(c + 2) +
               (1 - r) * s * corner(c + 3);
    };
    return box.corners.size() == 4 ? face(0) : Eigen::RowVector3d((1 - t) * face(0) + t * face(4));
}

void place_control_points(const std::string& path, const RawBox& raw, Su2FfdBox& box)
{
    const auto [n, m, l] = box.points;
    box.control_points.resize(static_cast<Eigen::Index>(n) * m * l, 3);
    const auto part = [](int i, int count) { return count < 2 ? 0.0 : static_cast<double>(i) / (count - 1); };
    for (int k = 0; k < l; ++k)
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < n; ++i)
                box.control_points.row(i + n * (j + m * k)) =
                    between_corners(raw, part(i, n), part(j, m), part(k, l));
    for (const std::vector<double>& row : raw.control_points) {
        if (row.size() != 6)
            fail(path, raw, "a control point must be i j k x y z");
        const auto at = [&](std::size_t axis) { return static_cast<int>(row[axis]); };
        if (box.dimension == 2 && at(2) != 0)
            continue; // SU2 gives a planar box two layers
        if (at(0) < 0 || at(0) >= n || at(1) < 0 || at(1) >= m || at(2) < 0 || at(2) >= l)
            fail(path, raw, "a control point has a number beyond the degrees of the box");
        box.control_points.row(at(0) + n * (at(1) + m * at(2))) << row[3], row[4],
            box.dimension == 2 ? 0 : row[5];
    }
}

Su2FfdBox finished(const std::string& path, const RawBox& raw)
{
    if (raw.corners.size() != 4 && raw.corners.size() != 8)
        fail(path, raw,
             "has " + std::to_string(raw.corners.size()) + " corner points, but 4 or 8 were expected");
    Su2FfdBox box;
    box.tag = raw.tag;
    box.bspline = raw.bspline;
    box.dimension = raw.corners.size() == 4 ? 2 : 3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool flat = axis == 2 && box.dimension == 2;
        if (!flat && raw.degree[axis] < 1)
            fail(path, raw, std::string("has no FFD_DEGREE_") + "IJK"[axis]);
        box.points[axis] = flat ? 1 : raw.degree[axis] + 1;
        const int order = raw.bspline && raw.order[axis] > 1 ? raw.order[axis] : raw.degree[axis] + 1;
        box.degree[axis] = flat ? 0 : std::min(order - 1, raw.degree[axis]);
    }
    if (std::int64_t{box.points[0]} * box.points[1] * box.points[2] > kMostControlPoints)
        fail(path, raw, "has more than " + std::to_string(kMostControlPoints) + " control points");
    place_control_points(path, raw, box);
    return box;
}

} // namespace

std::vector<Su2FfdBox> su2_ffd_boxes(const std::vector<OpaqueSection>& carried, const std::string& path)
{
    std::vector<Su2FfdBox> boxes;
    for (const OpaqueSection& text : carried)
        if (text.format == "su2")
            for (const RawBox& raw : BoxReader(text.text, path).read())
                boxes.push_back(finished(path, raw));
    return boxes;
}

} // namespace morph
