#!/bin/sh
# Draws what the mistakes of each stepNN_name/mistakes.txt draw, and keeps what they look like in
# tests/lessons/STEP/looks, where the check finds it (tests/check/looks.h says how); and as figure 4 of the
# lesson's wrong pictures, stepNN_name/figures/wrong_04.png, what the first mistake of that figure
# draws (tests/check/figure_make.c). To be called again after a change of a lesson's main.c, scenes,
# references or mistakes.txt.
#
#   tests/upkeep/verify/mistakes.sh BUILD MAKE [STEP]
#
# MAKE builds a program; STEP is 5, 05 or step05_zbuffer. Works in BUILD, where the check,
# looks_make, figure_make, the library and the models must be built. As many at a time as there are
# processors; WORKERS=1 in the environment for one.
#
# Exit status 0: done; 1: a list is wrong, or something cannot be written.
cd "$(dirname "$0")/../../.." || exit 1
build=$1
make=$2
wanted=${3:-}
workers=${WORKERS:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)}
work=$(mktemp -d "$build/verify.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

# keep LESSON: what its mistakes look like, and by which signs they are known.
keep() {
    looks=tests/lessons/$1/looks
    rm -rf "$looks"
    awk -F '\t' -v lesson="$1" '$2 == lesson { print $8, $10, $1, $9 }' "$work/table" >"$work/list"
    # shellcheck disable=SC2013 # one word a line
    for scene in $(awk -v lesson="$1" '$1 == lesson { print $2 }' tests/check/scenes.txt); do
        "$build/looks_make" "$1" "$scene" "tests/reference/$1/$scene.png" "$work/list" \
            "$work" tests/lessons || exit 1
    done >"$work/signs" || exit 1
    cat "$work"/[1-9]*/counted >>"$work/signs"
    # shellcheck disable=SC2016 # nothing to expand
    {
        echo '# Made by `make mistakes`: see tests/check/mistakes.h.'
        awk 'FNR == NR { signs[$1] = signs[$1] (signs[$1] ? ";" : "") $2; next }
            { words = substr($0, length($1 " " $2 " " $3) + 2)
              print $1, $2, ($3 in signs ? signs[$3] : "-"), words }' "$work/signs" "$work/list"
    } >"$looks/signs.txt" || exit 1
}

# draw_figures LESSON: the pictures of its table of wrong pictures.
draw_figures() {
    rm -f "$1"/figures/wrong_[0-9][0-9].png
    awk -F '\t' '$11 != "-" { printf "%s %s %s %s wrong_%02d.png\n", $1, $4, $5, $11, $10 }' \
        "$work/table" | while read -r number name scene part figure; do
        mkdir -p "$1/figures" &&
            "$build/figure_make" "tests/reference/$1/$scene.png" "$work/$number/$scene.png" \
                "$part" "$1/figures/$figure" || { echo "mistakes: $1: no picture of $name" >&2 && exit 1; }
    done || exit 1
}

# add_starter LESSON: an entry of the table for what is there when nothing is drawn (looks.h).
add_starter() {
    mkdir "$work/0" && awk -v mode=starter -f tests/student/marks.awk "$1/main.c" >"$work/0/main.c" ||
        exit 1
    printf '0\t%s\tmistake\tstarter\t-\t-\t-\t-\t(the starter)\t0\t-\n' "$1" >>"$work/table"
}

found=
for lesson in step[0-9]*_*/mistakes.txt; do
    lesson=${lesson%/mistakes.txt}
    number=${lesson#step}
    number=${number%%_*}
    case $wanted in '' | "$lesson" | "$number" | "${number#0}") ;; *) continue ;; esac
    found=yes
    awk -v directory="$work" -f tests/upkeep/verify/replace.awk -f tests/upkeep/verify/parse.awk \
        "$lesson/mistakes.txt" >"$work/table" || exit 1
    add_starter "$lesson"
    grep -v '^call ' tests/check/scenes.txt >"$work/pictures.txt" || exit 1
    cut -f 1 "$work/table" |
        xargs -P "$workers" -n 1 sh tests/upkeep/verify/draw.sh "$build" "$make" "$work" || exit 1
    keep "$lesson"
    draw_figures "$lesson"
    find "$work" -mindepth 1 -delete
    echo "$lesson: $(cat "tests/lessons/$lesson/looks"/* 2>/dev/null | wc -c) bytes"
done
[ -n "$found" ] || { echo "mistakes: there is no step '$wanted'" >&2 && exit 1; }
