#!/bin/bash
# The button Run: what the check says, without a grade. vpl_evaluate.sh says the rest.
grade=no . ./vpl_check.sh
