"""Free-form deformation by passes over full-length arrays, as PyGeM makes them: the peer of lattice_bench.

For each of the 4 x 4 x 4 control points one product of arrays as long as the mesh, and one more product and sum for each
component. 1M points; prints the shortest of five times.
"""
import time

import numpy as np

COUNT = 1_000_000


def cubic_bernstein(u):
    return [binomial * np.power(1 - u, 3 - i) * np.power(u, i) for i, binomial in enumerate((1, 3, 3, 1))]


def move(points, displacements):
    basis = [cubic_bernstein(points[:, axis]) for axis in range(3)]
    moved = [points[:, axis].copy() for axis in range(3)]
    for j in range(4):
        for k in range(4):
            of_jk = basis[1][j] * basis[2][k]
            for i in range(4):
                of_ijk = basis[0][i] * of_jk
                for axis in range(3):
                    moved[axis] += of_ijk * displacements[i, j, k, axis]
    return moved


def main():
    random = np.random.default_rng(1)
    points = random.random((COUNT, 3))
    displacements = random.random((4, 4, 4, 3))
    seconds = []
    for _ in range(5):
        start = time.perf_counter()
        move(points, displacements)
        seconds.append(time.perf_counter() - start)
    print(f"full-length passes in NumPy: {1000 * min(seconds):.0f} ms")


main()
