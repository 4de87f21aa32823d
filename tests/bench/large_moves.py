"""How far meshes can be moved: every row of large_moves.md and of docs/large_moves.md, made with the tools alone.

    python3 tests/bench/large_moves.py [BIN]                 (default: build/bin) the tables
    python3 tests/bench/large_moves.py [BIN] --random N      N random moves of each mesh
    python3 tests/bench/large_moves.py [BIN] --random N --mesh NAME --only K     the K-th of them, kept in ./case.toml

Columns of a row: inverted elements under harmonic weights (Laplace), harmonic with 1/distance, the same with rotations,
conformal biharmonic; then plain harmonic untangled: inverted elements, smallest scaled Jacobian, smallest and mean f_ss,
seconds of untangling.
"""
import argparse
import cmath
import math
import os
import random
import re
import shutil
import tempfile

from moved_case import BIHARMONIC, LAPLACE, METHODS, Case, data_mesh

MESHES = {
    "naca0012_inv": "airfoil",
    "naca0012_lam_hybrid": "airfoil",
    "rae2822_turb": "AIRFOIL",
    "cylinder_lam": "cylinder",
}
SHRINK = 0.7  # of a random move whose boundary is not simple
MOST_SHRINKS = 12


def moved_rigidly(points, degrees, centre, shift=0):
    """Turned about the centre, then shifted; points and shift as complex numbers."""
    turn = cmath.exp(1j * math.radians(degrees))
    return [centre + turn * (p - centre) + shift for p in points]


def print_row(mesh, name, inverted, report, skew):
    after = report["quality"]["after"]
    seconds = f"{report['seconds']['guard']:.2f} s"
    if report["boundary_crossings"]:
        seconds = report["boundary_crossings"][0]
    print("|", mesh, "|", name, "|", " | ".join(map(str, inverted)), "|", after["inverted"],
          f"| {after['min_scaled_jacobian']:.3f} | {skew['min_size_skew']:.3f} / {skew['mean_size_skew']:.3f} | {seconds} |",
          flush=True)


def print_move(case, mesh, name, moved, methods=METHODS):
    inverted = [case.report(moved, settings)["quality"]["after"]["inverted"] for settings in methods]
    report = case.report(moved, LAPLACE, "untangle")
    print_row(mesh, name, inverted, report, case.quality())


def print_meshes(tools, folder):
    for mesh, marker in MESHES.items():
        case = Case.fitted(tools, folder, data_mesh(mesh), marker)
        points = case.points[0]
        is_airfoil = mesh != "cylinder_lam"
        for degrees in (5, 10, 20, 45, 90, 120) if is_airfoil else ():
            print_move(case, mesh, f"turned by {degrees} degrees", [moved_rigidly(points, degrees, 0.5)])
        for chords in (1, 5):
            shift = chords * case.chord() * (0.6 + 0.8j)
            print_move(case, mesh, f"moved by {chords} chords", [moved_rigidly(points, 0, 0, shift)])
        for factor in (0.5, 3):
            print_move(case, mesh, f"thickness x {factor}", [[complex(p.real, p.imag * factor) for p in points]])


def print_wall(tools, folder):
    """Change of the cells at rae2822_turb's wall in a turn by 20 degrees, whose bar is 5 % and 5 degrees."""
    case = Case.fitted(tools, folder, data_mesh("rae2822_turb"), "AIRFOIL")
    moved = [moved_rigidly(case.points[0], 20, 0.5)]
    for name, settings, guard in (("harmonic", LAPLACE, "check"), ("1/distance", METHODS[1], "check"),
                                  ("rotations", METHODS[2], "check"), ("biharmonic", BIHARMONIC, "check"),
                                  ("harmonic, untangled", LAPLACE, "untangle"),
                                  ("biharmonic, untangled", BIHARMONIC, "untangle")):
        report = case.report(moved, settings, guard)
        wall = next(w for w in case.quality()["walls"] if w["marker"] == "AIRFOIL")
        print("| rae2822_turb turned by 20 degrees |", name, "|", report["quality"]["after"]["inverted"],
              f"| {100 * wall['height_change']['max']:.2f} % | {wall['orthogonality_change']['max']:.2f} degrees |", flush=True)


def write_block(path, cells=25):
    """A unit square of quads but for 5 x 1 of them in the middle."""
    number = {}
    quads = []
    for j in range(cells):
        for i in range(cells):
            if j != 12 or not 10 <= i < 15:
                corners = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                quads.append([number.setdefault(corner, len(number)) for corner in corners])
    ring = [(i, 12) for i in range(10, 16)] + [(i, 13) for i in range(15, 9, -1)]
    frame = [(i, 0) for i in range(cells)] + [(cells, i) for i in range(cells)]
    frame += [(cells - i, cells) for i in range(cells)] + [(0, cells - i) for i in range(cells)]
    with open(path, "w") as mesh:
        mesh.write(f"NDIME= 2\nNELEM= {len(quads)}\n")
        mesh.writelines("9 %d %d %d %d\n" % tuple(quad) for quad in quads)
        mesh.write(f"NPOIN= {len(number)}\n")
        mesh.writelines(f"{i / cells!r} {j / cells!r}\n" for i, j in number)
        mesh.write("NMARK= 2\n")
        for name, loop in (("block", ring), ("square", frame)):
            mesh.write(f"MARKER_TAG= {name}\nMARKER_ELEMS= {len(loop)}\n")
            mesh.writelines(f"3 {number[loop[k - 1]]} {number[loop[k]]}\n" for k in range(len(loop)))


