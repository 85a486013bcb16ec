#!/bin/sh
# Is a lesson entered in few places only? Makes a small course of two lessons: one of ours, and a
# copy of it under a new name, entered where CONTRIBUTING.md, "A new lesson", says and nowhere else.
# The copy must be built, drawn, checked and measured; parts that a lesson need not have may be
# missing.
. "$(dirname "$0")/../unit/script.sh"
old=step05_zbuffer
new=step11_copy

# course TARGET...: make in the small course; what it says goes to the log.
course() {
    said_by 0 make -s WERROR=-Werror CFLAGS=-O1 "$@"
}

# renamed FILE: its text with the new lesson's name and number.
renamed() {
    sed -e "s/$old/$new/g" -e "s/${old%%_*}/${new%%_*}/g" "$1"
}

# ---- A course of one lesson ----

cp -R "$top/Makefile" "$top/common" "$top/tests" "$top/$old" "$work" && cd "$work" || exit 1
rm -rf tests/reference
find tests/lessons -mindepth 1 -maxdepth 1 ! -name $old -exec rm -r {} +
mkdir tests/reference && cp -R "$top/tests/reference/$old" tests/reference || exit 1
grep "^$old " "$top/tests/check/scenes.txt" >scenes.txt || exit 1

# ---- A lesson more: its directory, its scenes, their pictures, its benchmark ----

mkdir $new
for file in "$old"/*; do
    [ -d "$file" ] || renamed "$file" >"$new/${file##*/}"
done
{ cat scenes.txt; renamed scenes.txt; } >tests/check/scenes.txt
cp -R tests/reference/$old tests/reference/$new
mkdir tests/lessons/$new || exit 1
for file in bench.c figures.c large.h live.c trials.c; do
    renamed tests/lessons/$old/$file >tests/lessons/$new/$file
done

# ---- It is drawn, checked, measured, and its other pictures are drawn ----

course
diff -r -x .drawn -x .all_drawn build/out/$old build/out/$new || wrong "the copy does not draw the same pictures"
build/$new --help | grep -q $new || wrong "build/$new does not say its own name"

course check
grep -q "^$new  PASS .* exact\$" "$said" || wrong "the check does not pass the copy"
[ "$(tail -n 1 "$said")" = "2 passed, 0 failed" ] || wrong "not all pass"

export BENCH_SECONDS=0.05
course bench STEP=11
course charts
cmp "build/bench/$new.svg" "$new/figures/bench.svg" || wrong "the copy has no chart"
grep -q "\"$new\"" build/bench/all.json || wrong "all.json does not name the copy"

course lesson-figures
# (Drawings, which are written by hand, have no program; `make mistakes` draws the wrong pictures.)
diff -r -x '*.svg' -x 'wrong_[0-9][0-9].png' $old/figures $new/figures ||
    wrong "the copy has not the same figures"

# ---- A lesson needs no figures and no benchmark ----

rm -rf $new/figures tests/lessons/$new "build/bench/$new.svg"
course lesson-figures
course bench STEP=05
course charts
if grep $new "$said" || [ -e $new/figures ]; then
    wrong "a lesson without figures and benchmark is not left alone"
fi
exit $failed
