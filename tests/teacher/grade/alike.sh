#!/bin/sh
# Finds submissions that are near copies of one another, for a person to look at: sim_c compares
# what each has written in a lesson, without the lines of the starter. It judges nobody.
#
#     alike.sh LIMITED OUT WORK
#
# WORK/alike gets a line `SHARE LESSON NAME NAME`, with tabs, for each pair of OUT/submissions of
# which one consists of SHARE % of the other, or more. WORK/not_compared says in a line each what
# was left out. WORK is an empty directory, LIMITED the program of limited.c.
#
# Exit status: 0 done, also where there is no sim_c; 1 it cannot be done.
cd "$(dirname "$0")/../../.." || exit 1
limited=$1
out=$2
work=$(cd "$3" && pwd) || exit 1
least_share=75  # %: tests/teacher/README.md says how these were chosen
least_tokens=250
run=16          # tokens in a row that agree
most=32768      # bytes of one lesson
target=grade
. tests/student/lesson.sh
. tests/student/marked.sh

# not_compared WHAT WHY
not_compared() {
    echo "Not compared: $1, $2" >>"$work/not_compared"
}

# Hostile text keeps sim_c busy for hours: does it take a second with this one?
is_quick() (
    # shellcheck disable=SC3045 # not in POSIX, but in every sh
    ulimit -t 1 && cd "$place" && sim_c -e -a -r $run "$1" ../starter >/dev/null 2>&1
)

# What the submissions have written, as $place/1, 2, ...: their names may be anything, also to
# sim_c. $place/names says whose each is. A line of the starter is one also with other names in it,
# as to sim_c all names are the same.
collect() {
    number=0
    for sources in "$out"/submissions/*/sources/"$lesson"; do
        [ -f "$sources/main.c" ] || continue
        name=${sources%/sources/*}
        name=${name##*/}
        number=$((number + 1))
        cat "$sources"/*.[ch] | awk '
            { shape = $0; gsub(/[ \t]/, "", shape); gsub(/[A-Za-z_0-9]+/, "x", shape) }
            NR == FNR { given[shape]; next }
            !(shape in given)' "$work/starter" - >"$place/$number" || exit 1
        if [ "$(wc -c <"$place/$number")" -gt $most ]; then
            not_compared "$name" "$lesson is longer than $most bytes."
        elif ! is_quick $number 2>/dev/null; then
            not_compared "$name" "$lesson keeps sim_c from its work."
        else
            printf '%s\t%s\n' $number "$name"
        fi
    done >"$place/names"
}

# Pairs of $place/said, with the larger of both shares: the shorter program's.
pairs() {
    awk -v lesson="$lesson" -v least=$least_tokens '
        NR == FNR { name[$1] = $2; next }
        $1 == "File" { tokens[$2 + 0] = $3 }
        $2 == "consists" && tokens[$1] >= least && tokens[$7] >= least {
            pair = $1 < $7 ? $1 SUBSEP $7 : $7 SUBSEP $1
            if (share[pair] < $4) share[pair] = $4
        }
        END {
            for (pair in share) {
                split(pair, who, SUBSEP)
                print share[pair] "\t" lesson "\t" name[who[1]] "\t" name[who[2]]
            }
        }' "$place/names" "$place/said" | LC_ALL=C sort
}

: >"$work/alike"
: >"$work/not_compared"
if ! command -v sim_c >/dev/null; then
    echo "Submissions were not compared with one another, for there is no sim_c;" \
        "on Debian: apt-get install similarity-tester" >"$work/not_compared"
    exit 0
fi
for lesson in $(list_lessons); do
    place=$work/$lesson
    main=$lesson/main.c
    find_marked
    text starter "$work/marked" "$main" >"$work/starter" && mkdir "$place" || exit 1
    collect
    [ "$(wc -l <"$place/names")" -gt 1 ] || continue
    # shellcheck disable=SC2016 # for that shell
    if why=$("$limited" 600 0 "$place" "$place/said" \
        sh -c 'cut -f 1 names | sim_c -p -e -a -i -r "$1" -t "$2"' - $run $least_share 2>&1); then
        pairs >>"$work/alike"
    else
        not_compared "$lesson" "${why:-sim_c failed}."
    fi
done
