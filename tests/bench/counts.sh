#!/bin/sh
# How many instructions does each scene of a lesson's own program take? Counted by callgrind: the same in every run, however
# busy the machine is. Writes tests/bench/counts.txt, and prints it with what was committed there and the
# change. No number makes it fail: another compiler gives others. Called by `make counts`.
#
#   tests/bench/counts.sh BUILD [STEP]    BUILD: the build directory
#                                   STEP: only this lesson (05); tests/bench/counts.txt stays as it is
cd "$(dirname "$0")/../.." || exit 1
build=${1:-build}/counts
chosen=$2
march=-march=x86-64-v3 # valgrind does not know everything that -march=native may mean
unset MAKEFLAGS MFLAGS # of the make that calls: other settings would give other numbers
if ! command -v valgrind >/dev/null; then
    echo 'counts: valgrind is missing; on Debian: apt-get install valgrind' >&2
    exit 2
fi

# -g changes no instruction; it says from which file each comes.
make -s BUILD="$build" CC=gcc CFLAGS='-O3 -g' MARCH=$march REAL= LANES= programs models || exit 1
git show HEAD:./tests/bench/counts.txt >"$build/committed" 2>/dev/null ||
    : >"$build/committed"

# count STEP SCENE: a line of the table. A function's cost includes that of the functions it calls;
# but `own` adds up the lesson's own functions, those of main.c and scenes.h, without what they call.
count() {
    rm -rf "$build/out"
    env -i THREADS=1 valgrind -q --tool=callgrind --compress-strings=no --compress-pos=no \
        --callgrind-out-file="$build/callgrind.out" "$build/$1" --only "$2" -o "$build/out" \
        >"$build/log" 2>&1 || { cat "$build/log" >&2; return 1; }
    awk -v step="$1" -v scene="$2" '
        /^fl=/ { own = index($0, "/" step "/") }
        /^cfn=/ { called = substr($0, 5) }
        /^calls=/ { getline; cost[called] += $2; next }
        /^[0-9]/ { all += $2; if (own) in_lesson += $2 }
        END {
            printf "%-17s %-10s %8.3f %8.3f %8.3f %8.3f %8.3f\n", step, scene, all / 1e6,
                cost["stage_begin"] / 1e6, cost["stage_draw"] / 1e6, cost["tga_write"] / 1e6,
                in_lesson / 1e6
        }' "$build/callgrind.out"
}

{
    echo "# $(gcc --version | sed 1q), -O3 $march, one thread: millions of instructions"
    echo '# step            scene           all     load     draw     save      own'
} >"$build/counts.txt"
awk -v s="$chosen" '
    /^step/ && (s == "" || s == $1 || index($1, "step" s "_") == 1 || index($1, "step0" s "_") == 1) {
        print $1, $2
    }' tests/check/scenes.txt >"$build/scenes"
[ -s "$build/scenes" ] || { echo "counts: there is no lesson $chosen" >&2; exit 2; }
while read -r step scene; do
    "$build/$step" --only "$scene" --help >/dev/null 2>&1 || continue # one of its trials
    count "$step" "$scene" </dev/null >>"$build/counts.txt" || exit 1
done <"$build/scenes"

awk 'FILENAME == ARGV[1] { committed[$1, $2] = $3; next }
    /^# step/ { print $0 "  committed"; next }
    /^#/ { print; next }
    !(committed[$1, $2] > 0) { print $0 "       none"; next }
    { old = committed[$1, $2]; printf "%s %10.3f %+6.1f %%\n", $0, old, 100 * ($3 / old - 1) }
    ' "$build/committed" "$build/counts.txt"
[ -n "$chosen" ] || cp "$build/counts.txt" tests/bench/counts.txt
