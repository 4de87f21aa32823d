#!/bin/sh
# Every benchmark, then whole runs of morph-deform at growing sizes: sh tests/bench/run.sh [BUILD]
set -eu
build=${1:-build/bench}
for bench in "$build"/bench/*_bench; do
    echo "== $(basename "$bench")"
    "$bench" --benchmark_counters_tabular=true
done

echo "== the peer of lattice_bench in NumPy"
python3 "$(dirname "$0")/full_length_passes.py"

echo "== conversions beside meshio and Gmsh"
python3 "$(dirname "$0")/convert_peers.py" "$build/bin" || echo "slower than wanted somewhere"

echo "== how far meshes can be moved"
python3 "$(dirname "$0")/large_moves.py" "$build/bin"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for vertices in 16000 100000 1000000 4000000; do
    echo "== morph-deform, $vertices vertices: seconds of each stage, then of the process, and its memory"
    "$build/bench/make_case" "$vertices" "$work"
    /usr/bin/time -f '%e s, %M KiB' "$build/bin/morph-deform" "$work/case.toml" --json "$work/report.json" --quiet
    sed -n '/"seconds"/,/}/p' "$work/report.json"
done
