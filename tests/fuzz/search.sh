#!/bin/sh
# Search with every fuzz target for some seconds each, one on each core, from a random seed:
#   tests/fuzz/search.sh SECONDS [BUILD_FOLDER]     (default: build/debug)
# A search goes on from what earlier ones kept in BUILD_FOLDER/fuzz/found. An input that crashes, hangs or takes
# more than a GiB fails the search and joins the corpus, so that the tests replay it from then on.
set -eu

seconds=${1:?usage: tests/fuzz/search.sh SECONDS [BUILD_FOLDER]}
here=$(cd "$(dirname "$0")" && pwd)
fuzz=${2:-$here/../../build/debug}/fuzz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

search_one() {
    mkdir -p "$fuzz/found/$1"
    if "$fuzz/fuzz_$1" -max_total_time="$seconds" -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=20 \
        -report_slow_units=60 -print_final_stats=1 -artifact_prefix="$here/corpus/$1/" \
        "$fuzz/found/$1" "$here/corpus/$1" >"$work/$1.log" 2>&1; then
        echo "fuzz_$1: $(grep -o 'number_of_executed_units: [0-9]*' "$work/$1.log") in $seconds s"
    else
        echo "fuzz_$1: failed" >&2
        tail -n 40 "$work/$1.log" >&2
        touch "$work/failed"
    fi
}

started=0
cores=$(nproc)
for corpus in "$here"/corpus/*; do
    search_one "$(basename "$corpus")" &
    started=$((started + 1))
    [ $((started % cores)) -ne 0 ] || wait
done
wait

[ ! -e "$work/failed" ]
