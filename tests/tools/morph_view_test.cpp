#include "formats/formats.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace morph {
namespace {

using test::ProcessResult;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

ProcessResult view(const std::vector<std::string>& arguments)
{
    return test::run_tool("morph-view", arguments);
}

std::string naca()
{
    return test::data_path("meshes/naca0012_inv.su2");
}

/// Squares in a row of ten, some of them folded over by moving their upper right vertex below the lower left.
MeshData square_with_folds(int folds)
{
    MeshData mesh = test::quad_square(10);
    mesh.markers.clear();
    for (int i = 0; i < folds;
         ++i) { // corner squares of far apart 3 x 3 blocks: each fold tangles only its own
        const Index vertex = (3 * (i / 3) + 2) * 11 + 3 * (i % 3) + 2;
        mesh.points.row(vertex) = mesh.points.row(vertex - 12);
        mesh.points(vertex, 0) -= 0.01;
        mesh.points(vertex, 1) -= 0.01;
    }
    return mesh;
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = 256 * value + static_cast<unsigned char>(bytes.at(at + i));
    return value;
}

std::size_t count(const std::string& text, std::string_view what)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++found;
    return found;
}

/// Filled shapes in the red that only inverted elements have (cairo writes it in percent).
std::size_t red_shapes(const std::string& svg)
{
    return count(svg, "fill:rgb(87.8");
}

/// Whether every tag of an XML text is closed in order.
bool is_well_formed(const std::string& text)
{
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos)
            return false;
        const std::string tag = text.substr(at + 1, end - at - 1);
        if (tag[0] == '?' || tag[0] == '!' || tag.back() == '/')
            continue;
        if (tag[0] != '/')
            open.push_back(tag.substr(0, tag.find_first_of(" \n")));
        else if (open.empty() || open.back() != tag.substr(1))
            return false;
        else
            open.pop_back();
    }
    return open.empty();
}

TEST(MorphView, DrawsAPngOfTheWidthAskedFor)
{
    const TemporaryFolder folder;
    const ProcessResult result = view({naca(), "-o", folder.file("naca.png"), "--width", "700"});
    ASSERT_EQ(result.status, 0) << result.errors;
    const std::string png = test::read_text(folder.file("naca.png"));
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(big_endian(png, 16), 700U);
    EXPECT_GT(big_endian(png, 20), 300U);
    EXPECT_THAT(result.output, HasSubstr("10216 elements, 0 inverted"));
}

TEST(MorphView, DrawsEveryRealMesh)
{
    const TemporaryFolder folder;
    for (const std::string& mesh : test::real_meshes())
        EXPECT_EQ(view({mesh, "-o", folder.file("mesh.png"), "--width", "400"}).status, 0) << mesh;
}

TEST(MorphView, GivesTheSameBytesForAnyNumberOfThreads)
{
    const TemporaryFolder folder;
    ASSERT_EQ(view({naca(), "-o", folder.file("1.png"), "--width", "400", "--threads", "1"}).status, 0);
    ASSERT_EQ(view({naca(), "-o", folder.file("3.png"), "--width", "400", "--threads", "3"}).status, 0);
    EXPECT_EQ(test::read_text(folder.file("1.png")), test::read_text(folder.file("3.png")));
}

