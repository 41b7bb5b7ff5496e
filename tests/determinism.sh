#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The same bits from every build: builds the library and tests/determinism.cpp in several ways, asks each the same
# 20,000 queries and fails naming the builds that answer in other bits. determinism.sh all: two builds more and a million
# queries of those that are optimised (minutes more; determinism_test asks 250,000 of its own build).
# EIGEN_INCLUDE names another folder than Debian's.
set -euo pipefail
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
language="-std=c++20 -Ishapes/include -Iccd/include -isystem ${EIGEN_INCLUDE:-/usr/include/eigen3}"
own_flags() { # <compiler and flags>: brink's own, as CMakeLists.txt has them
    local only_if=-
    [[ $1 = clang* ]] || ! grep -q __FMA__ <($1 -dM -E -x c++ /dev/null) || only_if=brink_gxx_fma
    sed -nE "s/^ *([\$]<[\$]<BOOL:[\$][{]${only_if}[}]>:)?(-f[a-z=-]+).*/\2/p" CMakeLists.txt | tr '\n' ' '
}
[[ $(own_flags g++) = *-ffp-contract=off* ]] || { echo "determinism.sh: no flags in CMakeLists.txt" && exit 1; }
generators="query draw path quick_body quick_gap quick_walk gap_over_time reference_gap reference_features solid bracket bracket_polytopes bracket_simplices"

# Commands are written down first, then done side by side.
compile() { # <object folder> <compiler and flags> <source>
    mkdir -p "$scratch/$1"
    echo "$2 $language -c $3 -o $scratch/$1/${3//\//_}.o" >> "$scratch/objects"
}
side_by_side() { # <file of commands>
    xargs -a "$1" -d '\n' -P "$(nproc)" -n 1 bash -c || { echo "determinism.sh: a command failed" && exit 1; }
}

# The library's sources many as one, which leaves an optimizer more to fuse and is sooner done, or with `all` one by one,
# as CMake compiles them; but for Eigen and the public headers, which are parsed once.
library() { # <object folder> <compiler and flags>
    local header=$scratch/$1/public.h suffix=gch own source
    own=$(own_flags "$2")
    [[ $2 != clang* ]] || suffix=pch
    mkdir -p "$scratch/$1"
    printf '#include <%s>\n' brink/ccd.h algorithm array cmath > "$header"
    echo "$2 $own $language -x c++-header $header -o $header.$suffix" >> "$scratch/headers"
    for source in $sources; do
        compile "$1" "$2 $own -Ishapes/src -Iccd/src -include $header" "$source"
    done
}
# What draws the queries, once for each compiler.
generator() { # <object folder> <compiler and flags> <object folder of the library with the same flags>
    local own name
    own=$(own_flags "$2")
    for name in $generators; do
        compile "$1" "$2 $own -Itests/support -include $scratch/$3/public.h" "tests/support/$name.cpp"
    done
}
# The user's program, whose flags are the user's.
program() { # <object folder> <compiler and flags>
    compile "$1" "$2 -Itests/support" tests/determinism.cpp
    compile "$1" "$2 -Itests/support" tests/support/fingerprint.cpp
}

names=() asked=() # of the builds; their programs and what they print are called 0, 1, ...
build() { # <name> <queries> <linker> <folders of program, library and generator, in the order of linking>
    local number=${#names[@]}
    names+=("$1") asked+=("$2")
    echo "$3 $scratch/$4/*.o $scratch/$5/*.o $scratch/$6/*.o -o $scratch/$number" >> "$scratch/links"
    echo "began=\$(date +%s.%N); '$scratch/$number' $2 > '$scratch/$number.said' || echo failed >> '$scratch/$number.said'
        echo \"\$(date +%s.%N) \$began\" > '$scratch/$number.took'" | tr '\n' ';' >> "$scratch/runs"
    echo >> "$scratch/runs"
}

one_by_one=$(ls shapes/src/*.cpp ccd/src/*.cpp | grep -v _qhull) # hulls that keep all their points
sources=$one_by_one
[ "${1:-}" = all ] || sources=$(
    bash tests/batches.sh "$scratch/batches" $one_by_one | grep -vxFf - <(printf '%s\n' $one_by_one)
    ls "$scratch"/batches/*.cpp
)

variant() { # <folder> <compiler> <flags> <queries> <generator>: library and program alike
    library "library-$1" "$2 $3"
    program "program-$1" "$2 $3"
    build "$2 $3" "$4" "$2" "program-$1" "library-$1" "$5"
}
few=20000 all=20000
[ "${1:-}" != all ] || all=1000000
generator generator-g "g++ -O2" library-g2
variant g2 g++ "-O2" $all generator-g
variant g0 g++ "-O0" $few generator-g
variant g3native g++ "-O3 -march=native" $all generator-g
variant clang3native clang++ "-O3 -march=native" $all generator-g
if [ $all != $few ]; then # else determinism_test, in a build with g++ -O3 and in one with clang++
    generator generator-clang "clang++ -O2" library-clang2
    variant g3 g++ "-O3 -march=x86-64" $few generator-g
    variant clang2 clang++ "-O2" $few generator-clang
fi
# The user's inline Eigen code is linked before the library's: where neither inlines it, the library runs the user's.
program user0native "g++ -O0 -march=native"
build "user g++ -O3 -march=native, library -O2" $few g++ program-g3native library-g2 generator-g
build "user g++ -O0 -march=native, library -O0" $few g++ user0native library-g0 generator-g

for stage in headers objects links runs; do
    began=$SECONDS
    side_by_side "$scratch/$stage"
    echo "$stage: $((SECONDS - began)) s"
done
grep -q __FMA__ <(g++ -march=native -dM -E -x c++ /dev/null) || echo "This machine has no FMA: -march=native shows less."

# A line of a program: how many queries, their hash, the hash of the answers. The first build is the measure.
said() { sed -nE "s/^ *$2 queries ([0-9a-f]+) answers ([0-9a-f]+)\$/\1 \2/p" "$scratch/$1.said"; }
passed=0 failed=()
printf '\n%-42s %8s  %-16s  %-16s\n' build seconds "answers, $few" "answers, $all"
for i in "${!names[@]}"; do
    verdict=same shown=()
    grep -q failed "$scratch/$i.said" && verdict="FAILED TO RUN"
    for queries in $few $all; do
        read -r drawn answers <<< "$(said "$i" "$queries") "
        read -r expected_drawn expected <<< "$(said 0 "$queries") "
        shown+=("${answers:--}")
        [ -n "$answers" ] || [ "$queries" -gt "${asked[i]}" ] || verdict="FAILED TO RUN"
        [ -z "$drawn" ] || [ "$drawn" = "$expected_drawn" ] || verdict="DIFFERENT QUERIES"
        [ -z "$answers" ] || [ "$drawn" != "$expected_drawn" ] || [ "$answers" = "$expected" ] || verdict=DIFFERENT
    done
    seconds=$(awk '{ printf "%.1f", $1 - $2 }' "$scratch/$i.took")
    printf '%-42s %8s  %-16s  %-16s  %s\n' "${names[i]}" "$seconds" "${shown[@]}" "$verdict"
    if [ "$verdict" = same ]; then passed=$((passed + 1)); else failed+=("${names[i]}: $verdict"); fi
done
echo
[ ${#failed[@]} -eq 0 ] || printf 'not the bits of %s: %s\n' "${names[0]}" "${failed[@]}"
echo "$passed passed, ${#failed[@]} failed"
[ ${#failed[@]} -eq 0 ]
