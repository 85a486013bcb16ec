#!/bin/sh
# Builds solutions to hold submissions against:
#
#     solutions.sh [--judged] OUT MAKE SOLUTION [LESSON...]
#
# OUT/LESSON/LESSON becomes the program of each LESSON (all, when none is named), made of
# SOLUTION/LESSON/main.c or, where SOLUTION is empty, of the lesson's marked source, wherever it is
# found (tests/student/marked.sh). With --judged the lessons' own main.c are what is judged, and no
# solution is made of them. OUT lies in the build directory; MAKE builds there. OUT/LESSON/drawn becomes
# an empty directory, in which hidden keeps what they draw.
#
# Exit status: 0 done, 2 not: a line says why.
cd "$(dirname "$0")/../../.." || exit 2
judged=
[ "$1" != --judged ] || { judged=yes && shift; }
out=$1
make=$2
solution=$3
shift 3
. tests/student/lesson.sh
. tests/student/marked.sh
# shellcheck disable=SC2046 # one word a lesson
[ $# -gt 0 ] || set -- $(list_lessons)

# fail STATUS MESSAGE...: whatever it is, there is no solution.
fail() {
    shift
    printf '%s\n' "$*" >&2
    exit 2
}

# The main.c of SOLUTION becomes $work/marked.
take_solution() {
    main=$solution/$lesson/main.c # also in messages
    [ -f "$main" ] || fail 2 "there is no $main"
    [ -z "$judged" ] || [ "$(cd "$solution/$lesson" && pwd -P)" != "$(cd "$lesson" && pwd -P)" ] ||
        fail 2 "nothing can be compared: $main is what is judged"
    cp "$main" "$work/marked" || fail 2 "cannot copy $main"
}

for lesson in "$@"; do
    work=$out/$lesson
    main=$lesson/main.c
    rm -rf "$work/drawn"
    mkdir -p "$work/drawn" || fail 2 "cannot write into $out"
    if [ -n "$solution" ]; then
        take_solution
    elif [ -n "$judged" ]; then
        find_marked_elsewhere
    else
        find_marked
    fi
    text solution "$work/marked" "$main" >"$work/main.c" || fail 2 "no solution of $lesson"
    said=$($make "$work/$lesson" 2>&1) || fail 2 "the solution of $lesson does not build: $said"
done
