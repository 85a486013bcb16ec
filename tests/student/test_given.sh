#!/bin/sh
# Is what a lesson teaches given from the next lesson on, and not before? For each function in
# common/given: a program that names it does not build in the first lesson and in its own, and is told
# why, and nothing else; in the next lesson it builds. No header that its lesson's texts name has it.
# In the check a lesson that calls ours has no points.
. "$(dirname "$0")/../unit/script.sh"

# Lines `LESSON FUNCTION`: what is given after that lesson.
awk '/^#if COURSE_LESSON <= / { lesson = $4 }
    /^#define/ && lesson { print lesson, $2 }
    /^#endif/ { lesson = "" }' common/given/*.h >"$work/given"
sed -n 's/^[a-z].*[ *]\([a-z0-9_]*\)(.*/\1/p' common/given/*.h | sort >"$work/functions"
cut -d ' ' -f 2 "$work/given" | sort | diff - "$work/functions" >"$work/log" && [ -s "$work/given" ] ||
    wrong "not all functions of common/given are taught in a lesson: $(cat "$work/log")"

# A program that names them all, one a line, is told about those that its lesson does not have yet, and
# nothing else.
{
    printf '#include "program.h"\n#include "texture.h"\n\nint main(void) {\n'
    sed 's/.* \(.*\)/    (void)\1;/' "$work/given"
    echo '}'
} >"$work/main.c"
for compiler in gcc clang; do
    command -v $compiler >"$work/log" || continue
    for lesson in 1 2 3 4 5 6 7 8 9 10; do
        awk -v lesson=$lesson '$1 >= lesson {
            lessons = $2 ~ /^line_/ ? "lessons 1 and 2" : "lesson " $1
            printf "main.c:%d: you write %s() in %s; it is given from lesson %d on\n", NR + 4, $2, lessons, $1 + 1
        }' "$work/given" >"$work/wanted"
        $compiler -std=c17 -Wall -Wextra -Werror -fsyntax-only -Icommon -DCOURSE_LESSON=$lesson \
            "$work/main.c" 2>&1 | sed -n "/error: /{s|.*/main|main|; s/:[0-9]*: error//; s/, and yours has .*//; p;}" |
            diff "$work/wanted" - >"$work/log" || wrong "$compiler, lesson $lesson: $(head -n 5 "$work/log")"
        echo '#include "pipeline.h"' >"$work/pipeline.c"
        $compiler -fsyntax-only -Icommon -DCOURSE_LESSON=$lesson "$work/pipeline.c" >"$work/log" 2>&1
        case $lesson:$? in
        9:0 | 10:0) ;;
        [1-8]:1) grep -q 'error: .*given from lesson 9 on' "$work/log" ;;
        *) false ;;
        esac || wrong "$compiler, the pipeline in lesson $lesson: $(head -n 5 "$work/log")"
    done
done

# ---- The texts: what they tell to read has no answer (MORE.md is for afterwards) ----

while read -r taught function; do
    for lesson in step01_* "$(echo step*"${taught}"_*)"; do
        # shellcheck disable=SC2046 # one word a file
        awk -v mode=starter -f tests/student/marks.awk "$lesson/main.c" |
            cat - $(pages "$lesson") "$lesson/hints.txt" | grep -oE '[a-z0-9_/]+\.[ch]\>' |
            sed 's|^common/||; s|^|common/|' | sort -u | while read -r named; do
            ! grep -qw "$function" "$named" 2>"$work/log" || echo "$lesson names $named, which has $function()"
        done
    done
done <"$work/given" >"$work/named"
[ ! -s "$work/named" ] || wrong "$(cat "$work/named")"

# Nor have the headers that a student is told to read the answer of task 10c.1.
for header in $(sed -n 's|^. \[`\([a-z]*\.h\)`\].*|\1|p' tests/student/README.md); do
    ! grep -n -- '- 127\.5' "common/$header" || wrong "common/$header has the answer of task 10c.1"
done

# ---- The check ----

# All that is made of a lesson's main.c is compiled as its own.
# shellcheck disable=SC2046 # one word a target
make -n V=1 BUILD="$work/build" $(for lesson in step*; do
    echo "$work/build/$lesson"
    for place in quick sanitized; do
        echo "$work/build/$place/$lesson $work/build/$place/numbers/$lesson $work/build/$place/numbers/$lesson.tried"
    done
done) >"$work/log" 2>&1 || wrong "make -n: $(tail -n 3 "$work/log")"
for lesson in step*; do
    number=${lesson#step}
    number=${number%%_*}
    [ "$(grep -c -- " -DCOURSE_LESSON=${number#0} .* -c [^ ]*$lesson/" "$work/log")" -eq 7 ] ||
        wrong "$lesson is not compiled as lesson ${number#0}"
done

awk -v mode=solution -f tests/student/marks.awk step06_texture/main.c |
    awk '/vec4 sample_bilinear\(/ { inside = 1 }
        inside && /place_in/ { print "    return texture_bilinear(texture, uv, number);"; inside = 0; next }
        { print }' >"$work/main.c"
make -s BUILD="$build" commands >"$work/commands"
said_by 1 "$build/check" --programs "$work" --sources "$work" --differences "$work/differences" \
    --make "sh tests/upkeep/verify/build.sh $work/commands" step06_texture
says 'SCORE 0/'
says 'error: you write texture_bilinear() in lesson 6; it is given from lesson 7 on'
exit $failed
