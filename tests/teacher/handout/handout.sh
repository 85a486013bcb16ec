#!/bin/sh
# Writes what a student gets: a course of its own, without a solution.
#
#     handout.sh OUT [LESSONS]        LESSONS is 5 or 1-5; all of them without it
#
# OUT is a directory that is not there yet, or empty. It gets the lessons with main.c as the
# starter, the texts without answers, common, the check with its references, hints, and the Makefile
# without the targets for the course as a whole. What common has of a technique (sections whose
# heading says `taught in step03_triangle`) comes with the first hand-out that reaches beyond that
# lesson. Twice the same command writes the same bytes.
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

# put_changed SCRIPT FILE: put it as awk changes it.
put_changed() {
    make_room "$2" &&
        awk -v first="$first" -v last="$last" "$1" "$2" >"$new/$2" &&
        { [ ! -x "$2" ] || chmod +x "$new/$2"; } || fail 1 "cannot write $new/$2"
}

# ---- The lessons ----

# shellcheck disable=SC2016 # awk's own dollars
with_note='
    { print }
    /^\[.*\.\.\/README\.md#map-of-the-course/ {
        print "\nThis is a part of the course: `make figures`, `make bench`, `make counts` and" \
            " `make\ncharts`, which this page names, belong to the whole of it."
    }'

put_lesson() {
    mkdir -p "$new/$1" "$new/tests/handout"
    awk -v mode=without -f tests/teacher/handout/answers.awk "$1/README.md" >"$work/README.md" &&
        awk "$with_note" "$work/README.md" >"$new/$1/README.md" || fail 1 "cannot write $new/$1"
    put_text starter "$1"
    cp "$new/$1/main.c" "$new/tests/handout/$1.c" || fail 1 "cannot write $new/tests/handout"
    files=
    for file in "$1"/scenes.h "$1"/extra_*.h "$1"/mine.c "$1"/attempts.h "$1"/hints.txt \
        "$1"/[A-Z]*.md "$1"/figures/* tests/reference/"$1"/*; do
        [ ! -f "$file" ] || [ "$file" = "$1/README.md" ] || files="$files $file"
    done
    # shellcheck disable=SC2086 # one word a file
    put_all $files
}
for lesson in $lessons; do
    put_lesson "$lesson"
done

# ---- What they stand on ----

# Of files: the pipeline is explained, and given, in lesson 9.
is_later() {
    [ "$last" -lt 9 ] || return 1
    case ${1##*/} in
    pipeline.[ch] | pipeline_*.[ch] | lanes.h | texture_lanes.h | workers.[ch]) ;;
    *) return 1 ;;
    esac
}

# A section ends where the next begins, or with the #endif of its header.
# shellcheck disable=SC2016
without_later_sections='
    function finish() { if (file != "" && close(file) != 0) failed = 1 }
    FNR == 1 {
        finish()
        file = ENVIRON["new"] "/" FILENAME # not by -v, which reads backslashes
        later = 0
    }
    END { finish(); exit failed }
    /^\/\* ---- / {
        later = 0
        line = $0
        while (match(line, /step[0-9]+_/)) {
            if (/taught in/ && substr(line, RSTART + 4, RLENGTH - 5) + 0 >= last) later = 1
            line = substr(line, RSTART + RLENGTH)
        }
    }
    /^#endif$/ { later = 0 }
    !later { print >file }'

