#!/usr/bin/python3
"""Gmsh and meshio read the .msh files that we write, and we read theirs.

usage: gmsh_peers.py BIN_DIR DATA_DIR    (Debian: python3-gmsh, python3-meshio)
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

FAILED = []
VERSIONS = [(2.2, 0), (2.2, 1), (4.0, 0), (4.1, 0), (4.1, 1)]  # Gmsh 4.8 writes 4.0 as text only


def check(name, good):
    print(("ok      " if good else "FAILED  ") + name)
    if not good:
        FAILED.append(name)


def convert(*arguments):
    subprocess.run([os.path.join(BIN, "morph-convert"), "--quiet", *arguments], check=True)


def info(path):
    """What morph-convert says of a file: counts, and sizes of markers and groups by name."""
    command = [os.path.join(BIN, "morph-convert"), "--info", "--json", "-", path]
    found = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["files"][0]
    return {
        "vertices": found["vertices"],
        "triangles": found["triangles"],
        "quads": found["quads"],
        "markers": {m["name"]: m["edges"] for m in found["markers"]},
        "groups": {g["name"]: g["elements"] for g in found["groups"]},
    }


def read_su2(path):
    """Points, corners of the elements and edges of each marker of an SU2 file."""
    points, elements, markers, rows = [], [], {}, None
    for line in open(path):
        words = line.split("%")[0].replace("=", "= ").split()
        if not words:
            continue
        if words[0] in ("NELEM=", "NPOIN="):
            rows = elements if words[0] == "NELEM=" else points
        elif words[0] == "MARKER_TAG=":
            rows = markers.setdefault(words[1], [])
        elif words[0][0] in "-.0123456789":
            rows.append(words)
    corners = {5: 3, 9: 4, 3: 2}
    numbers = lambda row: [int(w) for w in row[1:1 + corners[int(row[0])]]]
    return (numpy.array([[float(w) for w in p[:2]] for p in points]),
            [numbers(e) for e in elements],
            {name: [numbers(e) for e in edges] for name, edges in markers.items()})


def places(points, cells):
    """Cells by where their corners are, whatever the numbering; Gmsh's text has 16 digits."""
    return sorted(tuple(sorted(tuple(round(x, 9) for x in points[v][:2]) for v in cell)) for cell in cells)


def gmsh_cells(dimension, entities):
    """Node tags of the elements of these entities."""
    cells = []
    for entity in entities:
        types, _, nodes = gmsh.model.mesh.getElements(dimension, entity)
        for kind, flat in zip(types, nodes):
            size = {1: 2, 2: 3, 3: 4}.get(kind, 0)
            cells += [list(flat[i:i + size]) for i in range(0, len(flat), size)] if size else []
    return cells


def gmsh_reads_ours(source, path):
    """Everything of a planar SU2 mesh is in the Gmsh file that was made of it."""
    points, elements, markers = read_su2(source)
    gmsh.clear()
    gmsh.open(path)
    tags, flat, _ = gmsh.model.mesh.getNodes()
    place = {tag: tuple(flat[3 * i:3 * i + 2]) for i, tag in enumerate(tags)}
    ours = {i: tuple(p) for i, p in enumerate(points)}
    found = {gmsh.model.getPhysicalName(d, t): gmsh_cells(d, gmsh.model.getEntitiesForPhysicalGroup(d, t))
             for d, t in gmsh.model.getPhysicalGroups(1)}
    faces = gmsh_cells(2, [t for _, t in gmsh.model.getEntities(2)])
    return (places(place, faces) == places(ours, elements) and set(found) == set(markers)
            and all(places(place, found[m]) == places(ours, markers[m]) for m in markers))


