#!/bin/bash
# For the Virtual Programming Lab of Moodle: what vpl_run.sh and vpl_evaluate.sh share. All of them,
# take.sh and course.tar.gz (a hand-out) are execution files of the activity; students submit each
# lesson's main.c, and may submit no other files. Building and checking takes about a minute: give
# the activity that time (maximum execution time), 1 GB of memory and 200 processes.
#
# Formats: scripts leave a program vpl_execution, which says the grade in `Grade :=>>` and comments
# between `<|--` and `--|>`, titles after `-` and preformatted lines after `>`:
# https://vpl.dis.ulpgc.es/documentation/vpl-3.4.3+/advancedfeatures.html,
# http://demovpl.dis.ulpgc.es/index.php/support/2014-09-27-15-07-38/\
#     57-how-to-configure-the-moodle-module
# Binary files come in base64, and common_script.sh decodes them:
# https://github.com/jcrodriguez-dis/moodle-mod_vpl (jail/default_scripts/common_script.sh)

# shellcheck source=/dev/null disable=SC2154 # comes from Moodle; grade from who reads this
. ./common_script.sh
rm -f vpl_execution
course=$(mktemp -d) && tar xzf course.tar.gz -C "$course" --strip-components=1 || exit 1
rm course.tar.gz # no archive that somebody handed in
note=$(sh ./take.sh . "$course" "$course")
[ $? != 1 ] || exit 1

flags='CFLAGS=-O1 MARCH='
# shellcheck disable=SC2086 # one word a flag
said=$(cd "$course" && make -s $flags build/check models 2>&1 &&
    build/check --make "make -s $flags" --json report.json 2>&1)
score=
[ ! -f "$course/report.json" ] ||
    score=$(sed -n '1,3{s/^  "points": \([0-9]*\),$/\1/p; s/^  "most": \([0-9]*\),$/\1/p;}' \
        "$course/report.json" | tr '\n' ' ')
score=${score% }

# Each line of what programs and compilers say begins with >, so none can end the text or the
# comment, or give a grade.
{
    printf '#!/bin/bash\n%s\n' "cat <<'END_OF_RESULT'"
    [ "$grade" != yes ] || echo '<|--'
    if [ -n "$score" ]; then
        echo "-Score: ${score% *} of ${score#* } points"
    else
        echo "-The check itself cannot work: tell your teacher"
    fi
    printf '%s\n' "${note:+$note
}$said" | sed 's/^/>/'
    [ "$grade" != yes ] || echo '--|>'
    [ "$grade" != yes ] || [ -z "$score" ] ||
        echo "$score" | LC_ALL=C awk -v low="${VPL_GRADEMIN:-0}" -v high="${VPL_GRADEMAX:-10}" \
            '{ printf "Grade :=>> %.2f\n", low + (high - low) * $1 / ($2 > 0 ? $2 : 1) }'
    echo END_OF_RESULT
} >vpl_execution
chmod +x vpl_execution
rm -rf "$course"
