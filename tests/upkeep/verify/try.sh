#!/bin/sh
# Lets the check judge one program of the table that verify.sh has made: builds it, draws the scene
# or all of them, compares.
#
#   tests/upkeep/verify/try.sh BUILD MAKE WORK NUMBER
#
# Prints a finding, or nothing. Adds `LESSON KIND right TOLD` or `... wrong TOLD` to WORK/results
# (TOLD: yes for a mistake that the check names).
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

# signs_of LIST: the signs of this mistake, a line each; fails when the list does not have it.
signs_of() {
    awk -v before="$task $figure " -v says="$says" '
        index($0, before) == 1 && substr($0, length(before $3) + 2) == says { signs = $3; found = 1 }
        END { gsub(/;/, "\n", signs); print signs; exit !found }' "$1" 2>/dev/null
}

# A mistake that no picture shows is known by what it counts, and by which pictures of the whole
# lesson are right (tests/check/counters.h), when not more than four are the same.
judge_counted() {
    check --counted "$place/shown"
    sort -u "$place/shown" 2>/dev/null >"$place/now"
    grep "^[^:]*:[^0-9]" "$place/signs" | grep . | sort >"$place/kept"
    cmp -s "$place/now" "$place/kept" || finding STALE "not so in $list: $redo"
    wanted=$(grep "^$scene:" "$place/now")
    same=$(grep -cF -e "${wanted:-none}" "$list")
    case $same:$said in
    *'looks like'*"\"$says\""* | *'may be'*"\"$says\""*) judge_task ;;
    *'looks like'* | *'may be'*) finding MISLEADS "$said ($says)" ;;
    [1-4]:*) finding STALE "looks like nothing: $redo" ;;
    esac
}

# A mistake that is found must look like itself, when it can be told from others, and lead to a hint
# for its task. Sets told to yes, or no when it cannot be told.
judge_looks() {
    list=tests/lessons/$lesson/looks/signs.txt
    redo="make mistakes STEP=${lesson#step}"
    redo=${redo%%_*}
    told=no
    [ -f "$list" ] || return
    signs_of "$list" >"$place/signs" || { finding STALE "not in $list: $redo" && return; }
    row=$(sed -n "s/^$scene:\([0-9][0-9]*\):.*/\1/p" "$place/signs")
    distance=$(awk 'END { print $8 }' "$place/shares" 2>/dev/null)
    case ${row:-0}:$said in
    0:* | *"; $scene PASS"*) judge_counted ;; # a picture that is right, or within the limits
    *'looks like'*"\"$says\""* | *'may be'*"\"$says\""*)
        judge_task
        [ "$distance" = 0 ] || finding STALE "$redo"
        ;;
    *'looks like'* | *'may be'*) finding MISLEADS "$said ($says)" ;;
    *) finding STALE "looks like nothing: $redo" ;;
    esac
    case $result:$told in
    right:no) finding UNNAMED "$said ($says)" ;;
    esac
}

# The mistake whose picture is in the lesson's table of wrong pictures still draws that one.
judge_figure() {
    kept=$lesson/figures/wrong_$(printf %02d "$figure").png
    "$build/figure_make" "tests/reference/$lesson/$scene.png" \
        "$place/differences/$lesson/yours/$scene.png" "$part" "$place/figure.png" \
        2>"$place/errors" || finding ERROR "no figure $figure: $(cat "$place/errors")"
    [ ! -f "$place/figure.png" ] || cmp -s "$place/figure.png" "$kept" ||
        finding STALE "$kept: make mistakes STEP=$(expr "$lesson" : 'step\([0-9]*\)')"
}

# In the whole lesson, the mistake takes no points from tasks of earlier parts, and no hint leads to
# another task whose calls are right.
judge_whole() {
    case $task in -) return ;; esac
    check
    unfair=$(printf '%s\n' "$said" | awk -v task="$task" '
        function part(name) { sub(/\..*/, "", name); return name }
        function add(text) { found = found (found == "" ? "" : ", ") text }
        {
            count = split($0, rows, /; */)
            for (i = 1; i <= count; i++) {
                split(rows[i], word, " ")
                right[word[2]] = right[word[2]] || (word[1] == "numbers" && word[3] == "PASS")
            }
            for (i = 1; i <= count; i++) {
                if (match(rows[i], /^(next: task |make hint .* TASK=)[0-9a-z.]+/)) {
                    name = substr(rows[i], RSTART, RLENGTH)
                    sub(/.*[ =]/, "", name)
                    if (name != task && right[name]) {
                        add("a hint leads to task " name)
                    }
                } else if (rows[i] ~ /^(part [a-z]|tasks)[ :]/) {
                    tasks = rows[i]
                    sub(/^[^:]*: /, "", tasks)
                    n = split(tasks, each, ", ")
                    for (k = 1; k <= n; k++) {
                        name = each[k]
                        sub(/ .*/, "", name)
                        most = each[k]
                        sub(/.*\//, "", most)
                        if (part(name) < part(task) && each[k] !~ (" " most "/" most "$")) {
                            add("task " each[k])
                        }
                    }
                }
            }
            print found
        }')
    [ -z "$unfair" ] || finding UNFAIR "task $task, but $unfair"
}

# Where a task is undone, everything that fails needs it; and it has no points.
judge_undone() {
    case $said in
    *[:,]" $name TODO "[1-9]*/* | *[:,]" $name "[1-9]*/*) finding UNEARNED "$said" ;;
    esac
}

judge() {
    case $kind:$status:$said in
    mistake:1:BUILD*) finding ERROR "$said" ;;
    mistake:1:*)
        case $part in -) ;; *) judge_figure ;; esac
        case $scene in
        numbers) judge_task ;; # the call that is wrong says what no name would
        *) judge_looks ;;
        esac
        judge_whole
        ;;
    undone:1:BUILD*) ;; # nothing can be judged
    undone:1:TODO\ *) judge_undone ;;
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
judge
echo "$lesson $kind $result $told" >>"$work/results"
rm -rf "$place"
