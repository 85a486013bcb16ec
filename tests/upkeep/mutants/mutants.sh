#!/bin/sh
# Do the tests notice small changes of the code? Makes a random sample of changes (mutate.awk), each
# in its own directory, and runs the tests that link what changed until one fails.
#
#   mutants.sh BUILD COUNT SEED [FILE...]     in the course's directory, which stays as it is
#
# FILE: a source to be changed; without one all of common and every lesson's main.c. A change counts
# when it compiles without a warning and gives another object. It is killed when a unit test, `make
# check` or `make stress` fails or takes too long; what survives meets the unit tests once more, under
# sanitizers.
#
# In the environment: MUTANTS_CC and MUTANTS_SANITIZED, compilers with their flags; MUTANTS_STRESS,
# the sources of `make stress`; JOBS, how many changes at a time.
#
# Lists what survives. Of 300 changes 4 or 5 % do: some can't be noticed, being only slower, or safer
# than they need be. Exit status 0: at least 94 % were killed, not counting two that survive, as chance
# has it in a small sample; 1: fewer; 2: it cannot work, or a test fails without any change.
here=$(cd "$(dirname "$0")" && pwd) && mkdir -p "$1" && build=$(cd "$1" && pwd) || exit 2
root=$PWD count=$2 seed=$3 tab=$(printf '\t') workers=
shift 3
jobs=${JOBS:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)}
work=$(mktemp -d "$build/mutants.XXXXXX") && scratch=$(mktemp -d /tmp/m.XXXXXX) &&
    chmod 711 "$scratch" || exit 2 # tests also read as somebody else
trap 'rm -rf "$work" "$scratch"' EXIT
trap 'kill $workers 2>/dev/null; exit 2' HUP INT TERM
grep -v '^call ' tests/check/scenes.txt >"$work/scenes.txt"
export CHECK_EXACT=1 CHECK_TIMEOUT=100 STRESS=0.02
export MALLOC_PERTURB_=90 # memory that nobody has written is not 0 by luck

# parallel FUNCTION FILE: calls it with number and text of each line, until it is false.
parallel() {
    rm -rf "$work/taken" && mkdir "$work/taken"
    workers=
    while [ "$(echo "$workers" | wc -w)" -lt "$jobs" ]; do
        n=0
        while read -r line; do
            n=$((n + 1))
            mkdir "$work/taken/$n" 2>/dev/null || continue
            "$1" $n "$line" || break
        done <"$2" &
        workers="$workers $!"
    done
    wait
}

# ---- Programs: unit tests, lessons, stress, the sculptor ----

sources_of() { # PROGRAM
    case $1 in
    stress) echo "$MUTANTS_STRESS" ;;
    */sculpt) (cd "$work/sources" && find "${1%/*}" -name '*.c') ;;
    *) echo "$1.c" ;;
    esac
}

# compile TREE SOURCE: next to SOURCE its object, and what that depends on.
compile() {
    (cd "$1" && eval "$compiler -DCOURSE_BUILD='\"$work\"' -MMD -c $2 -o ${2%.c}.o") 2>/dev/null
}

# link TREE PROGRAM OBJECT...: what they lack comes from the unchanged library. Prints what is
# linked. A test that defines __wrap_malloc() gets the calls of malloc().
link() (
    # shellcheck disable=SC2034 # used by eval
    wrap=$(sed -n 's/.*__wrap_\([a-z_]*\)(.*{$/-Wl,--wrap=\1/p' "$work/sources/$2.c" 2>/dev/null)
    cd "$1" && shift 2 || exit 1
    eval "$compiler" '$wrap "$@" "$base/library.a" -lm -Wl,-t,-t -o program' 2>/dev/null
)

# Does ./program sculpt the models of the course, coarser ones as it did before any change, and say
# which file it cannot write and what is wrong with its arguments?
sculpts() {
    mkdir fine coarse && timeout 120 ./program fine && ./program coarse 8 && cp -R coarse kept ||
        return 1
    for file in fine/*; do
        name=${file##*/}
        cmp "$file" "$work/models/$name" &&
            cmp "coarse/$name" "$base/common/sculptor/sculpt/kept/$name" || return 1
        rm "coarse/$name" && mkdir "coarse/$name" || return 1
        message=$(./program coarse 8 2>&1)
        [ $? -eq 1 ] && case $message in *"$name: is a directory") ;; *) false ;; esac || return 1
        rmdir "coarse/$name"
    done
    ./program fine 9
    [ $? -eq 2 ]
}

