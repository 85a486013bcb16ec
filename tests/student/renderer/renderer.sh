#!/bin/sh
# Writes what a student wrote in ten lessons as one C file, builds it, and lets it draw the head:
#
#     renderer.sh BUILD OUT CC [SPEED]    OUT is the file, BUILD/renderer/renderer.c where it is empty;
#                                         with SPEED also how long a frame takes, next to lesson 10's
#
# BUILD has the models. The text is put together by renderer.awk, which explains how.
#
# Exit status: 0 done; 1 it cannot be done: what is still to do is said.

cd "$(dirname "$0")/../../.." || exit 1
target=renderer
build=$1
out=${2:-$build/renderer/renderer.c}
cc=$3
speed=$4
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
sed -n 's/^ \* \(Of its .* main[.]c[.]\)$/\1/p' "$out"
program=${out%.c}
$cc -O2 -o "$program" "$out" -lm || fail 1 "it does not compile: does each lesson's own program?"
echo "$out: this is yours. It needs nothing but a C compiler:"
echo "    cc -O2 -o renderer $out -lm"
echo "    ./renderer $build/models/bust.obj --look phong"
case $program in /*) ;; *) program=$PWD/$program ;; esac
case $build in /*) ;; *) build=$PWD/$build ;; esac
cd "$(dirname "$program")" && "$program" "$build/models/bust.obj" --frames 1 && echo "The first picture: $PWD/turn_000.tga" || exit 1
[ -n "$speed" ] || exit 0

# The programs take turns, because the machine may be busy with something else for a while.
$cc -O3 -o "$work/renderer3" "$work/renderer.c" -lm && cd "$work" || exit 1
echo "Milliseconds a frame at 800x800, the least of 40 frames:"
for _ in 1 2 3 4 5 6 7 8 9 10; do
    "$program" "$build/models/bust.obj" --frames 4 | sed 's/.* \(.*\) ms/renderer.c, -O2:\1/'
    ./renderer3 "$build/models/bust.obj" --frames 4 | sed 's/.* \(.*\) ms/renderer.c, -O3:\1/'
    for frame in 1 2 3 4 5; do echo "--only turn --frame $frame"; done | THREADS=1 "$build/step10_phong" --live |
        grep -ao 'frame 800 800 [0-9.]*' | sed '1d; s/.* /lesson 10, by the pipeline:/' # the first reads the textures
done | awk -F : '!($1 in least) { name[++n] = $1; least[$1] = $2 }
    $2 + 0 < least[$1] + 0 { least[$1] = $2 }
    END { for (i = 1; i <= n; i++) printf "    %-28s %5.1f\n", name[i], least[name[i]] }'
