#!/bin/sh
# Takes the lessons' sources out of a submission: unpack.sh LIMITED SUBMISSION INTO LESSON...
#
# SUBMISSION is a directory, a .zip or a .tar, packed or not; LIMITED the program of limited.c. Of each
# LESSON INTO/LESSON gets main.c and the student's own headers: regular files of a megabyte at most,
# with plain names, from the directory of that name that has a main.c, at the top or up to three below;
# of several from the one nearest to the top, then the first by name. Nothing else is looked at:
# neither links, nor what the course brings itself. INTO must not be there yet.
#
# Exit status: 0 done; 1 there is none, or it cannot be unpacked: a line says why.
limited=$1
submission=$2
into=$3
shift 3
megabytes=100

fail() {
    printf '%s\n' "$*"
    exit 1
}

# unpack COMMAND...: into $into.packed, where it may take neither long nor much.
unpack() {
    mkdir "$into.packed" || fail "no room to unpack it"
    why=$("$limited" 60 $megabytes "$into.packed" "$into.said" "$@" 2>&1) || {
        [ -n "$why" ] || why=$(sed -n '/\.\./p; 1p' "$into.said" 2>/dev/null | sed 1q)
        fail "cannot be unpacked${why:+: $why}"
    }
    chmod -R u+rwX "$into.packed" 2>/dev/null
    from=$into.packed
}

case $submission in /*) ;; *) submission=$PWD/$submission ;; esac
[ ! -h "$submission" ] || fail "a link"
if [ -d "$submission" ]; then
    from=$submission
else
    case $submission in
    *.[Zz][Ii][Pp]) # status 1: unpacked, with a warning, such as of the backslashes of Windows
        # shellcheck disable=SC2016 # expanded there
        unpack sh -c 'unzip -qq -o "$1" || [ $? -eq 1 ]' unzip "$submission"
        ;;
    *.[Tt][Aa][Rr] | *.[Tt][Aa][Rr].* | *.[Tt][GgXxBb][Zz]*)
        unpack tar xf "$submission" --no-same-owner --no-same-permissions
        ;;
    *) fail "neither a directory nor a .zip, .tar or .tar.gz" ;;
    esac
fi
# find_directory LESSON: where its main.c is. (macOS adds files with such names, too.)
find_directory() {
    (cd "$from" && find . -maxdepth 5 -name __MACOSX -prune -o ! -type d -path "*/$1/main.c" -print) \
        2>/dev/null | sed -n 's|^\(\./.*\)/main\.c$|\1|p' |
        awk -F / '{ print NF "\t" $0 }' | LC_ALL=C sort -k 1,1n -k 2 | sed 's/^[0-9]*.//; 1q'
}
mkdir "$into" || fail "no room to unpack it"
found= why=
for lesson in "$@"; do
    directory=$(find_directory "$lesson")
    [ -n "$directory" ] && [ -d "$from/$directory" ] || continue
    mkdir "$into/$lesson" || fail "no room to unpack it"
    for file in "$from/$directory"/*.h "$from/$directory/main.c"; do
        name=${file##*/}
        case $name in *[!A-Za-z0-9_.]*) continue ;; esac # such as '*', where there is none
        [ "$name" = main.c ] || [ ! -f "$lesson/$name" ] || continue # the course's own
        if [ -h "$file" ]; then
            why="$lesson/$name is a link" && continue
        elif [ ! -f "$file" ] || [ "$(wc -c <"$file")" -gt 1048576 ]; then
            why="$lesson/$name is no file of 1 MiB at most" && continue
        fi
        cp "$file" "$into/$lesson/$name" || fail "no room to unpack it"
    done
    [ ! -f "$into/$lesson/main.c" ] || found=yes
done
[ -n "$found" ] || fail "${why:-holds no main.c of a lesson}"
