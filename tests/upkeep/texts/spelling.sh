#!/bin/sh
# Are the words of the texts spelled as British English spells them? hunspell knows most, words.txt
# here the terms of the subject. Code, links, what is in `quotes`, French, and words with
# a digit are left out.
#
#   tests/upkeep/texts/spelling.sh [FILE...]         without files: every .md of the course, and its drawings
#
# Exit status 0: all are; 1: some are not, named as FILE: WORD; 2: hunspell is missing.

cd "$(dirname "$0")/../../.." || exit 1
if ! hunspell -D </dev/null 2>&1 | grep -q en_GB; then
    echo "spelling: hunspell is missing; on Debian: apt-get install hunspell hunspell-en-gb" >&2
    exit 2
fi

# words_of FILE: its prose. A drawing's is what is between <text> and </text>.
words_of() {
    case $1 in
    *.svg) sed -n 's/.*<\(text\|tspan\|title\)[^>]*>\([^<]*\)<.*/\2/p' "$1" ;;
    *)
        awk '/^ *```/ { quoted = !quoted; next } !quoted && !/^    /' "$1" |
            sed 's/`[^`]*`/ /g; s|<i lang="fr">[^<]*</i>| |g; s/<[^>]*>/ /g; s/](\([^)]*\))/] /g; s|https*:[^ ]*||g'
        ;;
    esac
}

if [ $# -eq 0 ]; then
    # shellcheck disable=SC2046 # one word a file
    set -- $(find . -name build -prune -o -name .git -prune -o \( -name '*.md' -o -path '*/figures/*.svg' \
        ! -name bench.svg \) -print | sed 's|^\./||' | sort)
fi
failed=0
for file; do
    for word in $(words_of "$file" | sed 's/[^ ]*[0-9][^ ]*/ /g' | hunspell -l -d en_GB -p tests/upkeep/texts/words.txt | sort -u); do
        echo "$file: $word"
        failed=1
    done
done
[ $failed -eq 0 ] && echo "spelling: all words are known"
exit $failed
