#include "libmorph/mesh/chain.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace morph {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// File numbers that are the numbers of the mesh and 100.
Numbering numbering()
{
    Numbering numbers;
    numbers.vertex.resize(50);
    std::iota(numbers.vertex.begin(), numbers.vertex.end(), 100);
    return numbers;
}

std::vector<Chain> chains(const std::vector<std::array<Index, 2>>& edges)
{
    return marker_chains({"wall", edges}, numbering());
}

std::string refusal(const std::vector<std::array<Index, 2>>& edges)
{
    try {
        marker_chain({"wall", edges}, numbering());
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(MarkerChains, StartsAClosedChainAtItsFirstEdge)
{
    const std::vector<Chain> found = chains({{3, 7}, {9, 2}, {2, 3}, {7, 9}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].closed);
    EXPECT_THAT(found[0].vertices, ElementsAre(3, 7, 9, 2));
}

TEST(MarkerChains, FollowsTheDirectionOfMostEdges)
{
    const std::vector<Chain> ring = chains({{3, 7}, {2, 9}, {3, 2}, {9, 7}});
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_TRUE(ring[0].closed);
    EXPECT_THAT(ring[0].vertices, ElementsAre(3, 2, 9, 7));

    const std::vector<Chain> line = chains({{1, 2}, {3, 2}, {4, 3}});
    ASSERT_EQ(line.size(), 1U);
    EXPECT_THAT(line[0].vertices, ElementsAre(4, 3, 2, 1));
}

TEST(MarkerChains, StartsAnOpenChainAtAnEnd)
{
    const std::vector<Chain> found = chains({{5, 6}, {4, 5}, {6, 7}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].closed);
    EXPECT_THAT(found[0].vertices, ElementsAre(4, 5, 6, 7));
    EXPECT_THAT(chains({{8, 3}})[0].vertices, ElementsAre(8, 3));
}

TEST(MarkerChains, KeepsPiecesInTheOrderOfTheirFirstEdges)
{
    const std::vector<Chain> found = chains({{21, 22}, {1, 2}, {20, 21}, {2, 3}, {3, 1}});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_THAT(found[0].vertices, ElementsAre(20, 21, 22));
    EXPECT_FALSE(found[0].closed);
    EXPECT_THAT(found[1].vertices, ElementsAre(1, 2, 3));
    EXPECT_TRUE(found[1].closed);
}

TEST(MarkerChain, RefusesSeveralPieces)
{
    EXPECT_THAT(refusal({{1, 2}, {4, 5}}), HasSubstr("marker 'wall' is in 2 pieces"));
    EXPECT_EQ(refusal({{1, 2}, {2, 3}}), "");
}

TEST(MarkerChain, RefusesABranchAndNamesTheFilesVertex)
{
    EXPECT_THAT(refusal({{1, 2}, {2, 3}, {2, 4}}), HasSubstr("marker 'wall' branches at vertex 102"));
    EXPECT_THAT(refusal({{1, 2}, {2, 3}, {3, 1}, {1, 5}}), HasSubstr("branches at vertex 101"));
}

TEST(MarkerChain, RefusesAnEdgeListedTwice)
{
    EXPECT_THAT(refusal({{1, 2}, {1, 2}}), HasSubstr("lists the edge between vertices 101 and 102 twice"));
    EXPECT_THAT(refusal({{1, 2}, {2, 3}, {3, 2}}),
                HasSubstr("lists the edge between vertices 103 and 102 twice"));
}

TEST(MarkerChain, RefusesAMarkerWithoutEdges)
{
    EXPECT_THAT(refusal({}), HasSubstr("marker 'wall' has no edges"));
}

TEST(MarkerChains, DoesNotDependOnTheOrderOfEdgesBeyondTheStart)
{
    std::vector<std::array<Index, 2>> edges;
    for (Index i = 0; i < 40; ++i)
        edges.push_back({i, (i + 1) % 40});
    const std::vector<Index> expected = chains(edges)[0].vertices;
    std::mt19937 random(1);
    for (int repeat = 0; repeat < 5; ++repeat) {
        std::shuffle(edges.begin(), edges.end(), random);
        const std::vector<Chain> found = chains(edges);
        ASSERT_EQ(found.size(), 1U);
        std::vector<Index> vertices = found[0].vertices;
        EXPECT_EQ(vertices[0], edges[0][0]);
        std::rotate(vertices.begin(), std::find(vertices.begin(), vertices.end(), 0), vertices.end());
        EXPECT_EQ(vertices, expected);
    }
}

TEST(MarkerChains, CoversEveryMarkerOfTheRealMeshes)
{
    for (const std::string& path : test::real_meshes()) {
        const Mesh mesh = build_mesh(read_mesh_data(path));
        for (const Marker& marker : mesh.markers) {
            std::size_t edges = 0;
            for (const Chain& chain : marker_chains(marker, mesh.numbering))
                edges += chain.vertices.size() - (chain.closed ? 0 : 1);
            EXPECT_EQ(edges, marker.edges.size()) << path << " " << marker.name;
        }
    }
}

} // namespace

} // namespace morph
