#!/bin/sh
# Shows a lesson's pictures, each with its reference.
#
#     show.sh BUILD STEP SCENE WHICH KIND
#
# STEP is 5, 05 or step05_zbuffer. SCENE is a scene, or empty: all of them. WHICH and KIND are what
# the options --which and --as of BUILD/show get; empty: it chooses.
#
# Exit status: 0 done; 1 it cannot be done; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=show
build=$1
wanted=$2
scene=$3
which=$4
kind=$5
. tests/starter/lesson.sh

# The size of the terminal: what it says itself, else what the shell knows.
find_size() {
    size=$(stty size 2>/dev/null </dev/tty)
    case $size in *[1-9]' '*[1-9]* | *[1-9]' '*0) ;; *) size="${LINES:-24} ${COLUMNS:-80}" ;; esac
    lines=${size% *}
    columns=${size#* }
}

find_lesson
find_size
pictures=$build/out/$lesson
set -- "$pictures"/*.tga # the scenes' pictures
if [ -n "$scene" ]; then
    [ -f "$pictures/$scene.tga" ] ||
        fail 2 "there is no scene \"$scene\" in $lesson. There are: $(
            for file in "$@"; do basename "$file" .tga; done | tr '\n' ' ')"
    set -- "$pictures/$scene.tga"
fi
for picture in "$@"; do
    name=$(basename "$picture" .tga)
    echo "$lesson $name"
    "$build/show" --columns "$columns" --lines "$lines" ${which:+--which "$which"} \
        ${kind:+--as "$kind"} "$picture" "tests/reference/$lesson/$name.png" || exit
done
