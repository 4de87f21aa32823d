"""CGNS against the CGNS tools and VTK: cgns.py BIN_DIR DATA_DIR

One line for each check; the exit status is 1 when a check fails.
"""

import os
import re
import subprocess
import sys
import tempfile

from vtkmodules.vtkIOCGNSReader import vtkCGNSReader

BIN, DATA = sys.argv[1:3]
MESHES = ["naca0012_inv", "naca0012_lam_hybrid", "wedge"]
failed = False

# A cube with a pyramid on it, as AFLR3 text (whose pyramids begin 0, 3, apex): faces of three boundaries.
BLOCK = """9 4 5 0 1 0 1
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
0.5 0.5 2
5 6 9
6 7 9
7 8 9
8 5 9
1 4 3 2
1 2 6 5
2 3 7 6
3 4 8 7
4 1 5 8
3 3 3 3 1 2 2 2 2
5 8 9 6 7
1 2 3 4 5 6 7 8
"""

# A grid of 4 x 3 x 1 points, as Plot3D text of one block.
GRID = "1\n4 3 1\n" + "\n".join(
    " ".join(str(v) for v in values)
    for values in ([0, 1, 2, 3] * 3, [0] * 4 + [1] * 4 + [2] * 4, [0] * 12)
)


def check(what, good):
    global failed
    failed = failed or not good
    print(("good: " if good else "BAD:  ") + what)


def run(*command):
    return subprocess.run(command, capture_output=True, text=True)


def convert(*arguments):
    result = run(os.path.join(BIN, "morph-convert"), *arguments)
    if result.returncode != 0:
        print(result.stderr.strip())
    return result.returncode == 0


def read(path):
    with open(path, "rb") as file:
        return file.read()


def vtk_counts(path):
    reader = vtkCGNSReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.EnableAllBases()
    reader.Update()
    iterator = reader.GetOutput().NewIterator()
    iterator.InitTraversal()
    grid = iterator.GetCurrentDataObject()
    return grid.GetNumberOfPoints(), grid.GetNumberOfCells()


def info(path, *options):
    return run(os.path.join(BIN, "morph-convert"), "--info", path, *options).stdout


def check_what_we_write(folder, name):
    source = os.path.join(DATA, "meshes", name + ".su2")
    ours = os.path.join(folder, name + ".cgns")
    adf = os.path.join(folder, name + "_adf.cgns")
    check(f"{name} is written", convert(source, ours))
    report = run("cgnscheck", ours).stdout
    check(f"cgnscheck finds no error in {name}", "checking complete" in report and "ERROR" not in report)
    counts = re.search(r"(\d+) vertices, (\d+) triangles, (\d+) quads", info(source))
    vertices, triangles, quads = (int(count) for count in counts.groups())
    check(f"VTK reads as many points and cells of {name}", vtk_counts(ours) == (vertices, triangles + quads))
    run("hdf2adf", ours, adf)
    good = convert(ours, ours + ".su2") and convert(adf, adf + ".su2")
    check(f"{name} as ADF is the same mesh", good and read(ours + ".su2") == read(adf + ".su2"))


def check_what_others_write(folder):
    text = os.path.join(folder, "block.ugrid")
    volume = os.path.join(folder, "block.cgns")
    with open(text, "w") as file:
        file.write(BLOCK)
    run("aflr3_to_cgns", "-f", text, volume)
    found = info(volume, "--surface")
    check("the surface of aflr3_to_cgns's volume", "9 vertices, 4 triangles, 5 quads" in found)
    check("its boundaries are groups", "group 'UserDefined 3': 4 elements" in found)

    text = os.path.join(folder, "grid.p3d")
    grid = os.path.join(folder, "grid.cgns")
    with open(text, "w") as file:
        file.write(GRID)
    run("plot3d_to_cgns", "-f", text, grid)
    check("the grid of plot3d_to_cgns", "12 vertices, 0 triangles, 6 quads" in info(grid))


with tempfile.TemporaryDirectory() as folder:
    for name in MESHES:
        check_what_we_write(folder, name)
    check_what_others_write(folder)
sys.exit(1 if failed else 0)
