#!/bin/sh
# Takes the lessons' sources out of a submission: unpack.sh LIMITED SUBMISSION INTO LESSON...
#
# SUBMISSION is a directory, a .zip or a .tar.gz (.tgz); LIMITED the program of limited.c. Of each
# LESSON INTO/LESSON gets main.c and the student's own headers: regular files of a megabyte at most,
# with plain names, from the first directory of that name at the top or up to three below. Nothing
# else is looked at: neither links, nor what the course brings itself. INTO must not be there yet.
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
    why=$("$limited" 60 $megabytes "$into.packed" "$into.said" "$@" 2>&1) ||
        fail "cannot be unpacked${why:+: $why}"
    chmod -R u+rwX "$into.packed" 2>/dev/null
    from=$into.packed
}

case $submission in /*) ;; *) submission=$PWD/$submission ;; esac
case $submission in
*.zip) unpack unzip -qq -o "$submission" ;;
*.tar.gz | *.tgz) unpack tar xzf "$submission" --no-same-owner --no-same-permissions ;;
*)
    [ -d "$submission" ] && [ ! -h "$submission" ] ||
        fail "neither a directory nor a .zip or .tar.gz"
    from=$submission
    ;;
esac
mkdir "$into" || fail "no room to unpack it"
found=
for lesson in "$@"; do
    directory=$(cd "$from" && find . -maxdepth 4 -type d -name "$lesson" 2>/dev/null | sed 1q)
    [ -n "$directory" ] && [ -d "$from/$directory" ] || continue
    mkdir "$into/$lesson" || fail "no room to unpack it"
    for file in "$from/$directory"/*.h "$from/$directory/main.c"; do
        name=${file##*/}
        case $name in *[!A-Za-z0-9_.]*) continue ;; esac # such as '*', where there is none
        [ "$name" = main.c ] || [ ! -f "$lesson/$name" ] || continue # the course's own
        [ -f "$file" ] && [ ! -h "$file" ] && [ "$(wc -c <"$file")" -le 1048576 ] || continue
        cp "$file" "$into/$lesson/$name" || fail "no room to unpack it"
    done
    [ ! -f "$into/$lesson/main.c" ] || found=yes
done
[ -n "$found" ] || fail "holds no main.c of a lesson"
