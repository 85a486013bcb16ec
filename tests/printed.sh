#!/bin/sh
# Are the tables in the lessons what the lessons' programs print? In stepNN_name/README.md a line
# `<!-- printed -->` stands before each table that `make figures` prints: either as it is printed,
# indented, or as a table in which each row begins with words of a printed line, and all its numbers
# stand in such lines.
#
#   tests/printed.sh BUILD        after `make figures` or `make lesson-figures` with that BUILD
#
# Exit status 1 and a line for each row that is not printed; also where no table is marked at all.

build=${1:?usage: tests/printed.sh BUILD}
cd "$(dirname "$0")/.." || exit 1

status=0
checked=0
for printed in "$build"/figures/step*.txt; do
    lesson=$(basename "$printed" .txt)
    rows=$(awk -v lesson="$lesson" '
        # The numbers of a text become the keys of an array; 1,024 is 1024.
        function find_numbers(text, numbers) {
            gsub(/,/, "", text)
            while (match(text, /[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?/)) {
                numbers[substr(text, RSTART, RLENGTH)]
                text = substr(text, RSTART + RLENGTH)
            }
        }
        function wrong(why) {
            print lesson "/README.md:" FNR ": " why ": " $0 > "/dev/stderr"
            failed = 1
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
                if (cells[i] ~ /^[-+0-9.,e ]+$/) {
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
            if (++row > 2) { # behind the head and the line below it
                rows++
                check_row()
            }
            next
        }
        /./ { inside = 0 }
        END { print rows + 0; exit failed }' "$printed" "$lesson/README.md") || status=1
    checked=$((checked + rows))
done
echo "$checked rows are compared with what is printed"
[ "$checked" -gt 0 ] && exit "$status"
exit 1
