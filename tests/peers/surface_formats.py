"""OFF, OBJ, PLY, STL and SU2 beside VTK and meshio: each reads what the other wrote.

    /usr/bin/python3 tests/peers/surface_formats.py BIN_DIR DATA_DIR

Needs python3-meshio and python3-vtk9. Prints a line for each check; fails when one does.
"""

import contextlib
import io
import os
import subprocess
import sys
import tempfile

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

FAILED = []
SINGLE = 1e-6  # relative: VTK and binary STL keep coordinates in single precision


def check(what, good, detail=""):
    print(("ok      " if good else "FAILED  ") + what + ("" if good else ": " + detail))
    if not good:
        FAILED.append(what)


def convert(source, target, *options):
    subprocess.run([os.path.join(sys.argv[1], "morph-convert"), "--quiet", *options, source, target], check=True)


def quietly(read, path):
    with contextlib.redirect_stdout(io.StringIO()):
        return read(path)


def centres(mesh):
    """The centres of all triangles and quads, in their order."""
    return [np.asarray(mesh.points)[cell, :2].mean(axis=0)
            for block in mesh.cells if block.type in ("triangle", "quad") for cell in block.data]


def same_elements(mesh, reference, tolerance):
    a, b = np.array(centres(mesh)), np.array(centres(reference))
    if a.shape != b.shape:
        return False, f"{len(a)} elements, expected {len(b)}"
    worst = np.abs(a - b).max()
    scale = np.abs(b).max()
    return bool(worst <= tolerance * scale), f"centres differ by {worst}"


def meshio_reads(folder, source):
    reference = quietly(meshio.read, source)
    plain = os.path.join(folder, "plain.off")
    convert(source, plain)  # without markers, since meshio refuses PLY files with edges
    for extension in ("su2", "off", "obj", "ply", "stl"):
        for option in ("--ascii", "--binary") if extension in ("ply", "stl") else ("",):
            path = os.path.join(folder, "ours." + extension)
            convert(plain if extension == "ply" else source, path, *filter(None, [option]))
            mesh = quietly(meshio.read, path)
            tolerance = SINGLE if extension == "stl" and option == "--binary" else 1e-15
            check(f"meshio reads our {extension} {option}", *same_elements(mesh, reference, tolerance))


def we_read_meshio(folder, source):
    reference = quietly(meshio.read, source)
    triangles = meshio.Mesh(np.column_stack([reference.points[:, :2], np.zeros(len(reference.points))]),
                            [("triangle", reference.cells_dict["triangle"])])
    for extension, options in (("off", {}), ("obj", {}), ("ply", {"binary": False}), ("ply", {"binary": True}),
                               ("stl", {"binary": False}), ("stl", {"binary": True})):
        path = os.path.join(folder, "theirs." + extension)
        back = os.path.join(folder, "back.ply")
        meshio.write(path, triangles, **options)
        convert(path, back)
        mesh = quietly(meshio.read, back)
        tolerance = SINGLE if extension == "stl" else 1e-12
        check(f"we read meshio's {extension} {options or ''}", *same_elements(mesh, triangles, tolerance))


def vtk_points_and_cells(reader, path):
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    return vtk_to_numpy(data.GetPoints().GetData()), data


def vtk_reads(folder, source):
    reference = quietly(meshio.read, source)
    count = len(centres(reference))
    for extension, reader in (("obj", vtk.vtkOBJReader), ("ply", vtk.vtkPLYReader), ("stl", vtk.vtkSTLReader)):
        for option in ("--ascii", "--binary") if extension != "obj" else ("",):
            path = os.path.join(folder, "ours." + extension)
            convert(source, path, *filter(None, [option]))
            points, data = vtk_points_and_cells(reader(), path)
            check(f"VTK reads the elements of our {extension} {option}", data.GetNumberOfPolys() == count,
                  f"{data.GetNumberOfPolys()}, expected {count}")
            worst = max(abs(points[:, k].min() - reference.points[:, k].min()) +
                        abs(points[:, k].max() - reference.points[:, k].max()) for k in (0, 1))
            check(f"VTK finds the box of our {extension} {option}",
                  worst <= SINGLE * np.abs(reference.points).max(), f"it differs by {worst}")


def groups_in_vtk(folder):
    """A solid for each group: VTK numbers them in its array of tags."""
    path = os.path.join(folder, "groups.obj")
    with open(path, "w", encoding="ascii") as file:
        file.write("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng a\nf 1 2 3\ng b c\nf 1 3 4\n")
    stl = os.path.join(folder, "groups.stl")
    convert(path, stl, "--ascii")
    reader = vtk.vtkSTLReader()
    reader.ScalarTagsOn()
    _, data = vtk_points_and_cells(reader, stl)
    tags = vtk_to_numpy(data.GetCellData().GetScalars())
    check("VTK tells the solids of our STL groups apart", tags[0] != tags[1], str(tags))


def fields_in_meshio(folder, source):
    """A column of a table beside the mesh becomes a property that meshio reads by name."""
    vtu = os.path.join(folder, "field.vtu")
    mesh = quietly(meshio.read, source)
    values = np.sin(np.arange(len(mesh.points)))
    points = np.column_stack([mesh.points[:, :2], np.zeros(len(mesh.points))])
    meshio.write(vtu, meshio.Mesh(points, [("triangle", mesh.cells_dict["triangle"])],
                                  point_data={"pressure": values}))
    for option in ("--ascii", "--binary"):
        ply = os.path.join(folder, "field.ply")
        convert(vtu, ply, option)
        read = quietly(meshio.read, ply)
        check(f"meshio finds the field of our ply {option}",
              "pressure" in read.point_data and np.array_equal(read.point_data["pressure"], values))


def main():
    source = os.path.join(sys.argv[2], "meshes", "naca0012_inv.su2")
    with tempfile.TemporaryDirectory() as folder:
        meshio_reads(folder, source)
        we_read_meshio(folder, source)
        vtk_reads(folder, source)
        groups_in_vtk(folder)
        fields_in_meshio(folder, source)
    return 1 if FAILED else 0


if __name__ == "__main__":
    sys.exit(main())
