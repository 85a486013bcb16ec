#!/bin/bash
# How long does a whole run of step10_phong take, how does its time divide, how often does it wait
# for a page of memory, and how many times is it that of `cat` of the same input files and a copy of
# its output? Called by `make bench-run`.
#
#   tests/bench/whole_run.sh BUILD      BUILD: the build directory
#
# Times are those of one processor, in user code and kernel, so that waiting for others does not
# count; a program that goes on after a wait still finds a colder cache. Runs and copies take turns.
cd "$(dirname "$0")/../.." || exit 1
build=${1:-build}/run
rounds=21
runs=5 # in each round
if ! command -v perf >/dev/null; then
    echo 'bench-run: perf is missing; on Debian: apt-get install linux-perf' >&2
    exit 2
fi
unset MAKEFLAGS MFLAGS # of the make that calls
# Frame pointers and no jumps for calls, so that perf sees who called whom.
make -s BUILD="$build" CFLAGS='-O3 -fno-omit-frame-pointer -fno-optimize-sibling-calls' programs \
    models || exit 1
export THREADS=1
TIMEFORMAT='%U %S'

draw() {
    for ((i = 0; i < runs; i++)); do
        "$build/step10_phong" --only "$scene" -o "$build/out" >"$build/log" || exit 1
    done
}

# The same bytes, and nothing done with them.
move() {
    for ((i = 0; i < runs; i++)); do
        cat "${inputs[@]}" >/dev/null && cp "$build/out/$scene.tga" "$build/copy" || exit 1
    done
}

# median FILE: in ms a run, of lines of seconds.
median() {
    awk '{ print ($1 + $2) * 1000 }' "$1" | sort -n |
        awk -v runs=$runs '{ ms[NR] = $1 / runs } END { print ms[int((NR + 1) / 2)] }'
}

report() {
    perf report -i "$build/perf.data" --comm step10_phong --percentage relative -g none --stdio "$@" \
        2>/dev/null
}

echo 'scene         ms   load   draw   save   kernel   faults   cat and cp   ratio'
for scene in four turn; do
    inputs=("$build"/models/bust.obj "$build"/models/bust_{diffuse,nm}.tga)
    [ $scene = four ] || inputs+=("$build/models/bust_spec.tga")
    draw # also makes what is copied
    rm -f "$build"/{draw,move}.times
    for ((round = 0; round < rounds; round++)); do
        { time draw; } 2>>"$build/draw.times"
        { time move; } 2>>"$build/move.times"
    done
    perf record -q -F 10000 -g -o "$build/perf.data" bash -c "$(declare -f draw)
        build='$build' scene=$scene runs=40; draw" >"$build/log" 2>&1 || { cat "$build/log"; exit 1; }
    faults=$(perf stat -x , -r $rounds -e page-faults -o /dev/stdout \
        "$build/step10_phong" --only "$scene" -o "$build/out" |
        awk -F , '/page-faults/ { print $1 }')
    { report --children; echo alone; report --no-children; } |
        awk -v scene=$scene -v ms="$(median "$build/draw.times")" -v faults="$faults" \
            -v bytes="$(median "$build/move.times")" '
            /^alone/ { alone = 1 }
            !alone { share[$NF] = $1 * ms / 100 }
            alone && / \[k\] / { kernel += $1 * ms / 100 }
            END {
                printf "%-8s %7.1f %6.1f %6.1f %6.1f %8.1f %8d %12.1f %7.1f\n", scene, ms,
                    share["stage_begin"], share["stage_draw"], share["tga_write"],
                    kernel, faults, bytes, ms / bytes
            }'
done
