#!/bin/sh
# In a hand-out, where it is tests/student/start.sh: brings a lesson's starter back.
#
#     start.sh start|solution STEP          STEP is 5, 05 or step05_zbuffer
#
# What main.c held is kept next to it as main.c.1, main.c.2, ...
#
# Exit status: 0 done; 1 it cannot be done, and main.c is as it was; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=$1
wanted=$2
. tests/student/lesson.sh
[ "$target" = start ] || fail 1 "solutions are not handed out; your instructor has them"
find_lesson
main=$lesson/main.c
starter=tests/student/starters/$lesson.c
if cmp -s "$starter" "$main"; then
    echo "$main is the starter."
    exit 0
fi
if [ -e "$main" ]; then
    number=1
    while [ -e "$main.$number" ]; do
        number=$((number + 1))
    done
    mv "$main" "$main.$number" || fail 1 "cannot keep $main"
    echo "What $main held is kept in $main.$number."
fi
cp "$starter" "$main" || fail 1 "cannot write $main"
echo "$main is the starter again."
