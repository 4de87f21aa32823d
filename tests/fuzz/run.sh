#!/bin/sh
# Run every fuzz target that is built for some seconds each, one on each core:
#   tests/fuzz/run.sh SECONDS [BUILD_FOLDER]     (default: build/fuzz, where the preset fuzz builds)
# Fails when a target crashes, hangs or takes more than a GiB, and keeps the input that did it.
set -eu

seconds=${1:?usage: tests/fuzz/run.sh SECONDS [BUILD_FOLDER]}
here=$(cd "$(dirname "$0")" && pwd)
build=${2:-$here/../../build/fuzz}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fuzz_one() {
    name=$(basename "$1")
    name=${name#fuzz_}
    mkdir -p "$work/$name" "$build/crashes"
    [ ! -d "$here/corpus/$name" ] || cp -r "$here/corpus/$name/." "$work/$name"
    if "$1" -max_total_time="$seconds" -rss_limit_mb=1024 -timeout=5 -print_final_stats=1 \
        -artifact_prefix="$build/crashes/$name-" "$work/$name" >"$work/$name.log" 2>&1; then
        echo "fuzz_$name: $(grep -o 'number_of_executed_units: [0-9]*' "$work/$name.log") in $seconds s"
    else
        echo "fuzz_$name: failed; its input is in $build/crashes" >&2
        tail -n 40 "$work/$name.log" >&2
        touch "$work/failed"
    fi
}

started=0
cores=$(nproc)
for target in "$build"/fuzz/fuzz_*; do
    [ -x "$target" ] || continue
    fuzz_one "$target" &
    started=$((started + 1))
    [ $((started % cores)) -ne 0 ] || wait
done
wait

[ "$started" -gt 0 ] || { echo "no fuzz target in $build/fuzz" >&2; exit 1; }
[ ! -e "$work/failed" ]
