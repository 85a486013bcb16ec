#!/bin/sh
# Shows a lesson's own program under the mouse, in the browser, until Ctrl-C.
#
#     live.sh BUILD MAKE STEP [MODEL]       STEP is 5, 05 or step05_zbuffer
#
# Exit status: 0 ended; 1 it cannot be done; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=live
build=$1
make=$2
wanted=$3
model=$4
. tests/student/lesson.sh

find_lesson
# The make that runs this counts jobs for its own commands.
MAKEFLAGS=$(echo "${MAKEFLAGS:-}" | sed 's/ -j[0-9]*//; s/ --jobserver-[a-z]*=[^ ]*//')
export MAKEFLAGS
echo "Your program draws on this page, and again at every save of $lesson/main.c; Ctrl-C ends."
exec "$build/live" "$build" "$make" "$lesson" "$model" "sh tests/student/browse.sh"
