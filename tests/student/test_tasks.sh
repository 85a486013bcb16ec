#!/bin/sh
# Does tests/check/scenes.txt tell the tasks of the lessons? Every task of a main.c must be shown by
# a scene or by numbers, and every task that a scene shows or needs must be one of that main.c. A main.c without
# marks (a starter, a solution) is left alone.
. "$(dirname "$0")/../unit/script.sh"
table=tests/check/scenes.txt

# column PART LESSON: tasks that its scenes and numbers show (1) or need besides or are spoilt by (2),
# one a line: 5.1,5.2+5.3~5.4
column() {
    awk -v part="$1" -v lesson="$2" '{ sub(/^call +/, "") }
        $1 == lesson {
            sub(/[+~]/, " ", $3)
            gsub(/[+~]/, ",", $3)
            split($3, parts, " ")
            print parts[part]
        }' $table |
        tr ',' '\n' | grep . | sort -u
}

# none_only_in OPTION FILE FILE WORDS: of the lines that comm prints then, the words are true.
none_only_in() {
    for task in $(comm "$1" "$2" "$3"); do
        wrong "$task $4"
    done
}

for lesson in $(awk '/^step/ { print $1 }' $table | uniq); do
    awk -v mode=tasks -f tests/student/marks.awk "$lesson/main.c" | cut -f 1 | sort >"$work/tasks"
    [ -s "$work/tasks" ] || continue
    { cat "$work/tasks" && sed 's/[.].*//' "$work/tasks"; } | sort -u >"$work/parts"
    column 1 "$lesson" >"$work/shown"
    column 2 "$lesson" >"$work/needed"
    none_only_in -23 "$work/tasks" "$work/shown" "of $lesson/main.c is shown by no scene of $table"
    none_only_in -13 "$work/tasks" "$work/shown" "is shown in $table, but is no task of $lesson/main.c"
    none_only_in -13 "$work/parts" "$work/needed" "is needed in $table, but is none of $lesson/main.c"
done
exit $failed