TEST(MorphView, RefusesAnSvgThatNoViewerCouldOpen)
{
    const TemporaryFolder folder;
    write_mesh_data(test::quad_square(450), folder.file("fine.su2")); // 202500 quads
    const ProcessResult result = view({folder.file("fine.su2"), "-o", folder.file("fine.svg")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("202500 elements"));
    EXPECT_THAT(result.errors, HasSubstr("write a .png, or zoom in"));
    EXPECT_THAT(folder.names(), ElementsAre("fine.su2"));
    EXPECT_EQ(view({folder.file("fine.su2"), "-o", folder.file("fine.svg"), "--zoom", "0,0,0.1,0.1"}).status,
              0);
}

TEST(MorphView, PaintsEachInvertedElementRedInAnSvg)
{
    for (const int folds : {0, 1, 5}) {
        const TemporaryFolder folder;
        write_mesh_data(square_with_folds(folds), folder.file("mesh.su2"));
        const auto counted = test::run_tool("morph-quality", {folder.file("mesh.su2"), "--json", "-"});
        const auto inverted = nlohmann::json::parse(counted.output)["inverted"].get<std::size_t>();
        EXPECT_EQ(inverted > 0, folds > 0);

        const ProcessResult result = view({folder.file("mesh.su2"), "-o", folder.file("mesh.svg"), "--zoom",
                                           "-0.1,-0.1,1.1,1.1", "--json", folder.file("view.json")});
        ASSERT_EQ(result.status, 0) << result.errors;
        const std::string svg = test::read_text(folder.file("mesh.svg"));
        EXPECT_TRUE(is_well_formed(svg));
        // Apart from the elements: the swatch of the legend, and each letter of "n inverted", which are glyphs.
        const std::size_t swatch = inverted > 0 ? 1 : 0;
        EXPECT_EQ(count(svg, "stroke:rgb(87.8"), inverted);
        EXPECT_GE(red_shapes(svg), inverted + swatch);
        const auto report = nlohmann::json::parse(test::read_text(folder.file("view.json")));
        EXPECT_EQ(report["meshes"][0]["inverted"], inverted);
    }
}

TEST(MorphView, RingsInvertedElementsTooSmallToBeSeen)
{
    const TemporaryFolder folder;
    MeshData mesh = read_mesh_data(naca());
    const Element& first = mesh.elements[0];
    mesh.points.row(first[0]).swap(mesh.points.row(first[1])); // turns this one and tangles its neighbours
    write_mesh_data(mesh, folder.file("mesh.su2"));
    ASSERT_EQ(view({folder.file("mesh.su2"), "-o", folder.file("far.svg"), "--zoom", "-20,-20,20,20"}).status,
              0);
    const auto counted = test::run_tool("morph-quality", {folder.file("mesh.su2"), "--json", "-"});
    const auto inverted = nlohmann::json::parse(counted.output)["inverted"].get<std::size_t>();
    ASSERT_GT(inverted, 0U);
    EXPECT_GT(count(test::read_text(folder.file("far.svg")), "stroke:rgb(87.8"), inverted);
}

TEST(MorphView, PutsTwoMeshesSideBySide)
{
    const TemporaryFolder folder;
    write_mesh_data(test::quad_square(10), folder.file("before.su2"));
    write_mesh_data(square_with_folds(2), folder.file("after.su2"));
    const ProcessResult result =
        view({folder.file("before.su2"), folder.file("after.su2"), "-o", folder.file("both.png")});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("before.su2: 100 elements, 0 inverted"));
    EXPECT_THAT(result.output, HasSubstr("after.su2: 100 elements, "));
}

