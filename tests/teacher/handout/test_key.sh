#!/bin/sh
# Does the instructor get what the students do not? In a copy of lessons 1 and 4, with few mistakes:
# the solution without marks, each mistake with the picture that it draws, the points
# as the table of scenes has them; the same bytes twice; all of it or nothing.
. "$(dirname "$0")/../../unit/script.sh"
said=$work/said && : >"$said"

mkdir -p "$work/course/tests/reference" && cd "$work/course" || exit 1
cp -R "$top/Makefile" "$top/README.md" "$top/LICENSE" "$top"/.gitattributes "$top/.gitignore" "$top/common" . &&
    cp -R "$top/step01_line" "$top/step04_flat" . || exit 1
(cd "$top/tests" && tests=$work/course/tests &&
    cp -R check student teacher upkeep "$tests" &&
    cp -R reference/step0[1-4]_* "$tests/reference" &&
    cp lesson.h numbers.h more_scenes.h "$tests" && mkdir "$tests/lessons" &&
    cp -R lessons/step01_line lessons/step04_flat "$tests/lessons") || exit 1
grep -e '^#' -e 'step01_' -e 'step04_' "$top/tests/check/scenes.txt" >tests/check/scenes.txt
cat >step01_line/mistakes.txt <<'END'
mistake axes
says x & y exchanged: "41" <before> 52
scene pixel
- image_set(image, 52, 41,
+ image_set(image, 41, 52,

mistake next_column
says the next column
scene pixel
- image_set(image, 52, 41,
+ image_set(image, 53, 41,

mistake killed
says the program ends too early
scene line
- walk->u++;
+ abort();
- #include "scenes.h"
+ #include "scenes.h"
+ #include <stdlib.h>

mistake short
says both ends belong to the line
scene numbers
- return (size_t)(width > height ? width : height) + 1;
+ return (size_t)(width > height ? width : height);
END
cp "$top/step04_flat/main.c" step04_flat/main.c

# key STATUS OUT [LESSONS]: what it says is in $work/said.
key() {
    sh tests/teacher/handout/key.sh "$build" "make -s BUILD='$build'" "$2" "$3" >"$work/said" 2>&1
    status=$?
    [ $status -eq "$1" ] || wrong "status $status, not $1"
}

# refuses STATUS WORDS [LESSONS]: ends with that, and leaves nothing.
refuses() {
    key "$1" "$work/refused" "$3"
    grep -q "$2" "$work/said" || wrong "does not say: $2"
    ls -d "$work"/refused* "$build"/key.* >"$work/said" 2>/dev/null
    [ ! -s "$work/said" ] || wrong "leaves something behind"
}

# ---- All is well ----

key 0 "$work/a" 1
cd "$work/a" || exit 1
[ ! -e step04_flat ] || wrong "a lesson that was not wanted"
awk -v mode=solution -f "$top/tests/student/marks.awk" "$top/step01_line/main.c" |
    cmp -s - step01_line/main.c || wrong "main.c is not the solution"
! grep -rlE 'BEGIN SOLUTION|END SOLUTION' . >"$work/said" || wrong "a mark is left"

page=step01_line/mistakes.html
grep -o '<h2>.*</h2>' $page >"$work/said"
[ "$(tr -d '\n' <"$work/said")" = '<h2>axes</h2><h2>next_column</h2><h2>killed</h2><h2>short</h2>' ] ||
    wrong "other mistakes"
grep -qF '<p>x &amp; y exchanged: "41" &lt;before&gt; 52 (task 1.1)</p>' $page ||
    wrong "no sentence in HTML"
grep -q '^+ *image_set(image, 41, 52,' $page || wrong "nobody sees what was changed"
grep -q 'line_length((0, 0), (5, 2)) must be 6: yours 5' $page || wrong "nobody sees the wrong number"
grep -q 'CRASH' $page || wrong "nobody sees that a program was killed"
[ "$(grep -c 'src="reference/pixel.png"' $page)" -eq 2 ] || wrong "no references"
grep -o 'src="[^"]*"' $page | sed 's/src="/step01_line\//; s/"//' |
    xargs ls >/dev/null 2>"$work/said" || wrong "pictures that are not there"
for name in axes next_column; do
    columns=41,\ 52
    [ $name = axes ] || columns=53,\ 41
    mkdir -p "$work/by_hand" && sed "s/image_set(image, 52, 41,/image_set(image, $columns,/" \
        step01_line/main.c >"$work/by_hand/main.c"
    (cd "$top" && cc -std=c17 -w -Wno-psabi -Icommon -Istep01_line -DCOURSE_BUILD='""' \
        "$work/by_hand/main.c" "$build/libcommon.a" -lm -pthread -o "$work/by_hand/line" &&
        "$work/by_hand/line" --only pixel --format png -o "$work/by_hand") >"$work/said" 2>&1
    cmp -s "$work/by_hand/pixel.png" step01_line/mistakes/$name.png ||
        wrong "not the picture of $name"
done

# The sums: of all lines of the table that give points.
points=$(awk '$1 == "step01_line" { sum += $4 } $2 == "step01_line" { sum += $5 }
    END { print sum }' "$work/course/tests/check/scenes.txt")
grep -qF "| all | | | **$points** | |" README.md || wrong "not $points points in all"
awk -F '|' '$3 ~ /[0-9]\.[0-9]/ { sum += $5 } END { print sum }' README.md >"$work/said"
[ "$(cat "$work/said")" -eq "$points" ] || wrong "the points of the tasks are not $points"
mkdir -p tests/unit tests/reference tests/upkeep/texts && cp "$top/tests/unit/script.sh" tests/unit &&
    cp "$top/tests/upkeep/texts/test_links.sh" tests/upkeep/texts
sh tests/upkeep/texts/test_links.sh >"$work/said" 2>&1 || wrong "links"
rm -rf tests

# ---- Twice the same; from a lesson that somebody has begun, too ----

cd "$work/course" || exit 1
WORKERS=1 key 0 "$work/b" 1
diff -r "$work/a" "$work/b" >"$work/said" || wrong "the second time differs"
rm -rf "$work/b"
make -s start STEP=01 >"$work/said" 2>&1 || wrong "make start"
key 0 "$work/b" 1
diff -r "$work/a" "$work/b" >"$work/said" || wrong "the key of a lesson that was begun differs"
sh tests/teacher/handout/handout.sh "$work/students" 1 >"$work/said" 2>&1 || wrong "handout"
cmp -s step01_line/main.c "$work/students/step01_line/main.c" || wrong "no starter is handed out"

# ---- A mark that is left ends a hand-out ----

echo '/* END SOLUTION */' >>step01_line/attempts.h
sh tests/teacher/handout/handout.sh "$work/marks" 1 >"$work/said" 2>&1 && wrong "a mark is handed out"
grep -q 'a mark is left in ./step01_line/attempts.h' "$work/said" || wrong "does not say where"
ls -d "$work"/marks* >"$work/said" 2>/dev/null && wrong "a refused hand-out leaves something"

# ---- What cannot be done ----

key 1 "$work/a" 1
grep -q 'not an empty directory' "$work/said" || wrong "says something else"
key 2 "" 1
refuses 2 'neither a number' 4-x
refuses 2 'no lesson' 44
mv step01_line/main.c.marked step01_line/main.c
sed 's/^says the next column$//' step01_line/mistakes.txt >changed
mv changed step01_line/mistakes.txt
refuses 1 'step01_line/mistakes.txt:7: next_column: no line' 1
: >step01_line/mistakes.txt
sed 's/image_set(image, 52, 41,/image_set(image, 41, 52,/' "$top/step01_line/main.c" \
    >step01_line/main.c
refuses 1 'step01/solution: FAIL' 1
awk -v mode=solution -f tests/student/marks.awk "$top/step01_line/main.c" \
    >step01_line/main.c
refuses 1 'no good marks' 1
sh tests/teacher/handout/handout.sh "$work/solutions" 1 >"$work/said" 2>&1 && wrong "a solution is handed out"
[ ! -e "$work/solutions" ] || wrong "a refused hand-out leaves something"
exit $failed
