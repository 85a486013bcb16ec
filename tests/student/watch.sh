#!/bin/sh
# Builds, checks and shows a lesson again at every save of its sources, until Ctrl-C.
#
#     watch.sh BUILD MAKE STEP SCENE
#
# STEP is 5, 05 or step05_zbuffer; SCENE is the scene to show, or empty: all of them. What is saved
# is seen within a second, by its contents: a file that is only touched changes nothing.
#
# Exit status: 0 ended by a signal; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=watch
build=$1
make=$2
wanted=$3
scene=$4
. tests/student/lesson.sh

# The make that runs this counts jobs for its own commands: those of ours count for themselves.
MAKEFLAGS=$(echo "${MAKEFLAGS:-}" | sed 's/ -j[0-9]*//; s/ --jobserver-[a-z]*=[^ ]*//')
export MAKEFLAGS

sums() {
    cksum "$lesson"/*.[ch] 2>/dev/null
}

# Is the program that of the sources as they are? What make knows of their text is newer than a
# program that could not be built of it.
is_built() {
    program=$build/quick/$lesson
    [ -x "$program" ] && [ -z "$(find "$build/$lesson.text" -newer "$program")" ]
}

# $make is a command with its options. At a terminal the check speaks to a person.
check_and_show() {
    [ ! -t 1 ] || printf '\033[H\033[2J\033[3J'
    $make check STEP="$lesson" BUILD="$build" 2>&1
    ! is_built || $make show STEP="$lesson" SCENE="$scene" BUILD="$build"
    echo "Waiting for the next save of $lesson; Ctrl-C ends."
}

find_lesson
trap 'exit 0' HUP INT TERM
seen=
while :; do
    now=$(sums)
    # A file that an editor is just replacing may be missing or empty: then the next second counts.
    if [ "$now" != "$seen" ] && [ -s "$lesson/main.c" ]; then
        seen=$now
        check_and_show
    fi
    sleep 1
done
