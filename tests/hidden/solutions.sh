#!/bin/sh
# Builds solutions to hold submissions against: solutions.sh OUT MAKE SOLUTION [LESSON...]
#
# OUT/LESSON/LESSON becomes the program of each LESSON (all, when none is named), made of
# SOLUTION/LESSON/main.c or, where SOLUTION is empty, of the lesson's marked source, wherever it is
# found (tests/starter/marked.sh). OUT lies in the build directory; MAKE builds there.
#
# Exit status: 0 done, 2 not: a line says why.
cd "$(dirname "$0")/../.." || exit 2
out=$1
make=$2
solution=$3
shift 3
[ $# -gt 0 ] || set -- step[0-9]*_*
. tests/starter/marked.sh

# fail STATUS MESSAGE...
fail() {
    shift
    printf '%s\n' "$*" >&2
    exit 2
}

# The solution's source becomes $place/main.c.
find_solution() {
    main=$lesson/main.c
    work=$place
    if [ -z "$solution" ]; then
        find_marked
        text solution "$place/marked" "$main" >"$place/main.c" || fail 2 "no solution of $lesson"
        return
    fi
    [ -f "$solution/$lesson/main.c" ] || fail 2 "there is no $solution/$lesson/main.c"
    text solution "$solution/$lesson/main.c" >"$place/main.c" || fail 2 "no solution of $lesson"
}

for lesson in "$@"; do
    place=$out/$lesson
    mkdir -p "$place" || fail 2 "cannot write into $out"
    find_solution
    said=$($make "$place/$lesson" 2>&1) || fail 2 "the solution of $lesson does not build: $said"
done
