#!/bin/sh
# What `make check` says to a person at a terminal, and that its status is 0 while something is only
# to do. In a file it says what it always did, with status 1. (script of util-linux is the terminal.)
. "$(dirname "$0")/../unit/script.sh"

script -qec true /dev/null >/dev/null 2>&1 || skip "there is no script -qec here"
mkdir -p "$work/sources/step01_line" && grep -v '^call ' tests/check/scenes.txt >"$work/scenes.txt" || exit 1
main=$work/sources/step01_line/main.c

# checks STATUS [VARIABLE]: lesson 1 as main.c is, at a terminal; what it says goes to $said.
checks() {
    said=$work/said
    sed "s|^#include \"scenes.h\"|#include \"$top/step01_line/scenes.h\"|" "$main" >"$work/main.c"
    ${CC:-cc} -std=c17 -w -I"$top/common" -I"$top/step01_line" -I"$top/tests" -DCOURSE_BUILD="\"$build\"" \
        -DLESSON="\"$work/main.c\"" "$top/tests/lessons/step01_line/trials.c" \
        "$build/libcommon.a" -lm -pthread -o "$work/built" || exit 1
    command="$2 '$build/check' --root '$top' --programs '$work' --sources '$work/sources' \
        --scenes '$work/scenes.txt' --differences '$work/differences' --make \"cp '$work/built' '$work/step01_line'; true\" 01"
    script -qec "$command" /dev/null >"$said"
    [ $? -eq "$1" ] || wrong "$2 the status is not $1: $(cat "$said")"
}

says() {
    grep -qF -- "$1" "$said" || wrong "nothing says \"$1\": $(cat "$said")"
}

says_no() {
    ! grep -qF -- "$1" "$said" || wrong "it says \"$1\": $(cat "$said")"
}

awk -v mode=starter -f tests/student/marks.awk step01_line/main.c >"$main"
checks 0
says '0 of 17 points. Next: task 1.1; `make hint STEP=01 TASK=1.1` gives a hint.'
says '11 more to come'
says_no 'octants TODO'
checks 1 VERBOSE=1
says 'octants TODO'
says '0 passed, 1 failed'
sh -c "$command" >"$said" && wrong "in a file, what is to do has not failed"
says '0 passed, 1 failed'

awk -v mode=solution -f tests/student/marks.awk step01_line/main.c >"$work/solution"
cp "$work/solution" "$main"
checks 0
says 'All 17 points.'
says 'tests/reference/step01_line/line.png' # build/show is not there
says 'You can draw now: a line without gaps, exact, with whole numbers only.'
says 'Next: `make start STEP=02` turns lesson 2 into its starter; then read step02_wireframe/README.md.'
says_no 'Difference images'

sed 's/52, 41/41, 52/' "$work/solution" >"$main"
checks 1
says '16 of 17 points. First put right: task 1.1'
says 'pixel FAIL 0/1'
says 'right: line, octants'
says_no 'Next: `make start'

sh tests/student/next.sh "$work" >"$said"
says 'Next: `make start STEP=01`'
says 'turn.png'
exit $failed
