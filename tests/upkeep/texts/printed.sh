#!/bin/sh
# Are the numbers in the lessons those that are printed? In a lesson's texts a line
# `<!-- printed -->` stands before each table that `make figures` prints: either as it is printed,
# indented, or as a table in which each row begins with words of a printed line, and all its numbers
# stand in such lines, but for those of columns headed "ms". And "counts 40 million instructions for `zbuffer`: 5 for loading, ..." is what
# tests/bench/counts.txt says.
#
#   tests/upkeep/texts/printed.sh BUILD        after `make figures` or `make lesson-figures` with that BUILD
#
# Exit status 1 and a line for each row that is not printed; also where no table is marked at all.

build=${1:?usage: tests/upkeep/texts/printed.sh BUILD}
cd "$(dirname "$0")/../../.." || exit 1

status=0
checked=0
for printed in "$build"/figures/step*.txt; do
    lesson=$(basename "$printed" .txt)
    for text in "$lesson"/*.md; do
        rows=$(awk '
            # The numbers of a text become the keys of an array; 1,024 is 1024.
            function find_numbers(text, numbers) {
                gsub(/,/, "", text)
                while (match(text, /[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?/)) {
                    numbers[substr(text, RSTART, RLENGTH)]
                    text = substr(text, RSTART + RLENGTH)
                }
            }
            function wrong(why) {
                print FILENAME ":" FNR ": " why ": " $0 > "/dev/stderr"
                failed = 1
            }
            function find_times(cells, count, i) {
                count = split($0, cells, / *\| */)
                split("", is_time)
                for (i = 3; i < count; i++) {
                    if (cells[i] == "ms") {
                        is_time[i]
                    }
                }
            }
            function check_row(cells, count, label, number, i, wanted, found) {
                count = split($0, cells, / *\| */)
                label = cells[2]
                sub(/ \(.*/, "", label)
                for (i = 1; i <= line_count; i++) {
                    if (index(" " lines[i], " " label) > 0) {
                        find_numbers(lines[i], found)
                    }
                }
                for (i = 3; i < count; i++) {
                    if (cells[i] ~ /^[-+0-9.,e ]+$/ && !(i in is_time)) {
                        find_numbers(cells[i], wanted)
                    }
                }
                for (number in wanted) {
                    if (!(number in found)) {
                        wrong(number " is not printed")
                        return
                    }
                }
            }
            NR == FNR { lines[++line_count] = $0; is_printed[$0]; next }
            /^<!-- printed -->$/ { inside = 1; row = 0; next }
            inside && /^    / {
                rows++
                if (!(substr($0, 5) in is_printed)) {
                    wrong("not printed")
                }
                next
            }
            inside && /^\|/ {
                row++
                if (row == 1) {
                    find_times()
                } else if (row > 2) { # behind the line below the head
                    rows++
                    check_row()
                }
                next
            }
            /./ { inside = 0 }
            END { print rows + 0; exit failed }' "$printed" "$text") || status=1
        checked=$((checked + rows))
    done
done
echo "$checked rows are compared with what is printed"
[ "$checked" -gt 0 ] || status=1

# Instructions: each number rounded as it is written.
for readme in step*/README.md; do
    tr '\n' ' ' <"$readme" | awk -v lesson="${readme%/README.md}" '
        function compare(written, counted) {
            digits = index(written, ".") > 0 ? length(written) - index(written, ".") : 0
            if (written != sprintf("%." digits "f", counted)) {
                print lesson "/README.md: " written " million instructions are " counted
                failed = 1
            }
        }
        # compare_part SENTENCE WORDS COUNTED: the number before these words, where they are.
        function compare_part(sentence, words, counted) {
            if (match(sentence, "[0-9.]+ " words)) {
                compare(substr(sentence, RSTART, RLENGTH - length(words) - 1), counted)
            }
        }
        NR == FNR {
            if ($1 == lesson) {
                all[$2] = $3; load[$2] = $4; draw[$2] = $5; save[$2] = $6
            }
            next
        }
        {
            text = $0
            while (match(text, /counts [0-9.]+ million instructions for `[a-z_]+`/)) {
                split(substr(text, RSTART, RLENGTH), words, /[ `]+/)
                text = substr(text, RSTART + RLENGTH)
                sentence = text
                sub(/\. .*/, "", sentence)
                scene = words[6]
                compare(words[2], all[scene])
                compare_part(sentence, "for loading", load[scene])
                compare_part(sentence, "for drawing", draw[scene])
                compare_part(sentence, "for saving", save[scene])
            }
        }
        END { exit failed }' tests/bench/counts.txt - || status=1
done
exit "$status"
