# For scripts that work on a lesson's pictures, which read this with `.` after lesson.sh, with
# `build`, `lesson` and `scene` set.

# Sets drawn to the names of the scenes whose pictures are there: all, or the one in `scene`.
find_drawn() {
    drawn=
    for picture in "$build/out/$lesson"/*.tga; do
        [ ! -f "$picture" ] || drawn="$drawn $(basename "$picture" .tga)"
    done
    [ -n "$drawn" ] || fail 1 "$lesson has drawn nothing"
    [ -n "$scene" ] || return 0
    case "$drawn " in *" $scene "*) ;; *)
        fail 2 "there is no scene \"$scene\" in $lesson. There are:$drawn"
        ;;
    esac
    drawn=$scene
}
