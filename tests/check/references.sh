#!/bin/sh
# Draws the reference images again: what `make references` calls, and never a check.
#
#   references.sh BUILD MAKE STEP...     STEP: a name like step05_zbuffer, whose program is built
#
# A reference that already shows the same picture is left alone, so that only what has changed is
# written. A step that does not draw all of its scenes changes nothing. Look at every picture that it
# names before you commit it.
#
# Exit status: 0 done, 1 a step failed.
build=$1 make=$2 failed=0
shift 2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
export CHECK_EXACT=1

wrong() {
    echo "references: $*" >&2
    failed=1
}

# is_exact STEP [SCENE]: does the program draw just this reference, or all of the step?
is_exact() {
    "$build/check" --programs "$build/quick" --differences "$work/differences" --make "$make" \
        --only "$2" "$1" >"$work/said" 2>&1
}

# draw STEP: every picture of the table into $work/STEP; or it says which is missing.
draw() {
    mkdir "$work/$1" && "$build/quick/$1" --only all --format png -o "$work/$1" >"$work/said" 2>&1 || return
    for scene in $scenes; do
        [ -f "$work/$1/$scene.png" ] || { echo "$scene: missing" >"$work/said" && return 1; }
    done
}

[ $# -gt 0 ] || wrong "there is no such step"
for step in "$@"; do
    scenes=$(awk -v step="$step" '$1 == step { print $2 }' tests/check/scenes.txt)
    [ -n "$scenes" ] || { wrong "$step has no line in tests/check/scenes.txt" && continue; }
    draw "$step" || { wrong "$step: $(cat "$work/said")" && continue; }
    mkdir -p "tests/reference/$step"
    for scene in $scenes; do
        reference=tests/reference/$step/$scene.png
        if [ ! -f "$reference" ]; then
            kind=new
        elif is_exact "$step" "$scene"; then
            echo "unchanged  $reference" && continue
        else
            kind=changed
        fi
        cp "$work/$step/$scene.png" "$reference" && printf '%-9s  %s\n' "$kind" "$reference" || exit 1
    done
    # A blank picture, for one, is no reference.
    is_exact "$step" '' || wrong "the check does not accept them: $(cat "$work/said")"
done
exit $failed
