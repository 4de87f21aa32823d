#include "libmorph/weights/boundary_extension.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/weights/biharmonic.h"
#include "libmorph/weights/damping.h"
#include "libmorph/weights/elasticity.h"
#include "libmorph/weights/harmonic.h"
#include "libmorph/weights/idw.h"
#include "libmorph/weights/rbf.h"
#include "libmorph/weights/spring.h"
#include "tests/support/boundary_values.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace morph;
using test::values_at;
using test::whole_boundary;

// One sparse solve; stiffnesses differ some hundred times on the meshes in code, 1e10 times in boundary
// layers.
constexpr double kSolveTol = 1e-11;
constexpr double kLayerTol = 1e-6;

struct Method {
    std::string name;
    std::function<std::unique_ptr<BoundaryExtension>(const Mesh&, const DirichletBoundary&)> make;
};

Method springs(const std::string& name, SpringStiffness stiffness, SpringBracing bracing)
{
    return {name, [=](const Mesh& mesh, const DirichletBoundary& held) {
                return braced_spring_extension(mesh, held, stiffness, bracing);
            }};
}

Method elastic(const std::string& name, YoungsModulus modulus)
{
    return {name, [=](const Mesh& mesh, const DirichletBoundary& held) {
                return elastic_extension(mesh, held, {modulus, 0.3});
            }};
}

std::vector<Method> methods()
{
    return {springs("torsion", SpringStiffness::inverse_length_squared, SpringBracing::torsion),
            springs("torsion_by_length", SpringStiffness::inverse_length, SpringBracing::torsion),
            springs("ball_vertex", SpringStiffness::inverse_length_squared, SpringBracing::ball_vertex),
            springs("ball_vertex_by_length", SpringStiffness::inverse_length, SpringBracing::ball_vertex),
            elastic("elastic", YoungsModulus::uniform),
            elastic("elastic_by_distance", YoungsModulus::inverse_distance),
            elastic("elastic_by_area", YoungsModulus::inverse_area),
            {"conformal_biharmonic", conformal_biharmonic_extension}};
}

class ACoupledExtension : public testing::TestWithParam<Method> {
protected:
    static std::unique_ptr<BoundaryExtension> make(const Mesh& mesh, const DirichletBoundary& held)
    {
        return GetParam().make(mesh, held);
    }
};

INSTANTIATE_TEST_SUITE_P(Methods, ACoupledExtension, testing::ValuesIn(methods()),
                         [](const auto& method) { return method.param.name; });

/// A translation and a turn to first order: what costs no energy.
Eigen::RowVector2d rigid(double x, double y)
{
    return {0.3 - 0.2 * y, -0.7 + 0.2 * x};
}

Eigen::RowVector2d wavy(double x, double y)
{
    return {0.1 * std::sin(3 * x - y), 0.2 * std::cos(2 * y + x)};
}

TEST_P(ACoupledExtension, MovesTheMeshRigidlyWithItsBoundary)
{
    for (const MeshData& data :
         {test::uneven_square(12), test::quad_square(12), test::uneven_annulus(0.5, 3, 40)}) {
        const Mesh mesh = build_mesh(data);
        const DirichletBoundary held = whole_boundary(mesh, mesh.markers.front().name);
        const Matrix u = make(mesh, held)->extend(values_at(mesh, held.vertices, rigid));
        const Matrix exact = values_at(mesh, rigid);
        EXPECT_LE((u - exact).norm(), kSolveTol * exact.norm());
    }
}

TEST_P(ACoupledExtension, IsExactOnTheBoundaryOfEveryRealMeshAndMovesItRigidly)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const DirichletBoundary held = whole_boundary(mesh, mesh.markers.front().name);
        const auto extension = make(mesh, held);
        const Matrix exact = values_at(mesh, rigid);
        EXPECT_LE((extension->extend(values_at(mesh, held.vertices, rigid)) - exact).norm(),
                  kLayerTol * exact.norm());
        const Matrix values = values_at(mesh, held.vertices, wavy);
        const Matrix u = extension->extend(values);
        EXPECT_EQ(u(held.vertices, Eigen::all), values);
        EXPECT_TRUE(u.allFinite());
    }
}

TEST_P(ACoupledExtension, IsLinear)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 40));
    const DirichletBoundary held = whole_boundary(mesh, "inner");
    const auto extension = make(mesh, held);
    const Matrix a = values_at(mesh, held.vertices, wavy), b = values_at(mesh, held.vertices, rigid);
    const Matrix sum = 2 * extension->extend(a) - 3 * extension->extend(b);
    EXPECT_LE((extension->extend(2 * a - 3 * b) - sum).norm(), kSolveTol * sum.norm());
    EXPECT_EQ(extension->extend(Matrix::Zero(a.rows(), 2)).norm(), 0);
}

