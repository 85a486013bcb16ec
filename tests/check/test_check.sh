#!/bin/sh
# The check itself: for each way to fail a small program in tests/check/wrong, and what the check must
# say of it; how it ends when it must, or cannot work; and that it leaves nothing behind.
. "$(dirname "$0")/../unit/script.sh"

unset CHECK_RUNNER
export TMPDIR="$work/tmp" WITNESS="$work/witness" MAKEFLAGS=s
export CHECK_EXACT=0 CHECK_TIMEOUT=1 CHECK_BUILD_TIMEOUT=4.5
mkdir "$TMPDIR" "$work/reference" && said=$work/said && : >"$said"

# check WORD...: the check of the wrong programs, with more options and steps.
check() {
    "$build/check" --root tests/check/wrong --scenes scenes.txt --references "$work/reference" \
        --programs "$work/build" --differences "$work/differences" --make "make BUILD=$work/build" "$@"
}

# checks STATUS WORD...: it ends so; what it says is in $said.
checks() {
    wanted=$1
    shift
    said_by "$wanted" check "$@"
}

# ends STATUS: the last command, which has written into $said, ended so.
ends() {
    got=$?
    [ $got -eq "$1" ] || wrong "status $got, not $1"
}

# Each reference is what the right program draws; one is blank. (They are TGA, which the check reads
# under any name.)
make -C tests/check/wrong BUILD="$work/build" "$work/build/step01_exact" "$work/build/step05_blank" &&
    "$work/build/step01_exact" -o "$work" && mv "$work/depth.tga" "$work/right" &&
    "$work/build/step05_blank" -o "$work" || exit 1
grep '^step' tests/check/wrong/scenes.txt | while read -r step scene _; do
    mkdir -p "$work/reference/$step"
    case $step/$scene in
    */nowhere) ;;
    step24*) cp "$work/depth.tga" "$work/reference/$step/$scene.png" ;;
    *) cp "$work/right" "$work/reference/$step/$scene.png" ;;
    esac
