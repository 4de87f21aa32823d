#include "libmorph/basis/tensor_sum.h"

namespace morph {

TensorNet tensor_net(const Lattice& lattice, const Matrix& values)
{
    TensorNet net;
    net.components = static_cast<int>(values.cols());
    net.line = values.cols() * lattice.definition().points[0];
    net.layer = net.line * lattice.definition().points[1];
    net.values.assign(values.data(), values.data() + values.size());
    return net;
}

Matrix homogeneous_points(const Lattice& lattice, const Eigen::Vector3d& origin)
{
    const Points& P = lattice.definition().control_points;
    const int d = lattice.dimension();
    Matrix A(P.rows(), d + (lattice.rational() ? 1 : 0));
    A.leftCols(d) = (P.rowwise() - origin.transpose()).leftCols(d);
    if (lattice.rational()) {
        A.col(d) = Eigen::Map<const Eigen::VectorXd>(lattice.definition().weights.data(), P.rows());
        A.leftCols(d).array().colwise() *= A.col(d).array();
    }
    return A;
}

int common_degree(const Lattice& lattice)
{
    const int degree = lattice.axis(0).degree();
    for (int d = 1; d < lattice.dimension(); ++d)
        if (lattice.axis(d).degree() != degree)
            return SplineAxis::kAnyDegree;
    return degree <= 3 ? degree : SplineAxis::kAnyDegree;
}

} // namespace morph
