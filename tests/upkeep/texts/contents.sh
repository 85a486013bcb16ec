#!/bin/sh
# The table of contents in README.md, between the lines `<!-- contents -->` and `<!-- end -->`: for
# each lesson and its parts the words to read and the lines to write, counted.
#
#   tests/upkeep/texts/contents.sh            writes the table into README.md again
#   tests/upkeep/texts/contents.sh --check    says whether it is right, and whether the tables of wrong pictures
#                                in the lessons are (tests/upkeep/verify/figures.awk): exit status 1 when
#                                one is not
#
# Words are those of the lesson without code, answers and pictures, to the nearest hundred. Lines are those of
# main.c between the marks of a part's tasks, without empty ones and comments on lines of their own.

cd "$(dirname "$0")/../../.." || exit 1

# words LESSON
words() {
    awk '/^ *```/ { quoted = !quoted; next }
        /<details>/ { answer = 1 }
        !quoted && !answer && !/^    / {
            gsub(/!\[[^]]*\]\([^)]*\)|\|/, " ")
            count += NF
        }
        /<\/details>/ { answer = 0 }
        END { print int(count / 100 + 0.5) * 100 }' "$1/README.md"
}

# parts LESSON: for each part its letter (`-` where the lesson is one), tasks, and lines to write.
parts() {
    awk '/\/\* BEGIN SOLUTION / {
            inside = 1
            part = $4
            sub(/\..*/, "", part)
            gsub(/[0-9]/, "", part)
            if (part == "") part = "-"
            if (!(part in lines)) order[++count] = part
            if (!($4 in seen)) tasks[part]++
            seen[$4] = 1
            next
        }
        /\/\* STARTER|END SOLUTION/ { inside = 0 }
        inside && !/^ *$/ && !/^ *(\/\*|\*( |\/|$)|\/\/)/ { lines[part]++ }
        END { for (i = 1; i <= count; i++) print order[i], tasks[order[i]], lines[order[i]] + 0 }' \
        "$1/main.c" | sort
}

# title LESSON PART: what follows `### Part a: ` in the lesson's README.
title() {
    sed -n "s/^### Part $2: //p" "$1/README.md" | head -n 1
}

contents() {
    echo "| lesson | words | part | tasks | lines to write |"
    echo "| --- | ---: | --- | ---: | ---: |"
    for lesson in step[0-9]*_*/; do
        lesson=${lesson%/}
        name="[$(sed -n '1s/^# Step //p' "$lesson/README.md")]($lesson/README.md)"
        words=$(words "$lesson")
        parts "$lesson" | while read -r part tasks lines; do
            [ "$part" = - ] && what= || what="$part: $(title "$lesson" "$part")"
            echo "| $name | $words | $what | $tasks | $lines |"
            name= words=
        done
    done
}

new=$(mktemp) || exit 1
trap 'rm -f "$new"' EXIT
table=$(contents) awk '
    !inside { print }
    /^<!-- end -->$/ && inside { print; inside = 0 }
    /^<!-- contents -->$/ { print "\n" ENVIRON["table"] "\n"; inside = 1; found = 1 }
    END { exit !found || inside }' README.md >"$new" || {
    echo "contents: README.md has no lines <!-- contents --> and <!-- end -->" >&2
    exit 1
}
if [ "$1" = --check ]; then
    diff README.md "$new" || {
        echo "contents: README.md is out of date; tests/upkeep/texts/contents.sh writes it again" >&2
        exit 1
    }
    # shellcheck disable=SC2046 # one word a file
    awk -f tests/upkeep/verify/figures.awk \
        $(find step[0-9]*_* -name README.md -o -name mistakes.txt | sort) >&2
else
    cat "$new" >README.md
fi
