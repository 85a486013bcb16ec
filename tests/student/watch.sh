#!/bin/sh
# Builds, shows and checks a lesson again at every save of its sources, until Ctrl-C.
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

# $make is a command with its options. The pictures come first: a verdict takes longer. Why there are
# none says the check, at a terminal as to a person.
show_and_check() {
    [ ! -t 1 ] || printf '\033[H\033[2J\033[3J'
    ! $make "$build/quick/$lesson" "$build/show" "$build/models/bust.obj" BUILD="$build" >/dev/null 2>&1 ||
        sh tests/student/show.sh "$build" "$lesson" "$scene" "$WHICH" "$KIND"
    $make check STEP="$lesson" BUILD="$build" 2>&1
    echo "Waiting for the next save of $lesson; Ctrl-C ends."
}

find_lesson
trap 'exit 0' HUP INT TERM
seen=
while :; do
    now=$(sums)
    # A file that an editor is just writing may be missing or empty, or change meanwhile: then the next
    # look counts.
    if [ "$now" != "$seen" ] && [ -s "$lesson/main.c" ] && [ "$now" = "$(sums)" ]; then
        seen=$now
        show_and_check
    fi
    sleep 0.2 2>/dev/null || sleep 1 # not every system has parts of seconds
done
