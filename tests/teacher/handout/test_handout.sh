#!/bin/sh
# Is what is handed out a whole course, and without solutions? Hands out two lessons: the same
# bytes twice; no mark, no mistake, nothing of what the next lessons teach; no link that
# leads nowhere. Each lesson alone: its solution compiles there. Then all of them, on a machine that
# has little more than gcc and make: `make` builds and draws every starter without a warning, and
# the check finds all to do.
. "$(dirname "$0")/../../unit/script.sh"

hand_out() {
    make -s handout OUT="$1" LESSONS="$2" >"$work/log" 2>&1
}

hand_out "$work/a" 4-5 || wrong "LESSONS=4-5 fails: $(cat "$work/log")"
hand_out "$work/b" 4-5 && diff -r "$work/a" "$work/b" >"$work/log" || wrong "the second time differs"
hand_out "$work/b" 4-5 && wrong "a directory with something in it is written over"
hand_out "$work/c" 4-x && wrong "LESSONS=4-x is taken"
hand_out "$work/c" 44 && wrong "LESSONS=44 is taken"
[ ! -e "$work/c" ] || wrong "a failure leaves something behind"

# What must not be there, and what must.
cd "$work/a" || exit 1
for file in step03_triangle step06_texture tests/upkeep tests/unit tests/lessons/step03_triangle \
    step04_flat/mistakes.txt common/pipeline.h; do
    [ ! -e "$file" ] || wrong "$file is handed out"
done
grep -rlE 'BEGIN SOLUTION|texture_bilinear\(' ./*.md step* common tests/student/starters \
    >"$work/log" &&
    wrong "a solution is handed out in $(cat "$work/log")"
grep -q 'bool edges_setup' common/given/triangles.h || wrong "the triangle of lesson 3 is missing in lesson 4"
grep -q 'to do 4\.1' step04_flat/main.c || wrong "the starter of lesson 4 is not one"
make -s help | grep -q 'make check' || wrong "make help does not help"
make -s help | grep -qE 'handout|mutants' && wrong "make help names targets of the instructor"

echo '// mine' >>step04_flat/main.c
make -s start STEP=04 >"$work/log" 2>&1 || wrong "make start: $(cat "$work/log")"
cmp -s step04_flat/main.c tests/student/starters/step04_flat.c || wrong "make start brings no starter back"
grep -q '// mine' step04_flat/main.c.1 || wrong "make start does not keep what main.c held"

mkdir -p tests/unit tests/upkeep/texts && cp "$top/tests/upkeep/texts/test_links.sh" tests/upkeep/texts &&
    cp "$top/tests/unit/script.sh" tests/unit
sh tests/upkeep/texts/test_links.sh >"$work/log" 2>&1 || wrong "$(cat "$work/log")"

# The first lesson needs nothing that it teaches.
cd "$top" || exit 1
hand_out "$work/one" 1 && cd "$work/one" || wrong "LESSONS=1 fails: $(cat "$work/log")"
grep -q 'line_begin(struct' common/*.h common/*.c common/*/*.h && wrong "the line of lesson 1 is handed out with it"
make -s CFLAGS=-O0 WERROR=-Werror programs >"$work/log" 2>&1 || wrong "make: $(cat "$work/log")"

# headers_build FILE...: each by itself, but those that say to include another one, which must be there.
headers_build() {
    alone=$(grep -L '#error "include .* instead"' "$@")
    for header in $(grep -l '#error "include .* instead"' "$@"); do
        other=$(sed -n 's/.*#error "include \(.*\) instead".*/\1/p' "$header")
        [ -f "common/$other" ] || alone="$alone $header"
    done
    # shellcheck disable=SC2086 # one word a file
    cc -std=c17 -fsyntax-only -Wall -Werror -Icommon -Itests -x c $alone
}

