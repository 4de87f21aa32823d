#!/bin/sh
# clang-format on every source, and clang-tidy on all or only on what changed since a revision:
#   .ci/lint.sh BUILD JOBS [SINCE]
# BUILD: configured without precompiled headers, which would hide an include that is missing. Also linted: sources
# that include a changed header, over however many others. A changed .clang-tidy lints everything.
set -eu
build=$1 jobs=$2 since=${3:-}
cd "$(dirname "$0")/.."

changed() { git diff --name-only --diff-filter=d "$since" -- "$@" && git ls-files --others --exclude-standard -- "$@"; }

# The files of the list $1 and those that include one of them, all by paths from the root as our includes are.
with_includers() {
    found=$1
    while :; do
        patterns=$(printf '%s\n' "$found" | sed 's/.*/#include "&"/')
        more=$(printf '%s\n' "$found" $(git grep -lF --untracked -e "$patterns" -- '*.h' '*.cpp') | sort -u)
        [ "$more" != "$found" ] || break
        found=$more
    done
    printf '%s\n' "$found"
}

tidied() { grep -E '\.cpp$' | grep -vE '^tests/(fuzz|bench)/'; }

if [ -z "$since" ] || [ -n "$(changed .clang-tidy)" ]; then
    sources=$(git ls-files '*.cpp' | tidied)
else
    sources=$(with_includers "$(changed '*.h' '*.cpp')" | tidied) || true
fi

git ls-files '*.h' '*.cpp' | xargs clang-format-14 --dry-run -Werror
[ -n "$sources" ] || { echo 'clang-tidy: nothing has changed'; exit 0; }
printf '%s\n' "$sources" | xargs -P "$jobs" -n 1 clang-tidy-14 -p "$build" --quiet
