#!/bin/sh
# Do each lesson's table of wrong pictures (WRONG.md), its mistakes.txt and the pictures in figures agree?
# A row has the number of its figure and the picture, `| 4 | ![words](figures/wrong_04.png) | ...`, or
# neither; the numbers go from 1 on; each figure is drawn by a mistake (`figure 4`), and no other is there.
. "$(dirname "$0")/../../unit/script.sh"

# agree WORDS: the table has a line for each number in $work/numbers.
agree() {
    awk '{ printf "%d figures/wrong_%02d.png\n", $1, $1 }' "$work/numbers" |
        diff - "$work/table" >"$said" || wrong "$lesson: $*"
}

said=$work/said

for lesson in step[0-9]*_*/mistakes.txt; do
    lesson=${lesson%/*}
    awk -F ' *[|] *' '/^[|] figure [|]/ { table = getline; next } !/^[|]/ { table = 0 }
        table && $2 $3 != "" { sub(/^!\[[^]]+\]\(/, "", $3); sub(/\)$/, "", $3); print $2, $3 }' \
        "$lesson/WRONG.md" >"$work/table"
    awk '{ print NR }' "$work/table" >"$work/numbers"
    agree "figures of the table are not those from 1 on"
    sed -n 's/^figure \([0-9]*\).*/\1/p' "$lesson/mistakes.txt" | sort -nu >"$work/numbers"
    agree "the figures of mistakes.txt are others than those of WRONG.md"
    find "$lesson/figures" -name 'wrong_[0-9]*' | sed 's/.*_0*\([0-9]*\)\.png/\1/' | sort -n >"$work/numbers"
    agree "the pictures are others than those of WRONG.md: make mistakes draws them"
done
exit $failed
