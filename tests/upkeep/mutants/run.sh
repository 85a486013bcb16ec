#!/bin/sh
# Do the tests notice small changes of the code? Applies the mutants of the lists beside this file,
# one at a time, to a copy of the course, builds the test that each of them names, and runs it.
#
#   tests/upkeep/mutants/run.sh BUILD [LIST [PATTERN]]
#
# LIST: only this list, as `geometry`; PATTERN: only mutants whose LIST/NAME has it in it. The copies
# are made in BUILD and removed at the end. Two mutants at a time; WORKERS=1 in the environment for
# one.
#
# Exit status 0: every mutant was killed, is equivalent or for another machine; 1: some survive, or
# a list is wrong.
cd "$(dirname "$0")/../../.." || exit 1
mkdir -p "${1:-build}" && work=$(cd "${1:-build}" && mktemp -d "$PWD/mutants.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
list=${2:-*}
only=${3:-}
workers=${WORKERS:-2}
limit=40 # seconds of processor time for a test; the longest takes 3

# What make is told. All trees have the models of the unchanged one, and so the same flags: what the
# unchanged one has built can be copied. Sanitizers only where a test asks for them: the build takes
# most of the time.
# shellcheck disable=SC2089 # make takes the quotes off
MAKEFLAGS="CFLAGS=-O1 OPENMP= DEFINES=-DCOURSE_BUILD='\"$work/tree0/build\"'"
# shellcheck disable=SC2090
export MAKEFLAGS

# make_test TREE ARGUMENT...: calls make there.
make_test() {
    tree=$1
    shift
    (cd "$tree" && make -s -j"$jobs" "$@")
}

# For make: the model is not sculpted again, since a mutant would make another one.
keep_model='-o build/models/bust.obj'

# run_test TREE TEST: builds and runs it. Prints `passed`, `failed`, `time` (stopped), or `error`:
# it could not be built or run.
run_test() {
    log=$1/log
    : >"$log"
    case $2 in
    test_*) arguments="SANITIZED=-O1 build/tests/$2" ;;
    sanitized*) arguments="BUILD=sanitized sanitized/tests/${2#* }" ;;
    stress*) arguments=build/stress ;;
    check*) arguments="build/check build/$(cd "$1" && echo step"${2#* }"_*)" ;;
    *) arguments= ;;
    esac
    # shellcheck disable=SC2086 # one word an argument
    if [ -n "$arguments" ] && ! make_test "$1" $keep_model $arguments >>"$log" 2>&1; then
        echo error
        return
    fi
    (
        cd "$1" || exit 126
        # Not in POSIX, but in every sh. A test of files writes more than 1 GiB of nothing.
        # shellcheck disable=SC3045
        ulimit -S -t $limit
        ulimit -f 3000000
        # shellcheck disable=SC3045
        ulimit -c 0
        case $2 in
        test_*)
            # shellcheck disable=SC3045
            ulimit -v 6000000
            exec "build/tests/$2"
            ;;
        sanitized*)
            exec "sanitized/tests/${2#* }"
            ;;
        *.sh)
            exec "tests/unit/$2"
            ;;
        stress*)
            share=${2#stress }
            STRESS=${share%% *} exec build/stress "${share#* }"
            ;;
        check*)
            build/check --programs build --differences build/differences \
                --make "make -s $keep_model" "${2#check }" >log.check
            cat log.check
            grep -q ' exact$' log.check
            ;;
        esac
    ) </dev/null >>"$log" 2>&1
    status=$?
    case $2:$status in
    *:0) echo passed ;;
    stress*:2 | *:12[67]) echo error ;;
    *:1[0-9][0-9])
        if [ "$(kill -l $status 2>/dev/null)" = XCPU ]; then echo time; else echo failed; fi
        ;;
    *) echo failed ;;
    esac
}

# Bring the tree back to what the unchanged one has.
restore() { # TREE FILE
    cp -p "$work/tree0/$2" "$1/$2"
    (cd "$1" && find build sanitized -type f -newer stamp) | while read -r path; do
        if [ -f "$work/tree0/$path" ]; then
            cp -p "$work/tree0/$path" "$1/$path"
        else
            rm -f "$1/$path"
        fi
    done
}

