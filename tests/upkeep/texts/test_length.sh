#!/bin/sh
# Can each part of a lesson be read at one sitting? At most 1,200 words from one heading `## ` to the
# next, where a reader may stop, on every page that has tasks.
#
# Exit status 0: all are; 1: not, named.
. "$(dirname "$0")/../../unit/script.sh"

for page in $(for lesson in step*; do pages "$lesson"; done); do
    awk -v page="$page" '
        function end() {
            if (words > 1200) { print page ": " words " words in \"" part "\", at most 1200"; bad = 1 }
            words = 0
        }
        /^## / { end(); part = substr($0, 4) }
        { gsub(/ "live: [^"]*"|<!--[^>]*-->/, ""); words += NF } # not what a figure offers
        END { end(); exit bad }' "$page" || failed=1
done
exit $failed
