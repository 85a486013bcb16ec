#!/bin/sh
# --no-skip does all the work, and every scene of every lesson is the same in each byte: that of the
# shortcuts is the one that is compared with the references. (In lessons 2 and 4 to 8 it is
# trials.c that does it. Which counters may differ, and how: test_skip.c.)
. "$(dirname "$0")/../../unit/script.sh"

for lesson in step[0-9]*_*; do
    for way in skip no-skip; do
        option=--$way
        [ $way = no-skip ] || option=
        # shellcheck disable=SC2086 # no word where there is no option
        "$build/quick/$lesson" --only all -o "$work/$way" --stats $option >"$work/$way.counts" ||
            wrong "$lesson $option: status $?"
    done
    diff -r "$work/skip" "$work/no-skip" || wrong "$lesson: --no-skip draws other pictures"
    # In the scenes of these lessons there is something to skip.
    case $lesson in
    step02* | step06* | step07* | step08* | step09* | step10*)
        ! cmp -s "$work/skip.counts" "$work/no-skip.counts" || wrong "$lesson: nothing was skipped"
        ;;
    esac
    rm -r "$work/skip" "$work/no-skip"
done
exit $failed
