#!/bin/bash
# Is a class graded rightly, whatever some of it do? try_class.sh WORK [COUNT [LAST]]
#
# Makes up a class of COUNT (60), in lessons 1 to LAST (3), in WORK, which is not there yet, kills
# the grading in the middle, lets it go on, and compares the points with those expected. Nothing may
# have been written, nothing may be left running or lying about. CONTAIN_BY in the environment:
# bwrap, unshare.
#
# Exit status 0: all of that is so; 1: something is not.
cd "$(dirname "$0")/../../.." || exit 1
work=$1
count=${2:-60}
last=${3:-3}
mkdir "$work" && work=$(cd "$work" && pwd) || exit 1
failed=0

wrong() {
    echo "class: $*"
    failed=1
}

build=build
. tests/teacher/grade/contained.sh
make -s grade-tools || exit 1
contained=1
[ "$CONTAIN_BY" != nothing ] || contained=
CONTAINED=$contained bash tests/teacher/grade/make_class.sh "$work" "$count" "$last" || exit 1

# A command that takes all its processes leaves another command's alone (only root's are counted).
contain() {
    export CONTAIN_COURSE="$PWD" CONTAIN_BUILD="$PWD/build" CONTAIN_SECRET=
    cd "$work/kinds" && exec sh "$CONTAIN_COURSE/tests/teacher/grade/contain.sh" "$@"
}
if [ -n "$contained" ] && [ "$(id -u)" -eq 0 ]; then
    (contain sh -c '(while sleep 20 & do :; done); exec sleep 20') 2>"$work/full" &
    until [ -s "$work/full" ]; do # it cannot fork
        kill -0 $! 2>/dev/null || break
    done
    # shellcheck disable=SC2016 # for that shell
    [ "$(contain sh -c 'echo "$(echo works)"' 2>&1)" = works ] ||
        wrong "one command takes the processes of another"
    kill -KILL $! && wait $! 2>/dev/null
fi

precious="build/quick/libcommon.a build/check tests/check/scenes.txt tests/reference/step01_line/line.png"
# shellcheck disable=SC2086
before=$(cksum $precious)
grade() {
    make -s grade SUBMISSIONS="$work/class" OUT="$work/out" LESSONS="1-$last"
}

# Killed after some results: what is there stays, and nothing else is left.
# shellcheck disable=SC2016 # for that shell
setsid bash -c 'exec make -s grade SUBMISSIONS="$1" OUT="$2" LESSONS="1-$3"' - "$work/class" \
    "$work/out" "$last" >"$work/first" 2>&1 &
first=$!
until [ "$(find "$work/out/submissions" -name state 2>/dev/null | wc -l)" -ge $((count / 3)) ]; do
    kill -0 $first 2>/dev/null || break
    sleep 0.2
done
kill -TERM -- -$first
sleep 0.1
kill -TERM -- -$first 2>/dev/null # and once more, while they tidy up
wait $first
# make does not wait for them: each tidies up when what it waits for has ended.
for ((i = 0; i < 600; i++)); do
    kill -0 -- -$first 2>/dev/null || break
    sleep 0.1
done
! kill -0 -- -$first 2>/dev/null || wrong "the stopped grading goes on"
early=$(find "$work/out/submissions" -name state | wc -l)
echo "stopped after $early"
[ "$early" -lt "$count" ] || wrong "it was over before it could be stopped"
begun=$SECONDS
grade >"$work/second" || wrong "make grade fails: $(tail -n 3 "$work/second")"
echo "the other $((count - early)) took $((SECONDS - begun)) s"

