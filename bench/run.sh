#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds brink's benchmarks and runs them all, installing what is missing: run.sh [options of `brink-bench all`]
# Without options: --quick, under ten minutes. Tables, CSVs, pictures and report.html go to out/.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/install.sh

install_missing $brink_packages
cmake -S . -B build -G Ninja
cmake --build build --target brink-bench brink-bench-v3
[ $# -gt 0 ] || set -- --quick
exec build/bench/brink-bench all "$@" # 1: an answer broke a promise, or a part failed
