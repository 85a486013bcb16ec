#!/bin/sh
# Does `make verify` find what it is for? (That it finds nothing else, it shows in every lesson.) In
# a copy of lesson 1: a mistake that passes, a correct program that fails, a wrong solution and a
# finished starter are findings, and looks that are not those kept; lists that are wrong are refused
# with file and line.
. "$(dirname "$0")/../../unit/script.sh"
said=$work/said

mkdir -p "$work/tests/reference" "$work/tests/check" && cd "$work" || exit 1
cp -R "$top/Makefile" "$top/common" "$top/step01_line" . || exit 1
(cd "$top/tests" && cp -R upkeep student "$work/tests" &&
    cp check/check.mk check/compare.h "$work/tests/check") || exit 1
cp -R "$top/tests/reference/step01_line" tests/reference || exit 1
grep -e '^#' -e '^step01' "$top/tests/check/scenes.txt" >tests/check/scenes.txt
mkdir -p tests/lessons/step01_line && cp "$top/tests/lessons/step01_line/trials.c" tests/lessons/step01_line &&
    cp "$top/tests/lesson.h" "$top/tests/more_scenes.h" tests || exit 1

# verify STATUS [NAME]: what it says is in `said`.
verify() {
    sh tests/upkeep/verify/verify.sh "$build" "make -s BUILD='$build'" 01 "$2" >said 2>&1
    status=$?
    [ $status -eq "$1" ] || wrong "status $status, not $1"
}

# says TEXT: a line begins with it.
says() {
    grep -q "^$1" said || wrong "nothing says: $1"
}

mistakes() {
    cat >step01_line/mistakes.txt
}

programs() {
    cat >tests/lessons/step01_line/alternatives.txt
}

# ---- What mistakes look like ----

# `mistakes` keeps it, and then they are named; one that draws nothing, by that it draws all else.
mistakes <<'END'
# A comment.

mistake axes
says the axes exchanged
scene pixel
figure 1
- image_set(image, 52, 41,
+ image_set(image, 41, 52,

mistake purple
says too much blue
scene pixel
figure 2 20x10+45+35
- image_set(image, 52, 41, color_rgb(255, 0, 0));
+ image_set(image, 52, 41, color_rgb(255, 0, 255));

mistake nothing
says no pixel
scene pixel
- image_set(image, 52, 41, color_rgb(255, 0, 0));
+ (void)image;
END
looks() {
    sh tests/upkeep/verify/mistakes.sh "$build" "make -s BUILD='$build'" 01 >said 2>&1 ||
        wrong "mistakes.sh failed"
}
looks
verify 0
says 'step01_line  *3/3  *3/3  *0/0  *5/5  to do  *exact'
signs=tests/lessons/step01_line/looks/signs.txt
cp "$signs" kept
# changed STATUS SED_EXPRESSION NAME TEXT: that is said of the mistake when the signs are others.
changed() {
    sed "$2" kept >"$signs"
    ! cmp -s kept "$signs" || wrong "changes nothing: $2"
    verify "$1" "$3"
    says "$4"
    cp kept "$signs"
}
changed 1 's/ no pixel/ nothing/' nothing 'STALE step01/nothing: not in '
changed 1 's/^1.1 0 pixel:brrrrrrrrrr:- no pixel/1.1 0 - no pixel\n1.1 0 pixel:brrrrrrrrrr:- void/' nothing \
    'MISLEADS step01/nothing: FAIL '
figures=step01_line/figures
cp $figures/wrong_02.png $figures/wrong_01.png
rm $figures/wrong_02.png
sed -i.old 's/^says no pixel/&\nfigure 3/' step01_line/mistakes.txt
verify 1
says "STALE step01/axes: $figures/wrong_01.png: make mistakes STEP=01"
says "STALE step01/purple: $figures/wrong_02.png: make mistakes STEP=01"
says 'ERROR step01/nothing: no figure 3: figure_make: all of it is black'
rm -r tests/lessons/step01_line/looks

# ---- Findings ----

mistakes <<'END'
mistake elsewhere
says shown by another scene
scene pixel
- .error = -(u_end - u_start),
+ .error = 0,

mistake no_program
says it does not build
scene pixel
- walk->u++;
+ walk->u++
END
programs <<'END'
accept axes
says not correct
- image_set(image, 52, 41,
+ image_set(image, 41, 52,
END
verify 1
says 'PASSES step01/elsewhere: 1/1 .* exact (shown by another scene); all scenes: FAIL 2/.*; line F'
says 'ERROR step01/no_program: BUILD '
says 'FAILS step01/axes: FAIL [0-9]*/.*; pixel FAIL 0/1: no drawn pixel is right'
says 'step01_line  *0/2  *0/2  *0/1  *5/5  to do  *exact'

rm step01_line/mistakes.txt tests/lessons/step01_line/alternatives.txt
sed -i.old 's/image_set(image, 52, 41,/image_set(image, 52, 42,/' step01_line/main.c
verify 1
says 'WRONG step01_line/solution: FAIL [0-9]*/.*; pixel FAIL 0/1: no drawn pixel is right (must be exact)'
says 'step01_line  *0/0  *0/0  *0/0  *2/5  to do  *wrong'
mv step01_line/main.c.old step01_line/main.c
sed -i.old 's/ 1\.3,1\.4~1\.2 / 1.4~1.2     /; s/1\.5+1\.3,1\.4~/1.5+1.4~/
    s/^\(step01_line *far *\)1\.2 /\11.2,1.5 /' tests/check/scenes.txt
verify 1
says 'WRONG step01_line without 1.3: CRASH [0-9]*/.*; list CRASH 0/'
says 'UNEARNED step01_line without 1.5: TODO [0-9]*/.* 1.5 TODO 1/'
says 'step01_line  *0/0  *0/0  *0/0  *3/5  to do  *exact'
mv tests/check/scenes.txt.old tests/check/scenes.txt
cp step01_line/main.c main.c
awk -v mode=solution -v name=step01_line/main.c -f tests/student/marks.awk main.c \
    >step01_line/main.c
verify 1
says 'WRONG step01_line/starter: PASS .* exact'
cp main.c step01_line/main.c

# ---- Lists that are wrong ----

# refused LINE MESSAGE TEXT_LINE...: such a list of mistakes is, for that line.
refused() {
    at="step01_line/mistakes.txt:$1: $2"
    shift 2
    printf '%s\n' "$@" >step01_line/mistakes.txt
    verify 1
    says "$at"
}

refused 4 'a: the text does not occur in step01_line/main.c' 'mistake a' 'says b' 'scene pixel' '- no such text'
refused 4 'a: the text occurs more than once' 'mistake a' 'says b' 'scene pixel' '- walk' '+ walks'
refused 1 'a: no scene of step01_line: pixels' 'mistake a' 'says b' 'scene pixels' '- walk->u++;' '+ ;'
refused 2 'a line that means nothing: say b' 'mistake a' 'say b'

exit $failed
