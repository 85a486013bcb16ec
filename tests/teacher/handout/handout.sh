#!/bin/sh
# Writes what a student gets: a course without solutions.
#
#     handout.sh OUT [LESSONS]        LESSONS is such as 5, 1-5 or 1-3,5; all of them without it
#
# OUT is a directory that is not there yet, or empty. It gets the lessons with main.c as the
# starter, the texts, the check with its references, hints, and what of common these
# need. What common has of a technique (sections whose heading says `taught in step03_triangle`)
# comes with the first hand-out that reaches beyond that lesson. Twice the same command writes the
# same bytes.
#
# Exit status: 0 done; 1 it cannot be done, or a mark of a solution would have gone out, and OUT is
# as it was; 2 wrong usage.

cd "$(dirname "$0")/../../.." || exit 1
target=handout
out=$1
wanted=$2
. tests/student/lesson.sh
. tests/student/marked.sh
. tests/teacher/handout/out.sh
begin_out "$(mktemp -d)"

# put_changed SCRIPT FILE...: put them as awk changes them, which writes each to `out`.
put_changed() {
    script=$1
    shift
    printf '%s\n' "$@" >"$work/changed"
    put_all <"$work/changed" && awk -v lessons="$lessons" -v last="$last" -v new="$new/" '
        FNR == 1 { close(out); out = new FILENAME }'"$script" "$@" || fail 1 "cannot write into $new"
}

# ---- The lessons ----

