#!/bin/bash
# Which lines and branches of common/ do the tests reach? Prints a table, one line a file, and every
# branch that no test takes. Called by `make coverage`, after the models are made.
#
#   tests/upkeep/coverage.sh BUILD       BUILD: the build directory, with models/ in it
#
# Needs gcc and gcov (GCOV=gcov-12 where it has another name). The branches of assert() are left
# out: the one that fails is the caller's bug, which no test may reach.
# shellcheck disable=SC2317 # each() calls the functions
cd "$(dirname "$0")/../.." || exit 1
. tests/upkeep/each.sh
mkdir -p "${1:-build}" || exit 1
build=$(cd "${1:-build}" && pwd)
work=$build/coverage
gcc=${GCC:-gcc}
gcov=${GCOV:-gcov}
for tool in "$gcc" "$gcov"; do
    if ! command -v "$tool" >/dev/null; then
        echo "coverage: $tool is missing; it comes with gcc: apt-get install gcc" >&2
        exit 2
    fi
done
if [ ! -f "$build/models/bust.obj" ]; then
    echo "coverage: $build/models/bust.obj is missing; make models" >&2
    exit 1
fi
rm -rf "$work"
mkdir -p "$work/common" "$work/tests" "$work/out" || exit 1

# ---- Build ----

# Kernels that are always inlined would be counted once for each place; here they are functions.
flags="-std=c17 -O0 -g -ffp-contract=off --coverage -Dalways_inline=unused -Icommon -Itests/unit
    -Itests/oracle"

# object SOURCE: where it is compiled into. A lesson's has the lesson's name.
object() {
    case $1 in
    common/*) echo "$work/${1%.c}.o" ;;
    step*) echo "$work/tests/${1%/*}.o" ;;
    *) echo "$work/tests/$(basename "$1" .c).o" ;;
    esac
}

compile() { # SOURCE
    # shellcheck disable=SC2086
    "$gcc" $flags "-DCOURSE_BUILD=\"$work\"" -c "$1" -o "$(object "$1")"
}

link() { # SOURCE
    program=$(object "$1")
    oracle=
    case $1 in tests/*) oracle=$(object tests/oracle/oracle.c) ;; esac
    # Tests that define __wrap_X() are linked so that calls of X() come there.
    wrap=$(sed -n 's/.*__wrap_\([a-z_]*\)(.*{$/-Wl,--wrap=\1/p' "$1")
    # shellcheck disable=SC2086
    "$gcc" --coverage $wrap "$program" $oracle "$work/common.a" -lm -o "${program%.o}"
}

export gcc flags work
export -f object compile link
programs=$(echo tests/unit/test_*.c step*/main.c)
# shellcheck disable=SC2086 # one word a source
each compile common/*.c tests/oracle/oracle.c $programs && ar rcs "$work/common.a" "$work"/common/*.o &&
    each link $programs || exit 1

# ---- Run ----

failed=0

# The programs: what people type, right and wrong. EXPECTED STATUS, PROGRAM, ARGUMENTS.
run() {
    expected=$1
    program=$2
    shift 2
    "$work/tests/$program" -o "$work/out" "$@" >"$work/log" 2>&1 </dev/null
    status=$?
    if [ $status -ne "$expected" ]; then
        echo "coverage: $program $*: status $status, not $expected" >&2
        cat "$work/log" >&2
        failed=1
    fi
}

run 1 step04_flat # the models are not made yet
ln -s "$build/models" "$work/models" || exit 1

run_test() { # SOURCE
    test=$(object "$1")
    test=${test%.o}
    "$test" >"$test.log" 2>&1 || {
        echo "coverage: $(basename "$test") failed" >&2
        cat "$test.log" >&2
        false
    }
}

# (What several processes count in the same file is added up.)
export -f run_test
each run_test tests/unit/test_*.c || failed=1

printf 'size 40 30\nline 1 2 30 20 255 0 0\n' >"$work/lines.txt"
printf 'triangle 1 2 30 20 5.5 25 255 0 0\n' >"$work/triangles.txt"
for source in step*/main.c; do
    program=$(dirname "$source")
    run 0 "$program" -s 120x90 --stats
    run 0 "$program" -s 60x45 --no-skip --format png
    run 0 "$program" --help
    run 2 "$program" --unknown
    run 2 "$program" -s 0x5
    # A lesson that draws text scenes takes one kind of them, lines or triangles; the others none.
    kinds=$("$work/tests/$program" --help | grep -c '\[scene.txt\]')
    for scene in lines triangles; do
        "$work/tests/$program" -o "$work/out" "$work/$scene.txt" >"$work/log" 2>&1 </dev/null &&
            kinds=$((kinds - 1))
    done
    if [ "$kinds" -ne 0 ]; then
        echo "coverage: $program takes another number of kinds of text scenes than it says" >&2
        failed=1
    fi
