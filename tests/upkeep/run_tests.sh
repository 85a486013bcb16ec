#!/bin/sh
# Runs tests, one more at a time than there are processors, because some wait (WORKERS=1 in the
# environment for one), and says how many pass, and which took the processors most seconds. What one
# says stays together. Every test runs, also after one that failed. One that ends with 77 says what this
# machine lacks for it, and is counted as skipped.
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
        case $2 in *.sh) sh "$2" ;; *) "$2" ;; esac >>"$log" 2>&1
        case $? in 0) end=passed ;; 77) end=skipped ;; *) end=failed ;; esac
        echo "$2" >>"$1/$end"
        times >"$log.times"
        echo "$2" $(tail -n 1 "$log.times") >>"$1/times"
        cat "$log"' run_test "$results"

touch "$results/passed" "$results/failed" "$results/skipped"
echo 'Seconds of processors:'
awk '{ split($2 "m" $3, of, "m"); printf "%6.1f  %s\n", 60 * (of[1] + of[3]) + of[2] + of[4], $1 }' \
    "$results/times" | sort -rn | head -n 12
sed 's/^/SKIPPED /' "$results/skipped"
sed 's/^/FAILED /' "$results/failed"
passed=$(grep -c . "$results/passed")
skipped=$(grep -c . "$results/skipped")
failed=$(($# - passed - skipped))
echo "$passed passed, $failed failed$([ "$skipped" -eq 0 ] || echo ", $skipped skipped")"
[ "$failed" -eq 0 ]
