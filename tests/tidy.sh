#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# clang-tidy over the library's own sources and headers. Nearly all of its time goes to Eigen's, so it reads as many
# sources as one as do not clash in some name. What it looks for in the main file alone (a using declaration without use)
# it does not find. EIGEN_INCLUDE names another folder than Debian's.
set -euo pipefail
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp .clang-tidy "$scratch"
flags=(-std=c++20 -Ishapes/include -Iccd/include -Ishapes/src -Iccd/src -isystem "${EIGEN_INCLUDE:-/usr/include/eigen3}")

# What clashes where a batch is read as one: two sources that an error and its note name, or one that errs alone.
clashes() { # <batch>
    clang++ "${flags[@]}" -w -fsyntax-only -ferror-limit=0 "$1" 2>&1 | awk '
        function source(text) { return match(text, /[^ "]*\/src\/[^:]*\.cpp/) ? substr(text, RSTART, RLENGTH) : "" }
        function end_error() { if (erring != "" && !named) print erring }
        /^In file included from / && source($0) != "" { reader = source($0) }
        / error: / {
            end_error()
            erring = source($1) != "" ? source($1) : reader
            named = 0
        }
        / note: / && source($1) != "" && source($1) != erring { print erring, source($1); named = 1 }
        END { end_error() }' | sort -u
}
# Of those that are left as many as are not known to clash: first those that clash with few.
together() {
    awk '
        FILENAME == "left" { left[$1] = 1 }
        FILENAME == "alone" { delete left[$1] }
        FILENAME == "clashing" && $1 in left && $2 in left && !(($1, $2) in clash) {
            clash[$1, $2] = clash[$2, $1] = 1
            others[$1] = others[$1] " " $2
            others[$2] = others[$2] " " $1
            ++degree[$1]
            ++degree[$2]
        }
        END { for (source in left) print degree[source] + 0, source others[source] }' left alone clashing |
        sort -k1,1n -k2,2 | awk '
        {
            for (i = 3; i <= NF; ++i) if ($i in taken) next
            taken[$2] = 1
            print $2
        }'
}

cd "$scratch"
flags=("${flags[@]//-I/-I$OLDPWD/}")
ls "$OLDPWD"/{shapes,ccd}/src/*.cpp > left
: > clashing
for ((batches = 0; $(wc -l < left); ++batches)); do
    : > alone
    while together > members; [ -s members ] || head -n 1 left > members
        sed 's|.*|#include "&" // NOLINT(bugprone-suspicious-include)|' members > "batch_$batches.cpp"
        clashes "batch_$batches.cpp" > new; [ -s new ] && [ "$(wc -l < members)" -gt 1 ]; do
        if grep -q ' ' new; then grep ' ' new >> clashing; else cat new >> alone; fi
    done
    grep -vxFf members left > rest || true
    mv rest left
done
wc -l batch_*.cpp
printf '%s\n' batch_*.cpp | xargs -I{} -P "$(nproc)" clang-tidy --quiet {} -- "${flags[@]}" 2> said ||
    { grep -v ' warnings generated\.$' said; exit 1; }
