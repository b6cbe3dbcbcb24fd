#!/bin/sh
# Instructions per dyad of every stage, counted by valgrind, for chains of so many dyads: all stages are linear if a row has the
# same number everywhere. Dyads RRR are rockers side by side; with `mixed` every second dyad is RRP.
#
#     benches/chains.sh [10 100 1000 …]
#     benches/chains.sh text 50000 > chain.mech        (a chain alone)
set -eu
cd "$(dirname "$0")/.."

# A chain: dyads, how the crank moves, rrr or mixed, what is written behind hinges.
text() {
    awk -v n="$1" -v drive="${2:-60 deg at 60 rpm}" -v kind="${3:-rrr}" -v hinge="${4:-}" 'BEGIN {
        print "mech 1\nmechanism \"Rockers in a row\"\nground {"
        for (i = 0; i <= n; i++) printf "  O%d (%d mm, 0)\n", i, 100 * i
        if (kind == "mixed") print "  H (0, 50 mm * sin(60 deg))\n  line way through H along 0 deg"
        print "}\nlink r0 O0-T0 50 mm\nrevolute O0: ground - r0\ndrive r0 = " drive
        for (i = 1; i <= n; i++) {
            b = i - 1
            printf "// dyad %d\ngiven l%d = 100 mm\nlet h%d = l%d / 2\n", i, i, i, i
            printf "link k%d T%d-T%d l%d\nrevolute T%d: r%d - k%d%s\n", i, b, i, i, b, b, i, hinge
            if (kind == "mixed" && i % 2) {
                printf "link r%d { T%d (0, 0); mass 1 kg at T%d; inertia 0.1 kg*m^2 }\n", i, i, i
                printf "prismatic O%d: r%d.T%d - ground.way\nassemble T%d ahead of T%d\n", i, i, i, i, b
            } else {
                printf "link r%d O%d-T%d h%d { S (h%d/2, 0); mass 1 kg at S; inertia 0.1 kg*m^2 }\n", i, i, i, i, i
                printf "revolute O%d: ground - r%d%s\nassemble U%d left of T%d-O%d\n", i, i, hinge, i, b, i
            }
            printf "revolute U%d: k%d.T%d - r%d.T%d%s\n", i, i, i, i, i, hinge
        }
        print "torque M on r" n " = 1 N*m cw\nbalance torque Mb on r0\nfind reactions, Mb"
    }'
}

if [ "${1:-}" = text ]; then
    shift
    text "$@"
    exit
fi

CARGO_PROFILE_RELEASE_DEBUG=line-tables-only cargo build --quiet --release --bin assur
program=${CARGO_TARGET_DIR:-target}/release/assur
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count() {
    valgrind --tool=callgrind --callgrind-out-file="$folder/out" "$program" "$@" > "$folder/answers" 2> "$folder/log"
    callgrind_annotate --inclusive=yes --threshold=100 "$folder/out" 2> /dev/null | sed 's/,//g' > "$folder/profile"
}

# Instructions within these functions, from the last count.
within() {
    total=0
    for function in "$@"; do
        one=$(awk -v f=":$function" '{ at = index($0, f); rest = substr($0, at + length(f), 1) }
            at && (rest == " " || rest == "") && $1 > most { most = $1 } END { printf "%.0f\n", most }' "$folder/profile")
        total=$((total + one))
    done
    echo "$total"
}

rows() {
    n=$1
    row() { echo "$n|$2|$(($3 / n))" >> "$folder/$1"; }
    text "$n" > "$folder/chain.mech"
    count solve "$folder/chain.mech"
    row table 'parse' "$(within assur_syntax::parse)"
    row table 'check' "$(within assur_check::check)"
    row table 'structure' "$(within assur_model::structure::structure)"
    row table 'plan' "$(within assur_position::plan::plan)"
    one=$(within assur::pipeline::solved::solve_conducted)
    row table 'first position' "$one"
    row table 'report: table' "$(within assur::report::of_answers assur::cli::solve::Printing::page)"
    count solve "$folder/chain.mech" --format json
    row table 'report: JSON' "$(within assur::cli::solve::json)"
    count solve "$folder/chain.mech" --format csv
    lines=assur::report::lines::CsvLines
    row table 'report: CSV' "$(within $lines::of $lines::header $lines::begin $lines::add)"
    text "$n" '60 deg .. 90 deg in 10 steps at 60 rpm' > "$folder/chain.mech"
    count solve "$folder/chain.mech"
    row table 'a position more' "$((($(within assur::pipeline::solved::solve_conducted) - one) / 10))"
}

[ $# -gt 0 ] || set -- 10 100 1000
for n in "$@"; do rows "$n"; done
awk -F'|' '!($1 in seen) { seen[$1]; sizes[++columns] = $1 } !($2 in at) { at[$2]; names[++rows] = $2 } { cell[$2, $1] = $3 }
    END {
        printf "| instructions per dyad |"; for (c = 1; c <= columns; c++) printf " %s |", sizes[c]
        printf "\n| --- |"; for (c = 1; c <= columns; c++) printf " --- |"
        for (r = 1; r <= rows; r++) { printf "\n| %s |", names[r]; for (c = 1; c <= columns; c++) printf " %s |", cell[names[r], sizes[c]] }
        print ""
    }' "$folder/table"
