#!/bin/sh
# Writes what a student wrote in ten lessons as one C file, builds it, and lets it draw the head:
#
#     renderer.sh BUILD OUT CC        OUT is the file, BUILD/renderer/renderer.c where it is empty
#
# BUILD has the models. The text is put together by renderer.awk, which explains how.
#
# Exit status: 0 done; 1 it cannot be done: what is still to do is said.

cd "$(dirname "$0")/../../.." || exit 1
target=renderer
build=$1
out=${2:-$build/renderer/renderer.c}
cc=$3
wanted=
. tests/student/lesson.sh

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
for number in 01 02 03 04 05 06 07 08 09 10; do
    lesson=$(list_lessons | grep "^step${number}_")
    [ -f "$lesson/main.c" ] || fail 1 "it takes all ten lessons, and lesson ${number#0} isn't here"
    mkdir "$work/$lesson" || exit 1
    if grep -q 'BEGIN [S]OLUTION [1-9]' "$lesson/main.c"; then
        awk -v mode=solution -f tests/student/marks.awk "$lesson/main.c" >"$work/$lesson/main.c" || exit 1
    else
        cp "$lesson/main.c" "$work/$lesson/main.c" || exit 1
    fi
    files="$files $work/$lesson/main.c"
done
# shellcheck disable=SC2086 # one word a file; a header comes before the source of its room
awk -v names=tests/student/mine.txt -v root="$work/" -f tests/student/renderer/renderer.awk \
    tests/student/renderer/given.c $files common/geometry.h common/geometry.c common/raster.h common/raster.c \
    common/tgaimage.h common/tgaimage.c common/texture.h common/texture.c common/model.h common/given/*.h \
    common/lanes.h common/pipeline.h >"$work/renderer.c" || exit 1
mkdir -p "$(dirname "$out")" && cp "$work/renderer.c" "$out" || fail 1 "cannot write $out"
sed -n 's/^ \* Of its \([0-9]*\) lines you wrote \([0-9]*\)\.$/\1 lines, \2 of them yours/p' "$out"
program=${out%.c}
$cc -O2 -o "$program" "$out" -lm || fail 1 "it does not compile: does each lesson's own program?"
echo "$out: this is yours. It needs nothing but a C compiler:"
echo "    cc -O2 -o renderer $out -lm"
echo "    ./renderer $build/models/bust.obj --look phong"
case $program in /*) ;; *) program=$PWD/$program ;; esac
case $build in /*) ;; *) build=$PWD/$build ;; esac
cd "$(dirname "$program")" && "$program" "$build/models/bust.obj" --frames 1 && echo "The first picture: $PWD/turn_000.tga"
