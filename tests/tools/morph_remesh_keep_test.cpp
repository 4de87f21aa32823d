#include "formats/formats.h"
#include "libmorph/quality/quality.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace morph {
namespace {

constexpr double kDistance = 0.4;

/// Of a ring of radii 1 and 3: the element has a vertex within kDistance of the inner circle, or nearly.
bool near_inner(const MeshData& mesh, const Element& element, double slack)
{
    return std::any_of(element.begin(), element.end(),
                       [&](Index v) { return v >= 0 && mesh.points.row(v).norm() <= 1 + kDistance + slack; });
}

TEST(MorphRemeshKeep, LeavesElementsNearAMarkerWithTheirNumbersAndRemakesTheOthers)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.su2"), out = folder.file("out.su2");
    write_mesh_data(test::annulus(1, 3, 80, 30), in);
    for (const std::string size : {"0.05", "0.5"}) {
        const test::ProcessResult result = test::run_tool(
            "morph-remesh", {in, "-o", out, "--size", size, "--keep", "inner:0.4", "--keep", "quads"});
        ASSERT_EQ(result.status, 0) << result.errors;
        const MeshData before = read_mesh_data(in), after = read_mesh_data(out);
        EXPECT_EQ(quality_report(read_mesh(out)).inverted, 0);
        std::size_t kept = 0;
        for (std::size_t f = 0; f < before.elements.size(); ++f) {
            const Element& element = before.elements[f];
            // Numbers above the new count cannot stay.
            const bool numbered = f < after.elements.size() &&
                                  *std::max_element(element.begin(), element.end()) < after.points.rows();
            if (!numbered || !near_inner(before, element, -1e-3)) // the polygon is inside the circle
                continue;
            ++kept;
            EXPECT_EQ(after.elements[f], element);
            for (const Index v : {element[0], element[1], element[2]})
                EXPECT_EQ(after.points.row(v), before.points.row(v));
        }
        EXPECT_GT(kept, 500U);
        EXPECT_NE(after.elements.size(), before.elements.size());
    }
}

TEST(MorphRemeshKeep, LeavesTheWholeMeshWhenAllOfItIsNear)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.su2"), out = folder.file("out.su2");
    write_mesh_data(test::annulus(1, 3, 40, 10), in);
    const test::ProcessResult result =
        test::run_tool("morph-remesh", {in, "-o", out, "--size", "0.1", "--keep", "outer:10"});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(read_mesh_data(out).points, read_mesh_data(in).points);
    EXPECT_EQ(read_mesh_data(out).elements, read_mesh_data(in).elements);
}

TEST(MorphRemeshKeep, RefusesWhatIsNoZoneAndNamesTheMarkerNearestToAMissingOne)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.su2"), out = folder.file("out.su2");
    write_mesh_data(test::annulus(1, 3, 40, 10), in);
    for (const char* text :
         {"inner", "inner:", "inner:-0.1", "inner:nan", "inner:inf", "inner:0.1x", ":0.1", "quad"}) {
        const test::ProcessResult result = test::run_tool("morph-remesh", {in, "-o", out, "--keep", text});
        EXPECT_EQ(result.status, 2) << text;
        EXPECT_NE(result.errors.find("--keep needs 'quads', or a marker and a distance of 0 or more"),
                  std::string::npos)
            << result.errors;
    }
    const test::ProcessResult result = test::run_tool("morph-remesh", {in, "-o", out, "--keep", "iner:0.1"});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.errors.find("did you mean 'inner'"), std::string::npos) << result.errors;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"in.su2"});
}

} // namespace
} // namespace morph
