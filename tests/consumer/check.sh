#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs the stranger's project both ways: check.sh <checkout> <build folder of brink> [CMake argument]...
# BRINK_CONSUMER=installed: only against the library as installed.
set -euo pipefail
checkout=$1 build=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

consumer() { # <build folder> <CMake argument>...
    local folder=$1
    shift
    cmake -S "$checkout/tests/consumer" -B "$folder" -DCMAKE_BUILD_TYPE=Release "$@"
    cmake --build "$folder"
    "$folder/consumer"
}

echo "== find_package, after an install into a scratch prefix"
cmake --install "$build" --prefix "$scratch/prefix" > "$scratch/install.log"
consumer "$scratch/installed" -DCMAKE_PREFIX_PATH="$scratch/prefix" "$@"

echo "== the same with -march=native against the library as installed"
"$scratch/installed/consumer_native"

[ "${BRINK_CONSUMER:-}" != installed ] || exit 0
echo "== add_subdirectory"
consumer "$scratch/checkout" -DBRINK_CHECKOUT="$checkout" "$@" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= \
    -DBRINK_BATCHES="brink_shapes;brink_ccd" -DBRINK_PRECOMPILE=ON # sooner built
