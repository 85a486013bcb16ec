#!/bin/sh
# Are the errors in the lessons' charts those that `make bench` has just measured? Times are another
# machine's, but errors are the same on each: a version with another one draws or computes something
# else than it did when its chart was made.
#
#   tests/bench/same_errors.sh BUILD

build=${1:?usage: tests/bench/same_errors.sh BUILD}
cd "$(dirname "$0")/../.." || exit 1

# errors CHART: a line for each version.
errors() {
    sed -n 's|.*<title>\(.*: error .*\), time .*</title>.*|\1|p' "$1"
}

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0
for chart in step*/figures/bench.svg; do
    lesson=${chart%%/*}
    errors "$chart" >"$work/shown"
    errors "$build/bench/$lesson.svg" >"$work/measured"
    if ! [ -s "$work/shown" ]; then
        echo "$chart: no error is shown"
        status=1
    elif ! diff -U 0 -L "$chart" -L "$build/bench/$lesson.svg" "$work/shown" "$work/measured"; then
        status=1
    fi
done
exit "$status"