def print_block(tools, folder):
    """The block of the literature on mesh motion, turned by 60 degrees and moved by (-0.2, -0.3)."""
    path = os.path.join(folder, "block.su2")
    write_block(path)
    corners = "[[0.4, 0.48], [0.6, 0.48], [0.6, 0.52], [0.4, 0.52]]"
    case = Case(tools, folder, f'[mesh]\nfile = "{path}"\n[[boundary]]\nname = "block"\ndegree = 1\nclosed = true\n'
                f"control_points = {corners}\n")
    print_move(case, "block", "turned and moved", [moved_rigidly(case.points[0], 60, 0.5 + 0.5j, -0.2 - 0.3j)])


def gap(one, other):
    """Least distance of two closed polygons that do not cross."""
    def to_edge(p, a, b):
        along = b - a
        part = ((p - a) * along.conjugate()).real / abs(along) ** 2
        return abs(p - a - min(max(part, 0), 1) * along)

    return min(to_edge(p, edges[k - 1], edges[k]) for points, edges in ((one, other), (other, one))
               for p in points for k in range(len(edges)))


def print_thesis(tools, folder):
    """Case 2 of the thesis: two bodies towards each other, and one around the other, in one step and in steps."""
    case = Case.example(tools, folder, "02_thesis_case2")
    one, other = (case.marker_points(name) for name in ("body1", "body2"))
    centres = [sum(points) / len(points) for points in (one, other)]
    way = centres[1] - centres[0]
    size = max(p.real for p in one) - min(p.real for p in one)
    part = 0  # of the way, half of it for each body
    while (now := gap([p + part * way / 2 for p in one], [p - part * way / 2 for p in other])) > 0.011 * size:
        part += max(1e-4, 0.5 * (now - 0.01 * size) / abs(way))
    first, second = case.points
    print_move(case, "thesis case 2", f"to {now / size:.3f} of their size apart",
               [moved_rigidly(first, 0, 0, part * way / 2), moved_rigidly(second, 0, 0, -part * way / 2)])
    around = {degrees: [first, moved_rigidly(second, degrees, centres[0])] for degrees in range(15, 181, 15)}
    for degrees in (45, 135, 180):
        print_move(case, "thesis case 2", f"one around the other by {degrees} degrees", around[degrees])
    for degrees, moved in around.items():
        inverted = [case.report(moved, METHODS[1])["quality"]["after"]["inverted"]]
        report = case.report(moved, METHODS[1], "untangle")
        print_row("thesis case 2", f"around, in steps, at {degrees} degrees", inverted, report, case.quality())
        if not report["boundary_crossings"]:
            case = case.next_step(moved)


def random_move(case, mesh, number):
    """Control points moved at random by up to half a chord; the same for one number on every machine."""
    rng = random.Random(f"{mesh} {number}")
    size = 0.5 * case.chord() * rng.random() / 3
    return [complex(rng.gauss(0, size), rng.gauss(0, size)) for _ in case.points[0]]


def simple_report(case, move):
    """The untangled move, made smaller until the boundary is simple and the right way round; None where it never is."""
    for shrink in range(MOST_SHRINKS):
        moved = [[p + SHRINK**shrink * d for p, d in zip(case.points[0], move)]]
        report = case.report(moved, LAPLACE, "untangle")
        if not report["boundary_crossings"]:
            return report
    return None


def count_random(case, mesh, numbers):
    count = {"moves": 0, "with inverted elements": 0, "after untangling": 0, "without proof": 0, "never simple": 0}
    slowest = 0
    for number in numbers:
        report = simple_report(case, random_move(case, mesh, number))
        count["moves"] += 1
        if not report:
            count["never simple"] += 1
            continue
        count["with inverted elements"] += "untangle" in report
        slowest = max(slowest, report["seconds"]["guard"])
        if report["quality"]["after"]["inverted"] > 0:
            count["after untangling"] += 1
            count["without proof"] += not report["untangle"]["hopeless"]
            print(f"{mesh} {number}: {report['quality']['after']['inverted']} inverted", flush=True)
    print(f"{mesh}:", ", ".join(f"{value} {what}" for what, value in count.items()), f"; slowest {slowest:.1f} s", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tools", nargs="?", default="build/bin")
    parser.add_argument("--random", type=int, default=0)
    parser.add_argument("--mesh", choices=MESHES)
    parser.add_argument("--only", type=int)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        if not options.random:
            for table in (print_meshes, print_wall, print_block, print_thesis):
                table(options.tools, folder)
            return
        for mesh in [options.mesh] if options.mesh else MESHES:
            case = Case.fitted(options.tools, folder, data_mesh(mesh), MESHES[mesh])
            count_random(case, mesh, range(options.random) if options.only is None else [options.only])
        if options.only is not None:
            shutil.copy(case.file("case.toml"), "case.toml")


main()
