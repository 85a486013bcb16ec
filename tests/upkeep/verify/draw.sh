#!/bin/sh
# Draws all scenes of one mistake of the table that mistakes.sh has made. What is wrong in them
# becomes WORK/NUMBER/SCENE.png, its signs where no picture tells it lines of WORK/NUMBER/counted.
# Exit status 255, at which xargs ends: the check cannot work.
#
#   tests/upkeep/verify/draw.sh BUILD MAKE WORK NUMBER
. tests/upkeep/verify/entry.sh

# No diagnosis is wanted, and the directory that is named has none; nor are calls.
check --looks "$place" --counted "$place.counted" --scenes "$work/pictures.txt"
[ "$status" -le 1 ] || { echo "mistakes: ${lesson%%_*}/$name: $said" >&2 && exit 255; }
mv "$place/differences/$lesson/yours" "$place.yours" 2>/dev/null || mkdir "$place.yours"
rm -rf "$place" && mv "$place.yours" "$place"
sort -u "$place.counted" 2>/dev/null | sed "s/^/$number /" >"$place/counted"
rm -f "$place.counted"
