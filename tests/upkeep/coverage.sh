#!/bin/sh
# Which lines and branches of common/ do the tests reach? Prints a table, one line a file, and every
# branch that no test takes. Called by `make coverage`.
#
#   tests/upkeep/coverage.sh BUILD MAKE       BUILD: the build directory
#
# Needs gcc and gcov. The branches of assert() are left out: the one that fails is the caller's bug,
# which no test may reach.
cd "$(dirname "$0")/../.." || exit 1
work=$(mkdir -p "$1" && cd "$1" && pwd)/coverage || exit 1
make=$2
failed=0
if ! command -v gcov >/dev/null; then
    echo 'coverage: gcov is missing; it comes with gcc: apt-get install gcc' >&2
    exit 2
fi
rm -rf "$work"
unset MAKEFLAGS MFLAGS # of the make that calls

# Kernels that are always inlined would be counted once for each place; here they are functions. (The
# tests' own build has that anyway.)
counted='-O0 -g --coverage -fprofile-update=atomic' # several threads count
build() {
    $make CC=gcc BUILD="$work" SANITIZED="$counted" MARCH= \
        CFLAGS="$counted -Dalways_inline=unused -Dflatten=unused" "$@" >"$work.log" 2>&1 ||
        { tail -n 20 "$work.log" >&2; exit 1; }
}

# run STATUS PROGRAM ARGUMENT...: what people type, right and wrong.
run() {
    expected=$1
    program=$2
    shift 2
    "$work/$program" -o "$work/out" "$@" >"$work.log" 2>&1 </dev/null
    status=$?
    if [ $status -ne "$expected" ]; then
        echo "coverage: $program $*: status $status, not $expected" >&2
        cat "$work.log" >&2
        failed=1
    fi
}

build programs
rm -rf "$work/models"
run 1 step04_flat # without a model
tests=$(find tests/unit -name 'test_*.c' | sed "s|^|$work/|; s|\.c\$||")
# shellcheck disable=SC2086
build models $tests
# shellcheck disable=SC2086
tests/upkeep/run_tests.sh $tests >"$work.log" 2>&1 || { grep FAILED "$work.log" >&2; failed=1; }

printf 'size 40 30\nline 1 2 30 20 255 0 0\n' >"$work/lines.txt"
printf 'triangle 1 2 30 20 5.5 25 255 0 0\n' >"$work/triangles.txt"
for lesson in step*_*; do
    run 0 "$lesson" -s 120x90 --stats
    run 0 "$lesson" -s 60x45 --no-skip --format png
    run 0 "$lesson" --help
    run 2 "$lesson" --unknown
    run 2 "$lesson" -s 0x5
    # Lesson 1 draws text scenes of lines and lesson 3 of triangles; the others take none.
    case $lesson in step01*) lines=0 ;; *) lines=1 ;; esac
    case $lesson in step03*) triangles=0 ;; *) triangles=1 ;; esac
    run $lines "$lesson" "$work/lines.txt"
    run $triangles "$lesson" "$work/triangles.txt"
done

# More than 1 GiB from a pipe, which does not tell its size.
if head -c 1100000000 /dev/zero | "$work/step01_line" -o "$work/out" - 2>"$work.log" ||
    ! grep -q "larger than 1 GiB" "$work.log"; then
    echo "coverage: step01_line - did not refuse more than 1 GiB" >&2
    failed=1
fi

# Each object by itself, so that what several of them include is added up here: for each line how often
# it ran, for each branch how often it was taken.
find "$work" -name '*.gcda' -exec gcov --branch-counts --branch-probabilities --stdout {} + \
    2>"$work.log" | awk '
    /^ +-: +0:Source:/ {
        file = $0
        sub(/.*Source:/, "", file)
        wanted = file ~ /^common\/([bfpr][a-z]+\/)?[a-z_]+\.[ch]$/
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
    }' | sort | sed 's/^1 ~/1  /; s/^2 \([^:]*\):0*/  \1:/; s/^1 //' >"$work.report"

grep -v '^ ' "$work.report"
grep '^ *all of' "$work.report" | sed 's/^ *//'
if grep -q '^  common' "$work.report"; then
    echo "Not reached by any test:"
    grep '^  common' "$work.report"
fi
exit $failed
