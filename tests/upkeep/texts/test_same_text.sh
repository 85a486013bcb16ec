#!/bin/sh
# Where a lesson writes a technique out in full and common has the same text, the two must not drift
# apart. Compares functions without white space, comments, marks for the starter, `static`, `inline`,
# the function's own name, the guard band, which the house has as an argument, and the top-left rule,
# which the house has as a macro.
. "$(dirname "$0")/../../unit/script.sh"

# function FILE NAME: its definition, from its name to the brace that ends it, on one line.
function_text() {
    awk -v mode=solution -f tests/student/marks.awk "$1" | awk -v name="$2" '
        !inside && $0 ~ "^[a-z].*[ *]" name "\\(" { inside = 1; text = "" }
        inside { line = $0; sub(/\/\*.*\*\//, "", line); text = text " " line }
        inside && /;$/ && text !~ /{/ { inside = 0 }   # only a declaration
        inside && /^}/ { print text; exit }' |
        sed -e "s/\\<$2\\>/FUNCTION/" -e 's/static//g' -e 's/inline//g' \
            -e 's/, double guard_band//' -e 's/, guard_band)/)/g' \
            -e 's/IS_TOP_LEFT(x_distance, y_distance)/y_distance < 0 || (y_distance == 0 \&\& x_distance < 0)/' |
        tr -d ' \t'
}

# same LESSON HOUSE NAME [HOUSE_NAME]
same() {
    lesson_text=$(function_text "$1" "$3")
    house_text=$(function_text "$2" "${4:-$3}")
    if [ -z "$lesson_text" ] || [ "$lesson_text" != "$house_text" ]; then
        wrong "$3() in $1 and ${4:-$3}() in $2 are not the same text"
    fi
}

lesson=step03_triangle/main.c
same $lesson common/raster.c make_edge
same $lesson common/raster.c triangle_setup edges_setup
same $lesson common/raster.c triangle_span edges_span
same $lesson common/given/triangles.h triangle_weights edges_weights

lesson=step08_projection/main.c
same $lesson common/geometry.c projection mat4_projection
same $lesson common/geometry.c lookat mat4_lookat
same $lesson common/given/camera.h correct_weights perspective_weights
for name in plane_distance mix cut_edge clip_at_plane; do
    same $lesson common/pipeline/clip.c $name
done

# The functions that lesson 9's page on the pipeline names are there.
for name in $(grep -oE '`[a-z_]+\(\)`' step09_shaders/PIPELINE.md | tr -d '`()' | sort -u); do
    grep -rqw "$name" common step0[89]_*/main.c || wrong "PIPELINE.md names $name(), which isn't there"
done

# On the pages with tasks each task has a heading, which names it as its marks do, and then its lines and minutes. Before
# the questions each page says what one can do now, and no level of headings is left out.
for lesson in step*; do
    # shellcheck disable=SC2046 # one word a page
    awk -v mode=tasks -f tests/student/marks.awk "$lesson/main.c" | awk -F '\t' '
        function wrong(what) { print FILENAME ":" FNR ": " what; failed = 1 }
        FILENAME == "-" { title[$1] = $2; next }
        /^##/ { level = index($0, " ") - 1; if (level > last + 1) wrong("a level is left out: " $0); last = level }
        /^# / { last = 1 }
        /^## Questions$/ && part_before != "## What you can do now" { wrong("after " part_before) }
        /^## / { part_before = $0 }
        /^### Task / {
            split(substr($0, 10), part, ": ")
            sub(/, .*/, "", part[2])
            if (title[part[1]] != part[2]) wrong("\"" title[part[1]] "\" in main.c: " $0)
            told[part[1]] = FNR + 2
            form = FNR + 2
        }
        FNR == form && !/^\*[0-9].* minutes\.\* / { wrong("not `*N lines, N minutes.* ...`: " $0) }
        END {
            for (task in title) if (!(task in told)) wrong("no heading of task " task)
            exit failed
        }' - $(pages "$lesson") || failed=1
done

# The version, where it stands; and the tasks of each lesson on the page for a semester, with the hours of the map.
version=$(sed -n 's/^#define COURSE_VERSION "\(.*\)"/\1/p' common/run/options.h)
grep -q "version $version, 20" README.md || wrong "README.md does not say how to cite version $version"
sed -n '/^## /{p;q;}' .github/CHANGELOG.md | grep -q "^## $version (" || wrong "CHANGELOG.md does not begin with $version"
for lesson in step*; do
    tasks=$(awk -v mode=tasks -f tests/student/marks.awk "$lesson/main.c" |
        awk -F '\t' '{ printf "%s%s %s", (NR > 1 ? "; " : ""), $1, $2 }')
    hours=$(sed -n "/href=.$lesson.README/s/.*<td>\([^ ]*\) hours\{0,1\}<.*/\1/p" README.md)
    row=$(grep "/$lesson/README.md) | " tests/teacher/COURSE.md)
    [ "${row#*) | }" = "$hours | $tasks |" ] || wrong "COURSE.md says of $lesson: ${row#*) | }, not: $hours | $tasks |"
done

exit $failed