# Commands and files that only the whole course has are in brackets behind what they measure or draw.
# shellcheck disable=SC2016 # awk's own dollars
without_commands='

    { text[out] = text[out] $0 "\n" }
    END {
        for (out in text) {
            gsub(/[ \n]+\(`make (figures|bench|bench-frame|counts|stress|prove)( STEP=[0-9]+| OPTIONS=[-a-z]+)?`\)/, "", text[out])
            gsub(/; `[a-z_]+\(\)` in `tests\/lessons\/[^`]+`/, "", text[out])
            printf "%s", text[out] >out
            close(out)
        }
    }'

put_lesson() {
    mkdir -p "$new/$1" "$new/tests/student/starters"
    put_text starter "$1"
    cp "$new/$1/main.c" "$new/tests/student/starters/$1.c" || fail 1 "cannot write $new/tests"
    for file in "$1"/scenes.h "$1"/extra_*.h "$1"/opengl.c "$1"/attempts.h "$1"/hints.txt \
        "$1"/figures/* tests/reference/"$1"/* \
        tests/lessons/"$1"/numbers.c tests/lessons/"$1"/trials.c tests/lessons/"$1"/live.c; do
        [ ! -f "$file" ] || echo "$file"
    done >"$work/files"
    put_all <"$work/files"
    put_changed "$without_commands" "$1"/[A-Z]*.md
}
for lesson in $lessons; do
    put_lesson "$lesson"
done

# ---- What they need ----

# A section ends where the next begins, or with the #endif of its header.
# shellcheck disable=SC2016
without_later_sections='
    FNR == 1 { later = 0 }
    /^\/\* ---- / {
        later = 0
        line = $0
        while (match(line, /step[0-9]+_/)) {
            if (/taught in/ && substr(line, RSTART + 4, RLENGTH - 5) + 0 >= last) later = 1
            line = substr(line, RSTART + RLENGTH)
        }
    }
    /^#endif$/ { later = 0 }
    !later { print >out }'

# Programs of which a student needs the sources, besides the lessons.
programs="tests/check/check.c tests/student/show.c tests/student/compare_page.c tests/student/live/serve.c common/sculptor/sculpt.c"
# shellcheck disable=SC2046,SC2086 # one word a file
awk -f tests/teacher/handout/needs.awk \
    $(find common tests/check tests/student -name '*.[ch]' ! -name 'test_*' | sort) = \
    $programs "$new"/step*/*.[ch] "$new"/tests/lessons/*/*.c >"$work/needed" || fail 1 "cannot find out what the lessons need"
put_all <"$work/needed"
# shellcheck disable=SC2046 # one word a file
put_changed "$without_later_sections" $(grep '^common/' "$work/needed")

# What is no source: scripts, pages, and what the mistakes of these lessons look like.
{
    find tests/check tests/student -type f ! -name '*.[ch]' ! -path '*/wrong/*' \
        ! -name 'test_*' ! -name 'try_*' ! -name 'mark*' ! -name start.sh ! -name references.sh
    for lesson in $lessons; do
        [ ! -d "tests/lessons/$lesson/looks" ] || find "tests/lessons/$lesson/looks" -type f
    done
} >"$work/others"
put_all <"$work/others"
# shellcheck disable=SC2016
put_changed '
    { name = $1 ~ /^step/ ? $1 : $2 } # `work` and `relations` are before it
    name ~ /^step[0-9]+_/ && !index(lessons " ", " " name " ") { next }
    { print >out }' tests/check/scenes.txt
put tests/lesson.h
put tests/numbers.h
put tests/more_scenes.h
! grep -qs lane_numbers.h "$new"/tests/lessons/*/numbers.c || put tests/lane_numbers.h
[ ! -f "$new/common/pipeline.h" ] || put tests/student/new.c # which draws with it
put tests/student/renderer/given.c
for file in LICENSE Makefile .gitattributes .gitignore; do
    put $file
done
put tests/student/lesson.sh
put tests/student/machine.mk

# `make start` has the starters themselves; there is no `make solution`.
put tests/teacher/handout/start.sh tests/student/start.sh
put_changed '!/make solution/ { print >out }' tests/student/student.mk

# ---- README.md: of a course that ends here ----

first_lesson=${lessons# }
first_lesson=${first_lesson%% *}
# In words, where they are not all.
some=
[ "$(list_lessons | wc -l)" -eq "$(echo "$lessons" | wc -w)" ] || some=$(echo "$wanted" | sed 's/-/ to /g; s/,/, /g')
sed -e "/^Then read/s|.*|Then read [lesson $first]($first_lesson/README.md).|" \
    -e "s|^..Begin lesson.*|**[Begin lesson $first]($first_lesson/README.md)**|" \
    -e "s/STEP=01/STEP=$(echo "$first_lesson" | cut -c 5-6)/; s/turns lesson 1 into/turns lesson $first into/" \
    README.md |
    awk -v lessons="$lessons" -v last="$last" -v some="$some" '
        function is_there(step) { return index(lessons, " step" step "_") }
        # "2½ hours" as a number
        function hours_of(text,    hours) {
            hours = text + 0
            if (text ~ /¼/) hours += 0.25
            if (text ~ /½/) hours += 0.5
            if (text ~ /¾/) hours += 0.75
            return hours
        }
        FNR == 1 { file++ }
        # First what the map says of the lessons that are there.
        file == 1 {
            if (/^<tr>/) picture = $0
            if (/href="step/) match($0, /step[0-9]+/)
            if (/href="step/ && is_there(substr($0, RSTART + 4, RLENGTH - 4)) && match($0, /<td>[^<]* hours?</)) {
                hours += hours_of(substr($0, RSTART + 4))
                sub(/.*src="/, "", picture)
                sub(/".*/, "", picture)
                last_picture = picture
            }
            next
        }
        /^## More/ { exit }
        /^    make solution/ || /^What is cloned is solved/ { next }
        BEGIN { several = some ~ /[^0-9]/ }
        some && /^# / { sub(/in ten lessons/, "by hand: lesson" (several ? "s " : " ") some) }
        last < 10 && /^From one line of pixels/ {
            print "In C17, without a graphics library or any other package."
            skipping = 1
            blank = 0
        }
        skipping { if (NF) next; skipping = 0 }
        some { sub(/The whole course takes about [0-9]+/, (several ? "The lessons take" : "The lesson takes") \
                   " about " int(hours + 0.99)) }
        last < 10 { sub(/with the last picture of the course/, "with its last picture") }
        last < 10 && /^<img src="step10_phong/ { print "<img src=\"" last_picture "\" width=\"240\" alt=\"\">"; blank = 0; next }
        # A row of the map has several lines.
        /^<tr>/ { row = ""; in_row = 1 }
        in_row {
            row = row $0 "\n"
            if (/<\/tr>/) {
                in_row = 0
                match(row, /href="step[0-9]+_/)
                if (is_there(substr(row, RSTART + 10, RLENGTH - 11))) printf "%s", row
            }
            next
        }
        NF || !blank { print }
        { blank = !NF }' README.md - >"$new/README.md" || fail 1 "cannot write $new/README.md"

finish_texts

# ---- Nothing of a solution goes out ----

# The check knows the marks itself.
left=$(cd "$new" && grep -rlE 'BEGIN SOLUTION|END SOLUTION|/\* STARTER$' . |
    grep -vxF ./tests/check/todo.c)
# shellcheck disable=SC2086 # one word a file
[ -z "$left" ] || fail 1 "a mark is left in" $left
end_out
