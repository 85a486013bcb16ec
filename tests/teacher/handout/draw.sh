#!/bin/sh
# Lets the check judge one program of the table that key.sh has made. A solution must pass; what it
# gets becomes WORK/LESSON.json. Of a mistake the picture of its scene becomes WORK/NUMBER.png, what
# the check says WORK/NUMBER.said, and what was changed WORK/NUMBER.diff. Exit status 255, at which
# xargs ends: the check cannot work, or a solution does not pass.
#
#   tests/teacher/handout/draw.sh BUILD MAKE WORK NUMBER
. tests/upkeep/verify/entry.sh

give_up() {
    echo "make key: ${lesson%%_*}/$name: $said" >&2
    exit 255
}

if [ "$kind" = solution ]; then
    check --json "$work/$lesson.json"
    [ "$status" -eq 0 ] || give_up
else
    diff "$work/course/$lesson/main.c" "$place/main.c" | sed -n 's/^</-/p; s/^>/+/p' \
        >"$work/$number.diff"
    check --only "$scene"
    [ "$status" -le 1 ] || give_up
    echo "$said" >"$work/$number.said"
    picture=$place/differences/$lesson/yours/$scene.png
    [ ! -f "$picture" ] || mv "$picture" "$work/$number.png" || give_up
fi
rm -rf "$place"
