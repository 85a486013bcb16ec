#!/bin/sh
# Says what comes next, and shows a picture where a terminal reads it and build/show is there.
#
#     next.sh BUILD               after `make`: the head to which the course leads
#     next.sh BUILD LESSON        when step05_zbuffer is right: its picture, which is the reference
#     next.sh BUILD '' FILE       after the program of one's own: this picture
#
# What one can do after a lesson is in the map of README.md. Exit status 0.

cd "$(dirname "$0")/../.." || exit 1
build=$1
done=$2
own=$3
. tests/student/drawn.sh

# picture FILE
picture() {
    if [ -t 1 ] && [ -x "$build/show" ]; then
        find_size
        "$build/show" "$columns" "$lines" '' '' reference '' none "$1" | sed 1d
    else
        echo "$1"
    fi
}

# map_of LESSON: its picture, and what one can do after it.
map_of() {
    awk -v lesson="$1" '
        /^<tr>/ { row = "" }
        { row = row $0 }
        /<\/tr>/ && index(row, "href=\"" lesson "/") {
            match(row, /src="[^"]*"/)
            print substr(row, RSTART + 5, RLENGTH - 6)
            sub(/<\/td><\/tr>.*/, "", row)
            sub(/.*<td>/, "", row)
            print row
        }' README.md
}

# begin LESSON: the command with which it begins.
begin() {
    number=${1#step}
    number=${number%%_*}
    if grep -q 'BEGIN SOLUTIO[N]' "$1/main.c"; then
        echo "Next: \`make start STEP=$number\` turns lesson ${number#0} into its starter; then read $1/README.md."
    else
        echo "Next: read $1/README.md; \`make check STEP=$number\` says what is to do."
    fi
}

if [ -n "$own" ]; then
    picture "$own"
    exit
fi
if [ -n "$done" ]; then
    map_of "$done" | {
        read -r file && read -r words || exit
        picture "$file"
        echo "You can draw now: $words."
    }
fi
[ -n "$done" ] || picture step10_phong/figures/turn.png
behind=${done:+yes} # is the lesson one of those up to the one that is done?
for lesson in step[0-9]*_*; do
    [ -f "$lesson/main.c" ] || continue
    if [ -z "$behind" ] && grep -q '// to do [0-9]' "$lesson/main.c"; then
        begin "$lesson"
        exit
    fi
    [ "$lesson" != "$done" ] || behind=
done
