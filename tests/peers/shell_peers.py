#!/usr/bin/python3
"""meshio, Gmsh and VTK read the Tecplot, Nastran and Abaqus files that we write, and we read theirs.

usage: shell_peers.py BIN_DIR DATA_DIR    (Debian: python3-gmsh, python3-meshio, python3-vtk9)
One line for each check; the exit status is 1 when one fails.
"""
import json
import os
import subprocess
import sys
import tempfile

import gmsh
import meshio
import numpy
from vtkmodules.vtkIOGeometry import vtkTecplotReader

FAILED = []
SIXTEEN_COLUMNS = 1e-14  # what a coordinate loses in a large field
POINTS = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 1 / 3, 0]])
QUADS = numpy.array([[0, 1, 2, 3]])
TRIANGLES = numpy.array([[1, 4, 2]])
LINES = numpy.array([[0, 1], [1, 4]])
SU2 = """NDIME= 2
NELEM= 2
9 0 1 2 3
5 1 4 2
NPOIN= 5
0 0
1 0
1 1
0 1
2 0.3333333333333333
NMARK= 1
MARKER_TAG= wall
MARKER_ELEMS= 2
3 0 1
3 1 4
"""


def check(name, good):
    print(("ok      " if good else "FAILED  ") + name)
    if not good:
        FAILED.append(name)


def convert(*arguments):
    subprocess.run([os.path.join(BIN, "morph-convert"), "--quiet", *arguments], check=True)


def info(path):
    command = [os.path.join(BIN, "morph-convert"), "--info", "--json", "-", path]
    return json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["files"][0]


def cells(mesh, kind):
    blocks = [block.data for block in mesh.cells if block.type == kind]
    return numpy.concatenate(blocks) if blocks else numpy.empty((0, 0), int)


def is_small(found, markers):
    sizes = [marker["edges"] for marker in found["markers"]]
    return (found["vertices"], found["triangles"], found["quads"], sizes) == (5, 1, 1, markers)


def check_meshio_reads(folder, source):
    for name, extension in (("Nastran", ".bdf"), ("Abaqus", ".inp")):
        ours = os.path.join(folder, "ours" + extension)
        convert(source, ours)
        mesh = meshio.read(ours)
        points = numpy.zeros((5, 3))
        points[:, : mesh.points.shape[1]] = mesh.points
        same = (numpy.abs(points - POINTS).max() <= SIXTEEN_COLUMNS
                and (cells(mesh, "quad") == QUADS).all() and (cells(mesh, "triangle") == TRIANGLES).all()
                and (cells(mesh, "line") == LINES).all())
        check(f"meshio reads our {name} file", same)
    ours = os.path.join(folder, "ours.dat")
    convert(source, ours)
    mesh = meshio.read(ours, file_format="tecplot")
    check("meshio reads our Tecplot file",
          (mesh.points[:, :2] == POINTS[:, :2]).all()
          and (cells(mesh, "quad") == [[0, 1, 2, 3], [1, 4, 2, 2]]).all())


def check_we_read_meshio(folder):
    blocks = [("quad", QUADS), ("triangle", TRIANGLES)]
    with_lines = meshio.Mesh(POINTS, blocks + [("line", LINES)])
    for name, extension in (("Nastran", ".bdf"), ("Abaqus", ".inp")):
        theirs = os.path.join(folder, "theirs" + extension)
        with_lines.write(theirs)
        check(f"we read meshio's {name} file", is_small(info(theirs), [2]))
    theirs = os.path.join(folder, "theirs.dat")
    fields = {"p": numpy.arange(5) / 3}
    meshio.Mesh(POINTS, blocks, point_data=fields).write(theirs, file_format="tecplot")
    found = info(theirs)
    check("we read meshio's Tecplot file",
          is_small(found, []) and [field["name"] for field in found["fields"]] == ["p"])


def check_gmsh(folder, source):
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 1)
    ours = os.path.join(folder, "gmsh_reads.bdf")
    convert(source, ours)
    gmsh.open(ours)
    types, tags, _ = gmsh.model.mesh.getElements()
    counts = {int(kind): len(of_kind) for kind, of_kind in zip(types, tags)}
    check("Gmsh reads our Nastran file", counts.get(2) == 1 and counts.get(3) == 1)
    gmsh.clear()
    gmsh.model.occ.addRectangle(0, 0, 0, 1, 1)
    gmsh.model.occ.synchronize()
    gmsh.model.setPhysicalName(1, gmsh.model.addPhysicalGroup(1, [1]), "wall")
    gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, [1]), "domain")
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.3)
    gmsh.model.mesh.generate(2)
    nodes = len(gmsh.model.mesh.getNodes()[0])
    for field_format, name in enumerate(("free", "small", "large")):
        theirs = os.path.join(folder, name + ".bdf")
        gmsh.option.setNumber("Mesh.BdfFieldFormat", field_format)
        gmsh.write(theirs)
        check(f"we read Gmsh's Nastran file in {name} field", info(theirs)["vertices"] == nodes)
    theirs = os.path.join(folder, "gmsh.inp")
    gmsh.write(theirs)
    found = info(theirs)
    check("we read Gmsh's Abaqus file and its sets",
          found["vertices"] == nodes and "wall" in [m["name"] for m in found["markers"]]
          and "domain" in [g["name"] for g in found["groups"]])
    gmsh.finalize()


def check_vtk(folder, source):
    ours = os.path.join(folder, "vtk_reads.dat")
    convert(source, ours)
    reader = vtkTecplotReader()
    reader.SetFileName(ours)
    reader.Update()
    zone = reader.GetOutput().GetBlock(0)
    check("VTK reads our Tecplot file",
          zone is not None and zone.GetNumberOfPoints() == 5 and zone.GetNumberOfCells() == 2
          and zone.GetPoint(4)[:2] == (2.0, numpy.float32(1 / 3)))


def main():
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "small.su2")
        with open(source, "w") as file:
            file.write(SU2)
        check_meshio_reads(folder, source)
        check_we_read_meshio(folder)
        check_gmsh(folder, source)
        check_vtk(folder, source)
    return 1 if FAILED else 0


if __name__ == "__main__":
    BIN = sys.argv[1]
    sys.exit(main())