def through_gmsh(folder):
    for name in ("naca0012_lam_hybrid", "triadapt"):
        source = os.path.join(DATA, "meshes", name + ".su2")
        for form, flag in (("gmsh", "--binary"), ("gmsh", "--ascii"), ("gmsh22", "--binary"), ("gmsh22", "--ascii")):
            path = os.path.join(folder, "ours.msh")
            convert(source, path, "--to", form, flag)
            check(f"Gmsh reads {name} as {form} {flag}", gmsh_reads_ours(source, path))
        for version, binary in VERSIONS:
            theirs, back = os.path.join(folder, "theirs.msh"), os.path.join(folder, "back.su2")
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(theirs)
            convert(theirs, back)
            a, b = read_su2(source), read_su2(back)
            same = places(a[0], a[1]) == places(b[0], b[1]) and set(a[2]) == set(b[2]) and all(
                places(a[0], a[2][m]) == places(b[0], b[2][m]) for m in a[2])
            check(f"we read {name} that Gmsh wrote as {version} {'binary' if binary else 'text'}", same)


def unit_square(size):
    """A square with physical groups of its sides (one backwards) and periodic sides."""
    gmsh.clear()
    geo = gmsh.model.geo
    corners = [geo.addPoint(x, y, 0, size) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    sides = [geo.addLine(corners[i], corners[(i + 1) % 4]) for i in range(4)]
    face = geo.addPlaneSurface([geo.addCurveLoop(sides)])
    geo.synchronize()
    for name, entities in (("walls, low & up", [sides[0], -sides[2]]), ("outlet", [sides[1]])):
        gmsh.model.setPhysicalName(1, gmsh.model.addPhysicalGroup(1, entities), name)
    for name in ("gas", "all"):
        gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, [face]), name)
    gmsh.model.mesh.setPeriodic(1, [sides[1]], [sides[3]], [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
    gmsh.model.mesh.generate(2)


def made_by_gmsh(folder):
    unit_square(0.3)
    faces = len(gmsh_cells(2, [1]))
    sides = [len(gmsh_cells(1, [i])) for i in range(1, 5)]
    expected = {
        "vertices": len(gmsh.model.mesh.getNodes()[0]),
        "triangles": faces,
        "quads": 0,
        "markers": {"walls, low & up": sides[0] + sides[2], "outlet": sides[1]},
        "groups": {"gas": faces, "all": faces},
    }
    for partitions in (0, 3):
        if partitions:
            gmsh.model.mesh.partition(partitions)
        for version, binary in VERSIONS:
            for parametric in (0,) if partitions else (0, 1):
                path = os.path.join(folder, "square.msh")
                gmsh.option.setNumber("Mesh.MshFileVersion", version)
                gmsh.option.setNumber("Mesh.Binary", binary)
                gmsh.option.setNumber("Mesh.SaveParametric", parametric)
                gmsh.write(path)
                check(f"we read a square of Gmsh, {version} {'binary' if binary else 'text'}"
                      f"{', parametric' if parametric else ''}{', partitioned' if partitions else ''}",
                      info(path) == expected)
    gmsh.option.setNumber("Mesh.SaveParametric", 0)


def volumes_of_gmsh(folder):
    """A box of tetrahedra, and of hexahedra and prisms: the boundary has the area 6."""
    for kind in ("tetrahedra", "hexahedra", "prisms"):
        gmsh.clear()
        geo = gmsh.model.geo
        corners = [geo.addPoint(x, y, 0, 0.5) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        face = geo.addPlaneSurface([geo.addCurveLoop([geo.addLine(corners[i], corners[(i + 1) % 4])
                                                      for i in range(4)])])
        layers = [] if kind == "tetrahedra" else [2]
        above = geo.extrude([(2, face)], 0, 0, 1, layers, recombine=bool(layers))
        if kind == "hexahedra":
            geo.mesh.setTransfiniteSurface(face)
            geo.mesh.setRecombine(2, face)
        geo.synchronize()
        gmsh.model.setPhysicalName(3, gmsh.model.addPhysicalGroup(3, [1]), "body")
        gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, [above[0][1]]), "top")
        gmsh.model.mesh.generate(3)
        for version, binary in VERSIONS:
            path, surface = os.path.join(folder, "box.msh"), os.path.join(folder, "box.obj")
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(path)
            convert("--surface", "--triangulate", path, surface)
            mesh = meshio.read(surface)
            cells = numpy.concatenate([block.data for block in mesh.cells])
            a, b, c = (mesh.points[cells[:, k]] for k in range(3))
            normals = numpy.cross(b - a, c - a) / 2
            volume = numpy.einsum("ij,ij->", a, normals) / 3
            area = numpy.linalg.norm(normals, axis=1).sum()
            check(f"the boundary of {kind} of Gmsh, {version} {'binary' if binary else 'text'}",
                  abs(area - 6) < 1e-12 and abs(volume - 1) < 1e-12)


def data_of_gmsh(folder):
    """Fields go to Gmsh and come back."""
    unit_square(0.4)
    path, with_data, back = (os.path.join(folder, n) for n in ("mesh.msh", "data.msh", "back.msh"))
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.write(path)
    tags, flat, _ = gmsh.model.mesh.getNodes()
    points = numpy.array(flat).reshape(-1, 3)
    values = numpy.sin(points @ numpy.array([[1, 2, 3], [4, 5, 6], [7, 8, 9]]))
    view = gmsh.view.add("velocity & more")
    gmsh.view.addModelData(view, 0, gmsh.model.getCurrent(), "NodeData", tags, values, 0, 3)
    for binary in (0, 1):
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.option.setNumber("PostProcessing.SaveMesh", 1)
        gmsh.view.write(view, with_data)
        convert(with_data, back)
        mesh = meshio.read(back)
        read = mesh.point_data["velocity & more"]
        good = len(read) == len(points) and all(
            numpy.abs(v - values[numpy.linalg.norm(points - p, axis=1).argmin()]).max() < 1e-14
            for p, v in zip(mesh.points, read))
        check(f"data that Gmsh wrote as {'binary' if binary else 'text'}", good)
        gmsh.open(back)
        views = gmsh.view.getTags()
        kind, _, ours, _, _ = gmsh.view.getModelData(views[-1], 0)
        check("Gmsh reads them from our file", kind == "NodeData" and len(ours) == len(points))


def through_meshio(folder):
    points = numpy.random.default_rng(1).random((6, 3))
    cells = [("line", numpy.array([[0, 1], [1, 2]])), ("triangle", numpy.array([[0, 1, 4], [0, 4, 3]])),
             ("quad", numpy.array([[1, 2, 5, 4]]))]
    physical = [numpy.array([1, 1]), numpy.array([2, 2]), numpy.array([3])]
    mesh = meshio.Mesh(points, cells, point_data={"T": points[:, 0], "v": points @ points.T[:3, :3]},
                       cell_data={"gmsh:physical": physical, "gmsh:geometrical": physical,
                                  "q": [numpy.array([1.5, 2.5]), numpy.array([3.5, 4.5]), numpy.array([5.5])]},
                       field_data={"wall": numpy.array([1, 1]), "front": numpy.array([2, 2]),
                                   "back": numpy.array([3, 2])})
    path, back = os.path.join(folder, "meshio.msh"), os.path.join(folder, "back.msh")
    for form, binary in (("gmsh22", False), ("gmsh22", True), ("gmsh", False), ("gmsh", True)):
        if form == "gmsh":
            mesh.point_data["gmsh:dim_tags"] = numpy.tile([2, 1], (6, 1))
        meshio.write(path, mesh, file_format=form, binary=binary)
        for to, flag in (("gmsh", "--binary"), ("gmsh22", "--ascii")):
            convert(path, back, "--to", to, flag)
            read = meshio.read(back)
            faces = {c.type: c.data for c in read.cells}
            good = (numpy.array_equal(read.points, points) and numpy.array_equal(faces["quad"], cells[2][1])
                    and numpy.array_equal(faces["triangle"], cells[1][1])
                    and numpy.array_equal(faces["line"], cells[0][1])
                    and all(numpy.array_equal(read.point_data[n].squeeze(), mesh.point_data[n]) for n in "Tv"))
            check(f"meshio's {form} {'binary' if binary else 'text'}, through us as {to} {flag}, in meshio", good)


def main():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    with tempfile.TemporaryDirectory() as folder:
        through_gmsh(folder)
        made_by_gmsh(folder)
        volumes_of_gmsh(folder)
        data_of_gmsh(folder)
        through_meshio(folder)
    gmsh.finalize()
    return 1 if FAILED else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    BIN, DATA = sys.argv[1:]
    sys.exit(main())
