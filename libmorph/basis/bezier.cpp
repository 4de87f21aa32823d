#include "libmorph/basis/bezier.h"

#include <array>

namespace morph {

namespace {

/// The polar form of the piece on @p span with @p lasts arguments `end` and the others `begin`.
Eigen::Vector3d polar_form(const Curve& curve, int span, double begin, double end, int lasts)
{
    const int p = curve.degree();
    const auto knot = [&](int i) { return curve.knots()[static_cast<std::size_t>(i)]; };
    std::array<Eigen::Vector3d, kMaxDegree + 1> d;
    for (int k = 0; k <= p; ++k)
        d[static_cast<std::size_t>(k)] = curve.homogeneous(span - p + k);
    for (int level = 1; level <= p; ++level) {
        const double u = level <= lasts ? end : begin;
        for (int k = p; k >= level; --k) {
            const double low = knot(span - p + k);
            const double share = (u - low) / (knot(span + k + 1 - level) - low);
            const auto at = static_cast<std::size_t>(k);
            d[at] = (1 - share) * d[at - 1] + share * d[at];
        }
    }
    return d[static_cast<std::size_t>(p)];
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
            piece.control.push_back(polar_form(curve, span, piece.begin, piece.end, lasts));
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

} // namespace morph
