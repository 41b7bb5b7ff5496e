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
    mapfile -t lines < "$file"
    [[ ${lines[*]:0:2} = *"SPDX-License-Identifier: BSD-3-Clause"* ]] || breach "$file" "no SPDX line"
    [ ${#lines[@]} -le 300 ] || breach "$file" "${#lines[@]} lines, more than 300"
done < <(find shapes ccd tests fuzz bench CMakeLists.txt .ci/run -type f \
    \( -name '*.h' -o -name '*.cpp' -o -name '*.sh' -o -name '*.cmake*' -o -name CMakeLists.txt -o -path .ci/run \))

# Every include. A layer reaches the folders after its name; what is ours and lies elsewhere is an arrow the other way.
ours="shapes/include shapes/src ccd/include ccd/src tests/support tests tests/consumer fuzz bench"
reach() { # <file>: sets `reach`
    case $1 in
        shapes/include/*) reach="shapes/include" ;;
        shapes/src/*) reach="shapes/include shapes/src" ;;
        ccd/include/*) reach="shapes/include ccd/include" ;;
        ccd/src/*) reach="shapes/include shapes/src ccd/include ccd/src" ;;
        tests/support/*) reach="shapes/include ccd/include tests/support" ;;
        tests/consumer/*) reach="shapes/include ccd/include tests/consumer" ;;
        tests/*) reach="shapes/include shapes/src ccd/include ccd/src tests/support tests" ;;
        fuzz/*) reach="shapes/include ccd/include tests/support fuzz" ;;
        bench/*) reach="shapes/include ccd/include tests/support bench" ;;
    esac
}
find_in() { # <header> <folder>...: sets `found`, the folders that have it
    local header=$1 folder
    shift
    found=()
    for folder; do [ ! -e "$folder/$header" ] || found+=("$folder"); done
}
while IFS=: read -r file mark header; do
    checked=$((checked + 1))
    [[ $header != *..* ]] || breach "$file" "includes $header: climbs out of its folder"
    if [[ $mark = "<" || ! -e ${file%/*}/$header ]]; then
        reach "$file"
        find_in "$header" $reach
        if [ ${#found[@]} -gt 1 ]; then
            breach "$file" "includes $header, which may be that of ${found[*]}"
        elif [ ${#found[@]} -eq 0 ]; then
            find_in "$header" $ours
            if [ ${#found[@]} -gt 0 ]; then
                breach "$file" "includes $header of ${found[*]}: the arrow runs the other way"
            elif [ "$mark" = '"' ]; then
                breach "$file" "includes \"$header\", which is not there"
            fi
        fi
    fi
    case $file:$header in
        shapes/include/*:brink/* | shapes/src/*:brink/* | ccd/include/*:brink/* | ccd/src/*:brink/*) ;;
        shapes/include/*:Eigen/* | shapes/src/*:Eigen/* | ccd/include/*:Eigen/* | ccd/src/*:Eigen/*) ;;
        shapes/src/hull_proposal_qhull.cpp:libqhull_r/*) ;;
        ccd/src/join_wide.cpp:hwy/* | ccd/src/parallel.cpp:tbb/*) ;;
        shapes/*:*/* | ccd/*:*/*) breach "$file" "the library needs Eigen only, not <$header>" ;;
    esac
    case $file in
        ccd/*scene* | ccd/include/brink/ccd.h) ;;
        ccd/src/block* | ccd/src/body_store* | ccd/src/broad_phase* | ccd/src/join* | ccd/src/packet* | \
            ccd/src/place_order* | ccd/src/search* | ccd/src/sweep* | ccd/src/unbounded*) ;; # a scene's own
        ccd/*)
            case $header in
                *scene* | brink/ccd.h | block*.h | body_store.h | broad_phase.h | join.h | packet.h | place_order.h | \
                    search.h | sweep.h | unbounded.h) breach "$file" "includes $header: knows scene" ;;
            esac ;;
    esac
done < <(grep -rE --include='*.h' --include='*.cpp' '^ *# *include *[<"]' shapes ccd tests fuzz bench |
    sed -E 's/^([^:]*):[^<"]*([<"])([^>"]*).*/\1:\2:\3/')

# The checkout itself on an include path would make FCL's <ccd/ccd.h> ours.
if [ -e "$build/compile_commands.json" ] &&
    grep -qE -- "(-I|-isystem ?)$PWD(/ccd)?/?[ \"]" "$build/compile_commands.json"; then
    breach CMakeLists.txt "the checkout or its ccd/ is on an include path"
fi

[ "$checked" -gt 100 ] || breach house.sh "only $checked files and includes looked at"
echo "house: $checked files and includes looked at, $breaches breaches"
[ "$breaches" -eq 0 ]
