#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The rules of the house that a program can see: house.sh <checkout> [build folder]. Names every breach, exits with 1.
set -uo pipefail
shopt -s nullglob
cd "$1" || exit 1
build=${2:-}
breaches=0 checked=0
breach() { echo "$1: $2"; breaches=$((breaches + 1)); }

# Top level.
for entry in *; do
    case $entry in
        CMakeLists.txt | README.md | LICENSE | ccd | shapes | fuzz | tests | bench) ;;
        build* | out | compile_commands.json) ;; # ignored by git
        *) breach "$entry" "not a name for the top level" ;;
    esac
done
for header in ccd/*.h; do breach "$header" "<ccd/...> is libccd's: no header lies directly in ccd/"; done

# Every file.
while read -r file; do
    checked=$((checked + 1))
    head -n 2 "$file" | grep -q 'SPDX-License-Identifier: BSD-3-Clause' || breach "$file" "no SPDX line"
    lines=$(wc -l < "$file")
    [ "$lines" -le 300 ] || breach "$file" "$lines lines, more than 300"
done < <(find shapes ccd tests fuzz bench CMakeLists.txt .ci -type f \
    \( -name '*.h' -o -name '*.cpp' -o -name '*.sh' -o -name '*.cmake*' -o -name CMakeLists.txt -o -path .ci/run \))

# Every include. A layer reaches the folders after its name; what is ours and lies elsewhere is an arrow the other way.
ours="shapes/include shapes/src ccd/include ccd/src tests/support tests tests/consumer fuzz bench"
reach() {
    case $1 in
        shapes/include/*) echo "shapes/include" ;;
        shapes/src/*) echo "shapes/include shapes/src" ;;
        ccd/include/*) echo "shapes/include ccd/include" ;;
        ccd/src/*) echo "shapes/include shapes/src ccd/include ccd/src" ;;
        tests/support/*) echo "shapes/include ccd/include tests/support" ;;
        tests/consumer/*) echo "shapes/include ccd/include tests/consumer" ;;
        tests/*) echo "shapes/include shapes/src ccd/include ccd/src tests/support tests" ;;
        fuzz/*) echo "shapes/include ccd/include tests/support fuzz" ;;
        bench/*) echo "shapes/include ccd/include tests/support bench" ;;
    esac
}
found_in() { # <header> <folder>...: the folders that have it
    local header=$1 folder
    shift
    for folder; do [ ! -e "$folder/$header" ] || echo "$folder"; done
}
while IFS=: read -r file include; do
    checked=$((checked + 1))
    header=$(sed -E 's/.*[<"]([^>"]*)[>"].*/\1/' <<< "$include")
    if [[ $include != *\"* || ! -e ${file%/*}/$header ]]; then
        reached=($(found_in "$header" $(reach "$file")))
        elsewhere=$(found_in "$header" $ours)
        if [ ${#reached[@]} -gt 1 ]; then
            breach "$file" "includes $header, which may be that of ${reached[*]}"
        elif [ ${#reached[@]} -eq 0 ] && [ -n "$elsewhere" ]; then
            breach "$file" "includes $header of $elsewhere: the arrow runs the other way"
        elif [[ ${#reached[@]} -eq 0 && $include == *\"* ]]; then
            breach "$file" "includes \"$header\", which is not there"
        fi
    fi
    case $file:$header in
        shapes/include/*:brink/* | shapes/src/*:brink/* | ccd/include/*:brink/* | ccd/src/*:brink/*) ;;
        shapes/include/*:Eigen/* | shapes/src/*:Eigen/* | ccd/include/*:Eigen/* | ccd/src/*:Eigen/*) ;;
        shapes/*:*/* | ccd/*:*/*) breach "$file" "the library needs Eigen only, not <$header>" ;;
    esac
    case $file in
        ccd/*scene* | ccd/include/brink/ccd.h) ;;
        ccd/*) [[ $header != *scene* && $header != brink/ccd.h ]] || breach "$file" "includes $header: knows scene" ;;
    esac
done < <(grep -rnE --include='*.h' --include='*.cpp' '^ *# *include' shapes ccd tests fuzz bench | sed -E 's/:[0-9]+:/:/')

# The checkout itself on an include path would make FCL's <ccd/ccd.h> ours.
if [ -e "$build/compile_commands.json" ] &&
    grep -qE -- "(-I|-isystem ?)$PWD(/ccd)?/?[ \"]" "$build/compile_commands.json"; then
    breach CMakeLists.txt "the checkout or its ccd/ is on an include path"
fi

[ "$checked" -gt 100 ] || breach house.sh "only $checked files and includes looked at"
echo "house: $checked files and includes looked at, $breaches breaches"
[ "$breaches" -eq 0 ]
