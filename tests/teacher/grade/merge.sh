#!/bin/sh
# Makes of the results in OUT/submissions the class's: merge.sh BUILD OUT [ROSTER [COLUMN]]
#
# OUT/class.csv has a row a submission, OUT/index.html the same with how each task went, the most
# frequent diagnoses and groups that are alike, OUT/similar.csv all pairs of these. All are
# written again from what is there. With ROSTER OUT/gradebook.csv is that table with the points in it, as
# gradebook.awk says.
#
# Exit status: 0 done; 1 there is nothing, or it cannot be written.
cd "$(dirname "$0")/../../.." || exit 1
LC_ALL=C # names of files are bytes
export LC_ALL
build=$1
out=$2
[ -d "$out/submissions" ] || {
    echo "make grade: nothing is graded in $out" >&2
    exit 1
}
work=$(mktemp -u "$out/.merging.XXXXXX") || exit 1 # see grade_one.sh
trap 'trap "" HUP INT TERM; rm -rf "$work"' EXIT
trap 'trap "" HUP INT TERM; exit 1' HUP INT TERM

mkdir -m 700 "$work" "$work/compared" && sh tests/teacher/grade/alike.sh "$build/limited" "$out" "$work/compared" || exit 1
cat "$work/compared/not_compared"

# Lines `NAME KIND ...` of all results, in the order of the names; sums.awk says what follows.
for submission in "$out"/submissions/*/; do
    name=$(basename "$submission")
    [ -s "$submission/state" ] || continue
    sed "s|^|$name	state	|; 1q" "$submission/state"
    sed "s|^|$name	seconds	|; 1q" "$submission/seconds"
    [ ! -f "$submission/report.json" ] ||
        awk -v name="$name" -f tests/check/report.awk -f tests/teacher/grade/tasks.awk \
            "$submission/report.json"
    [ ! -f "$submission/hidden" ] ||
        sed -n "s|^\(step[^ ]*\)  HIDDEN \([0-9]*\)/\([0-9]*\)|$name	hidden	\1	\2	\3|p
            s|^\(step[^ ]*\)  look at it: \(.*\)|$name	look	\1: \2|p" "$submission/hidden"
    [ ! -f "$submission/log" ] ||
        awk -v name="$name" '/^step[0-9]+_/ { step = $1 }
            sub(/^    looks like /, "") {
                sub(/"[:;] .*/, "\"")
                if (/^"/ && !seen[step, $0]++) printf "%s\tlooks\t%s\t%s\n", name, step, $0
            }' "$submission/log"
done >"$work/results"
sed 's/^/-	alike	/' "$work/compared/alike" >>"$work/results"
sed 's/^/-	not_compared	/' "$work/compared/not_compared" >>"$work/results"
show() {
    awk -F '\t' -f tests/teacher/grade/sums.awk -f "tests/teacher/grade/$1" "$work/results"
}
show class.awk >"$work/class.csv" && show page.awk >"$work/index.html" &&
    awk -F '\t' 'BEGIN { print "percent,lesson,submission,submission" }
        { print $1 "," $2 "," $3 "," $4 }' "$work/compared/alike" >"$work/similar.csv" &&
    mv "$work/class.csv" "$work/index.html" "$work/similar.csv" "$out" || exit 1
if [ -n "$3" ]; then
    : >"$work/others"
    awk -v roster="$3" -v column="$4" -v others="$work/others" -F '\t' -f tests/teacher/grade/sums.awk \
        -f tests/teacher/grade/gradebook.awk "$work/results" >"$work/gradebook.csv" &&
        mv "$work/gradebook.csv" "$out" || exit 1
    echo "$out/gradebook.csv: $(wc -l <"$work/others") submissions are nobody's in $3, or more than one's"
    sed 's/^/    /' "$work/others"
fi
echo "$out/index.html and $out/class.csv: $(grep -c '	state	' "$work/results") submissions"