# commands_are_there FILE...: every `make TARGET` of these texts is in the hand-out's `make help`, or a
# lesson's program.
commands_are_there() {
    # A command may be wrapped after its first word.
    { ls -d step* && sed -n 's/^##   make \([a-z-]*\).*/\1/p' Makefile tests/*/*.mk; } >"$work/there"
    ! awk '/`make$/ { printf "%s ", $0; next } { print }' "$@" |
        grep -hoE '(`|^    )make [a-z][a-z0-9_-]*' | sed 's/.*make /make /' | sort -u |
        grep -vxF "$(sed 's/^/make /' "$work/there")"
}

# paths_are_there: so is every file that its texts name, but what programs write and a system has.
paths_are_there() {
    for text in README.md step*/*.md tests/*/*.md; do
        grep -oE '`[A-Za-z0-9_./]+(\.(c|h|sh|txt|md|mk|awk)|/)`' "$text" | tr -d '`' | sort -u |
            while read -r path; do
                case $path in build/* | mine/* | math.h) continue ;; esac
                for place in . "$(dirname "$text")" common common/pipeline tests; do
                    [ ! -e "$place/$path" ] || continue 2
                done
                echo "$text names $path"
            done
    done
}
cd "$top" || exit 1
hand_out "$work/three" 1-3 || wrong "LESSONS=1-3 fails: $(cat "$work/log")"
hand_out "$work/all" '' || wrong "make handout fails: $(cat "$work/log")"
for out in one three all; do
    missing=$(cd "$work/$out" && paths_are_there)
    [ -z "$missing" ] || wrong "$out: $missing"
    for file in .gitattributes .gitignore; do
        cmp -s $file "$work/$out/$file" || wrong "$out has no $file"
    done
done
for text in '# A software renderer by hand: lessons 1 to 3' 'pointers. The lessons take about 9 hours.'; do
    grep -qxF "$text" "$work/three/README.md" || wrong "its README.md does not say: $text"
done
! grep -qE 'ten lessons|turn\.png|tried, and how' "$work/three/README.md" ||
    wrong "README.md of lessons 1 to 3 speaks of others"
cmp -s README.md "$work/all/README.md" && wrong "README.md speaks of what stays here"

# What a lesson asks for can be written with the headers that come with it, and what its text tells
# to do is there.
cd "$top" || exit 1
for lesson in step*; do
    out=$work/only/$lesson
    mkdir -p "$work/only" && hand_out "$out" "$(echo "$lesson" | cut -c 5-6)" ||
        wrong "$lesson alone fails: $(cat "$work/log")"
    awk -v mode=solution -f tests/student/marks.awk "$lesson/main.c" >"$out/$lesson/main.c"
    cc -std=c17 -Wall -Werror -DCOURSE_BUILD='"build"' -I"$out/common" -fsyntax-only \
        "$out/$lesson/main.c" >"$work/log" 2>&1 ||
        wrong "$lesson needs what is not handed out with it: $(head -n 3 "$work/log")"
    case $lesson in step01_* | step10_*) others=$(cd "$out" && echo tests/*/*.h tests/*/*/*.h) ;; *) others= ;; esac
    # shellcheck disable=SC2086 # one word a file
    (cd "$out" && headers_build common/*.h common/*/*.h $others) \
        >"$work/log" 2>&1 || wrong "headers of $lesson: $(head -n 3 "$work/log")"
    (cd "$out" && commands_are_there README.md tests/student/README.md "$lesson"/*.md "$lesson"/*.txt "$lesson"/*.[ch]) ||
        wrong "$lesson names commands that are not handed out"
    grep -q "Then read .*(${lesson}/README.md)" "$out/README.md" || wrong "where does $lesson begin?"
done

# All lessons. A C compiler brings binutils; the others are in every system.
cd "$top" || exit 1
mkdir "$work/bin"
for tool in gcc as ld ar make sh awk sed cmp cksum getconf cat chmod cp date dirname basename echo \
    env expr head ls mkdir mktemp mv rm rmdir sort tail test touch tr true uname wc; do
    ln -s "$(command -v $tool)" "$work/bin/$tool" 2>/dev/null || : # a word of the shell
done
ln -s gcc "$work/bin/cc"
# little TARGET: makes it there, in `make -s`, of which what is printed is in $work/log.
little() {
    (cd "$work/all" && env -i PATH="$work/bin" make -s CFLAGS=-O1 WERROR=-Werror "$1") \
        >"$work/log" 2>&1
}
little all && ! grep -E 'warning|not found' "$work/log" ||
    wrong "make, with gcc and make alone: $(tail -n 5 "$work/log")"
little check && wrong "a starter passes"
[ "$(grep -c '^step[0-9]*_[a-z]* *TODO 0/.* SCORE 0/' "$work/log")" -eq 10 ] ||
    wrong "the check says: $(cat "$work/log")"
exit $failed