done

# More than 1 GiB from a pipe, which does not tell its size.
if head -c 1100000000 /dev/zero | "$work/tests/step01_line" -o "$work/out" - 2>"$work/log" ||
    ! grep -q "larger than 1 GiB" "$work/log"; then
    echo "coverage: step01_line - did not refuse more than 1 GiB" >&2
    failed=1
fi

# ---- Report ----

# Each object by itself, so that what several of them include is added up here: for each line
# how often it ran, for each branch how often it was taken.
count() { # OBJECT
    "$gcov" --branch-counts --branch-probabilities --stdout "$1" >"$1.counts" 2>/dev/null
}

export gcov
export -f count
each count "$work"/common/*.o "$work"/tests/*.o || failed=1
cat "$work"/*/*.counts | awk '
    /^ +-: +0:Source:/ {
        file = $0
        sub(/.*Source:/, "", file)
        wanted = file ~ /^common\/[a-z_]+\.[ch]$/
        next
    }
    !wanted { next }
    /^branch / {
        key = file SUBSEP line SUBSEP branches++
        if (!asserted) {
            taken[key] += $3 == "taken" ? $4 : 0
        }
        next
    }
    /^(function|call|unconditional) / { next }
    {
        ran = $0
        sub(/:.*/, "", ran)
        gsub(/[ *]/, "", ran)
        rest = substr($0, index($0, ":") + 1)
        line = rest + 0
        branches = 0
        if (line > 0 && ran != "-") {
            text[file, line] = substr(rest, index(rest, ":") + 1)
            asserted = text[file, line] ~ /assert\(/
            lines[file, line] += ran ~ /^[#=]/ ? 0 : ran
        }
    }
    END {
        for (key in lines) {
            split(key, part, SUBSEP)
            all_lines[part[1]]++
            run_lines[part[1]] += lines[key] > 0
            if (lines[key] == 0) {
                printf "2 %s:%05d: never run:      %s\n", part[1], part[2], text[key]
            }
        }
        for (key in taken) {
            split(key, part, SUBSEP)
            all_branches[part[1]]++
            taken_branches[part[1]] += taken[key] > 0
            if (taken[key] == 0 && lines[part[1], part[2]] > 0) {
                printf "2 %s:%05d: branch %d:       %s\n", part[1], part[2], part[3],
                    text[part[1], part[2]]
            }
        }
        for (file in all_lines) {
            row(file, run_lines[file], all_lines[file], taken_branches[file], all_branches[file])
            run_sum += run_lines[file]
            line_sum += all_lines[file]
            taken_sum += taken_branches[file]
            branch_sum += all_branches[file]
        }
        row("~all of common", run_sum, line_sum, taken_sum, branch_sum)
    }
    function percent(part, whole) { return whole == 0 ? 100 : 100 * part / whole }
    function row(name, ran, lines, taken, branches) {
        printf "1 %-24s %5d of %5d lines %6.1f %%   %5d of %5d branches %6.1f %%\n", name, ran,
            lines, percent(ran, lines), taken, branches, percent(taken, branches)
    }' | sort | sed 's/^1 ~/1  /; s/^2 \([^:]*\):0*/  \1:/; s/^1 //' >"$work/report"

grep -v '^ ' "$work/report"
grep '^ *all of' "$work/report" | sed 's/^ *//'
if grep -q '^  common' "$work/report"; then
    echo "Not reached by any test:"
    grep '^  common' "$work/report"
fi
exit $failed
