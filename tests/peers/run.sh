#!/bin/sh
# Every check against another program: tests/peers/run.sh BIN
# Each tests/peers/NAME.py prints a line for each check and fails when one does; all are run.
set -eu
bin=${1:?usage: tests/peers/run.sh BIN}
here=$(cd "$(dirname "$0")" && pwd)
failed=
for script in "$here"/*.py; do
    name=$(basename "$script" .py)
    echo "== $name"
    /usr/bin/python3 "$script" "$bin" "$here/../data" || failed="$failed $name"
done
[ -z "$failed" ] || { echo "peers that disagree:$failed" >&2; exit 1; }
