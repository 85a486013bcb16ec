#!/usr/bin/env python3
"""Do the reports of one check, REPORT.json and .xml, say the same of the same items?

    formats.py REPORT       for reports.sh
"""
import json
import pathlib
import sys
import xml.etree.ElementTree as xml

import jsonschema

report = json.loads(pathlib.Path(sys.argv[1] + ".json").read_text())
schema = pathlib.Path(__file__).parents[2] / "check/report.schema.json"
jsonschema.validate(report, json.loads(schema.read_text()))
items = [(step["step"], item) for step in report["steps"] for item in step["items"]]
cases = xml.parse(sys.argv[1] + ".xml").findall(".//testcase")
assert len(items) == len(cases) > 0, (len(items), len(cases))
states = {"PASS": None, "TODO": "skipped", "FAIL": "failure"}
for (step, item), case in zip(items, cases):
    wanted = states.get(item["state"], "error")
    found = [child.tag for child in case if child.tag != "system-out"]
    assert found == ([wanted] if wanted else []), (step, item, found)
    assert case.get("classname") == step and case.get("name").startswith(item["scene"])
seen = {item["state"] for _, item in items}
assert {"PASS", "TODO", "BUILD", "CRASH"} <= seen, seen
assert report["points"] == sum(item["points"] for _, item in items)
print(len(items), "items, the same in JSON and JUnit")