# run TREE PROGRAM SECONDS: of processor time; a deadlock ends after two minutes.
run() (
    # shellcheck disable=SC3045 # not in POSIX, but in every sh; sanitizers reserve more addresses
    { [ "$base" = "$work/sanitized" ] || ulimit -v 6000000; } && ulimit -t "$3" && ulimit -c 0
    ulimit -f 3000000 && cd "$1" || exit 1
    case $2 in
    */trials) # are built: make has nothing to do, so no functions are called with numbers
        lesson=${2%/*}
        lesson=${lesson##*/}
        mkdir -p checked && mv program "checked/$lesson" && : >"checked/$lesson.said" &&
            cd "$root" &&
            timeout 120 "$build/check" --programs "$1/checked" --differences "$1/differences" \
                --scenes "$work/scenes.txt" --make : "$lesson"
        ;;
    */sculpt) sculpts ;;
    *) timeout 120 ./program || exit ;; # from here, so that the shell says nothing of a crash
    esac
) </dev/null >/dev/null 2>&1

# Builds the unchanged program and runs it, once, when it is first needed; notes what it links, and
# how many seconds it may take.
prepare() { # PROGRAM
    [ ! -s "$base/$1/limit" ] || return 0
    if mkdir -p "$base/$1" && mkdir "$base/$1/begun" 2>/dev/null; then
        objects=$(for source in $(sources_of "$1"); do echo "$base/${source%.c}.o"; done)
        # shellcheck disable=SC2086 # one word an object
        for source in $(sources_of "$1"); do compile "$base" "$source" || break; done &&
            link "$base/$1" "$1" $objects >"$base/$1/linked" &&
            (run "$base/$1" "$1" 300 && times) >"$base/$1/times" ||
            echo "$1 fails without any change" >>"$work/failed"
        awk -F '[ ms]+' 'NR == 2 { print int(3 + 4 * ($1 * 60 + $2)) }' "$base/$1/times" \
            >"$base/$1/limit"
    fi
    until [ -s "$base/$1/limit" ] || [ -f "$work/failed" ]; do sleep 1; done
    [ ! -f "$work/failed" ]
}

# ---- Changes ----

