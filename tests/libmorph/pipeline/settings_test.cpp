#include "libmorph/pipeline/settings.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/pipeline/deformer.h"
#include "libmorph/pipeline/generate.h"
#include "libmorph/remap/remap.h"
#include "tests/support/domains.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace {

using namespace morph;
using ::testing::HasSubstr;
using ::testing::StartsWith;

template <typename Enum>
class EnumNames : public ::testing::Test {
};

using NamedEnums =
    ::testing::Types<Method, Guard, Diffusivity, RadialFunction, YoungsModulus, SpringStiffness,
                     SpringBracing, BiharmonicCondition, LatticeBasis, Outside, QuadRule>;
TYPED_TEST_SUITE(EnumNames, NamedEnums);

TYPED_TEST(EnumNames, AreReadBackAndRefusedWithTheNearest)
{
    const std::vector<std::string> names = names_of<TypeParam>();
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(from_string<TypeParam>(names[i])), i)
            << "in the order of the enum";
        EXPECT_EQ(to_string(from_string<TypeParam>(names[i])), names[i]);
    }
    EXPECT_THAT(test::message_of([&] { from_string<TypeParam>(names[0] + "x"); }),
                HasSubstr("did you mean '" + names[0] + "'?"));
}

/// A change of settings that makes them wrong, and what the message says.
struct Slip {
    std::string what;
    std::function<void(MotionSettings&)> make;
    std::string message; ///< behind the place
};

MotionSettings ring_settings()
{
    MotionSettings settings;
    settings.curves = {{.marker = "inner", .curve = test::round_curve(0, 0, 1).definition()}};
    LatticeSettings lattice;
    lattice.shape.dimension = 2;
    lattice.shape.points = {6, 5, 1};
    lattice.shape.degree = {3, 2, 0};
    lattice.box = {{-1.5, -1.4, 0}, {1.6, 1.5, 0}};
    settings.lattice = lattice;
    return settings;
}

PullSettings pull_of(std::vector<Index> vertices, Matrix displacements)
{
    PullSettings pull;
    pull.vertices = std::move(vertices);
    pull.displacements = std::move(displacements);
    return pull;
}

std::vector<Slip> slips()
{
    using S = MotionSettings;
    return {
        {"no marker of that name", [](S& s) { s.curves[0].marker = "innner"; }, "marker 'innner'"},
        {"too few control points", [](S& s) { s.curves[0].curve.control_points.conservativeResize(2, 2); },
         "boundary 'inner': "},
        {"displacements of another number", [](S& s) { s.curves[0].displacements = Points2::Zero(3, 2); },
         "boundary 'inner': displacements has 3 rows, but there are 8 control points"},
        {"a displacement that is no number",
         [](S& s) {
             s.curves[0].displacements = Points2::Constant(8, 2, std::numeric_limits<double>::quiet_NaN());
         },
         "boundary 'inner': displacements must be finite numbers"},
        {"a curve twice", [](S& s) { s.curves.push_back(s.curves[0]); }, "boundary 'inner' is given twice"},
        {"a curve across itself",
         [](S& s) { s.curves[0].curve.control_points.row(0).swap(s.curves[0].curve.control_points.row(3)); },
         "boundary 'inner': the curve crosses itself"},
        {"a vertex beyond the mesh", [](S& s) { s.pulls = {pull_of({100000}, Matrix::Zero(1, 2))}; },
         "[[pull]] names vertex 100000"},
        {"a negative vertex", [](S& s) { s.pulls = {pull_of({-1}, Matrix::Zero(1, 2))}; },
         "[[pull]] names vertex -1"},
        {"a pull without displacements", [](S& s) { s.pulls = {pull_of({1}, {})}; },
         "[[pull]] needs displacements"},
        {"pulls of another number", [](S& s) { s.pulls = {pull_of({1}, Matrix::Zero(2, 2))}; },
         "[[pull]] displacements has 2 rows, but there are 1 points"},
        {"no lattice for ffd",
         [](S& s) {
             s.deform.method = Method::ffd;
             s.lattice.reset();
         },
         "method = \"ffd\" needs a [lattice]"},
        {"a lattice elsewhere",
         [](S& s) {
             s.deform.method = Method::ffd;
             s.lattice->box = {{10, 10, 0}, {11, 11, 0}};
         },
         "[lattice] holds no vertex of the mesh"},
        {"a lattice without area",
         [](S& s) {
             s.deform.method = Method::ffd;
             s.lattice->box->high = s.lattice->box->low;
         },
         "[lattice] "},
        {"lattice displacements of another number",
         [](S& s) {
             s.deform.method = Method::ffd;
             s.lattice->displacements = Matrix::Zero(29, 2);
         },
         "[lattice] displacements is 29 x 2, expected 30 x 2"},
        {"rotations with elasticity",
         [](S& s) {
             s.deform.method = Method::elasticity;
             s.deform.rotations = true;
         },
         "[deform] rotations go with methods that move x and y apart; \"elasticity\""},
        {"a negative distance",
         [](S& s) {
             s.deform.rigid = {{"inner", -1}};
         },
         "[deform] rigid distance of 'inner'"},
        {"a marker without area", [](S& s) { s.constraints = ConstraintSettings{.area = {"nowhere"}}; },
         "[constraints] the mesh has no marker 'nowhere'"},
        {"a tie to a control point that there is not",
         [](S& s) {
             s.constraints = ConstraintSettings{};
             s.constraints->ties = {{.boundary = "inner", .points = {{0, 0, 0}, {8, 0, 0}}}};
         },
         "[constraints] there is no such control point of 'inner': 9"},
        {"a thickness of nothing",
         [](S& s) {
             s.constraints = ConstraintSettings{};
             s.constraints->thicknesses = {{.boundary = "inner", .at = {0}}};
         },
         "[constraints] thickness of 'inner' must be above 0"},
        {"a mirror that is none",
         [](S& s) {
             s.constraints = ConstraintSettings{};
             s.constraints->mirrors = {
                 {.boundary = "inner", .at = {0, 0.3, 0}, .normal = Eigen::Vector3d::UnitY()}};
         },
         "[constraints] control point"},
    };
}

