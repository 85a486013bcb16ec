#!/bin/sh
# Prepares the image in which Gradescope runs run_autograder: a compiler, and all of the course that
# no submission changes. MARCH= because the image may run on another processor.
#
# Format: https://gradescope-autograders.readthedocs.io/en/latest/specs/
set -e
if ! command -v gcc >/dev/null || ! command -v make >/dev/null || ! command -v unzip >/dev/null; then
    apt-get update
    apt-get install -y gcc libc6-dev make unzip
fi
cd "${AUTOGRADER:-/autograder}/source/course"
make -s MARCH= build/check models
