#!/bin/bash
# How long does a whole run of step10_phong take, how much of it in the kernel, and how many times is
# it that of `cat` of the same input files and a copy of its output? (How it divides into loading,
# drawing and saving: `make counts STEP=10`.) Called by `make bench-run`.
#
#   tests/bench/whole_run.sh BUILD      BUILD: the build directory, with programs and models
#
# Times are medians, of one processor, in user code and kernel, so that waiting for others does not
# count; a program that goes on after a wait still finds a colder cache. Runs and copies take turns.
cd "$(dirname "$0")/../.." || exit 1
build=$1
out=$build/run
rounds=21
runs=5 # in each round
export THREADS=1
TIMEFORMAT='%U %S'

draw() {
    for ((i = 0; i < runs; i++)); do
        "$build/step10_phong" --only "$scene" -o "$out" >"$out/log" || exit 1
    done
}

# The same bytes, and nothing done with them.
move() {
    for ((i = 0; i < runs; i++)); do
        cat "${inputs[@]}" >/dev/null && cp "$out/$scene.tga" "$out/copy" || exit 1
    done
}

# median FILE COLUMNS: the sum of these columns, in ms a run, of lines of seconds.
median() {
    awk -v runs=$runs "{ print ($2) * 1000 / runs }" "$1" | sort -n | sed -n "$(((rounds + 1) / 2))p"
}

mkdir -p "$out"
echo 'scene         ms   kernel   cat and cp   ratio'
for scene in four turn; do
    inputs=("$build"/models/bust.obj "$build"/models/bust_{diffuse,nm}.tga)
    [ $scene = four ] || inputs+=("$build/models/bust_spec.tga")
    draw # also makes what is copied
    rm -f "$out"/{draw,move}.times
    for ((round = 0; round < rounds; round++)); do
        { time draw; } 2>>"$out/draw.times"
        { time move; } 2>>"$out/move.times"
    done
    ms=$(median "$out/draw.times" '$1 + $2')
    bytes=$(median "$out/move.times" '$1 + $2')
    printf '%-8s %7.1f %8.1f %12.1f %7s\n' $scene "$ms" "$(median "$out/draw.times" '$2')" "$bytes" \
        "$(awk "BEGIN { printf \"%.1f\", $ms / $bytes }")"
done
