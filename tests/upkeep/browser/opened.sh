#!/bin/sh
# What `make live` calls to open a page, for server.js: opened.sh SEEN PAGE. Writes into SEEN what others
# can see of it: a NUL, the page's path, a NUL, and the arguments of all processes.
{
    printf '\0%s\0' "$2"
    cat /proc/[0-9]*/cmdline 2>/dev/null | tr '\0' ' '
} >"$1.new"
mv "$1.new" "$1"
