#!/bin/sh
# Every lesson draws images of every shape; and a light is a direction, however long it is given.
. "$(dirname "$0")/../../unit/script.sh"

for lesson in step[0-9]*_*; do
    for size in 1x1 7x1 1x7 500x20 20x500 333x40; do
        said_by 0 "$build/$lesson" -o "$work/$lesson" -s "$size" --format png
    done
done

# The scenes of lesson 8 that have no model have the light as a normal.
for length in 1 1e100 1e-150; do
    said_by 0 "$build/step08_projection" -o "$work/light$length" -s 200x200 \
        --light "$length,$length,-$length"
done
for length in 1e100 1e-150; do
    said_by 0 diff -r "$work/light1" "$work/light$length"
done
exit $failed
