#include "formats/medit/keywords.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

struct Code {
    std::int32_t number;
    std::string_view keyword;
};

/// Those that are read, and those likely to be met, whose names serve in warnings.
constexpr std::array<Code, 62> kCodes{{
    {3, "Dimension"},
    {4, "Vertices"},
    {5, "Edges"},
    {6, "Triangles"},
    {7, "Quadrilaterals"},
    {8, "Tetrahedra"},
    {9, "Prisms"},
    {10, "Hexahedra"},
    {13, "Corners"},
    {14, "Ridges"},
    {15, "RequiredVertices"},
    {16, "RequiredEdges"},
    {17, "RequiredTriangles"},
    {18, "RequiredQuadrilaterals"},
    {19, "TangentAtEdgeVertices"},
    {20, "NormalAtVertices"},
    {21, "NormalAtTriangleVertices"},
    {22, "NormalAtQuadrilateralVertices"},
    {23, "AngleOfCornerBound"},
    {24, "TrianglesP2"},
    {25, "EdgesP2"},
    {26, "SolAtPyramids"},
    {27, "QuadrilateralsQ2"},
    {30, "TetrahedraP2"},
    {33, "HexahedraQ2"},
    {40, "VerticesOnGeometricVertices"},
    {41, "VerticesOnGeometricEdges"},
    {42, "VerticesOnGeometricTriangles"},
    {46, "Polyhedra"},
    {47, "Polygons"},
    {49, "Pyramids"},
    {50, "BoundingBox"},
    {54, "End"},
    {59, "Tangents"},
    {60, "Normals"},
    {61, "TangentAtVertices"},
    {62, "SolAtVertices"},
    {63, "SolAtEdges"},
    {64, "SolAtTriangles"},
    {65, "SolAtQuadrilaterals"},
    {66, "SolAtTetrahedra"},
    {67, "SolAtPrisms"},
    {68, "SolAtHexahedra"},
    {77, "Iterations"},
    {78, "Time"},
    {81, "Comments"},
    {86, "PrismsP2"},
    {87, "PyramidsP2"},
    {88, "QuadrilateralsQ3"},
    {89, "QuadrilateralsQ4"},
    {90, "TrianglesP3"},
    {91, "TrianglesP4"},
    {92, "EdgesP3"},
    {93, "EdgesP4"},
    {96, "TetrahedraP3"},
    {97, "TetrahedraP4"},
    {98, "HexahedraQ3"},
    {99, "HexahedraQ4"},
    {100, "PyramidsP3"},
    {101, "PyramidsP4"},
    {102, "PrismsP3"},
    {103, "PrismsP4"},
}};

constexpr std::array<MeditShape, 8> kShapes{{
    {"Edges", "edge", 2},
    {"Triangles", "triangle", 3},
    {"Quadrilaterals", "quadrilateral", 4},
    {"Tetrahedra", "tetrahedron", 4, VolumeShape::tetrahedron},
    {"Pyramids", "pyramid", 5, VolumeShape::pyramid},
    {"Prisms", "prism", 6, VolumeShape::prism},
    {"Hexahedra", "hexahedron", 8, VolumeShape::hexahedron},
    {"Hexaedra", "hexahedron", 8, VolumeShape::hexahedron}, // as old files spell it
}};

} // namespace

const MeditShape* find_medit_shape(std::string_view keyword)
{
    const auto* const found = std::find_if(kShapes.begin(), kShapes.end(),
                                           [&](const MeditShape& shape) { return shape.keyword == keyword; });
    return found == kShapes.end() ? nullptr : found;
}

const std::vector<MeditList>& medit_lists()
{
    static const std::vector<MeditList> lists{{"Corners", MeditListed::vertices},
                                              {"RequiredVertices", MeditListed::vertices},
                                              {"Ridges", MeditListed::edges},
                                              {"RequiredEdges", MeditListed::edges},
                                              {"RequiredTriangles", MeditListed::triangles},
                                              {"RequiredQuadrilaterals", MeditListed::quads}};
    return lists;
}

bool is_unsupported_medit_shape(std::string_view keyword)
{
    if (keyword == "Polygons" || keyword == "Polyhedra")
        return true;
    if (keyword.size() < 3 || keyword.back() < '2' || keyword.back() > '4')
        return false;
    const char family = keyword[keyword.size() - 2];
    return (family == 'P' || family == 'Q') && find_medit_shape(keyword.substr(0, keyword.size() - 2));
}

std::int32_t medit_code(std::string_view keyword)
{
    const auto* const found =
        std::find_if(kCodes.begin(), kCodes.end(), [&](const Code& code) { return code.keyword == keyword; });
    return found == kCodes.end() ? 0 : found->number;
}

std::string medit_keyword(std::int32_t code)
{
    const auto* const found =
        std::find_if(kCodes.begin(), kCodes.end(), [&](const Code& row) { return row.number == code; });
    return found == kCodes.end() ? "number " + std::to_string(code) : std::string(found->keyword);
}

} // namespace morph
