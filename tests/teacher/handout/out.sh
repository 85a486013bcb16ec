# shellcheck shell=sh disable=SC2034,SC2154 # its readers use what it sets, and the reverse
# For scripts that write a part of the course into a separate directory, whole or not at all,
# which read this with `.` after lesson.sh and marked.sh, with `target`, `out` (the directory) and
# `wanted` (lessons: 5 or 1-5; all of them when empty) set.

# begin_out WORK: `new`, which becomes `out` by end_out, is made, and WORK, a directory for what
# only the script needs, is to go at the end. Sets `lessons`, and the numbers `first` and `last`.
begin_out() {
    work=$1
    new=
    trap 'rm -rf "$work" "$new"' EXIT
    trap 'exit 1' HUP INT TERM
    [ -n "$work" ] || fail 1 "cannot write temporary files"
    [ -n "$out" ] || fail 2 "say where to: make $target OUT=some/directory [LESSONS=1-5]"
    select_lessons
    if [ -e "$out" ] && { [ ! -d "$out" ] || [ -n "$(ls -A "$out")" ]; }; then
        fail 1 "$out is there already, and not an empty directory"
    fi
    mkdir -p "$(dirname "$out")" && new=$(mktemp -d "$out.XXXXXX") ||
        fail 1 "cannot write next to $out"
}

# make_room FILE: for that file of the directory. (Without its own process, where there is.)
make_room() {
    case $1 in
    */*) [ -d "$new/${1%/*}" ] || mkdir -p "$new/${1%/*}" ;;
    esac
}

# put FILE [PLACE]: at the same place in the directory, or at PLACE.
put() {
    make_room "${2:-$1}" && cp "$1" "$new/${2:-$1}" || fail 1 "cannot write $new/${2:-$1}"
}

# put_all: the files that standard input names, one a line, those of one directory together.
put_all() {
    sort -u | awk '{ place = $0; if (!sub(/\/[^\/]*$/, "", place)) place = "."
        if (place != before) printf "%s%s", (NR > 1 ? "\n" : ""), place
        before = place; printf " %s", $0 } END { if (NR) print "" }' >"$work/places"
    while read -r place files; do
        # shellcheck disable=SC2086 # one word a file
        mkdir -p "$new/$place" && cp $files "$new/$place" || fail 1 "cannot write $new/$place"
    done <"$work/places"
}

# put_text MODE LESSON: main.c as starter or solution; where it is one of these already, it is taken
# from where `make start` finds the marked source.
put_text() {
    main=$2/main.c
    find_marked
    mkdir -p "$new/$2" && text "$1" "$work/marked" "$main" >"$new/$main" || fail 1 "no $1 of $2"
}

# Pictures of other places that a text shows come along; links to what is not there become words.
finish_texts() {
    for text in "$new"/*/*.md; do
        [ -f "$text" ] || continue
        directory=$(dirname "$text")
        grep -oE '(src="|\]\()[^")]*\.(png|svg)' "$text" | sed 's/^src="//; s/^](//' |
            while IFS= read -r link; do
                [ -e "$directory/$link" ] ||
                    put "$(echo "${directory#"$new"/}/$link" | sed 's|[^/]*/\.\./||')"
            done || exit 1
    done
    for text in "$new"/*.md "$new"/*/*.md "$new"/*/*/*.md; do
        [ -f "$text" ] || continue
        directory=$(dirname "$text")
        grep -o '\](\([^)#]*\)[^)]*)' "$text" | sed 's/^](//; s/[ #)].*//' | sort -u |
            while IFS= read -r link; do
                case $link in '' | http*) continue ;; esac
                [ -e "$directory/$link" ] || printf '%s\n' "$link"
            done >"$work/missing"
        awk -v missing="$work/missing" '
            BEGIN { while ((getline link <missing) > 0) gone[link] = 1 }
            { was_dropped = dropped; dropped = 0 }
            was_dropped && !NF { next }
            {
                rest = $0
                line = ""
                while (match(rest, /\[[^][]*\]\([^)]*\)/)) {
                    whole = substr(rest, RSTART, RLENGTH)
                    words = target = whole
                    sub(/^\[/, "", words); sub(/\]\(.*/, "", words)
                    sub(/.*\]\(/, "", target); sub(/[ #)].*/, "", target)
                    before = substr(rest, 1, RSTART - 1)
                    if (target in gone) sub(/!$/, "", before)
                    # A row or an item about it, or a line that is nothing else, goes with it.
                    if (target in gone && (line before ~ /^[|-] $/ || whole "." == $0)) {
                        dropped = 1
                        next
                    }
                    line = line before ((target in gone) ? words : whole)
                    rest = substr(rest, RSTART + RLENGTH)
                }
                line = line rest
                if (line ~ /README\.md#map-of-the-course/) { # from lesson to lesson
                    sub(/^< [^|]* \| /, "", line)
                    sub(/ \| [^]|[]* >$/, "", line)
                }
                print line
            }' "$text" >"$work/changed" && cat "$work/changed" >"$text" ||
            fail 1 "cannot write $text"
    done
}

# The directory is complete.
end_out() {
    chmod 755 "$new"
    [ ! -d "$out" ] || rmdir "$out"
    mv "$new" "$out" || fail 1 "cannot write $out"
    echo "$out: lessons$(echo "$lessons" | sed 's/ step\([0-9]*\)_[^ ]*/ \1/g')"
}
