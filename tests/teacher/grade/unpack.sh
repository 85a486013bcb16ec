#!/bin/sh
# Takes the lessons' sources out of a submission: unpack.sh LIMITED SUBMISSION INTO LESSON...
#
# SUBMISSION is a directory, a .zip, a .tar, packed or not, or a .c; LIMITED the program of limited.c.
# Of each LESSON INTO/LESSON gets main.c and the student's own headers, as take.sh finds them there, or
# in the one archive that is in it. INTO must not be there yet.
#
# Prints what a student should know of that. Exit status: 0 done; 1 there is none, or it cannot be
# unpacked: a line says why.
LC_ALL=C # names of files are bytes
export LC_ALL
limited=$1
submission=$2
into=$3
shift 3
megabytes=100

fail() {
    printf '%s\n' "$*"
    exit 1
}

# limited_to COMMAND...: in $from, an empty directory, where it may take neither long nor much.
limited_to() {
    why=$("$limited" 60 $megabytes "$from" "$from.said" "$@" 2>&1) || {
        [ -n "$why" ] || why=$(sed -n '/\.\./p; 1p' "$from.said" 2>/dev/null | sed 1q)
        fail "cannot be unpacked${why:+: $why}"
    }
    chmod -R u+rwX "$from" 2>/dev/null
}

# unpack FILE: into a directory of its own, which becomes $from.
unpack() {
    from=$(mktemp -d "$into.packed.XXXXXX") || fail "no room to unpack it"
    case $1 in
    *.[Zz][Ii][Pp]) # status 1: unpacked, with a warning, such as of the backslashes of Windows
        # shellcheck disable=SC2016 # expanded there
        limited_to sh -c 'unzip -qq -o "$1" || [ $? -eq 1 ]' unzip "$1"
        ;;
    *.[Tt][Aa][Rr] | *.[Tt][Aa][Rr].* | *.[Tt][GgXxBb][Zz]*)
        limited_to tar xf "$1" --no-same-owner --no-same-permissions
        ;;
    *.[Cc]) cp "$1" "$from" || fail "no room to unpack it" ;;
    *) fail "neither a directory nor a .zip, .tar, .tar.gz or .c" ;;
    esac
}

case $submission in /*) ;; *) submission=$PWD/$submission ;; esac
[ ! -h "$submission" ] || fail "a link"
if [ -d "$submission" ]; then
    from=$submission
else
    unpack "$submission"
fi
mkdir "$into" || fail "no room to unpack it"
take() {
    said=$(sh tests/teacher/templates/take.sh "$from" "$into" . "$@")
}
take "$@"
status=$?
# Moodle and mail programs put an archive into a directory, some students one into another.
inner=$(find "$from" -maxdepth 4 -type f \( -iname '*.zip' -o -iname '*.tar' -o -iname '*.tar.*' -o -iname '*.tgz' \) \
    ! -path '*/__MACOSX/*' 2>/dev/null)
if [ $status -eq 3 ] && [ -f "$inner" ]; then
    unpack "$inner"
    take "$@"
    status=$?
fi
[ $status -eq 0 ] || fail "${said:-no room to unpack it}"
printf '%s\n' "$said" | sed '/^There is no step/d; /^$/d'
