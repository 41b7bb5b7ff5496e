#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# clang-tidy over the library's own sources and headers. Nearly all of its time goes to Eigen's, so it reads many sources
# as one: first all but those that clash, in a name of their own, with one before them; then those, in the same way.
# EIGEN_INCLUDE names another folder than Debian's.
set -euo pipefail
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp .clang-tidy "$scratch"
flags=(-std=c++20 -Ishapes/include -Iccd/include -Ishapes/src -Iccd/src -isystem "${EIGEN_INCLUDE:-/usr/include/eigen3}")

# Of the sources of a batch, those with an error, in themselves or in a header of theirs.
with_errors() { # <batch>
    clang++ "${flags[@]}" -w -fsyntax-only -ferror-limit=0 "$1" 2>&1 |
        sed -nE 's/^(In file included from )?([^: ]*\/src\/[^: ]*\.cpp):[0-9]+:([0-9]+: .*error: .*)?$/\2/p' | LC_ALL=C sort -u
}

mapfile -t left < <(printf '%s\n' "$PWD"/shapes/src/*.cpp "$PWD"/ccd/src/*.cpp)
batches=()
while [ ${#left[@]} -gt 0 ]; do
    batch=$scratch/batch_${#batches[@]}.cpp
    printf '#include "%s" // NOLINT(bugprone-suspicious-include)\n' "${left[@]}" > "$batch"
    left=()
    mapfile -t clashing < <(with_errors "$batch")
    while [ ${#clashing[@]} -gt 0 ]; do
        left+=("${clashing[@]}")
        grep -vF "$(printf '"%s"\n' "${clashing[@]}")" "$batch" > "$batch.rest" ||
            { echo "tidy.sh: does not compile: ${clashing[*]}" && exit 1; }
        mv "$batch.rest" "$batch"
        mapfile -t clashing < <(with_errors "$batch")
    done
    batches+=("$batch")
done
wc -l "${batches[@]}" | sed -E "s|$scratch/||"
printf '%s\n' "${batches[@]}" | xargs -I{} -P "$(nproc)" clang-tidy --quiet {} -- "${flags[@]}" 2> "$scratch/said" ||
    { grep -v ' warnings generated\.$' "$scratch/said"; exit 1; }
