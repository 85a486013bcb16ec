#!/bin/sh
# Does `make verify` find what it is for? In a copy of lesson 1: a mistake that passes, a correct
# program that fails, a wrong solution and a finished starter are findings; lists that are wrong are
# refused with file and line.
. "$(dirname "$0")/../../unit/script.sh"
said=$work/said

mkdir -p "$work/tests/reference" "$work/tests/check" && cd "$work" || exit 1
cp -R "$top/Makefile" "$top/common" "$top/step01_line" . || exit 1
(cd "$top/tests" && cp -R upkeep student "$work/tests" && cp check/check.mk "$work/tests/check") || exit 1
cp -R "$top/tests/reference/step01_line" tests/reference || exit 1
grep -e '^#' -e '^step01' "$top/tests/check/scenes.txt" >tests/check/scenes.txt
mkdir -p tests/lessons/step01_line

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

# ---- All is well ----

mistakes <<'END'
# A comment.

mistake axes
says the axes exchanged
scene pixel
- image_set(image, 52, 41,
+ image_set(image, 41, 52,

mistake no_end
says for ever
scene line
- walk->u++;
+ walk->u += 0;
END
programs <<'END'
accept two_changes
says another bound, and a pixel found by a sum
build CFLAGS=-O0
- walk.u <= walk.u_last; walk_next(&walk)) {
-         struct pixel p
+ walk.u < walk.u_last + 1; walk_next(&walk)) {
+         struct pixel p
- image_set(image, 52, 41,
+ image_set(image, 51 + 1, 41,
END
CHECK_TIMEOUT=1 verify 0
says 'step01_line  *2/2  *0/2  *1/1  *5/5  to do  *exact'
verify 0 axes
says 'step01_line  *1/1  *0/1  *0/0  *0/0  -  *-'
printf 'accept elsewhere\nsays no compiler\nbuild CC=no_such_compiler\n' >tests/lessons/step01_line/alternatives.txt
verify 0 elsewhere
says 'SKIPPED step01/elsewhere: there is no no_such_compiler'
verify 1 nothing_like_it
says 'verify: no name has'

# ---- What mistakes look like ----

# `mistakes` keeps it, and then they are named; one that draws nothing, by that it draws all else.
cat >step01_line/mistakes.txt <<'END'
mistake axes
says the axes exchanged
scene pixel
figure 1
- image_set(image, 52, 41,
+ image_set(image, 41, 52,

mistake blue
says blue for red
scene pixel
figure 1
- image_set(image, 52, 41, color_rgb(255, 0, 0));
+ image_set(image, 52, 41, color_rgb(0, 0, 255));

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
says 'step01_line  *4/4  *4/4  *0/0  *5/5  to do  *exact'
signs=tests/lessons/step01_line/looks/signs.txt
grep -q '^1\.1 1 pixel:2:2 the axes exchanged$' "$signs" || wrong "not kept: figure 1"
grep -q '^1\.1 0 pixel:brrrrrr:- no pixel$' "$signs" || wrong "not kept: no pixel"
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
changed 1 's/^1.1 0 pixel:brrrrrr:- no pixel/1.1 0 - no pixel\n1.1 0 pixel:brrrrrr:- void/' nothing \
    'MISLEADS step01/nothing: FAIL '
sed -i.old 's/color_rgb(255, 0, 255)/color_rgb(255, 255, 0)/' step01_line/mistakes.txt
verify 1
says 'STALE step01/purple: '
says 'step01_line  *3/4  *3/4  *0/0'
looks
verify 0

# ---- Figures ----

# The first mistake of a figure gives its picture, of the part that it names.
figures=step01_line/figures
has_size() {
    set -- "$1" "$2" "$(od -An -tu1 -j16 -N8 "$figures/$1" |
        awk '{ print $3 * 256 + $4 " " $7 * 256 + $8 }')"
    [ "$3" = "$2" ] || wrong "$1 has $3 pixels, not $2"
}
has_size wrong_01.png '404 200'
has_size wrong_02.png '404 100'
cp "$figures/wrong_02.png" "$figures/wrong_01.png"
rm "$figures/wrong_02.png"
verify 1
says "STALE step01/axes: $figures/wrong_01.png: make mistakes STEP=01"
says "STALE step01/purple: $figures/wrong_02.png: make mistakes STEP=01"
echo old >"$figures/wrong_03.png"
looks
verify 0
[ ! -f "$figures/wrong_03.png" ] || wrong "figure 3 is still there"
cp step01_line/mistakes.txt mistakes.kept
sed 's/^says no pixel/&\nfigure 3/' mistakes.kept >step01_line/mistakes.txt
verify 1 nothing
says 'ERROR step01/nothing: no figure 3: figure_make: all of it is black'
rm -r tests/lessons/step01_line/looks
cp mistakes.kept step01_line/mistakes.txt

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
says 'PASSES step01/elsewhere: 1/1 .* exact (shown by another scene); all scenes: FAIL 1/.*; line F'
says 'ERROR step01/no_program: BUILD '
says 'FAILS step01/axes: FAIL [0-9]*/.*; pixel FAIL 0/1: 2 of 2 drawn pixels differ'
says 'step01_line  *0/2  *0/2  *0/1  *5/5  to do  *exact'

rm step01_line/mistakes.txt tests/lessons/step01_line/alternatives.txt
sed -i.old 's/image_set(image, 52, 41,/image_set(image, 52, 42,/' step01_line/main.c
verify 1
says 'WRONG step01_line/solution: FAIL [0-9]*/.*; pixel FAIL 0/1: 2 of 2 drawn pixels differ (must be exact), shi'
says 'step01_line  *0/0  *0/0  *0/0  *2/5  to do  *wrong'
mv step01_line/main.c.old step01_line/main.c
sed -i.old 's/ 1\.3,1\.4 / 1.4     /; s/1\.5+1\.3,1\.4/1.5+1.4    /' tests/check/scenes.txt
verify 1
says 'WRONG step01_line without 1.3: CRASH [0-9]*/.*; list CRASH 0/'
says 'step01_line  *0/0  *0/0  *0/0  *4/5  to do  *exact'
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

a='mistake a'
b='says b'
pixel='scene pixel'
before='- walk->u++;'
after='+ walk->u--;'
refused 4 'a: the text does not occur in step01_line/main.c' "$a" "$b" "$pixel" '- no such text' '+ text'
refused 4 'a: the text occurs more than once' "$a" "$b" "$pixel" '- walk' '+ walks'
# shellcheck disable=SC2016 # a word of the message
refused 1 'a: no line `says' "$a" "$pixel" "$before" "$after"
refused 1 'a: no scene of step01_line: pixels' "$a" "$b" 'scene pixels' "$before" "$after"
refused 2 'a line that means nothing: say b' "$a" 'say b'
refused 1 'this is in no paragraph' "$b"

exit $failed
