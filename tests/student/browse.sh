#!/bin/sh
# Opens an address or a page in the browser, where there is a desktop: browse.sh ADDRESS. Not over a
# bare SSH connection, where it would be a text browser. Exit status 0.
if [ "$(uname)" = Darwin ]; then
    open "$1"
elif command -v wslview >/dev/null; then
    wslview "$1"
elif [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && command -v xdg-open >/dev/null; then
    xdg-open "$1"
fi >/dev/null 2>&1 </dev/null
exit 0
