#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# clang-tidy over the library's own sources and headers. Nearly all of its time goes to Eigen's, so it reads many sources
# as one: first all but those that clash in some name with another, then those, in the same way. What it looks for in the
# main file alone (a using declaration without use) it does not find. EIGEN_INCLUDE names another folder than Debian's.
set -euo pipefail
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp .clang-tidy "$scratch"
flags=(-std=c++20 -Ishapes/include -Iccd/include -Ishapes/src -Iccd/src -isystem "${EIGEN_INCLUDE:-/usr/include/eigen3}")

# Of the sources of a batch, those with an error, in themselves or in a header of theirs.
with_errors() { # <batch>
    clang++ "${flags[@]}" -w -fsyntax-only -ferror-limit=0 "$1" 2>&1 |
        sed -nE 's/^(In file included from )?([^: ]*\/src\/[^: ]*\.cpp):[0-9]+:([0-9]+: .*error: .*)?$/"\2"/p'
}

cd "$scratch"
flags=("${flags[@]//-I/-I$OLDPWD/}")
printf '#include "%s" // NOLINT(bugprone-suspicious-include)\n' "$OLDPWD"/{shapes,ccd}/src/*.cpp > left
batches=0
while [ -s left ]; do
    batch=batch_$batches.cpp batches=$((batches + 1))
    cp left "$batch"
    while with_errors "$batch" > errors; [ -s errors ] && [ "$(wc -l < "$batch")" -gt 1 ]; do
        grep -vFf errors "$batch" > rest || head -n 1 "$batch" > rest
        mv rest "$batch"
    done
    grep -vxFf "$batch" left > rest || true
    mv rest left
done
wc -l batch_*.cpp
printf '%s\n' batch_*.cpp | xargs -I{} -P "$(nproc)" clang-tidy --quiet {} -- "${flags[@]}" 2> said ||
    { grep -v ' warnings generated\.$' said; exit 1; }
