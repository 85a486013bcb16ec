# For scripts that work on one lesson, which read this with `.` after `target` and `wanted` are set:
# what make was told to make, and the value of STEP. Sets `lesson`, by find_lesson.

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
