#!/bin/sh
# Makes a lesson's main.c its starter or its solution.
#
#     start.sh start|solution STEP          STEP is 5, 05 or step05_zbuffer
#
# Both come out of the marked source (marks.awk): main.c itself while it has marks, then
# main.c.marked, where it is kept when it is first replaced, else git's main.c. What main.c held is
# kept as main.c.1, main.c.2, ... next to it, unless it is the lesson's own or kept already.
#
# Exit status: 0 done; 1 it cannot be done, and main.c is as it was; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=$1
wanted=$2

. tests/student/lesson.sh
. tests/student/marked.sh

# put FILE PLACE: all of it, or nothing.
put() {
    if ! cp "$1" "$work/whole" || ! mv -f "$work/whole" "$2"; then
        fail 1 "cannot write $2"
    fi
}

# keep FILE: as main.c.1, main.c.2, ...; sets kept to where it is.
keep() {
    for kept in "$main".[0-9]*; do
        cmp -s "$1" "$kept" && return
    done
    number=1
    while [ -e "$main.$number" ]; do
        number=$((number + 1))
    done
    kept=$main.$number
    put "$1" "$kept"
}

keep_marked() {
    cmp -s "$work/marked" "$main.marked" && return
    if [ -f "$main.marked" ]; then
        keep "$main.marked"
        echo "The lesson's source has changed; what $main.marked held is kept in $kept."
    fi
    put "$work/marked" "$main.marked"
}

# Sets held to where that which main.c holds can be found again.
keep_held() {
    cp "$main" "$work/held" || fail 1 "cannot read $main"
    if cmp -s "$work/held" "$work/marked"; then
        held="the lesson's source; it is kept in $main.marked"
    elif cmp -s "$work/held" "$work/starter"; then
        held="the starter; make start brings it back"
    elif cmp -s "$work/held" "$work/solution"; then
        held="the solution; make solution brings it back"
    else
        keep "$work/held"
        held="yours; it is kept in $kept"
    fi
}

case $target in
start) new=starter ;;
solution) new=solution ;;
*) fail 2 "usage: start.sh start|solution STEP" ;;
esac
find_lesson
main=$lesson/main.c
work=$lesson/.start.$$ # next to main.c, so that mv only renames
mkdir "$work" || fail 1 "cannot write into $lesson"
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

find_marked
for mode in starter solution; do
    text $mode "$work/marked" "$main" >"$work/$mode" || fail 1 "cannot make the $mode"
done
if cmp -s "$main" "$work/$new"; then
    echo "$main is the $new already."
    exit 0
fi
keep_marked
held="not there"
[ ! -e "$main" ] || keep_held
put "$work/$new" "$main"
echo "$main is now the $new. What was there was $held."
if [ "$new" = starter ]; then
    echo "To do:"
    echo "$tasks" | sed 's/^/    /'
fi
