#!/bin/sh
# Do the arrows of the house point down only? A room is a lesson, a directory of tests or of common,
# or one of the pairs on top of common with its room; an arrow is an #include. Is the include guard of
# each header its path? And is nothing committed that a build has made?
. "$(dirname "$0")/../unit/script.sh"

# Lines `room room`, for tsort: the first includes a file of the second. (The scripts of grading jobs
# and the check's fixtures are programs of other courses.)
find common step* tests -name '*.[ch]' ! -path '*/wrong/*' | xargs awk '
    function room(path,   part) {
        split(path, part, "/")
        if (path ~ /^tests\/lesson\.h$/) return "lesson.h"
        if (path ~ /^tests\//) return part[1] "/" part[2]
        if (path !~ /^common\//) return part[1]
        if (part[2] ~ /^program\.|^run$/) return "common/program"
        if (part[2] ~ /^pipeline(\.|$)|^lanes\./) return "common/pipeline"
        sub(/\..*/, "", part[2])
        return "common/" part[2]
    }
    function exists(path) { return system("test -f " path) == 0 }
    match($0, /^#include "[^"]+"/) {
        name = substr($0, 11, RLENGTH - 11)
        directory = FILENAME
        sub(/\/[^\/]*$/, "", directory)
        if (!((directory, name) in found)) {
            path = directory "/" name
            while (sub(/[^\/.]+\/\.\.\//, "", path));
            if (!exists(path)) path = "common/" name
            if (!exists(path)) path = "tests/" name
            found[directory, name] = path
        }
        from = room(FILENAME)
        to = room(found[directory, name])
        if (from != to && !((from, to) in arrows)) print from, to
        arrows[from, to]
    }' >"$work/arrows"
[ -s "$work/arrows" ] || { echo "rooms: no arrow is found"; failed=1; }
tsort "$work/arrows" >"$work/order" 2>"$work/circles" || failed=1
[ ! -s "$work/circles" ] || { echo "rooms: a circle:"; cat "$work/circles"; failed=1; }
upwards=$(awk '$1 ~ /^common/ && $2 !~ /^common/ || $1 ~ /^step/ && $2 !~ /^common/' "$work/arrows")
[ -z "$upwards" ] || { echo "rooms: an arrow up: $upwards"; failed=1; }

# shellcheck disable=SC2046 # one word a file
wrong_guards=$(awk '
    FNR == 1 { guard = toupper(FILENAME); gsub(/[\/.]/, "_", guard); first = 1 }
    /^#ifndef [A-Z0-9_]+_H$/ && first { first = 0; if ($2 != guard) print FILENAME " has " $2 }
    ' $(find common tests -name '*.h'))
[ -z "$wrong_guards" ] || { echo "rooms: an include guard is not its path: $wrong_guards"; failed=1; }

built=$(git ls-files 2>/dev/null | grep -E '(^|/)build/|\.(o|a|d|out|exe|tga)$')
[ -z "$built" ] || { echo "rooms: built and committed: $built"; failed=1; }
exit $failed
