#!/bin/sh
# Lets the check judge one program of the table that verify.sh has made: builds it, draws the scene
# or all of them, compares.
#
#   tests/upkeep/verify/try.sh BUILD MAKE WORK NUMBER
#
# Prints a finding, or nothing. Adds `LESSON KIND right TOLD` or `... wrong TOLD` to WORK/results
# (TOLD: yes for a mistake that the check names), and to WORK/shares, for each picture, `KIND NAME
# LESSON SCENE WRONG APART COVERAGE NEAR LIGHTER LOOK` as `check --shares` writes them.
. tests/upkeep/verify/entry.sh

# finding WORDS: prints them with the name; the result is wrong.
finding() {
    result=wrong
    case $kind in
    starter | solution) echo "$1 $lesson/$name: $2" ;;
    undone) echo "$1 $lesson without $name: $2" ;;
    *) echo "$1 ${lesson%%_*}/$name: $2" ;;
    esac
}

# A mistake that the scene does not show: whether others do.
describe_others() {
    check
    [ "$status" -eq 1 ] && echo "; all scenes: $said"
}

# It leads to a hint for its task.
judge_task() {
    told=yes
    case $task:$said in
    -:* | *" TASK=$task"*) ;;
    *) finding MISLEADS "not to task $task: $said" ;;
    esac
}

# A mistake that no picture tells is told by what it counts, and by which pictures of the whole
# lesson are right (tests/check/counters.h), when not more than four are the same.
judge_counted() {
    list=tests/check/looks/$lesson/counters.list
    [ -d "${list%/*}" ] || return
    check --counted "$place/shown"
    list_counted "$place/shown" >"$place/now"
    awk -v says="$task $figure $says" 'substr($0, length($1 " " $2 " " $3) + 2) == says' "$list" \
        >"$place/kept" 2>/dev/null
    same=$(awk -v scene="$scene" '{ key = $1 " " $2 " " $3 }
        FNR == NR { if ($1 == scene) wanted = key; next }
        key == wanted { n++ }
        END { print n + 0 }' "$place/now" "$list" 2>/dev/null)
    case $same:$said in
    *'looks like'*"\"$says\""* | *'may be'*"\"$says\""*) judge_task ;;
    *'looks like'* | *'may be'*) finding MISLEADS "$said ($says)" ;;
    [1-4]:*) finding STALE "looks like nothing: $redo" ;;
    esac
    cmp -s "$place/now" "$place/kept" || finding STALE "not so in $list: $redo"
}

# A mistake that is found must look like itself, when it can be told from others, and lead to a hint
# for its task. Sets told to yes, or no when it cannot be told.
judge_looks() {
    list=tests/check/looks/$lesson/$scene.txt
    redo="make mistakes STEP=${lesson#step}"
    redo=${redo%%_*}
    row=none
    [ ! -f "$list" ] || row=$(awk -v says="$task $figure $says" '
        substr($0, length($1 " " $2) + 2) == says { row = $1 > row ? $1 : row; found = 1 }
        END { print found ? row + 0 : "none" }' "$list")
    distance=$(awk 'END { print $8 }' "$place/shares" 2>/dev/null)
    told=no
    case $row:$said in
    none:*) if [ -f "$list" ]; then finding STALE "not in $list: $redo"; else judge_counted; fi ;;
    0:* | *"; $scene PASS"*) judge_counted ;; # a picture that is right, or within the limits
    *'looks like'*"\"$says\""* | *'may be'*"\"$says\""*)
        judge_task
        [ "$distance" = 0 ] || finding STALE "$redo"
        ;;
    *'looks like'* | *'may be'*) finding MISLEADS "$said ($says)" ;;
    *) finding STALE "looks like nothing: $redo" ;;
    esac
    case $result:$told in
    right:no) [ ! -d "${list%/*}" ] || finding UNNAMED "$said ($says)" ;;
    esac
}

# The mistake whose picture stands in the lesson's table of wrong pictures still draws that one.
judge_figure() {
    kept=$lesson/figures/wrong_$(printf %02d "$figure").png
    "$build/figure_make" "tests/reference/$lesson/$scene.png" \
        "$place/differences/$lesson/yours/$scene.png" "$part" "$place/figure.png" \
        2>"$place/errors" || finding ERROR "no figure $figure: $(cat "$place/errors")"
    [ ! -f "$place/figure.png" ] || cmp -s "$place/figure.png" "$kept" ||
        finding STALE "$kept: make mistakes STEP=$(expr "$lesson" : 'step\([0-9]*\)')"
}

judge() {
    case $kind:$status:$said in
    mistake:1:BUILD*) finding ERROR "$said" ;;
    mistake:1:*)
        case $part in -) ;; *) judge_figure ;; esac
        judge_looks
        ;;
    undone:1:TODO\ * | undone:1:BUILD*) ;; # all that fails needs it, or nothing can be built
    starter:1:TODO\ 0/* | accept:0:* | solution:0:*' exact') ;; # as it should be
    mistake:0:*) finding PASSES "${said#PASS } ($says)$(describe_others)" ;;
    accept:1:*) finding FAILS "$said ($says)" ;;
    starter:[01]:* | solution:[01]:* | undone:[01]:*) finding WRONG "$said" ;;
    *) finding ERROR "$said" ;;
    esac
}

if [ "$compiler" != - ] && ! command -v "$compiler" >/dev/null; then
    echo "SKIPPED ${lesson%%_*}/$name: there is no $compiler"
    exit 0
fi
result=right
told=no
# Their main.c says what is to do.
if [ "$kind" = starter ] || [ "$kind" = undone ]; then
    mkdir -p "$place/sources/$lesson" && cp "$place/main.c" "$place/sources/$lesson" || exit 1
fi
case $scene in -) check ;; *) check --only "$scene" ;; esac
[ ! -f "$place/shares" ] || sed "s/^/$kind $name /" "$place/shares" >>"$work/shares"
judge
echo "$lesson $kind $result $told" >>"$work/results"
rm -rf "$place"
