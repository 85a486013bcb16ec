#!/bin/sh
# Builds solutions to hold submissions against:
#
#     solutions.sh [--judged] OUT MAKE SOLUTION [LESSON...]
#
# OUT/LESSON/LESSON becomes the program of each LESSON (all, when none is named), made of
# SOLUTION/LESSON/main.c or, where SOLUTION is empty, of the lesson's marked source, wherever it is
# found (tests/student/marked.sh). With --judged the lessons' own main.c are what is judged, and no
# solution is made of them. OUT lies in the build directory; MAKE builds there.
#
# Exit status: 0 done, 2 not: a line says why.
cd "$(dirname "$0")/../../.." || exit 2
judged=
[ "$1" != --judged ] || { judged=yes && shift; }
out=$1
make=$2
solution=$3
shift 3
[ $# -gt 0 ] || set -- step[0-9]*_*
. tests/student/marked.sh

# fail STATUS MESSAGE...
fail() {
    shift
    printf '%s\n' "$*" >&2
    exit 2
}

# Is the main.c of SOLUTION that which is judged?
is_judged() {
    [ -n "$judged" ] && [ "$(cd "$solution/$lesson" && pwd -P)" = "$(cd "$lesson" && pwd -P)" ]
}

# The solution's source becomes $place/main.c.
find_solution() {
    main=$lesson/main.c
    work=$place
    source=$solution/$lesson/main.c
    name=$source # in messages
    if [ -z "$solution" ]; then
        if [ -n "$judged" ]; then find_marked_elsewhere; else find_marked; fi
        source=$place/marked
        name=$main
    elif [ ! -f "$source" ]; then
        fail 2 "there is no $source"
    elif is_judged; then
        fail 2 "nothing can be compared: $source is what is judged"
    fi
    text solution "$source" "$name" >"$place/main.c" || fail 2 "no solution of $lesson"
}

for lesson in "$@"; do
    place=$out/$lesson
    mkdir -p "$place" || fail 2 "cannot write into $out"
    find_solution
    said=$($make "$place/$lesson" 2>&1) || fail 2 "the solution of $lesson does not build: $said"
done
