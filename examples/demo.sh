#!/bin/sh
# Morph a real mesh and look at it: sh examples/demo.sh BIN OUT
# BIN: where the tools are, OUT: the folder for what they make.
set -eu
bin=$1 out=$2
examples=$(dirname "$0")
mkdir -p "$out"

status=0
"$bin/morph-deform" "$examples/03_real_airfoil/case.toml" -o "$out/deformed.su2" --json "$out/report.json" || status=$?
"$bin/morph-view" "$examples/naca0012_inv.su2" "$out/deformed.su2" -o "$out/before_after.png" --quiet

echo
echo "deformed mesh  $out/deformed.su2"
echo "report         $out/report.json"
echo "picture        $out/before_after.png"
exit $status
