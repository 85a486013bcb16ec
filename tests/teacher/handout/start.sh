#!/bin/sh
# Brings a lesson's starter back: start.sh STEP, where STEP is 5, 05 or step05_zbuffer. What main.c
# held is kept beside it as main.c.1, main.c.2, ...
#
# Exit status: 0 done; 1 it cannot be done, and main.c is as it was; 2 wrong usage.

cd "$(dirname "$0")/../../.." || exit 1
target=start
wanted=$1
. tests/student/lesson.sh
find_lesson
main=$lesson/main.c
if cmp -s "tests/teacher/handout/$lesson.c" "$main"; then
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
cp "tests/teacher/handout/$lesson.c" "$main" || fail 1 "cannot write $main"
echo "$main is the starter again."
