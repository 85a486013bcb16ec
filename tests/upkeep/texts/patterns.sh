#!/bin/sh
# Counts what an editor looks for in prose: words, sentences, colons in them, and phrases that mostly can be said
# in a plainer way. A count is no verdict; it says where to read.
#
#   tests/upkeep/texts/patterns.sh [FILE...]         without files: the pages of the lessons

cd "$(dirname "$0")/../../.." || exit 1
[ $# -gt 0 ] || set -- step*/[A-Z]*.md
echo "words sentences colons what-is that-of stands is-told inverted file"
for file; do
    awk '/^ *```/ { quoted = !quoted; next } !quoted && !/^    / && !/^[|#<!\[]/' "$file" |
        sed 's/`[^`]*`/ code /g; s/](\([^)]*\))/]/g' | tr '\n' ' ' |
        awk -v file="$file" '
            function count(pattern) { return gsub(pattern, "&") }
            {
                words = NF
                $0 = tolower($0)
                print words, count("[.?!][*)\"]* "), count("[a-z)*]: "), count("what (is|are|lies|was) "),
                      count("(that|those) of "), count(" (stands?|in place of|beside|anew|likewise) "),
                      count(" (is|are) (told|there|asked|known by) "), count("[.?!] (of|is|has|have|are) [a-z]+ [a-z]+ "), file
            }'
done | awk '{ for (i = 1; i <= 8; i++) sum[i] += $i; print }
    END { if (NR > 1) { for (i = 1; i <= 8; i++) printf "%d ", sum[i]; print "all" } }'
