#!/bin/sh
# Opens an address or a page in the browser, where there is a desktop: browse.sh ADDRESS. Not over a
# bare SSH connection, where it would be a text browser. In WSL the browser is that of Windows, which
# has other names for files. Exit status 0.
if [ "$(uname)" = Darwin ]; then
    open "$1"
elif command -v wslview; then
    wslview "$1"
elif command -v explorer.exe; then
    case $1 in
    /*) explorer.exe "$(wslpath -w "$1")" ;;
    *) explorer.exe "$1" ;;
    esac
elif [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && command -v xdg-open; then
    xdg-open "$1"
elif [ -t 3 ]; then
    echo "There is no browser here: open this in one of yours." >&3
fi 3>&2 >/dev/null 2>&1 </dev/null
exit 0
