#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds brink and runs every test, installing what is missing: run.sh [CMake arguments] [-- ctest arguments]
# BRINK_BUILD names another build folder than build/.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/install.sh
build=${BRINK_BUILD:-build}
configure=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do configure+=("$1") && shift; done
[ $# -eq 0 ] || shift

install_missing $brink_packages
cmake -S . -B "$build" -G Ninja "${configure[@]}"
cmake --build "$build"

rc=0
ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(nproc)" "$@" || rc=$?

# doctest counts its test cases; a script counts as one test, and so does a program that failed beyond its test cases.
awk '
    function close_test() { if (open && ok && !cases) passed++; if (open && !ok && !bad) failed++ }
    / Testing: / { close_test(); open = 1; ok = cases = bad = 0 }
    /^\[doctest\] test cases:/ { cases = $4; passed += $6; bad = $9; failed += bad }
    /^Test Passed\./ { ok = 1 }
    END { close_test(); printf "%d passed, %d failed\n", passed, failed; exit failed || !passed }
' "$build/Testing/Temporary/LastTest.log" || rc=1
exit "$rc"
