#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds brink's benchmarks and runs them, installing what is missing. Tables, CSVs and pictures go to out/.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/install.sh

install_missing $brink_packages
cmake -S . -B build -G Ninja
cmake --build build --target brink-bench brink-bench-v3
build/bench/brink-bench tunnelling
build/bench/brink-bench pairs
status=0
build/bench/brink-bench accuracy || status=$? # 1: an answer broke a promise
build/bench/brink-bench scene || status=$?   # 1: a rival found other pairs
build/bench/brink-bench ingredients || status=$?
build/bench/brink-bench stability || status=$?
build/bench/brink-bench replay || status=$?

echo
echo "Pictures:"
ls "$PWD"/out/*.svg "$PWD"/out/*.png
exit "$status"
