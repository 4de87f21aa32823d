"""A mesh with curves around its bodies, moved by the tools: what large_moves.py runs for each row."""
import json
import os
import re
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
LAPLACE = 'method = "harmonic"\ndiffusivity = "uniform"\n'
BIHARMONIC = 'method = "biharmonic"\n'
METHODS = (
    LAPLACE,
    'method = "harmonic"\ndiffusivity = "inverse-distance"\n',
    'method = "harmonic"\nrotations = true\ndiffusivity = "inverse-distance"\n',
    BIHARMONIC,
)


POINTS = re.compile(r"^control_points = \[(.*?\])[,\s]*\]\n", re.S | re.M)


def data_mesh(name):
    return os.path.join(HERE, "..", "data", "meshes", name + ".su2")


def listed(points):
    return "[" + ", ".join(f"[{p.real!r}, {p.imag!r}]" for p in points) + "]"


class Case:
    """The text of a case file without [deform] and moves, in a folder of its own; points are complex numbers."""

    def __init__(self, tools, folder, text):
        self.tools = tools
        self.folder = folder
        self.text = re.sub(r"displacements = \[.*?\n\]\n", "", text, flags=re.S)
        self.mesh = re.search(r'^file = "(.*)"', text, re.M).group(1)
        self.points = [
            [complex(*map(float, pair.split(","))) for pair in re.findall(r"\[([^\[\]]+)\]", block)]
            for block in POINTS.findall(self.text)
        ]

    @classmethod
    def fitted(cls, tools, folder, mesh, marker):
        """With a curve fitted to the marker."""
        path = os.path.join(folder, "fitted.toml")
        run(tools, "morph-fit", mesh, "--marker", marker, "-o", path)
        with open(path) as fitted:
            text = re.sub(r'^file = ".*"', f'file = "{mesh}"', fitted.read(), flags=re.M)
        return cls(tools, folder, text)

    @classmethod
    def example(cls, tools, folder, name):
        """Of a case file in examples/ that generates its mesh."""
        mesh = os.path.join(folder, name + ".su2")
        path = os.path.join(HERE, "..", "..", "examples", name, "case.toml")
        run(tools, "morph-mesh", path, "-o", mesh)
        with open(path) as example:
            text = re.sub(r"^generate = .*\n", f'file = "{mesh}"\n', example.read(), flags=re.M)
        text = re.sub(r"^nodes = .*\n", "", text, flags=re.M)
        return cls(tools, folder, text)

    def file(self, name):
        return os.path.join(self.folder, name)

    def chord(self):
        return max(p.real for p in self.points[0]) - min(p.real for p in self.points[0])

    def report(self, moved, settings, guard="check"):
        """What morph-deform says of a move, the new control points of each curve, with these settings in [deform]."""
        curves = iter(moved)
        text = POINTS.sub(lambda points: f"{points.group(0)}moved = {listed(next(curves))}\n", self.text)
        text = re.sub(r"^\[deform\]\n.*", "", text, flags=re.S | re.M)
        with open(self.file("case.toml"), "w") as case:
            case.write(text + "\n[deform]\n" + settings)
        run(self.tools, "morph-deform", self.file("case.toml"), "-o", self.file("moved.su2"), "--guard", guard,
            "--json", self.file("report.json"))
        with open(self.file("report.json")) as report:
            return json.load(report)

    def quality(self):
        """What morph-quality says of the mesh that was moved last, against the one before."""
        run(self.tools, "morph-quality", self.file("moved.su2"), "--reference", self.mesh, "--json", self.file("quality.json"))
        with open(self.file("quality.json")) as quality:
            return json.load(quality)

    def next_step(self, moved):
        """The case that goes on from the mesh that was moved last, with its control points."""
        mesh = self.file("step.su2")
        os.replace(self.file("moved.su2"), mesh)
        curves = iter(moved)
        text = POINTS.sub(lambda _: f"control_points = {listed(next(curves))}\n", self.text)
        return Case(self.tools, self.folder, re.sub(r'^file = ".*"', f'file = "{mesh}"', text, flags=re.M))

    def marker_points(self, name):
        """Places of a marker's nodes, edge by edge."""
        with open(self.mesh) as mesh:
            lines = mesh.read().split("\n")
        start = next(k for k, line in enumerate(lines) if line.startswith("NPOIN"))
        begin = next(k for k, line in enumerate(lines) if re.match(rf"MARKER_TAG\s*=\s*{name}\s*$", line))
        count = int(lines[begin + 1].split("=")[1])
        nodes = (int(line.split()[1]) for line in lines[begin + 2 : begin + 2 + count])
        return [complex(*map(float, lines[start + 1 + node].split()[:2])) for node in nodes]


def run(tools, tool, *arguments):
    done = subprocess.run([os.path.join(tools, tool), *arguments, "--quiet"], capture_output=True)
    if done.returncode not in (0, 3):
        raise RuntimeError(done.stderr.decode())
