#!/bin/sh
# Is no honest program to be looked at, and is what correct programs draw right? Draws hidden scenes with
# each mistake of the lists and each correct program, and prints those of which the hidden scenes say so.
#
#     accused.sh BUILD MAKE STEP SEED...      STEP is 5, 05 or step05_zbuffer, or '' for all lessons
#
# At the end it prints how many programs were tried, how many have a wrong hidden scene, and how many
# are to be looked at. As many at a time as there are processors; VERIFY_SHARE=0/8 to 7/8 in the environment
# for one of eight programs. Exit status 0: none; 1: some, or they could not be drawn, or what a correct
# program draws is called wrong.
cd "$(dirname "$0")/../../.." || exit 1
if [ "$1" = --one ]; then
    shift
    seeds=$5
    VERIFY_FLAGS=-O1 # each seed draws longer than it takes to build
    . tests/upkeep/verify/entry.sh
    [ "$kind" != solution ] || exit 0
    sh tests/upkeep/verify/build.sh "$commands" -s "$place/$lesson" 2>"$place/errors" || exit 0
    for seed in $seeds; do
        "$build/hidden" "$place" "$work/solutions" "$seed" '' "$lesson" >"$place/said" 2>&1
        status=$?
        [ $status -le 1 ] || cat "$place/said" >>"$work/failed"
        [ $kind$status != accept1 ] ||
            sed -n "s/^  hidden: \(.*\): wrong/$lesson $name $seed is correct, and called wrong: \1/p" "$place/said" >>"$work/failed"
        echo "$lesson $name $seed $(tail -n 1 "$place/said")$(grep -o 'look at it.*' "$place/said")"
    done
    rm -rf "$place"
    exit 0
fi
build=$1
make=$2
target=accused
wanted=$3
shift 3
. tests/student/lesson.sh
[ -z "$wanted" ] || find_lesson
lessons=${wanted:+$lesson}
lessons=${lessons:-$(list_lessons)}
work=$(mktemp -d "$build/hidden.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
# shellcheck disable=SC2086 # one word a lesson
sh tests/teacher/hidden/solutions.sh "$work/solutions" "$make" '' $lessons || exit 1
$make "$build/hidden" models || exit 1
for lesson in $lessons; do
    ls "$lesson/mistakes.txt" "tests/lessons/$lesson/alternatives.txt" 2>/dev/null
done | xargs awk -v directory="$work" -f tests/upkeep/verify/replace.awk -f tests/upkeep/verify/parse.awk >"$work/table" ||
    exit 1
awk -v share="${VERIFY_SHARE:-0/1}" 'BEGIN { split(share, of, "/") } NR % of[2] == of[1] % of[2] { print $1 }' "$work/table" |
    xargs -P "${WORKERS:-$(getconf _NPROCESSORS_ONLN)}" -I {} \
        sh tests/teacher/hidden/accused.sh --one "$build" "$make" "$work" {} "$*" |
    tee "$work/said" | grep 'look at it'
awk '{ tried[$1 $2]; split($5, of, "/"); if (of[1] < of[2]) wrong[$1 $2] } /look at it/ { looked[$1 $2] }
    function count(list, one, sum) { for (one in list) sum++; return sum + 0 }
    END { print count(tried) " programs, " count(wrong) " with a wrong hidden scene, " count(looked) " to be looked at"
        exit count(looked) > 0 }' "$work/said" || exit 1
[ ! -s "$work/failed" ] || { sort "$work/failed" | uniq -c >&2; exit 1; }
