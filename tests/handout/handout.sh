#!/bin/sh
# Writes what a student gets: a course of its own, without a solution.
#
#     handout.sh OUT [LESSONS]        LESSONS is 5 or 1-5; all of them without it
#
# OUT is a directory that is not there yet, or empty. It gets the lessons with main.c as the
# starter, the texts without answers, common, the check with its references, hints, and the Makefile
# without the targets for the course as a whole. What common has of a technique (sections whose heading says
# `taught in step03_triangle`) comes with the first hand-out that reaches beyond that lesson. Twice
# the same command writes the same bytes.
#
# Exit status: 0 done; 1 it cannot be done, or a mark of a solution would have gone out, and OUT is
# as it was; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
target=handout
out=$1
wanted=${2:-1-99}
. tests/starter/lesson.sh

[ -n "$out" ] || fail 2 "say where to: make handout OUT=some/directory [LESSONS=1-5]"
case $wanted in
*[!0-9-]* | -* | *- | *-*-*) fail 2 "LESSONS=$wanted is neither a number nor like 1-5" ;;
esac
first=$(expr "${wanted%-*}" + 0)
last=$(expr "${wanted#*-}" + 0)
if [ -e "$out" ] && { [ ! -d "$out" ] || [ -n "$(ls -A "$out")" ]; }; then
    fail 1 "$out is there already, and not an empty directory"
fi
mkdir -p "$(dirname "$out")" && work=$(mktemp -d "$out.XXXXXX") ||
    fail 1 "cannot write beside $out"
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

# number LESSON: 5 of step05_zbuffer.
number() {
    number=${1#step}
    expr "${number%%_*}" + 0
}

# put FILE: at the same place in the hand-out.
put() {
    mkdir -p "$work/$(dirname "$1")" && cp "$1" "$work/$1" || fail 1 "cannot write $work/$1"
}

# without SCRIPT FILE: put it as awk changes it.
put_changed() {
    mkdir -p "$work/$(dirname "$2")" &&
        awk -v first="$first" -v last="$last" "$1" "$2" >"$work/$2" &&
        { [ ! -x "$2" ] || chmod +x "$work/$2"; } || fail 1 "cannot write $work/$2"
}

# ---- The lessons ----

lessons=
for lesson in step[0-9]*_*/; do
    lesson=${lesson%/}
    [ "$(number "$lesson")" -ge "$first" ] && [ "$(number "$lesson")" -le "$last" ] &&
        lessons="$lessons $lesson"
done
[ -n "$lessons" ] || fail 2 "there is no lesson in LESSONS=$wanted"

# shellcheck disable=SC2016 # awk's own dollars
without_answers='
    /<details><summary>Answer<\/summary>/ { inside = 1; next }
    inside { if (/<\/details>/) { inside = 0; gap = 1 } next }
    gap && /^ *$/ { next }
    gap { gap = 0; if (!/^ *[0-9]+\. /) print "" }
    { print }
    /^\[.*\.\.\/README\.md#map-of-the-course/ {
        print "\nThis is a part of the course: `make figures`, `make bench`, `make counts` and `make"
        print "charts`, which this page names, belong to the whole of it."
    }'

put_lesson() {
    put_changed "$without_answers" "$1/README.md"
    mkdir -p "$work/tests/handout"
    awk -v mode=starter -f tests/starter/marks.awk "$1/main.c" >"$work/$1/main.c" ||
        fail 1 "no starter of $1"
    cp "$work/$1/main.c" "$work/tests/handout/$1.c"
    for file in "$1"/scenes.h "$1"/extra_*.h "$1"/mine.c "$1"/attempts.h "$1"/hints.txt \
        "$1"/figures/* "$1"/[A-Z]*.md tests/reference/"$1"/*; do
        [ ! -f "$file" ] || [ "$file" = "$1/README.md" ] || put "$file"
    done
}
for lesson in $lessons; do
    put_lesson "$lesson"
done

# ---- What they stand on ----

# Of files: the pipeline is explained, and given, in lesson 9.
later_files() {
    [ "$last" -ge 9 ] || echo 'pipeline.[ch] pipeline_*.[ch] lanes.h texture_lanes.h workers.[ch]'
}

is_later() {
    for pattern in $(later_files); do
        # shellcheck disable=SC2254 # it is a pattern
        case ${1##*/} in $pattern) return 0 ;; esac
    done
    return 1
}

# A section ends where the next begins, or with the #endif of its header.
# shellcheck disable=SC2016
without_later_sections='
    /^\/\* ---- / {
        later = 0
        line = $0
        while (match(line, /step[0-9]+_/)) {
            if (/taught in/ && substr(line, RSTART + 4, RLENGTH - 5) + 0 >= last) later = 1
            line = substr(line, RSTART + RLENGTH)
        }
    }
    /^#endif$/ { later = 0 }
    !later { print }'

