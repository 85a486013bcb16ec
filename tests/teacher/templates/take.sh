#!/bin/sh
# Takes each lesson's main.c, and the student's own headers next to it, out of what was handed in.
#
#   take.sh SUBMISSION INTO COURSE [LESSON ...]
#
# INTO/LESSON gets them, for each LESSON (those of COURSE where none is named); what COURSE/LESSON has
# itself is never replaced, except main.c. SUBMISSION is a directory. Of these the first that is there
# counts, of several the one nearest to its top, up to five directories down, then the first by name;
# capitals and \ for / make no difference:
#
#   step01_line/main.c   step01_line.c   step01/main.c, lesson1/main.c, line/main.c   step01.c, lesson_1.c
#   ann_123_step01_line.c, and where one LESSON is wanted main.c, ann_123_main.c, the only .c
#
# Nothing else is looked at, no link is followed, and no file of more than a megabyte taken. UTF-16
# becomes UTF-8. It prints a line for each lesson that is not there, and what else a student should know.
#
# Exit status: 0 done; 1 something cannot be copied; 3 nothing is taken: the one line says why.
LC_ALL=C # names of files are bytes
export LC_ALL
submission=$1
into=$2
course=$3
shift 3
# shellcheck disable=SC2046 # one word a lesson
[ $# -gt 0 ] || set -- $(cd "$course" && ls step[0-9]*_*/main.c | sed 's|/main.c$||')

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
            if (index(file, lesson)) return 5
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

# Why nothing is taken, in a line.
nothing() {
    some=$(list | sed 's|^\./||; s/[^ -~]/?/g; s/.*/`&`/; 4q' | awk '
        { printf "%s%s", (NR > 1 ? ", " : ""), (NR > 3 ? "..." : $0) }')
    echo "holds no main.c of a lesson${some:+: found $some; name the folder $1}"
}

tab=$(printf '\t')
chosen=$(choose "$@")
taken=
while IFS=$tab read -r lesson path; do
    [ -z "$lesson" ] || take_lesson "$lesson" "$path"
done <<END_OF_LIST
$chosen
END_OF_LIST
if [ -z "$taken" ]; then
    [ -n "$chosen" ] || nothing "$1"
    exit 3
fi
for lesson in "$@"; do
    case $taken in *"$lesson"*) ;; *) echo "There is no $lesson/main.c in the submission." ;; esac
done
exit 0
