#include "libmorph/basis/bezier.h"

#include <array>

namespace morph {

namespace {

Eigen::Vector3d coefficient(const Curve& curve, int span, const BezierPiece& piece, int lasts)
{
    std::array<Eigen::Vector3d, kMaxDegree + 1> local;
    const auto count = static_cast<std::size_t>(curve.degree()) + 1;
    for (std::size_t k = 0; k < count; ++k)
        local[k] = curve.homogeneous(span - curve.degree() + static_cast<int>(k));
    return bernstein_coefficient(curve.knots(), span, piece.begin, piece.end, lasts,
                                 std::span(local).first(count));
}

} // namespace

std::vector<BezierPiece> bezier_pieces(const Curve& curve)
{
    const std::vector<double> breaks = curve.breakpoints();
    std::vector<BezierPiece> pieces;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        BezierPiece piece{breaks[k], breaks[k + 1], {}};
        const int span = find_span(curve.knots(), curve.degree(), piece.begin);
        for (int lasts = 0; lasts <= curve.degree(); ++lasts)
            piece.control.push_back(coefficient(curve, span, piece, lasts));
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

} // namespace morph
