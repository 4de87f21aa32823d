#!/bin/sh
# The same moves by every method, small, medium and large: sh examples/compare/run.sh BIN OUT
# BIN: where the tools are, OUT: the folder for a page and a report of each case.
set -eu
bin=$1 out=$2
here=$(dirname "$0")
mkdir -p "$out"

compare() {
    echo "== $1"
    "$bin/morph-compare" "$2" --moves "$3" --page "$out/$1.html" --json "$out/$1.json"
}
compare thesis_case1 "$here/../01_thesis_case1/case.toml" 0.3,1,2
compare thesis_case2 "$here/../02_thesis_case2/case.toml" 0.3,0.6,1
for mesh in naca0012_inv naca0012_lam_hybrid rae2822_turb; do
    compare "$mesh" "$here/$mesh.toml" 0.3,1,2
done
