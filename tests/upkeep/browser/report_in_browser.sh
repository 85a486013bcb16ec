#!/bin/bash
# Does the HTML report do what it says, in a browser that nobody here wrote? Lets the check judge
# lessons that are right, wrong as two known mistakes are, still to do, crash, and do not build with
# a message that is a page's own script; opens the report in headless Chromium, on a desktop and on
# a phone, in light and in dark, with the mouse and with the keyboard alone
# (report_in_browser.js). Screenshots are left in build/report, or the directory that is named.
#
#     tests/upkeep/browser/report_in_browser.sh [DIRECTORY]
#
# Exit status 0: it does; 1: not; 2: a tool is missing.
cd "$(dirname "$0")/../../.." || exit 1
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
[ -n "$browser" ] || missing=" chromium"
command -v node >/dev/null || missing="$missing nodejs"
if [ -n "$missing" ]; then
    echo "report_in_browser: there is no$missing; on Debian: apt-get install chromium nodejs" >&2
    exit 2
fi
out=${1:-build/report}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
course=$work/course
set -e
mkdir -p "$out"

# wrong LESSON NAME: its main.c becomes that of the mistake.
wrong() {
    mkdir "$work/$1"
    awk -v directory="$work/$1" -f tests/upkeep/verify/replace.awk -f tests/upkeep/verify/parse.awk "$1/mistakes.txt" \
        >"$work/table"
    number=$(awk -F '\t' -v name="$2" '$4 == name { print $1 }' "$work/table")
    cp "$work/$1/$number/main.c" "$course/$1/main.c"
}

make -s handout OUT="$course" LESSONS=1-7 >/dev/null
wrong step01_line pixel_axes_exchanged
for lesson in step02_wireframe step03_triangle step04_flat step07_gouraud; do
    awk -v mode=solution -f tests/student/marks.awk $lesson/main.c >"$course/$lesson/main.c"
done
printf '#error "</pre><script>document.title=1</script><img src=x onerror=alert(1)> \\ \xe2\x80\xae"\n' \
    >>"$course/step02_wireframe/main.c"
wrong step05_zbuffer cleared_to_0
sed -i 's/^int main.*/&\n    if (argc > 2) abort();/' "$course/step07_gouraud/scenes.h"
(cd "$course" && CHECK_EXACT='' make -s check CFLAGS=-O1 REPORT=report >"$work/text") && exit 1
cp "$course/report.html" "$course/report.json" "$out"
node tests/upkeep/browser/report_in_browser.js "$browser" "$out/report.html" "$out"
