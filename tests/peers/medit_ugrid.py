"""MEDIT and UGRID against meshio and Gmsh: medit_ugrid.py BIN_DIR DATA_DIR

One line for each check; the exit status is 1 when a check fails.
"""

import os
import subprocess
import sys
import tempfile

import meshio
import numpy

BIN, DATA = sys.argv[1:3]
SOURCE = os.path.join(DATA, "meshes", "naca0012_lam_hybrid.su2")
failed = False


def check(what, good):
    global failed
    failed = failed or not good
    print(("good: " if good else "BAD:  ") + what)


def run(*command):
    return subprocess.run(command, capture_output=True, text=True)


def convert(*arguments):
    return run(os.path.join(BIN, "morph-convert"), *arguments).returncode == 0


def blocks(mesh, kinds):
    found = {k: [c.data for c in mesh.cells if c.type == k] for k in kinds}
    return {k: numpy.concatenate(data) for k, data in found.items() if data}


def same(a, b, kinds):
    first, second = blocks(a, kinds), blocks(b, kinds)
    real = numpy.result_type(numpy.float32 if numpy.float32 in (a.points.dtype, b.points.dtype) else float)
    return numpy.array_equal(a.points[:, :2].astype(real), b.points[:, :2].astype(real)) and all(
        numpy.array_equal(first.get(k), second.get(k)) for k in kinds
    )


with tempfile.TemporaryDirectory() as folder:
    at = lambda name: os.path.join(folder, name)
    source = meshio.read(SOURCE)
    faces = ["triangle", "quad"]
    for name, kinds in [("a.mesh", faces + ["line"]), ("a.meshb", faces + ["line"])] + [
        (f"a{layout}.ugrid", faces) for layout in ("", ".b8", ".lb8", ".r8", ".lr8", ".b8l", ".lb8l")
    ]:
        check(f"we write {name}", convert(SOURCE, at(name)))
        theirs = meshio.read(at(name))
        check(f"meshio reads our {name}", same(source, theirs, kinds))
        if "ugrid" in name:  # meshio reads text in single precision, and its writer fails on cell data
            points = numpy.pad(source.points[:, :2], ((0, 0), (0, 1)))
            theirs = meshio.Mesh(points, list(blocks(theirs, kinds).items()))
        meshio.write(at("m_" + name), theirs)
        check(f"we read meshio's {name}", convert(at("m_" + name), at("back.su2")))
        check(f"{name} is the same after meshio", same(source, meshio.read(at("back.su2")), kinds))
    geo = at("g.geo")
    with open(geo, "w") as file:
        file.write(
            "Point(1)={0,0,0,.4}; Point(2)={1,0,0,.4}; Point(3)={1,1,0,.4};"
            "Point(4)={0,1,0,.4}; Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1};"
            "Curve Loop(1)={1,2,3,4}; Plane Surface(1)={1};"
            "Physical Curve(7)={1,3}; Physical Curve(8)={2,4}; Physical Surface(9)={1};\n"
        )
    check("Gmsh writes MEDIT", run("gmsh", "-2", geo, "-o", at("g.mesh"), "-v", "0").returncode == 0)
    check("we read Gmsh's MEDIT", convert(at("g.mesh"), at("h.mesh")))
    check(
        "Gmsh reads our MEDIT", run("gmsh", at("h.mesh"), "-save", "-o", at("h2.mesh"), "-v", "1").returncode == 0
    )
    # Gmsh numbers the vertices anew by the entities they are on.
    before, after = meshio.read(at("g.mesh")), meshio.read(at("h2.mesh"))
    corners = lambda mesh, kind: sorted(
        sorted(map(tuple, mesh.points[row, :2].tolist())) for row in blocks(mesh, [kind])[kind]
    )
    for kind in ["triangle", "line"]:
        good = len(corners(before, kind)) > 0 and corners(before, kind) == corners(after, kind)
        check(f"each {kind} is the same after Gmsh", good)

sys.exit(failed)
