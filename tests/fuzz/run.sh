#!/bin/sh
# Run every fuzz target that is built for some seconds each:
#   tests/fuzz/run.sh SECONDS [BUILD_FOLDER]     (default: build/fuzz, where the preset fuzz builds)
# Fails when a target crashes, hangs or takes more than a GiB, and keeps the input that did it.
set -eu

seconds=${1:?usage: tests/fuzz/run.sh SECONDS [BUILD_FOLDER]}
here=$(cd "$(dirname "$0")" && pwd)
build=${2:-$here/../../build/fuzz}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
ran=0

for target in "$build"/fuzz/fuzz_*; do
    [ -x "$target" ] || continue
    ran=$((ran + 1))
    name=$(basename "$target")
    name=${name#fuzz_}
    mkdir -p "$work/$name" "$build/crashes"
    [ ! -d "$here/corpus/$name" ] || cp -r "$here/corpus/$name/." "$work/$name"
    if "$target" -max_total_time="$seconds" -rss_limit_mb=1024 -timeout=5 -print_final_stats=1 \
        -artifact_prefix="$build/crashes/$name-" "$work/$name" >"$work/log" 2>&1; then
        echo "fuzz_$name: $(grep -o 'number_of_executed_units: [0-9]*' "$work/log") in $seconds s"
    else
        echo "fuzz_$name: failed; its input is in $build/crashes" >&2
        tail -n 40 "$work/log" >&2
        failed=1
    fi
done

[ "$ran" -gt 0 ] || { echo "no fuzz target in $build/fuzz" >&2; exit 1; }
exit "$failed"
