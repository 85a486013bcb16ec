#!/bin/sh
# The tables that go back to a platform, gradebook.csv, read by a reader of CSV that nobody here wrote, Python's:
# is every field what it was, and has each row the points of its submission and of no other? With names that
# have commas, quotes, umlauts and line breaks, in the lines and forms of Moodle, Canvas and a spreadsheet.
. "$(dirname "$0")/../../unit/script.sh"
command -v python3 >/dev/null || skip "there is no python3"
cd tests/teacher/grade || exit 1
export LC_ALL=C # as merge.sh has it
. ./encode.sh

# submissions NAME=POINTS...: of 40, as merge.sh has them.
submissions() {
    for one; do
        name=$(encode "${one%=*}")
        printf '%s\tstate\tGRADED\n%s\ttask\tstep01_line\t1.1\tPASS\t%s\t40\n' "$name" "$name" "${one##*=}"
    done >"$work/results"
}

# returns FORM COLUMN TITLE POINTS...: with that COLUMN= (or none) the roster's rows come back with these points
# below that title, `-` where the field stays.
returns() {
    form=$1
    column=$2
    shift 2
    awk -v roster="$work/roster.csv" -v column="$column" -v others="$work/others" -F '\t' -f sums.awk \
        -f gradebook.awk "$work/results" >"$work/gradebook.csv" || wrong "$form: status $?"
    python3 - "$work" "$@" <<'END' || wrong "$form: $(cat "$work/gradebook.csv")"
import csv, pathlib, sys

work, column, *points = sys.argv[1:]
def read(name):
    with open(pathlib.Path(work) / name, encoding="utf-8-sig", newline="") as file:
        return [row for row in csv.reader(file, strict=True) if row]
before, after = read("roster.csv"), read("gradebook.csv")
title, *rows = after
goal = title.index(column)
if column not in before[0]:
    before = [row + [column if i == 0 else ""] for i, row in enumerate(before)]
# Line breaks within a field are the platform's: \r\n or \n.
same = lambda rows: [[row[i].replace("\r\n", "\n") for i in range(len(row)) if i != goal] for row in rows]
assert same(after) == same(before), (before, after)
assert len(points) == len(rows), rows
for row, old, wanted in zip(rows, before[1:], points):
    assert row[goal] == (old[goal] if wanted == "-" else wanted), (row, wanted)
END
}

# Moodle's grading worksheet: UTF-8 with its mark, lines as on Windows; of 100 points.
submissions 'Jörg Müller_7_assignsubmission_file=30' 'Jörg Möller_assignsubmission_file=13' zoe=40 'Nobody Known=9' \
    'Ann Two_8_assignsubmission_file=0'
printf '\357\273\277%s\r\n' 'Identifier,Full name,Email address,Grade,Maximum Grade,"Feedback, ""comments"""' \
    'Participant 7,"Jörg ""Jo"" Müller, M.Sc.",jo@x.org,,100.00,"two' 'lines, ""of"" text"' \
    'Participant 17,Jörg Möller,jm@x.org,,100.00,""""' 'Participant 27,"Ångström, Zoë",zoe@x.org,,100.00,","' \
    'Participant 8,Ann Two,two@x.org,50,100.00,' 'Participant 9,Without,none@x.org,12,100.00,' |
    sed '2,$s/^\xef\xbb\xbf//' >"$work/roster.csv"
returns Moodle '' Grade 75 32.5 100 0 -
[ "$(cat "$work/others")" = Nobody%20Known ] || wrong "nobody's are $(cat "$work/others")"

# Canvas's export: points possible in the second line, and more columns after the assignments.
submissions doejane_101_555_step01_line.c=13 oneilsean_102_556_main.c=40 \
    oneilsean_LATE_102_556_main.c=27.5
printf '%s\n' 'Student,ID,SIS User ID,SIS Login ID,Section,Lesson 0 (17),"Lesson 1, ""lines"" (4711)",Final Score' \
    '    Points Possible,,,,,5.00,40.00,(read only)' '"Doe, Jane",101,u1,jane@x.org,"A, B",1,,' \
    '"O'\''Neil, ""Seán""",102,u2,sean@x.org,A,2,3,90' '"Student, Test",103,,x,A,,,' >"$work/roster.csv"
returns Canvas '' 'Lesson 1, "lines" (4711)' - 13 27.5 -
returns 'another of Canvas' 'Lesson 0 (17)' 'Lesson 0 (17)' - 13 27.5 -

# Any table, with and without the column; a line is empty.
submissions 'O, "Ann" ü=12' 'Beta=3.25'
printf 'Name,Remark\n"O, ""Ann"" ü",\n\nBeta,"a\nb"\nGamma,"""x"",""y"""' >"$work/roster.csv"
returns 'a new column' '' Points 12 3.25 -
returns 'a column with a name' 'Points, "final"' 'Points, "final"' 12 3.25 -
exit $failed
