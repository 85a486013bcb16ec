# For scripts that work on lessons, which read this with `.` after `target` and `wanted` are set:
# what make was told to make, and the value of STEP or LESSONS. find_lesson sets `lesson`.

# fail STATUS MESSAGE...
fail() {
    status=$1
    shift
    printf '%s\n' "make $target: $*" >&2
    exit "$status"
}

# All of them. (What was handed out may have a lesson's pictures alone, which README.md shows.)
list_lessons() {
    for lesson in step[0-9]*_*/; do
        [ "$(ls "$lesson")" = figures ] || echo "${lesson%/}"
    done
}

# Sets lessons to those of wanted, such as 5 or 1-3,5, all when it is empty, each once and in their order;
# and first and last to the numbers of the first and the last.
select_lessons() {
    wanted=${wanted:-1-99}
    lessons=
    for lesson in $(list_lessons); do
        number=${lesson#step}
        number=${number%%_*}
        for range in $(echo "$wanted" | tr , ' '); do
            case $range in
            *[!0-9-]* | -* | *- | *-*-*) fail 2 "LESSONS=$wanted is neither a number nor like 1-3,5" ;;
            esac
            [ "$number" -lt "${range%-*}" ] || [ "$number" -gt "${range#*-}" ] || {
                lessons="$lessons $lesson"
                break
            }
        done
    done
    [ -n "$lessons" ] || fail 2 "there is no lesson in LESSONS=$wanted"
    first=$(echo "$lessons" | sed 's/^ step0*\([0-9]*\).*/\1/')
    last=$(echo "$lessons" | sed 's/.* step0*\([0-9]*\)[^ ]*$/\1/')
}

# step05_zbuffer from 5, 05, step05_zbuffer or step05_zbuffer/.
find_lesson() {
    wanted=${wanted%/}
    for lesson in $(list_lessons); do
        number=${lesson#step}
        number=${number%%_*}
        case $wanted in "$lesson" | "$number" | "${number#0}") return 0 ;; esac
    done
    fail 2 "${wanted:+there is no step \"$wanted\"; }say which step, for example STEP=05. There are:
$(list_lessons | sed 's/^/    /')"
}
