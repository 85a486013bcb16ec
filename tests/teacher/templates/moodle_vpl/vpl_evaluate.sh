#!/bin/bash
# The button Evaluate: what the check says, as a comment, and its points as the grade.
grade=yes . ./vpl_check.sh
