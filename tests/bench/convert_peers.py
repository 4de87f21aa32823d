"""Whole conversions beside those of meshio and Gmsh, as a Markdown table:

    python3 tests/bench/convert_peers.py build/bin [--cells 1000] [--work FOLDER]

A square of cells x cells cells, each cut into two triangles, with four markers. Every run is a process of its own
on one core; our seconds are the smallest of three. Peers: /usr/bin/python3 with python3-meshio, and gmsh. Where
meshio cannot write the target (SU2), its seconds are those of reading the source alone; its PLY and VTK files
have no markers, because it refuses them.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile

import numpy

MARKERS = ("bottom", "right", "top", "left")


def write_square(path, cells, markers):
    """The square as an SU2 mesh with the first of its markers, its inner vertices shaken so that coordinates have all their digits."""
    n = cells + 1
    y, x = numpy.mgrid[0:n, 0:n] / cells
    shake = numpy.random.default_rng(1).uniform(-0.2 / cells, 0.2 / cells, (2, n, n))
    shake[:, [0, -1], :] = 0
    shake[:, :, [0, -1]] = 0
    points = numpy.stack([(x + shake[0]).ravel(), (y + shake[1]).ravel()], axis=1)
    corner = numpy.arange(n * n).reshape(n, n)
    a, b, c, d = corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]
    triangles = numpy.concatenate([numpy.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    sides = (corner[0, :], corner[:, -1], corner[-1, ::-1], corner[::-1, 0])
    with open(path, "w", encoding="ascii") as out:
        out.write(f"NDIME= 2\nNELEM= {len(triangles)}\n")
        out.writelines(f"5 {t[0]} {t[1]} {t[2]} {i}\n" for i, t in enumerate(triangles.tolist()))
        out.write(f"NPOIN= {len(points)}\n")
        out.writelines(f"{p[0]!r} {p[1]!r} {i}\n" for i, p in enumerate(points.tolist()))
        out.write(f"NMARK= {markers}\n")
        for name, side in zip(MARKERS[:markers], sides):
            out.write(f"MARKER_TAG= {name}\nMARKER_ELEMS= {len(side) - 1}\n")
            out.writelines(f"3 {i} {j}\n" for i, j in zip(side[:-1], side[1:]))


def measure(command, runs):
    """Smallest wall seconds and largest resident MiB of some runs; None when it fails."""
    seconds, peaks = [], []
    for _ in range(runs):
        timed = ["/usr/bin/time", "-f", "%e %M", *command]  # a fork of this process would count its own memory
        result = subprocess.run(timed, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        if result.returncode != 0:
            return None
        wall, kibibytes = result.stderr.split()[-2:]
        seconds.append(float(wall))
        peaks.append(float(kibibytes) / 1024)
    return min(seconds), max(peaks)


def meshio(source, target, *options):
    code = "import sys, meshio; meshio._cli.main(['convert'] + sys.argv[1:])"
    return ["/usr/bin/python3", "-c", code, source, target, *options]


def meshio_reading(source):
    return ["/usr/bin/python3", "-c", "import sys, meshio; meshio.read(sys.argv[1])", source]


def gmsh(source, target, *options):
    return ["gmsh", "-", source, "-o", target, "-save", "-nt", "1", *options]


def rows(work, tool):
    """(what, our command, name of the peer, its command, how much faster we want to be)."""

    def ours(source, target, *options):
        return [tool, source, target, "--threads", "1", "--quiet", *options]

    def at(name):
        return os.path.join(work, name)

    su2, out = at("square.su2"), at("out")
    return [
        ("SU2 to SU2", ours(su2, out + ".su2"), "meshio", meshio_reading(su2), 5),
        ("SU2 to VTU, binary", ours(su2, out + ".vtu"), "meshio", meshio(su2, out + "_m.vtu"), 5),
        ("SU2 to VTU, binary, halfedges built", ours(su2, out + ".vtu", "--check"), "meshio",
         meshio(su2, out + "_m.vtu"), 5),
        ("SU2 to VTU, text", ours(su2, out + ".vtu", "--ascii"), "meshio", meshio(su2, out + "_m.vtu", "--ascii"), 5),
        ("Gmsh text to SU2", ours(at("plain.msh"), out + ".su2"), "meshio", meshio_reading(at("plain.msh")), 5),
        ("OBJ to SU2", ours(at("square.obj"), out + ".su2"), "meshio", meshio_reading(at("square.obj")), 5),
        ("PLY to VTK, binary", ours(at("plain.ply"), out + ".vtk"), "meshio",
         meshio(at("plain.ply"), out + "_m.vtk"), 1),
        ("STL to PLY, binary", ours(at("square.stl"), out + ".ply"), "meshio",
         meshio(at("square.stl"), out + "_m.ply"), 1),
        ("VTK binary to Gmsh binary", ours(at("plain.vtk"), out + ".msh"), "meshio",
         meshio(at("plain.vtk"), out + "_m.msh", "-o", "gmsh22"), 1),
        ("Gmsh binary to SU2", ours(at("binary.msh"), out + ".su2"), "gmsh", gmsh(at("binary.msh"), out + "_g.su2"), 2),
        ("Gmsh text to binary", ours(at("text.msh"), out + ".msh"), "gmsh",
         gmsh(at("text.msh"), out + "_g.msh", "-bin"), 2),
        ("Gmsh binary to text", ours(at("binary.msh"), out + ".msh", "--ascii"), "gmsh",
         gmsh(at("binary.msh"), out + "_g.msh"), 2),
        ("VTU to OBJ", ours(at("plain.vtu"), out + ".obj"), "meshio", meshio(at("plain.vtu"), out + "_m.obj"), 5),
        ("VTK to STL, binary", ours(at("plain.vtk"), out + ".stl"), "meshio",
         meshio(at("plain.vtk"), out + "_m.stl"), 1),
    ]


def prepare(work, tool, cells):
    square = os.path.join(work, "square.su2")
    plain = os.path.join(work, "plain.su2")
    write_square(square, cells, len(MARKERS))
    write_square(plain, cells, 0)
    for name, options in (("text.msh", ["--ascii"]), ("binary.msh", []), ("square.obj", []), ("square.stl", [])):
        subprocess.run([tool, square, os.path.join(work, name), "--quiet", *options], check=True)
    subprocess.run([tool, plain, os.path.join(work, "plain.msh"), "--ascii", "--quiet"], check=True)
    subprocess.run([tool, plain, os.path.join(work, "plain.ply"), "--quiet"], check=True)
    for name in ("plain.vtk", "plain.vtu"):
        command = meshio(os.path.join(work, "plain.ply"), os.path.join(work, name))
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", help="folder of morph-convert")
    parser.add_argument("--cells", type=int, default=1000)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--work", help="folder for the meshes (default: one that is removed)")
    arguments = parser.parse_args()
    tool = os.path.join(arguments.bin, "morph-convert")
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    slow = False
    with tempfile.TemporaryDirectory() as folder:
        work = arguments.work or folder
        os.makedirs(work, exist_ok=True)
        prepare(work, tool, arguments.cells)
        print("| conversion | seconds | MiB | peer | seconds | times faster | wanted |")
        print("| --- | --- | --- | --- | --- | --- | --- |")
        for what, ours, peer, theirs, wanted in rows(work, tool):
            mine, other = measure(ours, arguments.runs), measure(theirs, 1)
            if mine is None:
                print(f"| {what} | failed | | | | | |")
                slow = True
                continue
            ratio = other[0] / mine[0] if other else None
            slow = slow or (ratio is not None and ratio < wanted)
            told = f"{other[0]:.2f} | {ratio:.1f}" if other else "failed | "
            print(f"| {what} | {mine[0]:.2f} | {mine[1]:.0f} | {peer} | {told} | {wanted} |", flush=True)
    return 1 if slow else 0


if __name__ == "__main__":
    sys.exit(main())
