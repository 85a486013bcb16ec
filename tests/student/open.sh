#!/bin/sh
# Writes a page with a lesson's pictures, and opens it where there is a desktop.
#
#     open.sh BUILD STEP SCENE              SCENE is a scene, or empty: all of them
#
# The page is BUILD/pages/LESSON.html. Exit status: 0 done; 1 it cannot be done; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=open
build=$1
wanted=$2
scene=$3
. tests/student/lesson.sh
. tests/student/drawn.sh

find_lesson
draw
find_drawn
page=$build/pages/$lesson.html
mkdir -p "$build/pages" || fail 1 "cannot write into $build"
set --
for name in $drawn; do
    set -- "$@" "$name" "$build/out/$lesson/$name.tga" "tests/reference/$lesson/$name.png"
done
"$build/compare_page" "$page" "$lesson" "$@" || exit
case $page in /*) ;; *) page=$PWD/$page ;; esac
echo "$page"

sh tests/student/browse.sh "$page"