# Each in the class has the points that it should have.
awk -F, 'NR == FNR { split($0, part, " "); state[part[1]] = part[2]; sign[part[1]] = part[3]
        points[part[1]] = part[4]; next }
    FNR > 1 {
        seen[$1] = 1
        right = $2 == state[$1] && (sign[$1] == "=" ? $3 == points[$1] : $3 < points[$1])
        if (!right) { print $1 ": " $2, $3 ", expected " state[$1], sign[$1], points[$1]; bad = 1 }
    }
    END { for (name in state) if (!(name in seen)) { print name ": has no row"; bad = 1 }
        exit bad }' FS=' ' "$work/expected" FS=, "$work/out/class.csv" || failed=1

# The copies are found.
if command -v sim_c >/dev/null; then
    for pair in one,copy%20three one,copy%20two three,copy%20two; do
        grep -qE "^(9[5-9]|100),step01_line,copy%20$pair\$" "$work/out/similar.csv" ||
            wrong "copy%20$pair are not listed as alike"
    done
else
    echo "class: without sim_c, copies are not looked for"
fi

# What it must not have done.
# shellcheck disable=SC2086
[ "$before" = "$(cksum $precious)" ] || wrong "the course was changed"
for place in "$work/written" written /var/tmp/written "$work"/class/*/written; do
    [ ! -e "$place" ] || wrong "$place was written"
done
! pgrep -f 'sleep 98765' >/dev/null || wrong "a child is left running"
! grep -rqs CONNECTED "$work/out/submissions"/*/log || wrong "the network can be reached"
! grep -rqsE '(: |^)READ /' "$work/out/submissions"/*/log || wrong "what is secret can be read"
for litter in build/grade.* "$work"/out/.grading* "$work"/out/.merging* "$work"/out/.begun/*; do
    [ ! -e "$litter" ] || wrong "$litter is left behind"
done

[ -z "$(find "$work/out/submissions" -name 'sources.*')" ] || wrong "archives are left unpacked"

# Stopped as soon as a directory of its own has a name, or is there, it leaves nothing either.
stops=$work/stops
mkdir "$stops" "$stops/out" || exit 1
for stop in 'mktemp /.grading.' 'mktemp /grade.' 'mkdir /.grading.'; do
    tool=${stop% *}
    printf '#!/bin/sh\n%s "$@"\ncase $* in *%s*) kill 0 ;; esac\n' "$(command -v "$tool")" "${stop#* }" \
        >"$stops/$tool" && chmod +x "$stops/$tool"
    PATH=$stops:$PATH setsid -w sh tests/teacher/grade/grade_one.sh build "make -s" "$work/kinds" "$stops/out" 1 \
        >"$stops/said" 2>&1 && wrong "a grading is not stopped at $stop"
    rm "$stops/$tool"
    for litter in build/grade.* "$stops"/out/.grading* "$stops"/out/.begun/*; do
        [ ! -e "$litter" ] || wrong "$litter is left behind by a grading that was stopped at $stop"
    done
done

# Once more: nothing is done again, and the same comes out.
cp "$work/out/class.csv" "$work/class.csv"
begun=$SECONDS
grade >"$work/third" && cmp "$work/class.csv" "$work/out/class.csv" ||
    wrong "another CSV the second time"
echo "again took $((SECONDS - begun)) s"

# What has changed is graded again, and nothing else; it prints what is gone.
changed=$(find "$work/class" -maxdepth 1 -name 'other0-*')
gone=$(find "$work/class" -maxdepth 1 -name 'wrong0-*')
echo '#error changed' >>"$changed/step01_line/main.c"
rm -r "$gone"
grade >"$work/fourth" || wrong "make grade fails: $(tail -n 3 "$work/fourth")"
grep -q "^    ${gone##*/}\$" "$work/fourth" || wrong "$gone is not told of: $(cat "$work/fourth")"
[ "$(grep -c '^\[' "$work/fourth")" -eq 1 ] || wrong "not one graded again: $(cat "$work/fourth")"
name=${changed##*/}
! grep -q "^$name,GRADED" <(comm -12 <(sort "$work/class.csv") <(sort "$work/out/class.csv")) ||
    wrong "$name has the points from before"
exit $failed