# The programs: those named after the file first, as far as possible, and those last that must be
# compiled again.
order() { # FILE
    stem=${1##*/}
    stem=${stem%.*}
    [ "$stem" != main ] || stem=${1%/*}
    again=$(cd "$base" && find . -name '*.d' -exec grep -lF "$1" {} + | tr '\n' ' ')
    awk -v stem="$stem" -v word="${stem%%_*}" -v again="$again" '{
        rank = index($0, stem) ? 0 : index($0, word) ? 2 : 4
        print rank + (index(again, $0 ".d") > 0), NR, $0
    }' "$programs" | sort -k 1,1n -k 2,2n | cut -d ' ' -f 3
}

# Compiles a source that includes what changed; false where it doesn't compile. Adds to `changed` an
# object that differs from the one before.
recompile() { # TREE SOURCE
    object=${2%.c}.o
    [ ! -f "$1/$object" ] || return 0
    compile "$1" "$2" || return 1
    cmp -s "$1/$object" "$base/$object" || changed="$changed $object"
}

# Sets `fate`: what becomes of the change.
decide() { # TREE FILE
    changed='' fate='not compiled'
    for list in $(cd "$base" && sed 's/c$/d/' "$work/library" | xargs grep -lF "$2"); do
        recompile "$1" "${list%d}c" || return
    done
    library=$changed
    for program in $(order "$2"); do
        prepare "$program" || return
        objects='' affected=false
        for source in $(sources_of "$program"); do
            object=${source%.c}.o
            if grep -qF "$2" "$base/${source%.c}.d"; then
                recompile "$1" "$source" || return
                objects="$objects $1/$object"
                case "$changed " in *" $object "*) affected=true ;; esac
            else
                objects="$objects $base/$object"
            fi
        done
        for object in $library; do
            ! grep -q "[/()]${object##*/}" "$base/$program/linked" || affected=true
            objects="$objects $1/$object"
        done
        [ $affected = true ] || continue
        # shellcheck disable=SC2086 # one word an object
        link "$1" "$program" $objects >/dev/null || return
        fate="killed by $program"
        run "$1" "$program" "$(cat "$base/$program/limit")" || {
            [ $? -ne 124 ] || fate="killed by a deadlock in $program"
            return
        }
        fate='not compiled'
    done
    [ -n "$changed" ] && fate=survives || fate='the same'
}

try_change() { # NUMBER LINE
    [ "$(grep -c '^[ks]' "$work/fates")" -lt "$count" ] && [ ! -f "$work/failed" ] || return 1
    file=$(printf '%s\n' "$2" | cut -f 4) tree=$work/tree.$1
    cp -R "$work/sources" "$tree"
    after=$(printf '%s\n' "$2" | cut -f 6) awk -v line="${2%%"$tab"*}" '
        { print NR == line ? ENVIRON["after"] : $0 }' "$work/sources/$file" >"$tree/$file"
    decide "$tree" "$file"
    printf '%s\t%d\t%s\n' "$fate" "$1" "$2" >>"$work/fates"
    rm -rf "$tree"
}

# try_changes NAME COMPILER: those in $work/changes; of their fates only the first that count stay.
try_changes() {
    base=$work/$1 compiler=$2 programs=$work/$1.programs
    cp -R "$work/sources" "$base"
    parallel compile_library "$work/library"
    (cd "$base" && sed 's/c$/o/' "$work/library" | xargs ar qc library.a)
    parallel try_change "$work/changes"
    if [ -f "$work/failed" ]; then
        cat "$work/failed"
        exit 2
    fi
    sort -t "$tab" -k 2n "$work/fates" >"$work/sorted"
    awk -v count="$count" '!/^[ks]/ || ++n <= count' "$work/sorted" >"$work/fates"
}

compile_library() { # NUMBER SOURCE
    compile "$base" "$2" || echo "$2 does not compile" >>"$work/failed"
}

# Whatever the order of their two arguments, they do the same.
symmetric="vec3_dot vec3_add fmin fmax calloc memcmp strcmp lanes_min lanes_max lanes_int_min lanes_int_max \
doubles_min doubles_max box_centers least_of most_of span_overlap span_around same_point same_place \
mean_of_four swap_rows swap_bytes count_equal area_of model_angle join joins_the_same"

# The sources. Tests make their files where they are found again, and not all over /tmp.
mkdir "$work/sources" || exit 2
stress=$(echo "$MUTANTS_STRESS" | tr ' ' '\n' | sed 's|/[^/]*$||' | sort -u)
for part in common step* tests/unit tests/lessons tests/oracle $stress; do
    [ ! -d "$part" ] || { mkdir -p "$work/sources/$part" && cp -R "$part/." "$work/sources/$part"; }
done
[ ! -f tests/lesson.h ] || cp tests/*.h "$work/sources/tests"
cd "$work/sources" || exit 2
find . -type f ! -name '*.[ch]' -exec rm -f {} +
find tests/unit -name '*.[ch]' -exec sed -i "s|\"/tmp/[a-z_]*\.XXXXXX|\"$scratch/f.XXXXXX|" {} +
ln -s "$build/models" "$work/models"
find common tests/oracle -name '*.c' 2>/dev/null | grep -v /sculptor/ >"$work/library"
find tests/unit tests/lessons -name 'test_*.c' 2>/dev/null | sed 's/\.c$//' | sort >"$work/sanitized.programs"
[ ! -d common/sculptor ] || echo common/sculptor/sculpt >>"$work/sanitized.programs"
find tests/lessons -name trials.c 2>/dev/null | sed 's/\.c$//' | sort |
    cat "$work/sanitized.programs" - >"$work/plain.programs"
[ -z "$MUTANTS_STRESS" ] || echo stress >>"$work/plain.programs"
# shellcheck disable=SC2046 # one word a file
[ $# -gt 0 ] || set -- $(find common -name '*.[ch]') $(find step* -name main.c 2>/dev/null)
awk -v seed="$seed" 'BEGIN { for (i = 0; i < 99; i++) printf "%s", "seed " seed }' >"$work/seed"
awk -f "$here/mutate.awk" "$@" | awk -F "$tab" -v symmetric="$symmetric" \
    '$2 != "swapped" || !index(" " symmetric " ", " " $3 " ")' |
    sort -t "$tab" -k 4R --random-source="$work/seed" >"$work/changes"
: >"$work/fates"
cd "$root" || exit 2
try_changes plain "$MUTANTS_CC"
grep '^survives' "$work/fates" | cut -f 3- >"$work/changes"
if [ -s "$work/changes" ] && [ -n "$MUTANTS_SANITIZED" ]; then
    grep '^killed' "$work/fates" >"$work/killed"
    mv "$work/killed" "$work/fates"
    count=$((count + 1))
    try_changes sanitized "$MUTANTS_SANITIZED"
    # Where no unit test links what changed, as of most lessons, none could be run again.
    sed -i -e 's/^the same/survives/' -e 's/^not compiled/survives/' "$work/fates"
fi
cp "$work/fates" "${MUTANTS_LOG:-/dev/null}"
sort -t "$tab" -k 6,6 -k 3,3n "$work/fates" | awk -F '\t' -v seed="$seed" '
    /^survives/ { n++; printf "%s:%d: %s survives\n    - %s\n    + %s\n", $6, $3, $4, $7, $8 }
    /^killed/ { killed++ }
    END {
        printf "%d of %d changes killed (seed %s)\n", killed, killed + n, seed
        exit killed == 0 || killed + 2 < 0.94 * (killed + n)
    }'
