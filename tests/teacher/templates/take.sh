#!/bin/sh
# Takes each lesson's main.c, and the student's own headers next to it, out of what was handed in.
#
#   take.sh SUBMISSION INTO COURSE [LESSON ...]
#
# INTO/LESSON gets them, for each LESSON (those of COURSE where none is named); what COURSE/LESSON has
# itself is never replaced, except main.c. SUBMISSION is a directory, a .zip, a .tar, packed or not, or a
# .c. Of these the first that is there counts, of several the one nearest to its top, up to five
# directories down, then the first by name; capitals and \ for / make no difference:
#
#   step01_line/main.c   step01_line.c   step01/main.c, lesson1/main.c, line/main.c   step01.c, lesson_1.c
#   ann_123_step01_line.c, and where one LESSON is wanted main.c, ann_123_main.c, the only .c
#
# Where none is there, the one archive in it is searched. Nothing else is looked at, no link is followed,
# and no file of more than a megabyte taken. UTF-16 becomes UTF-8. It prints a line for each lesson that is
# not there, and what else a student should know. LIMITED may name the program of grade/limited.c, which
# keeps an archive from taking too long or too much; a service's container does that itself.
#
# Exit status: 0 done; 1 something cannot be copied; 3 nothing is taken: the one line says why.
LC_ALL=C # names of files are bytes
export LC_ALL
case $1 in /*) submission=$1 ;; *) submission=$PWD/$1 ;; esac
into=$2
course=$3
shift 3
# shellcheck disable=SC2046 # one word a lesson
[ $# -gt 0 ] || set -- $(cd "$course" && ls step[0-9]*_*/main.c | sed 's|/main.c$||')
unpacked=
trap '[ -z "$unpacked" ] || { chmod -R u+rwx "$unpacked" 2>/dev/null; rm -rf "$unpacked"; }' EXIT
trap 'exit 1' HUP INT TERM

# nothing WHY...
nothing() {
    printf '%s\n' "$*"
    exit 3
}

# limited COMMAND...: in $from, an empty directory, where it may take neither long nor much.
limited() {
    if [ -n "$LIMITED" ]; then
        why=$("$LIMITED" 60 100 "$from" "$from.said" "$@" 2>&1)
    else
        (cd "$from" && "$@" </dev/null >"$from.said" 2>&1)
    fi || {
        [ -n "$why" ] || why=$(sed -n '/^\[/d; s/^ *//; /\.\./p; 1,2p' "$from.said" 2>/dev/null | sed 1q)
        nothing "cannot be unpacked${why:+: $why}"
    }
    chmod -R u+rwX "$from" 2>/dev/null
}

# unpack FILE: into a directory of its own, which becomes $submission.
unpack() {
    why=
    unpacked=${unpacked:-$(mktemp -d)} && from=$(mktemp -d "$unpacked/XXXXXX") || exit 1
    case $1 in
    *.[Zz][Ii][Pp]) # status 1: unpacked, with a warning, such as of the backslashes of Windows
        # shellcheck disable=SC2016 # expanded there
        limited sh -c 'unzip -qq -o "$1" || [ $? -eq 1 ]' unzip "$1"
        ;;
    *.[Tt][Aa][Rr] | *.[Tt][Aa][Rr].* | *.[Tt][GgXxBb][Zz]*)
        limited tar xf "$1" --no-same-owner --no-same-permissions
        ;;
    *.[Cc]) cp "$1" "$from" || exit 1 ;;
    *) nothing "neither a directory nor a .zip, .tar, .tar.gz or .c" ;;
    esac
    submission=$from
}

# The .c files of the submission, from ./ on. (macOS adds a directory with such names, too.)
list() {
    (cd "$submission" && find . -maxdepth 6 -name __MACOSX -prune -o ! -type d -name '*.[cC]' -print) 2>/dev/null |
        sed -n '/^\.\//p' | sort
}

