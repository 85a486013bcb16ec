#!/bin/sh
# Is each lesson short enough to be read? At most 2,500 words from its title to the end of its last
# task, and 900 to its first one.
#
# Exit status 0: all are; 1: not, named.
. "$(dirname "$0")/../../unit/script.sh"

for lesson in step[0-9]*_*/README.md; do
    awk -v lesson="$lesson" '
        /^#### Task/ || /^- \*\*[0-9]+[a-z]?\.[0-9]/ { if (!first) first = words; task = 1 }
        /^## / && task { last = words; task = 0 }
        { words += NF }
        END { if (first && first <= 900 && last && last <= 2500) exit 0
              print lesson ": " first + 0 " words to the first task, " last + 0 " to the end of the last"
              exit 1 }' "$lesson" || failed=1
done
exit $failed