void set_places(MotionSettings& settings, const std::string& where)
{
    settings.where = settings.deform.where = where;
    for (CurveMove& curve : settings.curves)
        curve.where = where;
    for (PullSettings& pull : settings.pulls)
        pull.where = where;
    if (settings.lattice)
        settings.lattice->where = where;
    if (!settings.constraints)
        return;
    settings.constraints->where = where;
    for (TieSettings& tie : settings.constraints->ties)
        tie.where = where;
    for (MirrorSettings& mirror : settings.constraints->mirrors)
        mirror.where = where;
    for (ThicknessSettings& thickness : settings.constraints->thicknesses)
        thickness.where = where;
}

TEST(MotionSettingsThatAreWrong, AreRefusedByTheNameOfTheEntryBehindItsPlace)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 60, 10));
    for (const Slip& slip : slips()) {
        MotionSettings settings = ring_settings();
        slip.make(settings);
        const std::string in_memory = test::message_of([&] { Deformer(mesh, settings).move(); });
        EXPECT_THAT(in_memory, HasSubstr(slip.message)) << slip.what;
        set_places(settings, "case.toml:12: ");
        EXPECT_EQ(test::message_of([&] { Deformer(mesh, settings).move(); }), "case.toml:12: " + in_memory)
            << slip.what;
    }
}

TEST(MotionSettings, NameTheirControlPointsBeforeThereIsAMesh)
{
    MotionSettings settings = ring_settings();
    EXPECT_EQ(control_points(settings).size(), 8U);
    EXPECT_EQ(control_points(settings)[7], (ControlPoint{"inner", 7}));
    settings.deform.method = Method::ffd;
    EXPECT_EQ(control_points(settings).size(), 30U);
    EXPECT_EQ(control_points(settings)[0], (ControlPoint{kLatticeName, 0}));
    settings.deform.method = Method::harmonic;
    settings.curves.clear();
    EXPECT_EQ(control_points(settings).size(), 30U);
}

TEST(GenerateMesh, MakesTheDomainAroundTheCurves)
{
    std::vector<CurveMove> curves{
        {.marker = "body", .curve = test::round_curve(0, 0, 1).definition(), .nodes = 40}};
    const GenerateSettings settings{.where = "case.toml: ", .box = {-4, -4, 4, 4}, .size = 1};
    const MeshData mesh = generate_mesh(settings, curves);
    EXPECT_EQ(mesh.markers.size(), 2U);
    EXPECT_EQ(mesh.markers[0].name, "body");
    EXPECT_EQ(mesh.markers[0].edges.size(), 40U);
    curves[0].nodes = 0;
    EXPECT_THAT(test::message_of([&] { generate_mesh(settings, curves); }),
                StartsWith("boundary 'body' needs nodes"));
    curves[0].nodes = 2;
    EXPECT_THAT(test::message_of([&] { generate_mesh(settings, curves); }), StartsWith("case.toml: "));
}

} // namespace
