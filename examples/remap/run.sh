#!/bin/sh
# Carry a velocity between the meshes of the thesis's three cases, both ways: sh examples/remap/run.sh BIN OUT
# BIN: where the tools are, OUT: the folder for meshes, results and pictures.
set -eu
bin=$1 out=$2
mkdir -p "$out"

"$bin/remap_cases" make "$out"
for case in pipe_triangles pipe_quads airfoil_hybrid; do
    for way in "coarse fine" "fine coarse"; do
        set -- $way
        for outside in idw project; do
            "$bin/morph-remap" "$out/${case}_$1.vtu" "$out/${case}_$2.su2" --outside $outside \
                -o "$out/${case}_$1_to_$2_$outside.vtu" --json "$out/${case}_$1_to_$2_$outside.json" --quiet
        done
    done
done
"$bin/remap_cases" table "$out" >"$out/table.md"
cat "$out/table.md"
for case in pipe_triangles pipe_quads airfoil_hybrid; do
    "$bin/morph-view" "$out/${case}_coarse_to_fine_idw.vtu" --field error -o "$out/${case}_error.png" --quiet
    "$bin/morph-view" "$out/${case}_coarse.vtu" "$out/${case}_coarse_to_fine_idw.vtu" --field velocity \
        -o "$out/${case}.png" --quiet
done
