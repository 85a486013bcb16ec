#!/bin/sh
# Do the texts lead somewhere? Every relative link and picture of every .md file names a file that
# is there, and a heading that is there (`#map-of-the-course`); every picture in a lesson's figures/
# is shown by some text. And no formula loses an asterisk in prose, or begins a list with its plus.
. "$(dirname "$0")/../../unit/script.sh"

# texts: the .md files of the course.
texts() {
    find . -name build -prune -o -name .git -prune -o -name '*.md' -print | sed 's|^\./||' | sort
}

# links FILE...: FILE:LINE, a tab and the target, for each `](target)`, src="target" and
# href="target", outside of ``` blocks.
links() {
    awk '
        FNR == 1 { quoted = 0 }
        /^ *```/ { quoted = !quoted }
        quoted { next }
        {
            line = $0
            gsub(/`[^`]*`/, "", line)
            while (match(line, /\]\([^)]*\)|(src|href)="[^"]*"/)) {
                target = substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
                sub(/ "[^"]*"\)$/, ")", target) # a title
                gsub(/^\]\(|\)$|^(src|href)="|"$/, "", target)
                print FILENAME ":" FNR "\t" target
            }
        }' "$@"
}

# headings FILE: as GitHub names them: small letters, `-` for spaces, without other signs.
headings() {
    awk '/^```/ { quoted = !quoted }
        /^#+ / && !quoted {
            name = tolower($0)
            sub(/^#+ /, "", name)
            gsub(/[^a-z0-9 _-]/, "", name)
            gsub(/ /, "-", name)
            print name
        }' "$1"
}

# wrong_links FILE...: each that leads nowhere.
wrong_links() {
    links "$@" | while IFS='	' read -r place target; do
        case $target in http://* | https://* | mailto:*) continue ;; esac
        from=${place%:*}
        file=${target%%#*}
        if [ -z "$file" ]; then
            file=$from
        else
            file=$(dirname "$from")/$file
        fi
        if [ ! -e "$file" ]; then
            echo "$place: there is no $target"
        elif [ "$target" != "${target#*#}" ] &&
            ! headings "$file" | grep -qxF "${target#*#}"; then
            echo "$place: $file has no heading #${target#*#}"
        fi
    done
}

# unused_figures: pictures in figures/ that no text shows.
unused_figures() {
    # shellcheck disable=SC2046 # one word a file
    links $(texts) | cut -f 2 | sed 's|.*/||' | sort -u >"$work/shown"
    for figure in step*/figures/*; do
        [ ! -e "$figure" ] || grep -qxF "${figure##*/}" "$work/shown" || echo "$figure: no text shows it"
    done
}

# eaten_formulas FILE...: each line with `*` between numbers or names, or with + first, outside of code.
eaten_formulas() {
    for file; do
        awk '/^ *```/ { quoted = !quoted; next } !quoted && !/^    / { text = text $0 "\n" }
            END {
                gsub(/`[^`]*`/, "", text)
                count = split(text, line, "\n")
                for (i = 1; i <= count; i++)
                    if (line[i] ~ /[^ ] \* |[0-9a-z)]\*[0-9a-z(]|^ *\+ /) print FILENAME ": " line[i]
            }' "$file"
    done
}

# Does it find what is wrong? One of each.
printf '# A title: 2 & 3\n[a](#a-title-2--3) [b](#none)\n![c](missing.png)\n`[d](no)`\n' >"$work/x.md"
printf 'A *word*, `2*x\n* y` and\nx*x here\n    2*x\n+ y\n' >"$work/y.md"
[ "$(eaten_formulas "$work/y.md" | cut -d: -f2 | xargs)" = "x*x here + y" ] || wrong "sees no eaten formula"
expected="$work/x.md:2: $work/x.md has no heading #none
$work/x.md:3: there is no missing.png"
[ "$(wrong_links "$work/x.md")" = "$expected" ] || wrong "does not find what is wrong"

# shellcheck disable=SC2046
{ wrong_links $(texts) && unused_figures && eaten_formulas $(texts); } >"$work/found"
said=$work/found
[ ! -s "$said" ] || wrong "some lead nowhere, or lose a sign"
exit $failed