# choose LESSON...: a line `LESSON PATH` for each that is there, with a tab between.
choose() {
    list | awk -v wanted="$*" '
        # Does a name of a directory or file, in small letters, mean the lesson of that number and word?
        function means(name, number, word) {
            return name == word || name ~ "^(step|lesson)[-_ .]*0*" number "([^0-9].*)?$" ||
                name ~ "^0*" number "([-_ .]+" word ")?$"
        }
        function rank(lesson, number, word) {
            if (directory == lesson && file == "main") return 1
            if (file == lesson) return 2
            if (means(directory, number, word) && file == "main") return 3
            if (means(file, number, word)) return 4
            if (index(file, lesson) || file ~ "[-_ .](step|lesson)[-_ .]*0*" number "([^0-9].*)?$") return 5
            if (count > 1 || file directory ~ /(step|lesson)[-_ .]*[0-9]/) return 0
            return file ~ /(^|[^a-z])main[^a-z]*$/ ? 6 : 7
        }
        BEGIN { count = split(wanted, lesson, " ") }
        {
            shown = tolower($0)
            gsub(/\\/, "/", shown)
            depth = split(shown, part, "/")
            directory = part[depth - 1]
            file = substr(part[depth], 1, length(part[depth]) - 2)
            for (i = 1; i <= count; i++) {
                split(substr(lesson[i], 5), word, "_")
                this = rank(lesson[i], word[1] + 0, word[2])
                key = this * 100 + depth
                if (this == 7) others++
                if (this > 0 && (!(i in best) || key < best_key[i])) {
                    best[i] = $0
                    best_key[i] = key
                }
            }
        }
        END {
            for (i = 1; i <= count; i++)
                if (best_key[i] > 0 && (best_key[i] < 700 || others == 1)) print lesson[i] "\t" best[i]
        }'
}

# Is it a file that may be taken? Otherwise says why not.
is_plain() {
    if [ -h "$1" ]; then
        echo "$2 is a link."
    elif [ ! -f "$1" ] || [ "$(wc -c <"$1")" -gt 1048576 ]; then
        echo "$2 is no file of 1 MiB at most."
    else
        return 0
    fi
    return 1
}

# take FILE AS: as UTF-8, where it begins as UTF-16 does.
take() {
    case $(od -An -tx1 -N2 "$1") in
    ' ff fe' | ' fe ff')
        if iconv -f UTF-16 -t UTF-8 "$1" 2>/dev/null >"$into/$2"; then
            echo "$2 was UTF-16, and is taken as UTF-8."
        else
            echo "$2 is UTF-16: save it as UTF-8."
            cp "$1" "$into/$2"
        fi
        ;;
    *) cp "$1" "$into/$2" ;;
    esac || exit 1
}

# take_lesson LESSON PATH
take_lesson() {
    is_plain "$submission/$2" "$1/main.c" || return
    mkdir -p "$into/$1" || exit 1
    for header in "$submission/${2%/*}"/*.h; do
        name=${header##*/}
        case $name in *[!A-Za-z0-9_.]*) continue ;; esac # such as *, where there is none
        if [ ! -f "$course/$1/$name" ] && is_plain "$header" "$1/$name"; then
            take "$header" "$1/$name"
        fi
    done
    take "$submission/$2" "$1/main.c"
    taken="$taken $1"
}

# Sets taken to the lessons that are there.
take_all() {
    chosen=$(choose "$@")
    taken=
    while IFS=$tab read -r lesson path; do
        [ -z "$lesson" ] || take_lesson "$lesson" "$path"
    done <<END_OF_LIST
$chosen
END_OF_LIST
}

tab=$(printf '\t')
[ ! -h "$submission" ] || nothing "a link"
[ -d "$submission" ] || unpack "$submission"
take_all "$@"
# Moodle and mail programs put an archive into a directory, some students one into another.
for _ in inner innermost; do
    [ -z "$taken" ] || break
    archive=$(find "$submission/" -maxdepth 4 -type f \( -iname '*.zip' -o -iname '*.tar' -o -iname '*.tar.*' -o -iname '*.tgz' \) \
        ! -path '*/__MACOSX/*' 2>/dev/null)
    [ -f "$archive" ] || break
    unpack "$archive"
    take_all "$@"
done
if [ -z "$taken" ]; then
    [ -z "$chosen" ] || exit 3
    # What could have been meant.
    some=$(cd "$submission" && find . -maxdepth 6 -name __MACOSX -prune -o ! -type d \( -iname '*.c*' -o -iname '*.t*' \
        -o -iname '*.zip' -o -iname '*.rar' -o -iname '*.7z' \) -print 2>/dev/null |
        sed 's|^\./||; s/[^ -~]/?/g; s/.*/`&`/' | sort | awk '
        NR <= 4 { printf "%s%s", (NR > 1 ? ", " : ""), (NR > 3 ? "..." : $0) }')
    nothing "holds no main.c of a lesson${some:+: found $some; hand in $1/main.c}"
fi
for lesson in "$@"; do
    case $taken in *"$lesson"*) ;; *) echo "There is no $lesson/main.c in the submission." ;; esac
done
exit 0
