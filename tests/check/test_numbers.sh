#!/bin/sh
# Functions called with numbers: what the check says where one gives another number, never returns,
# crashes or ends the program, and that a task that is to do is not called; also that the numbers in
# the lessons' texts are those of the calls.
. "$(dirname "$0")/../unit/script.sh"

mkdir -p "$work/course" && cp -R Makefile common step01_line tests "$work/course" &&
    cd "$work/course" || exit 1
main=step01_line/main.c
cp "$main" "$work/solution.c"

# checked STATUS OLD NEW: lesson 1 with the line of 1.3 that holds OLD instead of it.
checked() {
    awk -v old="$2" -v new="$3" 'index($0, old) { print new; next } { print }' "$work/solution.c" >"$main"
    said_by "$1" make -s check STEP=01 MARCH= CFLAGS=-O0 CHECK_TIMEOUT=4
}
length='return (size_t)(width > height ? width : height) + 1;'

checked 0 nothing ''
checked 1 "$length" 'return (size_t)(width > height ? width : height) + (width + height > 0);'
says '  numbers 1.3 FAIL 0/1: line_length((5, 5), (5, 5)) must be 1: yours 0'
silent '1.3 perhaps'
says '1.4 2/2'
said_by 0 make hint STEP=01 MARCH= CFLAGS=-O0
says 'Task 1.3, hint 1 of 3'
checked 1 "$length" 'for (;;) width = 0;'
says '  numbers 1.3 TIME 0/1: line_length((0, 0), (5, 2)) must be 6: yours does not return'
says '  far PASS'
says ', 1.3 TIME 0/2, 1.4 2/2,'
checked 1 "$length" '*(volatile int *)0 = 1; return 1;'
says '  numbers 1.3 CRASH 0/1: line_length((0, 0), (5, 2)) must be 6: SIGSEGV, outside of an array, or a pointer to nothing (and 3 more calls)'
says 'pointer to nothing; line_length() crashes, see numbers 1.3'
checked 1 "$length" 'exit(0);'
says '  numbers 1.3 CRASH 0/1: line_length((0, 0), (5, 2)) must be 6: yours ends the program (and 3 more calls)'
checked 0 "$length" 'puts("9\t1.3\tx\t1\t2\twrong"); return (size_t)(width > height ? width : height) + 1;'
checked 1 "$length" 'return 1; // to do 1.3'
says '  numbers 1.3 TODO 0/1: task 1.3 is to do'
says '  numbers 1.4 PASS'
checked 1 "$length" 'return (size_t)(width > height ? width : height);' # the array of the list is one too short
says ': memory was written outside of an array: '


# ---- A call that ends in another task's function ----

# 1.4 calls what 1.2 writes, and keeps the point of its calls.
step='walk->u++;'
checked 1 "$step" 'walk->u = walk->u_last = *(volatile int *)0;'
says '  numbers 1.2 CRASH 0/1: line(image, (0, 0), (5, 2), white) must be '
says '  numbers 1.4 NOT JUDGED 1/1: judged when task 1.2, whose code it runs, is right'
says 'next: task 1.2'
checked 1 "$step" ';'
says '  numbers 1.2 TIME 0/1: line(image, (0, 0), (5, 2), white) must be '
says '  numbers 1.4 NOT JUDGED 1/1: judged when task 1.2, whose code it runs, is right'
checked 1 "$step" 'walk->u = walk->u_last = *(volatile int *)0; // to do 1.4'
says '  numbers 1.4 TODO 0/1: task 1.4 is to do'
list='list[count++] = walk_pixel(&walk);'
checked 1 "$list" "*(volatile int *)0 = 1, $list"
says '  numbers 1.2 PASS 1/1'
says '  numbers 1.4 CRASH 0/1: line_list((0, 0), (5, 2), list) must be '
# Of two parts of one function the later one is at fault.
cp tests/check/scenes.txt "$work/scenes.txt"
sed 's/^\(call .* \)1\.2 /\11.2~1.4 /' "$work/scenes.txt" >tests/check/scenes.txt
checked 1 "$step" 'walk->u = walk->u_last = *(volatile int *)0;'
says '  numbers 1.2 NOT JUDGED 1/1: judged when task 1.4, whose code it runs, is right'
says '  numbers 1.4 CRASH 0/1: line_list((0, 0), (5, 2), list) must be '
cp "$work/scenes.txt" tests/check/scenes.txt

checked 1 "$length" 'int zero = 0; return 1 / zero;'
said_by 1 make -s check STEP=01 MARCH= CFLAGS=-O0 CHECK_TIMEOUT=20 SANITIZE=1
says '  numbers 1.3 CRASH 0/1: line_length((0, 0), (5, 2)) must be 6: step01_line/main.c:'
says ': division by zero'
checked 0 nothing ''
said_by 0 make -s check STEP=01 MARCH= CFLAGS=-O0 CHECK_TIMEOUT=20 SANITIZE=1
says '22/22'

# ---- What is not built ----

: >step01_line/program.h
checked 1 nothing ''
says 'SCORE 0/22: step01_line/program.h: error: it hides common/program.h: give it another name'
rm step01_line/program.h
checked 0 nothing ''
awk 'BEGIN { for (i = 0; i < 50000; i++) print "/* a comment in many lines */" }' >>"$main"
said_by 1 make -s check STEP=01 MARCH= CFLAGS=-O0
says 'bytes; at most 1048576 are judged'

# ---- The texts ----

cd "$top" || exit 1
for numbers in tests/lessons/step*/numbers.c; do
    lesson=${numbers#tests/lessons/}
    lesson=${lesson%/numbers.c}
    make -s BUILD="$build" "$build/quick/numbers/$lesson" && rm -f "$work/rows" &&
        "$build/quick/numbers/$lesson" "$work/rows" 0 || wrong "$lesson: the calls fail"
    # A call that the text names is followed, in its paragraph or its row of a table, by what it gives, and
    # each task that has calls has one in the text, on whichever page has tasks.
    # shellcheck disable=SC2046 # one word a file
    awk -F '\t' -v lesson="$lesson" '
        FILENAME ~ /\.md$/ { text = text (FNR == 1 ? "\n" : "") $0 ($0 == "" || /^\|/ ? "\n" : " "); next }
        FNR == 1 { gsub(/ +/, " ", text) }
        NF < 6 { next } # the last line
        {
            tasks[$2] += 0
            rest = text
            while ((at = index(rest, "`" $3 "`")) > 0) {
                rest = substr(rest, at + length($3) + 2)
                paragraph = substr(rest, 1, index(rest, "\n"))
                if (index(paragraph, $4) == 0) { print lesson ": " $3 " is not " $4 " in the text"; bad = 1 }
                tasks[$2]++
            }
            if ($6 != "right") { print lesson ": " $3 " is " $5 ", not " $4; bad = 1 }
        }
        END {
            for (task in tasks) if (tasks[task] == 0) { print lesson ": no call of task " task " in the text"; bad = 1 }
            exit bad
        }' $(pages "$lesson") "$work/rows" || wrong "$lesson: text and calls differ"
done
exit $failed