# try TREE NUMBER NAME FILE TEST: prints what became of the mutant.
try() {
    case $5 in
    equivalent:*)
        echo "equivalent $3 (${5#equivalent: })"
        return
        ;;
    awaits:*)
        echo "awaits     $3 (${5#awaits: })"
        return
        ;;
    elsewhere:*)
        echo "elsewhere  $3 (${5#elsewhere: } is not defined here)"
        return
        ;;
    esac
    touch "$1/stamp"
    cp "$work/list/$2" "$1/$4"
    case $(run_test "$1" "$5" 2>/dev/null) in # sh itself tells of crashes there
    passed) echo "SURVIVED   $3 ($5)" ;;
    failed) echo "killed     $3 ($5)" ;;
    time) echo "killed     $3 ($5, by time)" ;;
    *)
        echo "ERROR      $3 ($5 does not build or run):"
        sed 's/^/    /; 5q' "$1/log"
        ;;
    esac
    restore "$1" "$4"
}

# Take mutants from the table until there are none left.
work_on() { # TREE
    tab=$(printf '\t')
    while IFS=$tab read -r number name file test; do
        if mkdir "$work/list/taken$number" 2>/dev/null; then
            try "$1" "$number" "$name" "$file" "$test"
        fi
    done <"$work/list/table"
}

# ---- The lists ----

mkdir "$work/list" "$work/tree0" || exit 1
# shellcheck disable=SC2086 # a pattern
awk -v directory="$work/list" -v only="$only" -f tests/upkeep/verify/replace.awk -f tests/upkeep/mutants/parse.awk \
    tests/upkeep/mutants/$list.txt >"$work/list/table" || exit 1
# What is for other machines is not tried here.
"${CC:-cc}" -march=native -dM -E -x c /dev/null >"$work/macros" 2>/dev/null
tab=$(printf '\t')
# shellcheck disable=SC2013 # macros are words
for macro in $(sed -n "s/.*${tab}on \([^ ]*\) .*/\1/p" "$work/list/table" | sort -u); do
    if grep -q "^#define $macro " "$work/macros"; then
        sed "s/${tab}on $macro /$tab/" "$work/list/table" >"$work/list/new"
    else
        sed "s/${tab}on $macro .*/${tab}elsewhere: $macro/" "$work/list/table" >"$work/list/new"
    fi
    mv "$work/list/new" "$work/list/table"
done
if [ ! -s "$work/list/table" ]; then
    echo "mutants: no mutant has such a name" >&2
    exit 1
fi

# ---- The unchanged course: every test that is named must pass ----

cp -pR Makefile common tests step* "$work/tree0" && mkdir "$work/tree0/sanitized" || exit 1
tests=$(cut -f 4 "$work/list/table" | grep -v -e '^equivalent:' -e '^awaits:' -e '^elsewhere:' |
    sort -u)
jobs=$workers
if ! make_test "$work/tree0" models >"$work/tree0/log" 2>&1; then
    cat "$work/tree0/log"
    exit 1
fi
failed=$(echo "$tests" | while read -r test; do
    case $test in '') continue ;; esac
    result=$(run_test "$work/tree0" "$test")
    if [ "$result" != passed ]; then
        echo "$test: $result without a mutation:"
        tail -n 5 "$work/tree0/log"
    fi
done)
if [ -n "$failed" ]; then
    echo "$failed"
    exit 1
fi

# ---- The mutants ----

jobs=1
{
    worker=1
    pids=
    trap 'kill $pids' HUP INT TERM
    while [ "$worker" -le "$workers" ]; do
        cp -pR "$work/tree0" "$work/tree$worker" || exit 1
        work_on "$work/tree$worker" &
        pids="$pids $!"
        worker=$((worker + 1))
    done
    wait
} | tee "$work/results"

# ---- The counts ----

count() {
    grep -c "^$1 " "$work/results"
}
echo "$(count '[a-zA-Z]*') mutants: $(count killed) killed, $(count equivalent) equivalent," \
    "$(count elsewhere) for other machines, $(count SURVIVED) survive," \
    "$(count awaits) await a test, $(count ERROR) errors"
! grep -q -e '^SURVIVED ' -e '^awaits ' -e '^ERROR ' "$work/results"
