#!/bin/sh
# Runs tests, one more at a time than there are processors, because some wait (WORKERS=1 in the
# environment for one), and says how many pass. What one says stays together. Every test runs, also
# after one that failed.
#
#   run_tests.sh TEST...
#
# Exit status 0: all pass; 1: some fail.
results=$(mktemp -d) || exit 1
trap 'rm -rf "$results"' EXIT
trap 'exit 1' HUP INT TERM

# shellcheck disable=SC2016 # for the shell of each test
printf '%s\n' "$@" |
    xargs -n 1 -P "${WORKERS:-$(($(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1) + 1))}" sh -c '
        log=$(mktemp "$1/log.XXXXXX") && echo "== $2" >"$log" || exit 1
        if "$2" >>"$log" 2>&1; then echo "$2" >>"$1/passed"; else echo "$2" >>"$1/failed"; fi
        cat "$log"' run_test "$results"

touch "$results/passed" "$results/failed"
sed 's/^/FAILED /' "$results/failed"
passed=$(grep -c . "$results/passed")
echo "$passed passed, $(($# - passed)) failed"
[ "$passed" -eq $# ]