TEST_P(ACoupledExtension, DoesNotDependOnTheUnitOfLengthOrTheAxes)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 40));
    const DirichletBoundary held = whole_boundary(mesh, "inner");
    const Matrix values = values_at(mesh, held.vertices, wavy);
    const Matrix u = make(mesh, held)->extend(values);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
    for (const double scale : {1e-6, 1e6}) {
        Mesh other = mesh;
        points(other).leftCols<2>() = scale * (points(mesh).leftCols<2>() * turn);
        const Matrix v = make(other, held)->extend(values * turn);
        EXPECT_LE((v - u * turn).norm(), kSolveTol * u.norm()) << scale;
    }
}

TEST_P(ACoupledExtension, IsTheSameBytesForAnyNumberOfThreads)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 180));
    const DirichletBoundary held = whole_boundary(mesh, "inner");
    const Matrix values = values_at(mesh, held.vertices, wavy);
    set_thread_count(1);
    const Matrix alone = make(mesh, held)->extend(values);
    set_thread_count(3);
    EXPECT_EQ(make(mesh, held)->extend(values), alone);
    set_thread_count(0);
}

TEST_P(ACoupledExtension, TakesTheCopiesOfASplitVertexAsOneUnknown)
{
    const Mesh mesh = build_mesh(test::touching_squares(6));
    ASSERT_GT(vertex_count(mesh), mesh.numbering.file_vertices);
    DirichletBoundary held = whole_boundary(mesh, "top");
    std::erase_if(held.vertices, [&](Index v) { return points(mesh).row(v).head<2>().isOnes(); });
    const Matrix u = make(mesh, held)->extend(values_at(mesh, held.vertices, wavy));
    std::vector<Index> copies;
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (points(mesh).row(v).head<2>().isOnes())
            copies.push_back(v);
    ASSERT_EQ(copies.size(), 2U);
    EXPECT_EQ(u.row(copies[0]), u.row(copies[1]));
    EXPECT_GT(u.row(copies[0]).norm(), 0);
}

TEST_P(ACoupledExtension, LeavesAVertexOfNoElementWhereItIs)
{
    MeshData data = test::uneven_square(4);
    data.points.conservativeResize(26, 3);
    data.points.row(25) << 3, 3, 0;
    const Mesh mesh = build_mesh(data);
    DirichletBoundary held = whole_boundary(mesh, "top");
    std::erase_if(held.vertices, [&](Index v) { return points(mesh)(v, 0) > 2; });
    const Matrix u = make(mesh, held)->extend(values_at(mesh, held.vertices, rigid));
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (points(mesh)(v, 0) > 2) {
            EXPECT_EQ(u.row(v).norm(), 0);
        }
}

TEST_P(ACoupledExtension, RefusesWhatMakesNoSense)
{
    Mesh mesh = build_mesh(test::uneven_square(4));
    const DirichletBoundary good = whole_boundary(mesh, "top");
    const Matrix values = values_at(mesh, good.vertices, wavy);
    const auto extension = make(mesh, good);
    EXPECT_THROW(extension->extend(values.topRows(3)), InputError);
    EXPECT_THROW(extension->extend(values * NAN), InputError);
    DirichletBoundary bad = good;
    bad.vertices.back() = 25;
    EXPECT_THROW(make(mesh, bad), InputError);
    bad.vertices.back() = bad.vertices.front();
    EXPECT_THROW(make(mesh, bad), InputError);
    bad.vertices.clear();
    EXPECT_THROW(make(mesh, bad), InputError);
    mesh.dimension = 3;
    EXPECT_THROW(make(mesh, good), InputError);
}

TEST_P(ACoupledExtension, TakesTwoColumnsOnly)
{
    const Mesh mesh = build_mesh(test::uneven_square(4));
    const DirichletBoundary boundary = whole_boundary(mesh, "top");
    const auto extension = make(mesh, boundary);
    EXPECT_EQ(extension->components(), 2);
    const auto k = static_cast<Index>(boundary.vertices.size());
    for (const Index columns : {1, 3, 4})
        EXPECT_THROW(extension->extend(Matrix::Ones(k, columns)), InputError) << columns;
}

TEST_P(ACoupledExtension, RefusesAFlatElementAndSaysWhere)
{
    Mesh mesh = build_mesh(test::uneven_square(4));
    const auto [a, b, c, none] = element_corners(mesh, 0);
    points(mesh).row(a) = points(mesh).row(b);
    EXPECT_THAT(test::message_of([&] { make(mesh, whole_boundary(mesh, "top")); }),
                testing::MatchesRegex("(element [0-9]+ (is inverted|has three corners on a line)"
                                      "|the elements around vertex [0-9]+ are inverted).*"));
}

