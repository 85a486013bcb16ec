#!/bin/sh
# Can a student start each lesson from its README alone? Takes the skeleton out of each README, puts it
# in the place of the lesson's main.c in a copy of the course, and asks the check: the skeleton must
# build without a warning, and the check must say FAIL (the pictures are still empty), not BUILD or CRASH.
#
# Exit status 0: all lessons can be started; 1: one cannot.

top=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
failed=0

cp -R "$top/Makefile" "$top/common" "$top/tests" "$work" || exit 1
for lesson in "$top"/step*; do
    name=$(basename "$lesson")
    mkdir "$work/$name" || exit 1
    # The C block whose first line says "start here".
    awk '/^```c/ { inside = 1; first = 1; next }
         /^```/ { inside = 0 }
         inside && first { wanted = /start here/; first = 0 }
         inside && wanted' "$lesson/README.md" >"$work/$name/main.c"
    if ! [ -s "$work/$name/main.c" ]; then
        echo "lesson_starts: $name/README.md has no skeleton"
        failed=1
    fi
done

cd "$work" || exit 1
make -s programs WERROR=-Werror >build.log 2>&1 || { cat build.log; failed=1; }
build_check=$(make check WERROR=-Werror 2>&1)
echo "$build_check" | grep '^step' || failed=1
if [ "$(echo "$build_check" | grep -c '^step[0-9]*_[a-z]*  FAIL 0/')" -ne 10 ]; then
    echo "lesson_starts: not every skeleton gets FAIL for all of its scenes"
    failed=1
fi
exit $failed
