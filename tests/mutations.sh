#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Do the tests of the closed forms notice? Breaks the library in one place at a time - each constant of an error bound a
# hundredth of itself, each exact answer replaced by the plain one - in a copy, and runs them. A table of what they
# say; exits with 1 where a mutation survives. Some ten minutes; not part of .ci/run. mutations.sh [name]... for some only.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/install.sh
install_missing $brink_packages
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -r CMakeLists.txt shapes ccd tests LICENSE "$scratch"
cmake -S "$scratch" -B "$scratch/build" -G Ninja -DBRINK_FUZZ=OFF -DBRINK_BENCH=OFF > /dev/null
wanted=("$@") survived=0

# Whether the tests pass with what lies in the scratch copy.
pass() {
    ninja -C "$scratch/build" brink-tests > "$scratch/log" 2>&1 || { tail -n 20 "$scratch/log" && exit 2; }
    "$scratch/build/tests/brink-tests" --minimal \
        --source-file='*/pairs_test.cpp,*/exact_contact_test.cpp,*/sharp_test.cpp,*/dyadic_test.cpp,*/regressions*_test.cpp' \
        > "$scratch/said" 2>&1
}
try() { # <name> <file> <sed script>
    [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " = *" $1 "* ]] || return 0
    sed -i -E "$3" "$scratch/$2"
    ! cmp -s "$2" "$scratch/$2" || { echo "$1: nothing changed in $2" && exit 2; }
    local failures verdict=noticed
    if pass; then verdict=SURVIVED survived=$((survived + 1)); fi
    failures=$(grep -c 'ERROR:' "$scratch/said" || true)
    printf '%-26s %-10s %6s failed checks\n' "$1" "$verdict" "$failures"
    cp "$2" "$scratch/$2"
}

pass || { cat "$scratch/said" && echo "the tests fail before any mutation" && exit 2; }
tolerances=ccd/src/tolerance.h
for constant in axis_slack turning_slack guess_slack witness_depth loose_axis pair_slack quotient exact_root cancelled_slack \
    ring end_slack polish_slack rounded_step rate_slack; do
    try "$constant / 100" $tolerances "s/^(inline constexpr double $constant = )(.*);/\1(\2) \/ 100;/"
done
try "no exact numbers" ccd/src/toi.cpp \
    's/const Verdict v = exact_contact\(\*q\.given\);/const Verdict v{e.t > 0 || e.meeting ? Status::hit : Status::separated, e.t, q.options.t_max};/'
try "no exact end of step" ccd/src/crossing.h 's/c\.t_upper > m\.t_max \? Found::doubt : Found::hit/Found::hit/'
try "no exact start" ccd/src/advance.cpp 's/if \(!\(now_\.gap < -rounding_\)\) return \{\};//'
try "no low parts" ccd/src/sphere_sphere.cpp 's/return \{sum\.hi, sum\.lo \+ \(product\.lo.*/return {sum.hi, both(0)};/'
try "no rescaling" ccd/src/toi.cpp 's/const int exponent = exponent_to_usual\(a, b, q, m\);/const int exponent = 0;/'
echo "$survived survived"
[ "$survived" -eq 0 ]
