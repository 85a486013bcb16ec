#!/bin/sh
# Draws all scenes of one mistake of the table that mistakes.sh has made. What is wrong in them
# becomes WORK/NUMBER/SCENE.png, what tells it where no picture does lines of WORK/NUMBER/counted.
# Exit status 255, at which xargs ends: the check cannot work.
#
#   tests/upkeep/verify/draw.sh BUILD MAKE WORK NUMBER
. tests/upkeep/verify/entry.sh

# No diagnosis is wanted, and the directory that is named has none.
check --looks "$place" --counted "$place.counted"
[ "$status" -le 1 ] || { echo "mistakes: ${lesson%%_*}/$name: $said" >&2 && exit 255; }
mv "$place/differences/$lesson/yours" "$place.yours" 2>/dev/null || mkdir "$place.yours"
rm -rf "$place" && mv "$place.yours" "$place"
list_counted "$place.counted" >"$place/counted"
rm -f "$place.counted"
