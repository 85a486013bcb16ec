#!/bin/sh
# Grades one submission: grade_one.sh BUILD MAKE SUBMISSION OUT [LESSONS [SEED]]
#
# The check, the library and the models must be built in BUILD, and with SEED the solutions in
# BUILD/solutions. LESSONS is 5 or 1-5. What the submission brings is only what take.sh takes:
# everything else is the course's own. Its programs are built and run by contain.sh.
#
# OUT/submissions/NAME becomes: state (GRADED, or ERROR and a reason), seconds, report.html, .xml
# and .json, log (what the check said), hidden (with SEED), sources, and of: sums of the
# submission, LESSONS and SEED. It comes as a whole or not at all, and what is there is not done
# again while it is of the same: so a class that was stopped goes on where it was. NAME is that of the
# submission, with %20 for a blank.
#
# Exit status: 0 that is there, whatever is in it; 1 it is not; 2 wrong usage.
[ $# -ge 4 ] && [ -n "$3" ] || {
    echo "say which: make grade-one SUBMISSION=path OUT=dir [LESSONS=1-5] [SEED=7]" >&2
    exit 1
}
build=$1
make=$2
submission=${3%/}
out=$4
wanted=$5
seed=$6
case $submission in /*) ;; *) submission=$PWD/$submission ;; esac
case $out in /*) ;; *) out=$PWD/$out ;; esac
cd "$(dirname "$0")/../../.." || exit 1
LC_ALL=C # names of files are bytes
export LC_ALL
case $build in /*) ;; *) build=$PWD/$build ;; esac
# make names what it builds as it was told to.
short=${build#"$PWD/"}
. tests/teacher/grade/contained.sh
. tests/teacher/grade/encode.sh
target=grade-one
. tests/student/lesson.sh
select_lessons

name=$(encode "${submission##*/}")
result=$out/submissions/$name

# What the result depends on: of a directory what take.sh may take, with its places.
sums() {
    echo "LESSONS=$wanted SEED=$seed"
    if [ -d "$submission" ]; then
        (cd "$submission" && find . -maxdepth 6 -type f \( -name '*.[cC]' -o -name '*.h' -o -iname '*.zip' -o -iname '*.t*' \) \
            -size -204800 -exec cksum {} +) 2>/dev/null | LC_ALL=C sort
    else
        cksum <"$submission"
    fi
}
of=$(sums | cksum)
[ ! -d "$result" ] || [ "$(cat "$result/of" 2>/dev/null)" != "$of" ] || exit 0
begun=$(date +%s)
# Named first and made when they are sure to be removed: whoever stops this may do it at any moment.
mkdir -p "$out/.begun" "$out/submissions" && work=$(mktemp -u "$out/.grading.XXXXXX") &&
    place=$(mktemp -u "$build/grade.XXXXXX") || exit 1
place_short=$short${place#"$build"}
# A make that is stopped stops its commands once more: that must not stop the tidying.
trap 'trap "" HUP INT TERM; chmod -R u+rwx "$work" "$place" 2>/dev/null; rm -rf "$work" "$place"' EXIT
# Whoever stops this does not mean the submission.
trap 'trap "" HUP INT TERM; rm -f "$out/.begun/$name"; exit 1' HUP INT TERM
mkdir -m 700 "$work" "$place" "$work/result" || exit 1

# finish STATE...: the result, as a whole, and a line that tells of it.
finish() {
    printf '%s\n' "$*" >"$work/result/state"
    [ -f "$work/result/log" ] || cp "$work/result/state" "$work/result/log" # the class page leads there
    echo "$(($(date +%s) - begun))" >"$work/result/seconds"
    echo "$of" >"$work/result/of"
    chmod -R u+rw,go+rX "$work/result" && rm -rf "$result" && mv "$work/result" "$result" || exit 1
    rm -f "$out/.begun/$name"
    points=$(awk '/^  "points": / { points = $2 } /^  "most": / { printf "%d/%d", points, $2; exit }' \
        "$result/report.json" 2>/dev/null)
    echo "$name $*${points:+ $points} ($(cat "$result/seconds") s)"
    exit 0
}

# Two gradings that ended with nobody asking for it: this submission kills whoever grades it.
echo begun >>"$out/.begun/$name"
[ "$(wc -l <"$out/.begun/$name")" -le 2 ] || finish "ERROR killed the grading twice"

# shellcheck disable=SC2086 # one word a lesson
taken=$(TMPDIR=$work LIMITED=$build/limited sh tests/teacher/templates/take.sh "$submission" "$work/sources" . $lessons) ||
    finish "ERROR ${taken:-no room to unpack it}"
# Whatever modes its files have: the compiler that reads them runs as another user.
chmod -R u+rwX,go+rX "$work/sources" &&
    mv "$work/sources" "$work/result" && cp -R "$work/result/sources" "$place/sources" &&
    mkdir "$place/tmp" && chmod 711 "$place" "$place/tmp" || exit 1

export CONTAIN_COURSE="$PWD" CONTAIN_BUILD="$build"
CONTAIN_SECRET=$(printf '%s\n' "$out" "$build/solutions") && export CONTAIN_SECRET
# What make was told, but not where it gets its jobs from.
flags=$(printf '%s' "$MAKEFLAGS" | sed 's/--jobserver[^ ]*//g; s/ -j[0-9]* / /g')
export CHECK_EXACT=0 CHECK_TIMEOUT="${CHECK_TIMEOUT:-10}"

# limited OUTPUT COMMAND...: for as long as a patient instructor waits, in the course.
limited() {
    output=$1
    shift
    "$build/limited" "${GRADE_SECONDS:-1200}" 0 "$PWD" "$output" env MAKEFLAGS="$flags" \
        CHECK_RUNNER="$PWD/tests/teacher/grade/contain.sh" TMPDIR="$place/tmp" "$@"
}

# shellcheck disable=SC2086
limited "$work/result/log" "$build/check" --programs "$place_short" \
    --sources "$place/sources" --differences "$work/result/differences" \
    --make "$make" --note "$({ contain_note; printf '%s\n' "$taken"; } | sed '/^There is no step/d; /^$/d' | tr '\n' ' ' | sed 's/ $//')" --junit "$work/result/report.xml" \
    --json "$work/result/report.json" --html "$work/result/report.html" $lessons
status=$?
rm -rf "$work/result/differences"
if [ ! -s "$work/result/report.json" ]; then
    case $status in
    124) finish "ERROR stopped after ${GRADE_SECONDS:-1200} s" ;;
    137) finish "ERROR killed by the submission" ;;
    *) finish "ERROR the check ended without a result, with status $status: see log" ;;
    esac
fi
[ $status -lt 2 ] || finish "ERROR the check cannot work: see log"
if [ -n "$seed" ]; then
    # shellcheck disable=SC2086
    limited "$work/result/hidden" "$build/hidden" "$place_short" "$short/solutions" "$seed" '' \
        $lessons
    [ $? -lt 2 ] || finish "ERROR the hidden scenes cannot be tried: see hidden"
fi
finish GRADED
