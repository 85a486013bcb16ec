#!/bin/sh
# --no-skip does all the work, and every scene of every lesson is the same in each byte: that of the
# shortcuts is the one that is compared with the references. The counters tell of the same scene:
# what was asked for is equal, no more is left out, and no less is done; and depth tests, which are
# counted for --stats alone, are counted.
. "$(dirname "$0")/../../unit/script.sh"

# What is counted, by the end of its name. A shader that discards is asked a second time by the
# shortcuts: so what `culling` shades tells nothing.
cat >"$work/judge.awk" <<'EOF'
function kind(name) {
    if (name ~ /\.(objects|faces|triangles)$|^files\./) return "asked"
    if (name ~ /_(skipped|reused|outside|hidden|behind|turned_away)$/) return "left out"
    if (name ~ /\.faces_(unlit|too_far|without_pixel|clipped)$|\.lines_off_image$/) return "found"
    return name == "culling.pixels_shaded" ? "found" : "done"
}
{
    name = $1
    sub(/:$/, "", name)
    what = kind(name)
    if ($1 != $3) bad = "another counter"
    else if (what == "asked" && $2 != $4) bad = "not equal"
    else if (what == "left out" && $4 > $2) bad = "more left out with --no-skip"
    else if (what == "done" && $4 < $2) bad = "less done with --no-skip"
    else if (name ~ /\.pixels_(covered|passed)$/ && $2 == 0) bad = "no depth test is counted"
    else bad = ""
    if (bad != "") print $0 ": " bad
    saved += what == "done" && $4 > $2
}
END { print saved + 0 > saved_in }
EOF

for lesson in step[0-9]*_*; do
    for way in skip no-skip; do
        option=--$way
        [ $way = no-skip ] || option=
        # shellcheck disable=SC2086 # no word where there is no option
        "$build/$lesson" -o "$work/$way" --stats $option >"$work/$way.counts" ||
            wrong "$lesson $option: status $?"
    done
    diff -r "$work/skip" "$work/no-skip" || wrong "$lesson: --no-skip draws other pictures"
    paste -d ' ' "$work/skip.counts" "$work/no-skip.counts" >"$work/both"
    awk -v saved_in="$work/saved" -f "$work/judge.awk" "$work/both" >"$work/said"
    [ ! -s "$work/said" ] || wrong "$lesson: $(cat "$work/said")"
    # In the scenes of these lessons there is something to skip.
    case $lesson in
    step02* | step06* | step07* | step08* | step09* | step10*)
        [ "$(cat "$work/saved")" -gt 0 ] || wrong "$lesson: nothing was skipped"
        ;;
    esac
    rm -r "$work/skip" "$work/no-skip"
done
exit $failed
