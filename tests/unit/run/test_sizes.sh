#!/bin/sh
# Every lesson draws images of every shape, and a model that is not the course's head, without a
# warning; and a light is a direction, however long it is given.
. "$(dirname "$0")/../../unit/script.sh"

for lesson in step[0-9]*_*; do
    for size in 1x1 7x1 1x7 500x20 20x500 333x40; do
        said_by 0 "$build/$lesson" -o "$work/$lesson" -s "$size" --format png
    done
done

# Upright, so that no picture has anything in its highest rows.
for lesson in step0[24-9]*_* step10*; do
    "$build/$lesson" -o "$work/$lesson" --fit --turn 1,0,0 "$build/models/knot.off" 2>"$work/said" \
        >"$work/names" || wrong "$lesson: status $?"
    ! grep . "$work/said" || wrong "$lesson: a warning without a cause"
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
