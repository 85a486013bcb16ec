#!/bin/sh
# Prints the next hint for a lesson's first task that is wrong, else for the first one that is still
# to do: each time one more of three.
#
#     hint.sh BUILD STEP [TASK] [AGAIN] [MAKE]     STEP is 5, 05 or step05_zbuffer; TASK is 5.2
#
# Which one is wrong says the check, which MAKE builds, and the lesson. A task is to
# do while main.c holds the starter's line `to do 5.2`. When another one is meant, TASK says which. With AGAIN (any word) everything that was shown is shown again. What was shown is
# kept in BUILD/hints. The hints are in the lesson's hints.txt (hints.awk says how).
#
# Exit status: 0 done; 1 there are no hints; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=hint
build=$1
wanted=$2
task=$3
again=$4
make=$5
. tests/student/lesson.sh

# Of the tasks that have hints, those whose line `to do` is still in main.c, one a line.
find_to_do() {
    echo "$hints" | cut -f 1 | uniq | while read -r name; do
        awk -v name="$name" '
            match($0, /\/\/.*/) {
                rest = substr($0, RSTART) " "
                while (match(rest, /to do [1-9][0-9]*[a-z]?\.[1-9][0-9]*[^0-9]/)) {
                    if (substr(rest, RSTART + 6, RLENGTH - 7) == name) found = 1
                    rest = substr(rest, RSTART + RLENGTH)
                }
            }
            END { exit !found }' "$main" && echo "$name"
    done
}

# The tasks that have hints, as one line.
all_tasks() {
    echo "$hints" | cut -f 1 | uniq | tr '\n' ' ' | sed 's/ $//'
}

# Sets wrong to the task that the check puts first, if any. Ends where the lesson does not build.
find_wrong() {
    wrong=
    [ -n "$make" ] && sh -c "$make '$build/check' models" >/dev/null 2>&1 || return
    said=$("$build/check" --programs "$build/quick" --make "$make" "$number" </dev/null 2>/dev/null)
    case $said in
    "$lesson  BUILD"*)
        echo "$main does not build: $(echo "$said" | sed -n '1s/^[^:]*: //p')"
        exit 0
        ;;
    esac
    wrong=$(echo "$said" | sed -n 's/^  next: task //p')
}

# Sets task to the one that is meant, and others to the rest of those that are to do.
choose_task() {
    to_do=$(find_to_do)
    if [ -z "$task" ]; then
        find_wrong
        task=$(printf '%s\n%s\n' "$wrong" "$to_do" | grep -m 1 .)
    fi
    if [ -z "$task" ]; then
        echo "Nothing is wrong or left to do in $main. Say for which task you want a hint, for example
    make hint STEP=$number TASK=$(echo "$hints" | head -n 1 | cut -f 1)
There are: $(all_tasks)"
        exit 0
    fi
    echo "$hints" | cut -f 1 | grep -qxF -e "$task" ||
        fail 2 "there is no task \"$task\" in this lesson. There are: $(all_tasks)"
    others=$(echo "$to_do" | grep -vxF -e "$task" | tr '\n' ' ' | sed 's/ $//')
}

# How many hints for the task were shown.
count_shown() {
    [ ! -f "$state" ] || awk -v task="$task" '$1 "" == task && $2 ~ /^[1-3]$/ { n = $2 }
        END { print n }' "$state"
}

# print_hints FIRST LAST: of the task.
print_hints() {
    echo "$hints" | awk -F '\t' -v task="$task" -v first="$1" -v last="$2" '
        $1 "" != task { next } # as words: 5.10 is not 5.1
        $2 != "" { number = $2 }
        number >= first && number <= last {
            print ($2 == "" ? "        " : "    " $2 ". " ) $3
        }' | sed 's/^        /       /'
}

find_lesson
main=$lesson/main.c
state=$build/hints/$lesson
[ -f "$lesson/hints.txt" ] || fail 1 "$lesson has no hints.txt"
[ -f "$main" ] || fail 1 "there is no $main; make start STEP=$number makes the starter"
hints=$(awk -f tests/student/hints.awk "$lesson/hints.txt") || exit 1
choose_task
shown=$(count_shown)
shown=${shown:-0}

if [ -n "$again" ]; then
    [ "$shown" -gt 0 ] || fail 2 "no hint for task $task was shown yet"
    echo "Task $task, what was shown:"
    print_hints 1 "$shown"
    exit 0
fi
if [ "$shown" -lt 3 ]; then
    shown=$((shown + 1))
    if ! mkdir -p "$build/hints" || ! echo "$task $shown" >>"$state"; then
        fail 1 "cannot write $state"
    fi
    echo "Task $task, hint $shown of 3:"
    print_hints "$shown" "$shown"
else
    echo "Task $task, all 3 hints:"
    print_hints 1 3
fi
[ "$shown" -eq 3 ] || echo "The same command again tells more."
[ "$shown" -eq 1 ] || echo "All so far: make hint STEP=$number TASK=$task AGAIN=1"
[ -z "$others" ] || echo "Also to do: $others (make hint STEP=$number TASK=${others%% *})"
