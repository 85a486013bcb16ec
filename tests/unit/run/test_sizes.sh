#!/bin/sh
# Every lesson draws images of every shape; and a light is a direction, however long it is given.
#
# CHECK_PROGRAMS=build tests/unit/run/test_sizes.sh
cd "$(dirname "$0")/../../.." || exit 1
build=${CHECK_PROGRAMS:?where the programs are}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0

wrong() {
    echo "sizes: $*" >&2
    status=1
}

for lesson in step[0-9]*_*; do
    for size in 1x1 7x1 1x7 500x20 20x500 333x40; do
        "$build/$lesson" -o "$work/$lesson" -s "$size" --format png >"$work/said" 2>&1 ||
            wrong "$lesson -s $size: status $?: $(cat "$work/said")"
    done
done

# The scenes of lesson 8 that have no model have the light as a normal.
for length in 1 1e100 1e-150; do
    "$build/step08_projection" -o "$work/light$length" -s 200x200 \
        --light "$length,$length,-$length" >/dev/null || wrong "the light $length: status $?"
done
for length in 1e100 1e-150; do
    diff -r "$work/light1" "$work/light$length" >"$work/said" ||
        wrong "a light of length $length: $(cat "$work/said")"
done
exit $status