# Of lessons that are not handed out nobody needs to know what mistakes look like.
is_handed_out() {
    case $1 in
    tests/check/looks/step*)
        lesson=${1#tests/check/looks/}
        [ -d "$new/${lesson%%/*}" ]
        ;;
    common/*) ! is_later "$1" ;;
    esac
}

files=$(find common tests/check tests/student -type f |
    grep -v '/test_\|/wrong/\|/references.c$\|/\(looks\|figure\)_make.c$\|/wrong_figure.[ch]$' |
    sort)
changed=
unchanged=
for file in $files; do
    is_handed_out "$file" || continue
    case $file in
    common/*)
        make_room "$file" || fail 1 "cannot write $new/$file"
        changed="$changed $file"
        ;;
    tests/check/scenes.txt)
        # shellcheck disable=SC2016
        put_changed '
            { name = $1 ~ /^step/ ? $1 : $2 } # `work` and `relations` stand before it
            match(name, /^step[0-9]+_/) {
                step = substr(name, 5, RLENGTH - 5) + 0
                if (step < first || step > last) next
            }
            { print }' "$file"
        ;;
    *) unchanged="$unchanged $file" ;;
    esac
done
# shellcheck disable=SC2086 # one word a file
put_all $unchanged
# shellcheck disable=SC2086
new=$new awk -v last="$last" "$without_later_sections" $changed ||
    fail 1 "cannot write $new/common"
put LICENSE
put step10_phong/figures/turn.png # where all this leads to: README.md begins with it
put tests/student/lesson.sh

# The Makefile, whose help names only what is there.
# shellcheck disable=SC2016
put_changed '
    /^For the course as a whole:/ { whole = 1 }
    whole && /^  make help/ { whole = 0 }
    whole || /^  make solution/ { next }
    { print }' Makefile
cat >"$new/tests/handout/handout.mk" <<'END'
# make start STEP=05      step05_zbuffer/main.c becomes the starter again; what it held is kept
.PHONY: start solution
start:
	@tests/teacher/handout/start.sh '$(STEP)'
solution:
	@echo 'make solution: solutions are not handed out; your instructor has them' >&2; exit 1
END
cp tests/teacher/handout/start.sh "$new/tests/handout/start.sh" || fail 1 "cannot write $new"

# ---- README.md: of a course that ends here ----

first_lesson=${lessons# }
first_lesson=${first_lesson%% *}
# shellcheck disable=SC2016
sed -e "/^Go to/s|step01_line|$first_lesson|g" \
    -e "s/STEP=01/STEP=$(echo "$first_lesson" | cut -c 5-6)/" \
    -e "s/10 passed, 0 failed/$(echo "$lessons" | wc -w | tr -d ' ') passed, 0 failed/" \
    -e 's/no sandbox: where you do not trust what you grade, `make grade` shuts it in\./no sandbox./' \
    -e 's/as \.ci\/run: a picture/a picture/' README.md |
    awk -v first="$first" -v last="$last" '
        /^## / { left_out = /^## (If you teach|Accurate, fast|Layout|For contributors)/ }
        /^A position travels/ && (first > 8 || last < 8) { elsewhere = 1 } # what lesson 8 shows
        /^Hidden scenes/ { elsewhere = 1 }
        elsewhere || /^    make (solution|check HIDDEN)/ { if (/^$/) elsewhere = 0; next }
        match($0, /^    (THREADS=1 )?build\/step[0-9]+/) { # a program that is not there
            step = substr($0, RLENGTH - 1, 2) + 0
            if (step < first || step > last) next
        }
        /^<tr>/ { row = ""; in_row = 1 }
        in_row {
            row = row $0 "\n"
            if (/<\/tr>/) {
                in_row = 0
                match(row, /href="step[0-9]+_/)
                step = substr(row, RSTART + 10, RLENGTH - 11) + 0
                if (step >= first && step <= last) printf "%s", row
            }
            next
        }
        /^\| \[[0-9]+: / { keep = substr($0, 4) + 0 >= first && substr($0, 4) + 0 <= last }
        /^\| \|/ || /^\|  \|/ { if (!keep) next }
        /^\| \[[0-9]+: / && !keep { next }
        !left_out { print }' >"$new/README.md" || fail 1 "cannot write $new/README.md"

finish_texts

# Pictures that only answers show stay here, too.
cat "$new"/*.md "$new"/*/*.md | grep -oE '[[:alnum:]_.-]+\.(png|svg)' | sort -u >"$work/shown"
printf '%s\n' "$new"/step*/figures/* |
    awk -F / -v shown="$work/shown" '
        BEGIN { while ((getline name <shown) > 0) is_shown[name] = 1 }
        !($NF in is_shown) { print }' |
    while IFS= read -r figure; do
        rm -f "$figure"
    done

# ---- Nothing of a solution goes out ----

# The check knows the marks itself.
left=$(cd "$new" && grep -rlE 'BEGIN SOLUTION|END SOLUTION|/\* STARTER$|<summary>Answer' . |
    grep -vxF ./tests/check/todo.c)
# shellcheck disable=SC2086 # one word a file
[ -z "$left" ] || fail 1 "a mark is left in" $left
end_out
