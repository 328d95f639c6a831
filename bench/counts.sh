#!/bin/sh
# counts.sh COMPILER DOUBLE FLOAT TABLE: instructions of the items of bench, in both precisions, as
# valgrind counts them around the calls alone, as CSV on stdout; they are the same in every run.
# Where TABLE was made by the same compiler, a count that grew by more than 5 per cent is named, and
# one that grew by more than 10 is an error.
compiler=$1 table=$4 log=$(mktemp) counts=$(mktemp)
trap 'rm -f "$log" "$counts"' EXIT

count() { # PROGRAM ITEM
    units=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --collect-atstart=no \
        --toggle-collect=counted "$1" --count "$2" 2>"$log") || { cat "$log" >&2 && return 1; }
    sed -n 's/.*Collected : //p' "$log" | awk -v units="$units" '{printf "%.2f", $1 / units}'
}

echo "item,double,float,$compiler" >"$counts"
"$2" --list | while read -r item; do
    a=$(count "$2" "$item") && b=$(count "$3" "$item") && echo "$item,$a,$b" >>"$counts"
done
cat "$counts"
[ -e "$table" ] || exit 0
awk -F, -v table="$table" '
    BEGIN { getline head <table; while ((getline line <table) > 0) {
        n = split(line, a, ","); was[a[1], 2] = a[n - 1]; was[a[1], 3] = a[n] } }
    NR == 1 { same = $0 == head; if (!same) print "not compared: " table " is of another compiler" }
    NR > 1 && same { for (i = 2; i <= 3; i++) if (was[$1, i] > 0 && $i > 1.05 * was[$1, i]) {
        print ($i > 1.1 * was[$1, i] ? "FAIL" : "warning"), $1, was[$1, i], "->", $i
        if ($i > 1.1 * was[$1, i]) bad = 1 } }
    END { exit bad }' "$counts" >&2
