"""How far meshes can be moved: the tables of docs/large_moves.md, made with the tools alone.

    python3 tests/bench/large_moves.py [BIN] [--random N]     (default: build/bin, no random moves)

Each line: inverted elements under harmonic weights (Laplace), harmonic with 1/distance, the same with rotations, conformal
biharmonic; then plain harmonic untangled: inverted elements, smallest scaled Jacobian, smallest and mean f_ss, seconds.
"""
import argparse
import json
import math
import os
import random
import re
import subprocess
import tempfile

MESHES = (
    ("naca0012_inv", "airfoil"),
    ("naca0012_lam_hybrid", "airfoil"),
    ("rae2822_turb", "AIRFOIL"),
    ("cylinder_lam", "cylinder"),
)
HERE = os.path.dirname(os.path.abspath(__file__))


class Case:
    """A mesh with a curve fitted to its body, in a folder of its own."""

    def __init__(self, tools, folder, mesh, marker):
        self.tools = tools
        self.folder = folder
        self.mesh = os.path.join(HERE, "..", "data", "meshes", mesh + ".su2")
        self.run("morph-fit", self.mesh, "--marker", marker, "-o", self.file("fitted.toml"))
        with open(self.file("fitted.toml")) as fitted:
            self.text = fitted.read()
        listed = re.search(r"control_points = \[(.*?)\n\]", self.text, re.S).group(1)
        self.points = [
            [float(number) for number in pair.split(",")] for pair in re.findall(r"\[([^\[\]]+)\]", listed)
        ]
        self.chord = max(x for x, _ in self.points) - min(x for x, _ in self.points)

    def file(self, name):
        return os.path.join(self.folder, name)

    def run(self, tool, *arguments):
        done = subprocess.run([os.path.join(self.tools, tool), *arguments, "--quiet"], capture_output=True)
        if done.returncode not in (0, 3):
            raise RuntimeError(done.stderr.decode())

    def report(self, moved, settings, guard="check"):
        """What morph-deform says of a move with these settings in [deform]."""
        text = re.sub(r"displacements = \[.*?\n\]\n", f"moved = {moved}\n", self.text, flags=re.S)
        text = re.sub(r'diffusivity = "[^"]*"\n', "", text)
        text = re.sub(r'method = "harmonic"\n', settings, text)
        with open(self.file("case.toml"), "w") as case:
            case.write(text)
        self.run("morph-deform", self.file("case.toml"), "-o", self.file("moved.su2"), "--guard", guard,
                 "--json", self.file("report.json"))
        with open(self.file("report.json")) as report:
            return json.load(report)

    def size_skew(self):
        """Of the mesh that was moved last, against the one before."""
        self.run("morph-quality", self.file("moved.su2"), "--reference", self.mesh, "--json",
                 self.file("quality.json"))
        with open(self.file("quality.json")) as quality:
            return json.load(quality)


LAPLACE = 'method = "harmonic"\ndiffusivity = "uniform"\n'
METHODS = (
    LAPLACE,
    'method = "harmonic"\ndiffusivity = "inverse-distance"\n',
    'method = "harmonic"\nrotations = true\ndiffusivity = "inverse-distance"\n',
    'method = "biharmonic"\n',
)


def turned(points, degrees):
    cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[0.5 + cos * (x - 0.5) - sin * y, sin * (x - 0.5) + cos * y] for x, y in points]


def moves_of(case, is_airfoil):
    moves = {}
    for degrees in (5, 10, 20, 45, 90, 120) if is_airfoil else ():
        moves[f"turned by {degrees} degrees"] = turned(case.points, degrees)
    for chords in (1, 5):
        shift = chords * case.chord
        moves[f"moved by {chords} chords"] = [[x + 0.6 * shift, y + 0.8 * shift] for x, y in case.points]
    for factor in (0.5, 3):
        moves[f"thickness x {factor}"] = [[x, y * factor] for x, y in case.points]
    return moves


def print_lines(case, mesh, is_airfoil):
    for name, moved in moves_of(case, is_airfoil).items():
        inverted = [case.report(moved, settings)["quality"]["after"]["inverted"] for settings in METHODS]
        report = case.report(moved, LAPLACE, "untangle")
        after, skew = report["quality"]["after"], case.size_skew()
        print("|", mesh, "|", name, "|", " | ".join(map(str, inverted)), "|", after["inverted"],
              f"| {after['min_scaled_jacobian']:.3f} | {skew['min_size_skew']:.3f} / "
              f"{skew['mean_size_skew']:.3f} | {report['seconds']['guard']:.2f} s |", flush=True)


def count_random(case, mesh, count):
    """Control points moved at random by up to half a chord, less and less until the boundary is simple."""
    inverted = left = unproven = 0
    for _ in range(count):
        size = 0.5 * case.chord * random.random() / 3
        move = [[random.gauss(0, size), random.gauss(0, size)] for _ in case.points]
        for shrink in range(12):
            moved = [[x + dx * 0.7**shrink, y + dy * 0.7**shrink]
                     for (x, y), (dx, dy) in zip(case.points, move)]
            report = case.report(moved, LAPLACE, "untangle")
            if not report["boundary_crossings"]:
                break
        else:
            continue
        inverted += "untangle" in report
        if report["quality"]["after"]["inverted"] > 0:
            left += 1
            unproven += not report["untangle"]["hopeless"]
    print(f"{mesh}: {count} random moves, {inverted} with inverted elements, {left} after untangling, "
          f"{unproven} of them without a proof that no mesh exists", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tools", nargs="?", default="build/bin")
    parser.add_argument("--random", type=int, default=0)
    options = parser.parse_args()
    random.seed(1)
    with tempfile.TemporaryDirectory() as folder:
        for mesh, marker in MESHES:
            case = Case(options.tools, folder, mesh, marker)
            if options.random:
                count_random(case, mesh, options.random)
            else:
                print_lines(case, mesh, mesh != "cylinder_lam")


main()
