#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Parts sources into batches to compile as one, since most of the time goes to headers that they share:
# batches.sh <folder> <source>... writes the batches there and prints the sources in them.
# Two sources may share a batch if neither says a name that is the other's own (of its unnamed namespaces and using
# declarations), if no header of ours that only one of them includes declares one that is the other's own or defines a
# type whose name the other says, and if they have the same using directives; what defines macros or specializes
# templates stays alone. This looks at words, not at C++: it relies on clang-format, which puts what a file declares in
# the first column, and where it errs the compiler says so.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1
shift
most=2000 # lines of a batch: what keeps two compilers busy
mkdir -p "$folder/new"
find shapes ccd tests fuzz bench -name '*.h' ! -name '*-inl.h' | xargs awk -v folder="$folder/new" -v most="$most" -v root="$PWD" '
    function absolute(path) { return path ~ /^\// ? path : root "/" path }
    function base(path) { sub(/.*\//, "", path); return path }
    function first_word(text) { return match(text, /[A-Za-z_][A-Za-z_0-9]*/) ? substr(text, RSTART, RLENGTH) : "" }
    function last_word(text) { return match(text, /[A-Za-z_][A-Za-z_0-9]*[^A-Za-z_0-9]*$/) ? first_word(substr(text, RSTART)) : "" }
    function declare(name) {
        if (name == "") return
        declares[file, name] = 1
        names[file, ++count[file]] = name
    }
    function own(name) { owns[file, name] = 1; declare(name) }
    function declaration(text) { # what begins in the first column
        sub(/^(template <.*> |\[\[[^]]*\]\] )/, "", text)
        if (text ~ /operator/) own("operator")
        else if (sub(/^(struct|class|union|enum class|enum) /, "", text)) {
            own(first_word(text))
            if (text !~ /;$/) types[file] = types[file] " " first_word(text)
        }
        else if (match(text, /[^A-Za-z_0-9:<>&*, ]/)) {
            own(last_word(substr(text, 1, RSTART - 1)))
            while (match(text, /, [A-Za-z_0-9]+ ?[={]/)) { # const double a = 1, b = 2
                own(first_word(substr(text, RSTART)))
                text = substr(text, RSTART + RLENGTH)
            }
        }
    }

    FNR == 1 {
        is_header = FILENAME ~ /\.h$/
        file = is_header ? base(FILENAME) : FILENAME
        if (!is_header) source[++sources] = file
        else if (file in path) path[file] = "" # of two headers
        else path[file] = FILENAME
        unnamed = is_header
    }
    { lines[file]++ }
    /^ *# *include/ {
        split($0, parts, /["<>]/)
        includes[file] = includes[file] " " base(parts[2])
        next
    }
    /^ *# *define|^template <>/ { alone[file] = 1 }
    /^namespace [{]/ { unnamed = 1; next }
    /^[}] \/\/ namespace$/ { unnamed = is_header; next }
    {
        gsub(/\\./, "")
        gsub(/"[^"]*"/, "")
        sub(/ *\/\/.*/, "")
        if (/^using (namespace|enum)/) directives[file] = directives[file] $0
        else if (/^using [^=]*$/) { uses[file, last_word($0)] = 1; declare(last_word($0)) }
        else if (unnamed && /^[A-Za-z_[]/ && !/^(namespace|static_assert|template <.*>$)/) declaration($0)
        gsub(/(\.|->|[A-Za-z_0-9]+::)[A-Za-z_0-9]+/, " ")
        words = split($0, word, /[^A-Za-z_0-9]+/)
        for (i = 1; i <= words; ++i) says[file, word[i]] = 1
    }

    function reach(file, from,    parts, many, i) { # every header of ours that a file includes
        many = split(includes[from], parts, " ")
        for (i = 1; i <= many; ++i)
            if (parts[i] in path && path[parts[i]] != "" && !((file, parts[i]) in reached)) {
                reached[file, parts[i]] = 1
                headers[file] = headers[file] " " parts[i]
                reach(file, parts[i])
            }
    }
    function strange_types(a, b,    i, many, parts, out) { # of headers of a that b does not include
        many = split(headers[a], parts, " ")
        for (i = 1; i <= many; ++i) if (!((b, parts[i]) in reached)) out = out types[parts[i]]
        return out
    }
    function disturbs(a, b,    i, k, name, parts, many) { # whether a name of a or of a header of its is another to b
        many = split(strange_types(a, b), parts, " ")
        for (i = 1; i <= many; ++i) if ((b, parts[i]) in says) return 1
        many = split(headers[b], parts, " ")
        for (i = 1; i <= count[a]; ++i) {
            name = names[a, i]
            if (((a, name) in owns || !((a, name) in uses)) && ((b, name) in says || (b, name) in uses)) return 1
            for (k = 1; k <= many; ++k)
                if (!((a, parts[k]) in reached) && (parts[k], name) in declares) return 1
        }
        return 0
    }
    function fits(file, batch,    i) {
        if (file in alone || size[batch] + lines[file] > most) return 0
        for (i = 1; i <= members[batch]; ++i)
            if (directives[file] != directives[member[batch, i]] || disturbs(file, member[batch, i]) ||
                disturbs(member[batch, i], file))
                return 0
        return 1
    }
    function write(batch,    out, i, k, parts, many, done) { # all headers come before the first name of a source
        out = folder "/batch_" batch ".cpp"
        print "// SPDX-License-Identifier: BSD-3-Clause" > out
        for (i = 1; i <= members[batch]; ++i) {
            many = split(headers[member[batch, i]], parts, " ")
            for (k = 1; k <= many; ++k)
                if (!((batch, parts[k]) in done)) {
                    done[batch, parts[k]] = 1
                    printf "#include \"%s\"\n", absolute(path[parts[k]]) > out
                }
        }
        for (i = 1; i <= members[batch]; ++i) {
            printf "#include \"%s\"\n", absolute(member[batch, i]) > out
            print member[batch, i]
        }
        close(out)
    }
    END {
        for (s = 1; s <= sources; ++s) {
            file = source[s]
            reach(file, file)
            for (batch = 1; batch <= batches && !fits(file, batch); ++batch);
            if (batch > batches) batches = batch
            member[batch, ++members[batch]] = file
            size[batch] += file in alone ? most : lines[file]
        }
        for (batch = 1; batch <= batches; ++batch) if (members[batch] > 1) write(batch)
    }
' "$@"
# What is as it was is not to be compiled again.
for batch in "$folder"/batch_*.cpp; do [ -e "$folder/new/${batch##*/}" ] || rm -f "$batch"; done
for batch in "$folder"/new/*; do
    if cmp -s "$batch" "$folder/${batch##*/}"; then rm "$batch"; elif [ -e "$batch" ]; then mv "$batch" "$folder"; fi
done
rmdir "$folder/new"
