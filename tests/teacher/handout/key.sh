#!/bin/sh
# Writes the instructor's part, which no student gets: what `make handout` leaves out.
#
#     key.sh BUILD MAKE OUT [LESSONS]        LESSONS is 5 or 1-5; all of them without it
#
# OUT is a directory that is not there yet, or empty. It gets README.md with the points of each
# task, and for each lesson
#
#     main.c           the solution, without marks: it has passed the check
#     mistakes.html    each mistake of mistakes.txt: what is written wrong, what the check says to
#                      it, and the picture that it draws next to the reference
#
# MAKE builds a program. Works in BUILD, where the check, the library and the models must be built;
# as many programs at a time as there are processors, WORKERS=1 in the environment for one. Twice
# the same command writes the same bytes.
#
# Exit status: 0 done; 1 it cannot be done, and OUT is as it was; 2 wrong usage.

cd "$(dirname "$0")/../../.." || exit 1
target=key
build=$1
make=$2
out=$3
wanted=$4
workers=${WORKERS:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)}
. tests/student/lesson.sh
. tests/student/marked.sh
. tests/teacher/handout/out.sh
begin_out "$(mktemp -d "$build/key.XXXXXX")"

# The solutions, and all mistakes, become programs of $work/table, as tests/upkeep/verify has it. Mistakes
# are changes of the marked source, wherever that is found.
for lesson in $lessons; do
    put_text solution "$lesson"
    mkdir -p "$work/course/$lesson" && cp "$work/marked" "$work/course/$lesson/main.c" &&
        mkdir "$work/$lesson.solution" && cp "$new/$lesson/main.c" "$work/$lesson.solution" ||
        fail 1 "cannot write $work"
    [ ! -f "$lesson/mistakes.txt" ] || cp "$lesson/mistakes.txt" "$work/course/$lesson"
done
mkdir -p "$work/course/tests/check" && cp tests/check/scenes.txt "$work/course/tests/check" &&
    cp tests/upkeep/verify/replace.awk tests/upkeep/verify/parse.awk "$work" && cd "$work/course" &&
    awk -v directory=.. -f ../replace.awk -f ../parse.awk step*/mistakes.txt >../table ||
    fail 1 "a mistakes.txt is wrong"
cd - >/dev/null || exit 1
for lesson in $lessons; do
    printf '%s\t%s\tsolution\tsolution\t-\t-\t-\t-\t-\t0\t-\n' "$lesson.solution" "$lesson"
done >>"$work/table"
cut -f 1 "$work/table" |
    xargs -P "$workers" -n 1 sh tests/teacher/handout/draw.sh "$build" "$make" "$work" || fail 1 "stopped"

# ---- The pages ----

tab=$(printf '\t')
while IFS=$tab read -r number lesson kind name scene _; do
    [ "$kind" = mistake ] || continue
    [ "$scene" = numbers ] || put "tests/reference/$lesson/$scene.png" "$lesson/reference/$scene.png"
    mkdir -p "$new/$lesson/mistakes" || fail 1 "cannot write $new"
    [ ! -f "$work/$number.png" ] || mv "$work/$number.png" "$new/$lesson/mistakes/$name.png" ||
        fail 1 "cannot write $new"
done <"$work/table"

sums=
for lesson in $lessons; do
    sums="$sums $work/$lesson.json"
    text tasks "$work/course/$lesson/main.c" >>"$work/titles"
    [ ! -d "$new/$lesson/mistakes" ] ||
        awk -v lesson="$lesson" -v work="$work" -v page="$new/$lesson" \
            -f tests/teacher/handout/mistakes_page.awk "$work/table" >"$new/$lesson/mistakes.html" ||
        fail 1 "cannot write $new"
done

{
    cat <<'END'
# For the instructor: solutions, mistakes, points

Not for students: `make handout` writes what they get. All of this is made by `make key` from the
course; after a change of the course, make it again.

`main.c` is the solution that `make check` passes. Open `mistakes.html` in a browser: it shows the
pictures that typical mistakes draw, next to the reference.

END
    for lesson in $lessons; do
        title=$(sed -n '1s/^# //p' "$lesson/README.md")
        mistakes=
        [ ! -f "$new/$lesson/mistakes.html" ] || mistakes=", [mistakes]($lesson/mistakes.html)"
        echo "- $title: [solution]($lesson/main.c)$mistakes"
    done
    printf '\n## Points\n\n'
    # shellcheck disable=SC2086 # one word a file
    awk -v titles="$work/titles" -f tests/check/report.awk -f tests/teacher/handout/points.awk $sums
} >"$new/README.md" || fail 1 "cannot write $new"

finish_texts
end_out
