#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What brink-bench says of a folder of results is what its CSVs hold: report.sh <folder of results> <brink-bench>
# Measures nothing: the results are those that are committed.
set -euo pipefail
results=$1
bench=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$results"/* "$work"
page=$work/report.html
failed=0

check() { # <what> <command>...
    local what=$1
    shift
    if "$@" > "$work/said" 2>&1; then return; fi
    echo "WRONG: $what"
    tail -n 5 "$work/said"
    failed=1
}

exits_with() { # <code> <text it must say> <command>...
    local code=$1 text=$2 rc=0
    shift 2
    "$@" > "$work/out" 2>&1 || rc=$?
    [ "$rc" = "$code" ] && grep -q -- "$text" "$work/out" && return
    echo "exit code $rc, said:"
    tail -n 5 "$work/out"
    return 1
}

# The rows of a table of the page, cells between tabs.
rows_of() { # <id>
    sed -n "/<table id=\"$1\">/,/<\/table>/p" "$page" | sed -nE 's/^<tr[^>]*><td>(.*)<\/td><\/tr>$/\1/p' |
        sed 's/<\/td><td>/\t/g; s/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&amp;/\&/g'
}

# One number each of question, who, ns and spread: the same whoever wrote them.
plain() { awk -F '\t' '{ printf "%s\t%s\t%.9g\t%.9g\n", $1, $2, $3, $4 }' | sort; }

same_as_pairs_csv() {
    [ "$(rows_of figures-pairs | wc -l)" -gt 20 ] || return 1
    diff <(rows_of figures-pairs | plain) <(awk -F, '$4 == "mixed" {
        who = $3 == "baseline" ? "brink" : $3 == "FCL" ? "FCL" : "brink " $3
        printf "%s%s\t%s\t%s\t%s\n", $1, $2 == "none" ? " straight" : " turning to " $2, who, $5, $6
    }' "$work/pairs.csv" | plain)
}

# ns, errors and counts of every row of error.csv, in order.
same_as_error_csv() {
    diff <(rows_of figures-error | awk -F '\t' '{ printf "%.9g %.9g %s %s %s\n", $3, $4, $8, $9, $11 }') \
        <(awk -F, 'NR > 1 { printf "%.9g %.9g %s %s %s\n", $7, $8, $13, $14, $15 }' "$work/error.csv")
}

# The geometric mean of FCL's time over brink's, told anew from the CSV.
same_mean() {
    local shown told
    shown=$(rows_of summary | awk -F '\t' '$1 == "pairs" && $2 == "FCL" { print $5 }')
    told=$(awk -F, '$4 == "mixed" && $3 == "baseline" { brink[$1 $2] = $5 } $4 == "mixed" && $3 == "FCL" { fcl[$1 $2] = $5 }
        END { for (q in fcl) if (q in brink) { sum += log(fcl[q] / brink[q]); n++ } printf "%.3g", exp(sum / n) }' "$work/pairs.csv")
    echo "shown $shown, told $told"
    [ -n "$shown" ] && [ "$shown" = "$told" ]
}

pictures_present() {
    local there shown
    there=$(find "$work" -name '*.svg' | wc -l)
    shown=$(grep -c '<img alt="[^"]\+" src="data:image/svg+xml,%3C' "$page")
    echo "$there pictures in the folder, $shown in the page"
    [ "$there" = "$shown" ]
}

# Nothing is fetched from elsewhere.
on_its_own() { ! grep -E '(src|href)="(http|//|[a-z_]+\.)' "$page"; }

measured_nothing() { for csv in "$results"/*.csv; do cmp "$csv" "$work/$(basename "$csv")"; done; }

check "all --go-on" "$bench" all --go-on --out "$work"
check "all --go-on measures what is there already" measured_nothing
check "figures of pairs" same_as_pairs_csv
check "figures of error" same_as_error_csv
check "the summary's mean" same_mean
check "pictures" pictures_present
check "the page needs other files" on_its_own

check "the same compared" exits_with 0 "Nothing got slower or less exact" "$bench" compare "$results" "$work"
awk -F, -v OFS=, '$1 == "box-box" && $3 == "baseline" { $5 = 4 * $5 } { print }' "$results/pairs.csv" > "$work/pairs.csv"
check "slower boxes" exits_with 1 "box-box.*slower, 4.00 times" "$bench" compare "$results" "$work"
awk -F, -v OFS=, '$3 == "brink" { $13 = $13 + 1 } { print }' "$results/error.csv" > "$work/error.csv"
check "more missed" exits_with 1 "more missed: 0 of" "$bench" compare "$results" "$work"
head -c 3000 "$results/pairs.csv" > "$work/pairs.csv"
check "a CSV cut off" exits_with 2 "pairs.csv" "$bench" compare "$results" "$work"
check "no results" exits_with 2 "no CSV" "$bench" compare "$results" /proc
check "an unknown part" exits_with 2 "tunnelling" "$bench" speed
check "an unknown option" exits_with 2 "colour" "$bench" pairs --colour
check "an unwritable folder" exits_with 2 "cannot write to the folder" "$bench" pairs --out /proc/nowhere
exit "$failed"
