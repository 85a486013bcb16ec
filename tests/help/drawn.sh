# For scripts that work on a lesson's pictures, which read this with `.` after lesson.sh, with
# `build`, `lesson` and `scene` set.

# scenes_in_order: those of the lesson, then whatever else has been drawn.
scenes_in_order() {
    awk -v lesson="$lesson" '$1 == lesson { print $2 }' tests/check/scenes.txt 2>/dev/null
    for picture in "$build/out/$lesson"/*.tga; do
        basename "$picture" .tga
    done
}

# Sets drawn to the names of the scenes whose pictures are there: all, or the one in `scene`.
find_drawn() {
    drawn=
    for name in $(scenes_in_order); do
        case "$drawn " in *" $name "*) continue ;; esac
        [ ! -f "$build/out/$lesson/$name.tga" ] || drawn="$drawn $name"
    done
    [ -n "$drawn" ] || fail 1 "$lesson has drawn nothing"
    [ -n "$scene" ] || return 0
    case "$drawn " in *" $scene "*) ;; *)
        fail 2 "there is no scene \"$scene\" in $lesson. There are:$drawn"
        ;;
    esac
    drawn=$scene
}