/// A method as somebody would write it: every vertex but the prescribed ones gets @p inside.
class Constant final : public BoundaryExtension {
public:
    Constant(const Mesh& mesh, const DirichletBoundary& boundary, double inside, int components = 1)
        : BoundaryExtension(mesh, boundary, components), vertices_(vertex_count(mesh)), inside_(inside)
    {
    }

    mutable Matrix joined; ///< what solve() was given

private:
    Matrix solve(const Matrix& given) const override
    {
        joined = given;
        return Matrix::Constant(vertices_, given.cols(), inside_);
    }

    Index vertices_;
    double inside_;
};

class ANewMethod : public testing::Test {
protected:
    /// Vertices at (1, 1), where two squares touch.
    std::vector<Index> copies() const
    {
        std::vector<Index> found;
        for (Index v = 0; v < vertex_count(mesh); ++v)
            if (points(mesh).row(v).head<2>().isOnes())
                found.push_back(v);
        return found;
    }

    Mesh mesh = build_mesh(test::touching_squares(3));
    DirichletBoundary boundary = whole_boundary(mesh, "top");
    Index k = static_cast<Index>(boundary.vertices.size());
};

TEST_F(ANewMethod, NeedNotMeetThePrescribedValuesItself)
{
    const Matrix values = values_at(mesh, boundary.vertices, wavy);
    const Matrix u = Constant(mesh, boundary, 7).extend(values);
    EXPECT_EQ(u(boundary.vertices, Eigen::all), values);
    EXPECT_EQ((u.array() == 7).count(), 2 * (vertex_count(mesh) - k));
}

TEST_F(ANewMethod, SeesTheCopiesOfASplitVertexAsOne)
{
    ASSERT_EQ(copies().size(), 2U);
    const Constant method(mesh, boundary, 7);
    method.extend(Matrix::Ones(k, 3));
    EXPECT_EQ(method.joined, Matrix::Ones(k - 1, 3)); // both copies are in the boundary
}

TEST_F(ANewMethod, GivesAllCopiesOfASplitVertexItsValue)
{
    const std::vector<Index> pair = copies();
    std::erase(boundary.vertices, pair[1]);
    const Matrix u = Constant(mesh, boundary, 7).extend(Matrix::Ones(k - 1, 1));
    EXPECT_EQ(u(pair[0], 0), 1);
    EXPECT_EQ(u(pair[1], 0), 1);
}

TEST_F(ANewMethod, ReturnsNothingThatIsNotFinite)
{
    EXPECT_THROW(Constant(mesh, boundary, NAN).extend(Matrix::Ones(k, 1)), SolverError);
    EXPECT_THROW(Constant(mesh, boundary, INFINITY).extend(Matrix::Ones(k, 1)), SolverError);
}

TEST_F(ANewMethod, IsGivenNothingThatMakesNoSense)
{
    const Constant method(mesh, boundary, 7);
    Matrix values = Matrix::Ones(k, 1);
    values(1, 0) = NAN;
    EXPECT_THROW(method.extend(values), InputError);
    EXPECT_THROW(method.extend(Matrix::Ones(k + 1, 1)), InputError);
    const auto copy = std::find(boundary.vertices.begin(), boundary.vertices.end(), copies()[1]);
    values.setOnes();
    values(copy - boundary.vertices.begin(), 0) = 2;
    EXPECT_THROW(method.extend(values), InputError); // another value than the other copy
    EXPECT_EQ(method.joined.size(), 0);
}

TEST_F(ANewMethod, SaysHowManyComponentsInfluenceEachOther)
{
    const Constant apart(mesh, boundary, 7), together(mesh, boundary, 7, 3);
    EXPECT_EQ(apart.components(), 1);
    EXPECT_EQ(together.components(), 3);
    EXPECT_EQ(apart.extend(Matrix::Ones(k, 5)).cols(), 5);
    EXPECT_EQ(together.extend(Matrix::Ones(k, 3)).cols(), 3);
    EXPECT_THROW(together.extend(Matrix::Ones(k, 2)), InputError);
}

TEST(MethodsWithoutCoupling, HaveOneComponent)
{
    const Mesh mesh = build_mesh(test::uneven_square(4));
    const DirichletBoundary boundary = whole_boundary(mesh, "top");
    EXPECT_EQ(harmonic_extension(mesh, boundary, Diffusivity::uniform)->components(), 1);
    EXPECT_EQ(spring_extension(mesh, boundary, SpringStiffness::inverse_length)->components(), 1);
    EXPECT_EQ(biharmonic_extension(mesh, boundary)->components(), 1);
    EXPECT_EQ(damping_extension(mesh, boundary)->components(), 1);
    EXPECT_EQ(idw_extension(mesh, boundary)->components(), 1);
    EXPECT_EQ(rbf_extension(mesh, boundary)->components(), 1);
}

} // namespace