TEST(MorphView, ColoursByNodalAndElementFields)
{
    const TemporaryFolder folder;
    MeshData mesh = test::uneven_square(6);
    mesh.fields.push_back({"height", FieldLocation::vertex, mesh.points.col(1)});
    mesh.fields.push_back({"velocity", FieldLocation::vertex, mesh.points});
    Matrix holes = Matrix::Ones(72, 1);
    holes(3, 0) = 2;
    mesh.fields.push_back({"cell", FieldLocation::element, holes});
    write_mesh_data(mesh, folder.file("mesh.vtu"));
    for (const char* field : {"height", "velocity", "cell", "scaled_jacobian"}) {
        const ProcessResult result =
            view({folder.file("mesh.vtu"), "-o", folder.file("mesh.svg"), "--field", field, "--no-edges"});
        ASSERT_EQ(result.status, 0) << result.errors;
        const std::string svg = test::read_text(folder.file("mesh.svg"));
        EXPECT_TRUE(is_well_formed(svg));
        EXPECT_THAT(svg, HasSubstr("fill:rgb(26.6")) << "the lowest value is dark violet: " << field;
    }
    const ProcessResult unknown =
        view({folder.file("mesh.vtu"), "-o", folder.file("other.svg"), "--field", "hight"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_THAT(unknown.errors, HasSubstr("height, velocity, cell"));
    EXPECT_THAT(unknown.errors, HasSubstr("did you mean 'height'?"));
    EXPECT_THAT(folder.names(), ElementsAre("mesh.svg", "mesh.vtu"));
}

TEST(MorphView, DrawsASurfaceInSpace)
{
    const TemporaryFolder folder;
    MeshData dome = test::quad_square(12);
    dome.dimension = 3;
    for (Index v = 0; v < dome.points.rows(); ++v)
        dome.points(v, 2) = dome.points(v, 0) * (1 - dome.points(v, 0)) * dome.points(v, 1);
    write_mesh_data(dome, folder.file("dome.vtu"));
    const ProcessResult result = view({folder.file("dome.vtu"), "-o", folder.file("dome.png")});
    EXPECT_EQ(result.status, 0) << result.errors;
    const ProcessResult zoomed =
        view({folder.file("dome.vtu"), "-o", folder.file("zoomed.png"), "--zoom", "0,0,1,1"});
    EXPECT_EQ(zoomed.status, 1);
    EXPECT_THAT(zoomed.errors, HasSubstr("--zoom is for planar meshes"));
}

TEST(MorphView, SurvivesNamesThatAreNoText)
{
    const TemporaryFolder folder;
    write_mesh_data(test::uneven_square(2), folder.file("plain.su2"));
    std::string text = test::read_text(folder.file("plain.su2"));
    text.replace(text.find("bottom"), 6, "\xff\xfe\xc3(");
    text.replace(text.find("right"), 5, std::string(5000, 'x'));
    folder.write("mesh.su2", text);
    const ProcessResult result =
        view({folder.file("mesh.su2"), "-o", folder.file("mesh.svg"), "--title", "\xe2\x82"});
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_TRUE(is_well_formed(test::read_text(folder.file("mesh.svg"))));
}

TEST(MorphView, HoldsCoordinatesFarOutsideThePicture)
{
    const TemporaryFolder folder;
    const ProcessResult result =
        view({naca(), "-o", folder.file("tip.png"), "--zoom", "0.999999,-0.000001,1.000001,0.000001"});
    EXPECT_EQ(result.status, 0) << result.errors;
}

TEST(MorphView, RefusesWhatItCannotDoAndLeavesNoFile)
{
    const TemporaryFolder folder;
    const std::string broken = folder.write("broken.su2", "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 1\n0 0\n");
    const std::string single = folder.write("case.toml", "[mesh]\n");
    const std::string out = folder.file("out.png");
    struct Refusal {
        std::vector<std::string> arguments;
        int status;
        std::string message;
    };
    const std::vector<Refusal> refusals{
        {{naca(), "-o", folder.file("out.gif")}, 1, "written as .png or .svg, not '.gif'"},
        {{naca(), "-o", folder.file("out")}, 1, "written as .png or .svg"},
        {{naca(), "-o", folder.file("no/folder/out.png")}, 1, "out.png"},
        {{naca()}, 2, "--out"},
        {{naca(), naca(), naca(), "-o", out}, 2, "At Most 2 required but received 3"},
        {{naca(), "-o", out, "--field", "pressure"},
         1,
         "field 'pressure' is not in the mesh, which has no fields"},
        {{naca(), "-o", out, "--zoom", "0,0,1"}, 2, "--zoom needs"},
        {{naca(), "-o", out, "--zoom", "0,0,1,1,2"}, 2, "--zoom needs"},
        {{naca(), "-o", out, "--zoom", "0,0,0,1"}, 2, "--zoom needs"},
        {{naca(), "-o", out, "--zoom", "0,0,nan,1"}, 2, "--zoom needs"},
        {{naca(), "-o", out, "--zoom", "0,0,1e999,1"}, 2, "--zoom needs"},
        {{naca(), "-o", out, "--zoom", "0,0,1,1x"}, 2, "--zoom needs"},
        {{naca(), "-o", out, "--zoom", "100,100,101,101"},
         1,
         "shows no part of the mesh, which spans x -20 to 20"},
        {{naca(), "-o", out, "--width", "10"}, 2, "--width"},
        {{naca(), "-o", out, "--width", "1000000"}, 2, "--width"},
        {{broken, "-o", out}, 1, "broken.su2"},
        {{folder.path(), "-o", out, "--from", "su2"}, 1, folder.path()},
        {{single, "-o", out}, 1, "case files cannot be shown, only mesh files"},
        {{folder.file("missing.su2"), "-o", out}, 1, "missing.su2"},
    };
    for (const Refusal& refusal : refusals) {
        const ProcessResult result = view(refusal.arguments);
        EXPECT_EQ(result.status, refusal.status) << refusal.message << result.errors;
        EXPECT_THAT(result.errors, HasSubstr(refusal.message));
        EXPECT_EQ(count(result.errors, "\n"), 1U) << result.errors;
        EXPECT_THAT(folder.names(), ElementsAre("broken.su2", "case.toml"));
    }
}

} // namespace
} // namespace morph
