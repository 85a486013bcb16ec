#!/bin/sh
# The files with which each fuzz target begins: one archive a target, tests/upkeep/fuzz/corpus/NAME.tar.
#
#   tests/upkeep/fuzz/corpus.sh names            the targets, one a line
#   tests/upkeep/fuzz/corpus.sh unpack NAME DIR  put the files of a target into DIR, and no others
#   tests/upkeep/fuzz/corpus.sh pack NAME DIR    make the archive from the files of DIR (GNU tar)
#
# The same files give the same archive, byte for byte, whoever packs them and when.
fuzz=$(cd "$(dirname "$0")" && pwd) || exit 1
archive=$fuzz/corpus/$2.tar

case $1 in
names)
    for target in "$fuzz"/fuzz_*.c; do
        basename "$target" .c | sed 's/^fuzz_//'
    done
    ;;
unpack)
    rm -rf "$3" && mkdir -p "$3" && tar -xf "$archive" -C "$3"
    ;;
pack)
    cd "$3" && LC_ALL=C tar --format=ustar --sort=name --mtime=@0 --mode=644 --owner=0 --group=0 \
        --numeric-owner -cf "$archive.new" -- * && mv "$archive.new" "$archive"
    ;;
*)
    echo "usage: corpus.sh names | unpack NAME DIR | pack NAME DIR" >&2
    exit 2
    ;;
esac