done
rm "$work"/*.tga

# ---- All of them ----

# All that it prints, line by line.
check >"$said" 2>"$work/errors"
ends 2 # a reference is missing
awk '
    NR == FNR { if (!/^#/) pattern[++count] = $0; next }
    {
        wanted = pattern[FNR]
        gsub(/[][\\.^$(){}|+?]/, "\\\\&", wanted)
        gsub(/[*]/, ".*", wanted)
        if ($0 !~ "^" wanted "$") { print "not as in expected.txt: " $0; exit bad = 1 }
    }
    END { exit bad || FNR != count }
' tests/check/wrong/expected.txt "$said" || wrong "the output is another one"

# Each picture that failed is kept next to its reference, enlarged twice, three panels wide.
for picture in step02_shifted/depth step06_size/huge step08_unreadable/pipe; do
    size=$(od -An -tu1 -j16 -N4 "$work/differences/$picture.png" | tr -d ' \n')
    [ "$size" = 004208 ] || wrong "$picture: another width than 1232: $size"
done

# No process that told its number is alive, and none went on after its time; what takes too long to
# build is tried once.
! grep -q alive "$WITNESS" || wrong "something went on after its time"
grep -q 'ended by' "$WITNESS" || wrong "no SIGTERM came first"
[ "$(grep -c try "$WITNESS")" -eq 1 ] || wrong "built more than once"
processes=$(grep -c '^[0-9][0-9]*$' "$WITNESS")
[ "$processes" -ge 68 ] || wrong "only $processes processes told their number"
sleep 1 # for init to reap what is dead already
for id in $(grep '^[0-9][0-9]*$' "$WITNESS"); do
    ! kill -0 "$id" 2>/dev/null || wrong "process $id is alive"
done
[ -z "$(ls -A "$TMPDIR")" ] || wrong "left behind: $(ls "$TMPDIR")"

# ---- Some of them ----

mkdir -p "$work/differences/step01_exact" && : >"$work/differences/step01_exact/depth.png"
checks 0 01 2
says 'step01_exact  PASS 2/2 SCORE 2/2 exact'
says '2 passed, 0 failed'
says /step02_shifted/
silent /step01_exact/
silent step03
[ ! -e "$work/differences/step01_exact/depth.png" ] || wrong "an old difference image is kept"
checks 1 1 step07_missing
says '1 passed, 1 failed'
: >"$WITNESS"
checks 0 --only depth2 -- 01
says 'step01_exact  PASS 1/1 SCORE 1/1 exact'
grep -q 'one scene of 2' "$WITNESS" || wrong "the program is not told which scene"
checks 2 --only depth3 01
says "step01_exact has no scene 'depth3'"
silent SCORE
# A build with sanitizers gets no advice to use them.
checks 1 --sanitized 33
says 'depth CRASH 0/1: SIGABRT'
silent SANITIZE

export CHECK_EXACT=1
checks 1 01 02
says 'step01_exact  PASS 2/2 SCORE 2/2 exact'
says 'step02_shifted  FAIL 0/1 '
says '(must be exact)'
export CHECK_EXACT=yes
checks 2 01
export CHECK_EXACT=0

# A program of an earlier build does not count, though it is newer than its source.
for step in step10_build step12_absent; do
    cp "$work/build/step01_exact" "$work/build/$step"
    checks 1 $step
    says "$step  BUILD "
done

# No reference is changed, whatever fails.
before=$(ls -i "$work/reference/step05_blank" && cksum "$work/reference/step05_blank/depth.png")
checks 1 5
[ "$before" = "$(ls -i "$work/reference/step05_blank" && cksum "$work/reference/step05_blank/depth.png")" ] ||
    wrong "a reference is another one"
[ ! -e "$work/reference/step23_noreference/nowhere.png" ] || wrong "a reference is made"

# A score that nobody gets is no score; nor is one that went into a file which the check has opened
# for itself.
if [ -w /dev/full ]; then
    check 01 >/dev/full 2>"$said"
    ends 2
    says 'check: the score could not be written'
fi
check 01 >&- 2>"$said"
ends 2
check 01 2>&- >"$said"
ends 0
check 01 <&- >"$said" 2>&1
ends 0
says 'SCORE 2/2 exact'
[ ! -s "$work/build/check.lock" ] || wrong "it writes into the lock"

# ---- Wrong options, and what it cannot do ----

# refuses MESSAGE COMMAND...: status 2, and it says that.
refuses() {
    message=$1
    shift
    said_by 2 "$@"
    says "$message"
    silent PASS
    silent FAIL
}

refuses "unknown option '--nonsense'" "$build/check" --nonsense
refuses "unknown option '-'" "$build/check" -
refuses '--root needs a value' "$build/check" --root
refuses "there is no step '--root'" "$build/check" -- --root
refuses "there is no step '--'" "$build/check" -- -- 1
refuses '/nowhere: No such file' "$build/check" --root /nowhere
refuses /nowhere "$build/check" --scenes /nowhere
refuses "there is no step '77'; the steps are step01_line" "$build/check" 77
refuses "there is no step 'step05'" "$build/check" step05
refuses "there is no step '5x'" "$build/check" 5x
for seconds in soon -1 nan 0; do
    refuses CHECK_TIMEOUT env CHECK_TIMEOUT=$seconds "$build/check" 01
done
refuses "CHECK_BUILD_TIMEOUT is '0'" env CHECK_BUILD_TIMEOUT=0 "$build/check" 01
refuses 'cannot run no_such_make' check --make no_such_make 01
refuses '/dev/null: cannot make the directory' check --programs /dev/null/x 01
refuses 'check: /proc' check --programs /proc 01

# An old program, or what the compiler leaves next to it, cannot be removed.
for place in step12_absent step01_exact.o step09_status.d step05_blank.said; do
    mkdir "$work/build/$place" 2>/dev/null || { rm "$work/build/$place" && mkdir "$work/build/$place"; }
    refuses ': cannot remove ' check "${place%.*}"
    says "${place%.*}  ERROR 0/"
    rmdir "$work/build/$place"
done

# The table of scenes: a line each, with what is said of it behind a |.
row='step1_a b 1.1 1 exact\n'
while IFS='|' read -r table message; do
    printf '%b' "$(echo "$table" | sed "s/ROW/$row/")" >"$work/table"
    refuses "$message" "$build/check" --scenes "$work/table"
done <<'END'
|there is no scene in it
nonsense a|:1: 'nonsense' is not the name of a step
step1_a|:1: '' is not the name of a scene
step1_a ../b|:1: '../b' is not the name of a scene
step1_a b|:1: '' are no tasks, like 5.2 or 5.1,5.2
step1_a b 1.1,|:1: '1.1,' are no tasks
step1_a b 1.1,1.1|:1: '1.1,1.1' are no tasks
step1_a b 1B.1|:1: '1B.1' are no tasks
step1_a b 1.01|:1: '1.01' are no tasks
step1_a b 1b.1.1|:1: '1b.1.1' are no tasks
step1_a b 1234567890.1|:1: '1234567890.1' are no tasks
step1_a b 1b|:1: '1b' are no tasks
step1_a b 1.1+1|:1: '1.1+1' are no tasks
step1_a b 1.1+1b.1,1.1|:1: '1.1+1b.1,1.1' are no tasks
step1_a b 1.1+1b+1c|:1: '1.1+1b+1c' are no tasks
step1_a b 1.1+|:1: '1.1+' are no tasks
step1_a b 1.1,1.2,1.3,1.4,1.5,1.6,1.7,1.8,1.9,2.1,2.2,2.3,2.4,2.5,2.6,2.7,2.8|are no tasks
step1_a b 1.1|:1: '' is not a number of points
step1_a b 1.1 0|:1: '0' is not a number of points
step1_a b 1.1 1.5|:1: '1.5' is not a number of points
step1_a b 1.1 nan|:1: 'nan' is not a number of points
step1_a b 1.1 1001|:1: '1001' is not a number of points
step1_a b 1.1,1b.2 3|:1: 3 points cannot be shared out evenly to 2 tasks
step1_a b 1.1 1|:1: '' is neither 'exact' nor a percentage
step1_a b 1.1 1 100.1 1|:1: '100.1' is neither 'exact' nor a percentage
step1_a b 1.1 1 1 nan|:1: 'nan' is neither 'exact' nor a percentage
step1_a b 1.1 1 1 2|:1: '' is neither 'exact' nor a percentage
step1_a b 1.1 1 1 2 3 x|:1: 'x' is neither 'exact' nor a percentage
step1_a b 1.1 1 1 2 3 4 5|:1: unexpected '5'
step1_a b 1.1 1 -1|:1: '-1' is neither 'exact' nor a percentage
step1_a b 1.1 1 exact c|:1: unexpected 'c'
work step1_a b 1.1 1 c 1|:1: work of 'step1_a' must follow its scenes
ROWwork step2_a b|:2: work of 'step2_a' must follow
ROWwork step1_a c|:2: step1_a has no scene 'c'
ROWwork step1_a b 1|:2: '1' are no tasks
ROWwork step1_a b 1.1 1|:2: '' is not the name of a counter
ROWwork step1_a b 1.1 1 c -1|:2: '-1' is not what a counter
ROWwork step1_a b 1.1 1 c 1.5|:2: '1.5' is not what a counter
ROWwork step1_a b 1.1 1 c 1 x|:2: 'x' is not what a counter
ROWwork step1_a b 1.1 1 c 1 2 3|:2: unexpected '3'
ROWsame step1_a b 1.1 1 1|:2: '1' are no relations
ROWsame step1_a b 1.1 1 moved,|:2: 'moved,' are no relations
ROWsame step1_a b 1.1 1 moved,moved 1|:2: 'moved,moved' are no
ROWsame step1_a b 1.1 1 moved|:2: '' is neither 'exact' nor a
ROWsame step1_a b 1.1 1 moved 1 2|:2: unexpected '2'
ROWstep1_a b 1.1 1 exact|:2: b is here twice
ROWcall step1_a numbers 1.1 1\nstep1_a c 1.1 1 exact|:3: the scenes of step1_a must be together
ROWstep2_a b 2.1 1 1 1 1\n\nstep1_a c 1.1 1 exact|:4: the scenes of step1_a must be together
END

# ---- When others end it, or wait ----

# A check that is ended takes its program and its directory with it, at once.
for signal in INT TERM; do
    for seconds in 3 20; do # where the machine is busy the program begins late
        : >"$WITNESS"
        said_by 124 timeout -k 5 -s $signal $seconds env CHECK_TIMEOUT=60 "$build/check" \
            --root tests/check/wrong --scenes scenes.txt --references "$work/reference" \
            --programs "$work/build" --make "make BUILD=$work/build" 15
        [ ! -s "$WITNESS" ] || break
    done
    silent SCORE
    id=$(head -n 1 "$WITNESS")
    [ -n "$id" ] || wrong "$signal came too early"
    ! kill -0 "$id" 2>/dev/null || wrong "after $signal the program is alive"
    [ -z "$(ls -A "$TMPDIR")" ] || wrong "after $signal there is still $(ls "$TMPDIR")"
done

# Two checks in one build directory would remove each other's programs: the second waits, until it is
# told to end or the first has ended.
: >"$WITNESS"
CHECK_TIMEOUT=30 check 15 >"$work/first" 2>&1 &
running=$!
until [ -s "$WITNESS" ] || ! kill -0 $running 2>/dev/null; do sleep 0.1; done
said_by 124 timeout -k 5 -s INT 1 "$build/check" --root tests/check/wrong --scenes scenes.txt \
    --programs "$work/build" --make "make BUILD=$work/build" 1
says 'check: waiting for another check in '
silent step01
check 1 >"$said" 2>&1 &
second=$!
until grep -q waiting "$said" || ! kill -0 $second 2>/dev/null; do sleep 0.1; done
silent step01
# shellcheck disable=SC2046 # the check itself: the shell that runs check() has no child but this
kill $(ps -o pid= --ppid $running)
wait $second
ends 0
says 'PASS 2/2 SCORE 2/2 exact'
running=

# A program that ends who has started it, by whatever signal, is judged, and has not passed.
echo 'step17_killer depth 17.1 1 exact' >"$work/table"
cp -R "$work/reference/step01_exact" "$work/reference/step17_killer"
for signal in 9 15 2 11 10; do
    export KILLS_WITH=$signal
    checks 1 --scenes "$work/table" 17
    says 'SCORE 0/1'
done

# A program that others keep from the processors gets its time all the same.
echo 'step27_busy depth 27.1 1 exact' >"$work/table"
cp -R "$work/reference/step01_exact" "$work/reference/step27_busy"
others=
for _ in $(seq $((2 * $(getconf _NPROCESSORS_ONLN)))); do
    sh -c 'while :; do :; done' &
    others="$others $!"
done
checks 0 --scenes "$work/table" 27
# shellcheck disable=SC2086 # one word a process
kill $others

# A program that is run by another one: its status tells of a signal.
export CHECK_RUNNER="$top/tests/check/wrong/runner.sh"
checks 1 1 9 14
says 'step01_exact  PASS 2/2 SCORE 2/2 exact'
says 'exit status 1: step09_status: bust.obj:17'
says '  depth CRASH 0/1: SIGABRT, ended by abort() or a failed assert(): '
export CHECK_RUNNER=/nowhere/runner
checks 1 1
says 'cannot start /nowhere/runner'
unset CHECK_RUNNER

# ---- Known mistakes that no picture tells ----

# knows STEP SIGNS WORDS OPTION...: with only these signs known the check says WORDS; with '' for
# WORDS it names nothing.
knows() {
    mkdir -p "$work/looks/$1/looks" && echo "$2" >"$work/looks/$1/looks/signs.txt"
    step=$1 words=$3
    shift 3
    checks 1 --looks "$work/looks" "$@" "$step"
    if [ -n "$words" ]; then
        says "$words"
    else
        silent 'looks like'
        silent 'may be'
    fi
}

hint='; make hint STEP=41 TASK=41.2'
knows step41_counted '41.2 0 depth:-:pixels=5,rows=7 five' "    looks like \"five\"$hint"
knows step41_counted '41.2 4 depth:-:pixels=5,rows=7 five' \
    "looks like \"five\": see step41_counted/WRONG.md, figure 4$hint" --only depth
knows step41_counted '41.2 0 depth:-:pixels=5,rows=7 five' '' --only depth2
knows step41_counted '41.2 0 depth:-:pixels=5 not all of it' ''
knows step41_counted '41.2 0 depth2:-:pixels=5,rows=8 five' "looks like \"five\"$hint"
says '    looks like the same'
knows step42_black '42.2 0 depth2:rbb:-;depth3:rbb:- black' \
    '    may be "black"; make hint STEP=42 TASK=42.2'
says '    may be the same'
knows step42_black '42.2 0 depth2:rbr:- black' ''
knows step42_black '42.2 0 depth2:rbb:- black' '' --only depth2
knows step43_divided '43.2 0 depth2:rd:- by 0' '    may be "by 0"; make hint STEP=43 TASK=43.2'
knows step13_crash '13.1 0 depth2:rd:- another crash' ''
exit $failed
