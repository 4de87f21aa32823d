#!/bin/sh
# Run one fuzz target on its corpus and on a fixed number of inputs made from it, the same ones each time:
#   tests/fuzz/replay.sh TARGET CORPUS RUNS
# No result depends on how fast the machine is: only a target that hangs for minutes is stopped.
set -eu

target=$1 corpus=$2 runs=$3
crashes=$(dirname "$target")/crashes
mkdir -p "$crashes"

# Named in order: a folder is read in the order of its file system.
cd "$corpus"
seeds=$(LC_ALL=C ls | paste -s -d , -)
[ -n "$seeds" ] || { echo "$corpus: holds no file; some that the reader takes are expected" >&2; exit 1; }

"$target" -seed=1 -runs="$runs" -seed_inputs="$seeds" -timeout=300 -report_slow_units=300 \
    -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 -artifact_prefix="$crashes/$(basename "$target")-"
