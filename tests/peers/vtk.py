"""VTK's files against VTK and meshio: vtk.py BIN_DIR DATA_DIR

One line for each check; the exit status is 1 when a check fails.
"""

import os
import re
import subprocess
import sys
import tempfile

import meshio
from vtkmodules import vtkIOLegacy, vtkIOXML
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

BIN, DATA = sys.argv[1:3]
MESHES = ["naca0012_inv", "naca0012_lam_hybrid", "wedge"]
CODINGS = {".vtu": ["--binary", "--ascii", "--compress"],
           ".vtp": ["--binary", "--ascii", "--compress"],
           ".vtk": ["--binary", "--ascii"]}
failed = False

# Two wedges make a cube, with a pyramid on it, whose base matches no face of the wedges.
VOLUME = """# vtk DataFile Version 3.0
by hand
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 9 double
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 0.5 0.5 2
CELLS 3 20
6 0 1 2 4 5 6
6 0 2 3 4 6 7
5 4 5 6 7 8
CELL_TYPES 3
13 13 14
"""


def check(what, good):
    global failed
    failed = failed or not good
    print(("good: " if good else "BAD:  ") + what)


def convert(*arguments):
    result = subprocess.run([os.path.join(BIN, "morph-convert"), *arguments], capture_output=True, text=True)
    if result.returncode != 0:
        check(" ".join(arguments) + ": " + result.stderr.strip(), False)
    return result.returncode == 0


def reader_of(path):
    if path.endswith(".vtk"):
        return vtkIOLegacy.vtkUnstructuredGridReader()
    return vtkIOXML.vtkXMLPolyDataReader() if path.endswith(".vtp") else vtkIOXML.vtkXMLUnstructuredGridReader()


def vtk_read(path):
    reader = reader_of(path)
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def writers(grid, folder, extension):
    """VTK's writers of that extension in every coding, each with the name of its file."""
    if extension == ".vtk":
        writer = vtkIOLegacy.vtkUnstructuredGridWriter()
        writer.SetFileTypeToBinary()
        yield writer, os.path.join(folder, "legacy.vtk")
        return
    kind = vtkIOXML.vtkXMLPolyDataWriter if extension == ".vtp" else vtkIOXML.vtkXMLUnstructuredGridWriter
    for mode in ["Ascii", "Binary", "Appended"]:
        for compressor in ["None", "ZLib", "LZ4"]:
            for big in [False, True]:
                writer = kind()
                getattr(writer, "SetDataModeTo" + mode)()
                getattr(writer, "SetCompressorTypeTo" + compressor)()
                writer.SetEncodeAppendedData(big)
                if big:
                    writer.SetByteOrderToBigEndian()
                    writer.SetHeaderTypeToUInt64()
                name = f"{mode}_{compressor}_{'big' if big else 'little'}{extension}"
                yield writer, os.path.join(folder, name)


def meshio_read(path, folder):
    """Without the names of markers: meshio refuses strings in field data."""
    nameless = os.path.join(folder, "nameless.vtu")
    with open(path) as file, open(nameless, "w") as copy:
        copy.write(re.sub("<FieldData>.*</FieldData>", "", file.read(), flags=re.DOTALL))
    return meshio.read(nameless)


def same_file(a, b):
    with open(a, "rb") as first, open(b, "rb") as second:
        return first.read() == second.read()


def check_mesh(mesh, folder):
    plain = os.path.join(folder, "plain.vtu")
    if not convert(os.path.join(DATA, "meshes", mesh + ".su2"), plain, "--ascii"):
        return
    ours = meshio_read(plain, folder)
    cells = sum(len(block.data) for block in ours.cells)
    check(f"{mesh}: meshio and VTK count {cells} cells", cells == vtk_read(plain).GetNumberOfCells())
    for extension, options in CODINGS.items():
        for option in options:
            path = os.path.join(folder, "ours" + extension)
            convert(plain, path, option)
            grid = vtk_read(path)
            same = grid.GetPoints() and (vtk_to_numpy(grid.GetPoints().GetData()) == ours.points).all()
            named = grid.GetFieldData().GetAbstractArray("marker_names") is not None
            check(f"{mesh}: VTK reads {extension} {option}",
                  bool(same and named and grid.GetNumberOfCells() == cells))
        for writer, path in writers(grid, folder, extension):
            writer.SetFileName(path)
            writer.SetInputData(grid)
            writer.Write()
            back = os.path.join(folder, "back.vtu")
            if convert(path, back, "--ascii"):
                check(f"{mesh}: {os.path.basename(path)} of VTK reads to the same mesh",
                      same_file(back, plain))


def check_volume(folder):
    path = os.path.join(folder, "volume.vtk")
    with open(path, "w") as file:
        file.write(VOLUME)
    boundary = os.path.join(folder, "boundary.vtp")
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(vtk_read(path))
    surface.Update()
    expected = surface.GetOutput().GetNumberOfCells()
    if convert(path, boundary, "--surface"):
        found = vtk_read(boundary).GetNumberOfCells()
        check(f"a volume has the {expected} boundary faces that VTK finds", found == expected)


with tempfile.TemporaryDirectory() as folder:
    for mesh in MESHES:
        check_mesh(mesh, folder)
    check_volume(folder)
sys.exit(1 if failed else 0)
