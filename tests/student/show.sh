#!/bin/sh
# Shows a lesson's pictures, each with its reference.
#
#     show.sh BUILD STEP SCENE WHICH KIND
#
# STEP is 5, 05 or step05_zbuffer. SCENE is a scene, or empty: all of them. WHICH and KIND are for
# BUILD/show.
#
# Exit status: 0 done; 1 it cannot be done; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=show
build=$1
wanted=$2
scene=$3
which=$4
kind=$5
. tests/student/lesson.sh
. tests/student/drawn.sh

find_lesson
find_size
draw
find_drawn
for name in $drawn; do
    "$build/show" "$columns" "$lines" "$lesson" "$name" "$which" "$kind" \
        "$build/out/$lesson/$name.tga" "tests/reference/$lesson/$name.png" || exit
done
