#!/bin/sh
# Does tests/check/scenes.txt tell the tasks of the lessons? Every task of a main.c must be shown by
# a scene, and every task that a scene shows or needs must be one of that main.c. A main.c without
# marks (a starter, a solution) is left alone.
#
# Exit status 0: all of that is so; 1: something is not.
cd "$(dirname "$0")/../.." || exit 1
table=tests/check/scenes.txt
failed=0

# tasks_of LESSON: as main.c marks them. shown_by LESSON: as its scenes show them. needed_by LESSON:
# what these need besides. One a line.
tasks_of() {
    awk -v mode=tasks -f tests/student/marks.awk "$1/main.c" | cut -f 1 | sort
}
shown_by() {
    awk -v lesson="$1" '$1 == lesson { sub("[+].*", "", $3); gsub(",", "\n", $3); print $3 }' $table |
        sort -u
}
needed_by() {
    awk -v lesson="$1" '$1 == lesson && sub(".*[+]", "", $3) { gsub(",", "\n", $3); print $3 }' \
        $table | sort -u
}

# each_in LINES OTHER_LINES WORDS: of those that the others lack, the words are true.
each_in() {
    for task in $1; do
        case "
$2
" in *"
$task
"*) ;; *) failed=1 && echo "tasks: $task $3" ;; esac
    done
}

for lesson in $(awk '/^step/ { print $1 }' $table | uniq); do
    tasks=$(tasks_of "$lesson")
    shown=$(shown_by "$lesson")
    [ -n "$tasks" ] || continue
    each_in "$tasks" "$shown" "of $lesson/main.c is shown by no scene of $table"
    each_in "$shown" "$tasks" "is shown by $lesson in $table, but $lesson/main.c has no such task"
    each_in "$(needed_by "$lesson")" "$(echo "$tasks" && echo "$tasks" | sed 's/[.].*//')" \
        "is needed by $lesson in $table, but $lesson/main.c has no such task"
done
[ $failed -eq 0 ] && echo "tasks: every task is shown by a scene"
exit $failed
