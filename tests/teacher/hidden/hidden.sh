#!/bin/sh
# Lets the lessons' programs draw hidden scenes beside their solutions.
#
#     hidden.sh BUILD PROGRAMS MAKE SEED STEP SOLUTION [POINTS]
#
# The programs are built anew in PROGRAMS. Until all is told no check works there: it waits, as this
# does for one that is at work. STEP is 5, 05 or step05_zbuffer, several of them, or empty: all
# lessons. A solution is made of SOLUTION/step05_zbuffer/main.c where SOLUTION is given, and
# otherwise of the marked source that git has or `make start` keeps (tests/student/marked.sh), but
# never of the main.c that is judged; it is built in a directory of its own, and removed. Where
# POINTS is given, what `check --csv` wrote, lessons that print stored pictures lose theirs.
#
# Exit status: that of BUILD/hidden (hidden.c).

cd "$(dirname "$0")/../../.." || exit 2
# The lock is a process's own: a program takes it, and becomes this script.
if [ "$1" != --locked ]; then
    exec "$1/hidden" --locked "$2" tests/teacher/hidden/hidden.sh --locked "$@"
fi
shift
build=$1
programs=$2
make=$3
seed=$4
steps=$5
solution=$6
points=$7
. tests/student/lesson.sh

# fail STATUS MESSAGE...: whatever it is, the check itself cannot work.
fail() {
    shift
    printf '%s\n' "make check HIDDEN=$seed: $*" >&2
    exit 2
}

cannot() {
    fail 2 "$@"
}

# Sets lessons to the names of those that are wanted.
find_lessons() {
    lessons=
    for wanted in ${steps:-step[0-9]*_*}; do
        find_lesson
        lessons="$lessons $lesson"
    done
}

find_lessons
all=$(mktemp -d "$build/hidden.XXXXXX") || cannot "cannot write into $build"
trap 'rm -rf "$all"' EXIT
trap 'exit 2' HUP INT TERM
# shellcheck disable=SC2086 # one word a lesson
said=$(tests/teacher/hidden/solutions.sh --judged "$all" "$make" "$solution" $lessons 2>&1) ||
    cannot "$said"
{
    # shellcheck disable=SC2086 # one word a lesson
    "$build/hidden" --programs "$programs" --solutions "$all" --seed "$seed" --make "$make" \
        $lessons
    echo $? >"$all/status"
} | tee "$all/said" || cannot "the score could not be written to standard output"
status=$(cat "$all/status")
if [ -n "$points" ] && [ $status -lt 2 ]; then
    awk -f tests/teacher/hidden/stored.awk -f tests/teacher/hidden/score.awk "$points" "$all/said" ||
        cannot "the score could not be written to standard output"
fi
exit "$status"
