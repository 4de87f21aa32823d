MeshVersionFormatted 2
Dimension 2
SolAtVertices 4
4 1 2 1 1
0 0.5 1 1 2
1 1.5 2 1 2
2 2.5 3 1 2
3 3.5 4 1 nan
SolAtTriangles 1 1 3
1 2 3
SolAtQuadrilaterals 1 1 3
-1 -2 -3
End
# vertex field 1 = p
# vertex field 3 to 4 = pair
