# For scripts that work on a lesson's pictures, which read this with `.` after lesson.sh, with
# `target`, `build`, `lesson` and `scene` set.

# The size of the terminal: what it says itself, else what the shell knows.
find_size() {
    size=$(stty size 2>/dev/null </dev/tty)
    case $size in [1-9]*' '[1-9]*) ;; *) size="${LINES:-24} ${COLUMNS:-80}" ;; esac
    lines=${size% *}
    columns=${size#* }
}

# scenes_in_order: those of the lesson, then whatever else has been drawn.
scenes_in_order() {
    awk -v lesson="$lesson" '$1 == lesson { print $2 }' tests/check/scenes.txt 2>/dev/null
    for picture in "$build/out/$lesson"/*.tga; do
        [ ! -f "$picture" ] || basename "$picture" .tga
    done
}

# A program that does not end would keep the terminal: after so many seconds it is stopped.
seconds=${CHECK_TIMEOUT:-10}

# limited COMMAND...: its exit status, 137 where it was stopped. (timeout(1) is not everywhere, and
# Ctrl-C does not reach what it runs.)
limited() {
    "$@" </dev/null &
    program=$!
    (
        sleeper=
        trap '[ -z "$sleeper" ] || kill "$sleeper"; exit' TERM
        sleep "$seconds" &
        sleeper=$!
        wait "$sleeper"
        kill -KILL "$program"
    ) </dev/null >/dev/null 2>&1 &
    watchdog=$!
    trap 'kill -KILL "$program"; kill "$watchdog"; exit 1' HUP INT TERM
    wait "$program" 2>/dev/null # "Killed" is said below, and better
    ended=$?
    kill "$watchdog" 2>/dev/null
    trap - HUP INT TERM
    return "$ended"
}

# Are the lesson's pictures those of its program, all of them?
is_drawn() {
    [ -f "$out/.all_drawn" ] &&
        [ -z "$(find "$build/quick/$lesson" "$build/models/bust.obj" -newer "$out/.all_drawn" 2>/dev/null)" ]
}

# Pictures of an earlier program go away: what one leaves behind that ends early is its own.
forget_pictures() {
    if [ -n "$only" ]; then
        rm -f "$out/$only.tga"
    else
        rm -f "$out/.drawn" "$out/.all_drawn" "$out"/*.tga
    fi
}

# how_it_ended STATUS
how_it_ended() {
    if [ "$1" -eq 137 ]; then
        echo "was stopped after $seconds s"
    elif [ "$1" -gt 128 ]; then
        echo "crashed: SIG$(kill -l "$1")"
    else
        echo "ended with status $1"
    fi
}

# Draws what is to be shown, where that is not done: the lesson's scenes, or the one of `scene`.
draw() {
    out=$build/out/$lesson
    ! is_drawn || return 0
    only=
    ! scenes_in_order | grep -qxF -e "$scene" || only=$scene
    mkdir -p "$out" && forget_pictures || fail 1 "cannot write into $out"
    limited "$build/quick/$lesson" -o "$out" --only "${only:-all}" >/dev/null
    status=$?
    if [ $status -ne 0 ]; then
        printf '%s\n' "make $target: $lesson $(how_it_ended $status)" >&2
    elif [ -z "$only" ]; then
        touch "$out/.all_drawn"
    fi
}

# Sets drawn to the names of the scenes whose pictures are there: all, or the one in `scene`.
find_drawn() {
    drawn=
    known=
    for name in $(scenes_in_order); do
        case "$known " in *" $name "*) continue ;; esac
        known="$known $name"
        [ ! -f "$build/out/$lesson/$name.tga" ] || drawn="$drawn $name"
    done
    [ -n "$scene" ] || [ -n "$drawn" ] || fail 1 "$lesson has drawn nothing"
    [ -n "$scene" ] || return 0
    case "$drawn :$known " in
    *" $scene "*:*) drawn=$scene ;;
    *:*" $scene "*) fail 1 "$lesson has not drawn $scene" ;;
    *) fail 2 "there is no scene \"$scene\" in $lesson. There are:$known" ;;
    esac
}