# Of lessons that are not handed out nobody needs to know what mistakes look like.
is_handed_out() {
    case $1 in
    tests/check/looks/step*)
        lesson=${1#tests/check/looks/}
        [ -d "$work/${lesson%%/*}" ]
        ;;
    common/*) ! is_later "$1" ;;
    esac
}

set -f # patterns are for is_later
files=$(find common tests/check tests/help -type f |
    grep -v '/test_\|/wrong/\|/references.c$\|/looks_make.c$' | sort)
set +f
for file in $files; do
    is_handed_out "$file" || continue
    case $file in
    common/*) put_changed "$without_later_sections" "$file" ;;
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
    *) put "$file" ;;
    esac
done
put LICENSE
put step10_phong/figures/turn.png # where all this leads to: README.md begins with it
put tests/starter/lesson.sh

# The Makefile, whose help names only what is there.
# shellcheck disable=SC2016
put_changed '
    /^For the course as a whole:/ { whole = 1 }
    whole && /^  make help/ { whole = 0 }
    whole || /^  make solution/ { next }
    { print }' Makefile
cat >"$work/tests/handout/handout.mk" <<'END'
# make start STEP=05      step05_zbuffer/main.c becomes the starter again; what it held is kept
.PHONY: start solution
start:
	@tests/handout/start.sh '$(STEP)'
solution:
	@echo 'make solution: solutions are not handed out; your instructor has them' >&2; exit 1
END
cp tests/handout/start.sh "$work/tests/handout/start.sh" || fail 1 "cannot write $work"

# ---- README.md: of a course that ends here ----

first_lesson=${lessons# }
first_lesson=${first_lesson%% *}
# shellcheck disable=SC2016
sed -e "/^Go to/s|step01_line|$first_lesson|g; s/STEP=01/STEP=$(echo "$first_lesson" | cut -c 5-6)/" \
    -e "s/10 passed, 0 failed/$(echo "$lessons" | wc -w | tr -d ' ') passed, 0 failed/" README.md |
    awk -v first="$first" -v last="$last" '
        /^## / { left_out = /^## (If you teach|Accurate, fast|Layout|For contributors)/ }
        /^A position travels/ && (first > 8 || last < 8) { elsewhere = 1 } # what lesson 8 shows
        /^Hidden scenes/ { elsewhere = 1 }
        elsewhere || /^    make (solution|check HIDDEN)/ { if (/^$/) elsewhere = 0; next }
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
        !left_out { print }' >"$work/README.md" || fail 1 "cannot write $work/README.md"

# Pictures of other lessons that a text shows come along; links to what is not there become words.
for text in "$work"/*/*.md; do
    directory=$(dirname "$text")
    grep -oE '(src="|\]\()[^")]*\.(png|svg)' "$text" | sed 's/^src="//; s/^](//' |
        while IFS= read -r link; do
            [ -e "$directory/$link" ] || put "$(echo "${directory#"$work"/}/$link" | sed 's|[^/]*/\.\./||')"
        done
done
for text in "$work"/*.md "$work"/*/*.md; do
    directory=$(dirname "$text")
    grep -o '\](\([^)#]*\)[^)]*)' "$text" | sed 's/^](//; s/[#)].*//' | sort -u |
        while IFS= read -r link; do
            case $link in '' | http*) continue ;; esac
            [ -e "$directory/$link" ] || printf '%s\n' "$link"
        done >"$work/missing"
    awk -v missing="$work/missing" '
        BEGIN { while ((getline link <missing) > 0) gone[link] = 1 }
        {
            rest = $0
            line = ""
            while (match(rest, /\[[^][]*\]\([^)]*\)/)) {
                whole = substr(rest, RSTART, RLENGTH)
                words = target = whole
                sub(/^\[/, "", words); sub(/\]\(.*/, "", words)
                sub(/.*\]\(/, "", target); sub(/[#)].*/, "", target)
                before = substr(rest, 1, RSTART - 1)
                if (target in gone) sub(/!$/, "", before)
                line = line before ((target in gone) ? words : whole)
                rest = substr(rest, RSTART + RLENGTH)
            }
            line = line rest
            if (line ~ /README\.md#map-of-the-course/) { # from lesson to lesson
                sub(/^< [^|]* \| /, "", line)
                sub(/ \| [^]|[]* >$/, "", line)
            }
            print line
        }' "$text" >"$work/changed" && mv "$work/changed" "$text" || fail 1 "cannot write $text"
done
rm -f "$work/missing"

# Pictures that only answers show stay here, too.
for figure in "$work"/step*/figures/*; do
    cat "$work"/*.md "$work"/*/*.md | grep -qF "${figure##*/}" || rm -f "$figure"
done

# ---- Nothing of a solution goes out ----

left=$(grep -rlE 'BEGIN SOLUTION|END SOLUTION|/\* STARTER$|<summary>Answer' "$work"/*.md \
    "$work"/step* "$work/common" "$work/tests/handout" | sed "s|^$work/||")
[ -z "$left" ] || fail 1 "a mark is left in" $left
chmod 755 "$work"
[ ! -d "$out" ] || rmdir "$out"
mv "$work" "$out" || fail 1 "cannot write $out"
echo "$out: lessons$(echo "$lessons" | sed 's/ step\([0-9]*\)_[^ ]*/ \1/g')"
