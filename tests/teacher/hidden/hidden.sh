#!/bin/sh
# Lets the lessons' programs draw hidden scenes next to their solutions.
#
#     hidden.sh BUILD PROGRAMS MAKE SEED STEP SOLUTION
#
# The programs are built again in PROGRAMS. STEP is 5, 05 or step05_zbuffer, several of them, or
# empty: all lessons. A solution is made of SOLUTION/step05_zbuffer/main.c where SOLUTION is given,
# and otherwise of the marked source that git has or `make start` keeps (tests/student/marked.sh),
# but never of the main.c that is judged; it is built in a separate directory, and removed.
#
# Exit status: that of BUILD/hidden (hidden.c).

cd "$(dirname "$0")/../../.." || exit 2
build=$1
programs=$2
make=$3
seed=$4
steps=$5
solution=$6
target="check HIDDEN=$seed"
. tests/student/lesson.sh

lessons=
for wanted in ${steps:-$(list_lessons)}; do
    find_lesson
    lessons="$lessons $lesson"
done
all=$(mktemp -d "$build/hidden.XXXXXX") || fail 2 "cannot write into $build"
trap 'rm -rf "$all"' EXIT
trap 'exit 2' HUP INT TERM
# shellcheck disable=SC2086 # one word a lesson
said=$(sh tests/teacher/hidden/solutions.sh --judged "$all" "$make" "$solution" $lessons 2>&1) ||
    fail 2 "$said"
# shellcheck disable=SC2086 # one word a lesson
"$build/hidden" "$programs" "$all" "$seed" "$make" $lessons
