#!/bin/sh
# ledger.sh: every equation that nagata3.h cites, as (5.1.13) or in a range (3.1.5)-(3.1.7), has its
# test TEST(eq_5_1_13) in tests/equations.c, and every such test its citation.
set -eu
LC_ALL=C
export LC_ALL
cd "$(dirname "$0")/.."

# One number or range on a line: what stands between parentheses, ranges joined first.
cited() {
    sed -e 's/\([0-9]\)) *- *(\([0-9]\)/\1-\2/g' -e 'y/()/\n\n/' nagata3.h |
        sed -n '/^[0-9]\.[0-9]\.[0-9][-0-9.]*[ab]\{0,1\}$/p'
}

# 3.1.5-3.1.7 becomes 3.1.5, 3.1.6, 3.1.7.
expand() {
    while read -r number; do
        case $number in
        *-*)
            first=${number%-*} last=${number#*-}
            [ "${first%.*}" = "${last%.*}" ] || {
                echo "ledger: the range ($first)-($last) crosses sections" >&2
                exit 1
            }
            i=${first##*.}
            while [ "$i" -le "${last##*.}" ]; do
                echo "${first%.*}.$i"
                i=$((i + 1))
            done
            ;;
        *) echo "$number" ;;
        esac
    done
}

tested() {
    sed 'y/()_/\n\n./' tests/equations.c |
        sed -n 's/^eq\.\([0-9]\.[0-9]\.[0-9][0-9]*[ab]\{0,1\}\)$/\1/p'
}

scratch=${TMPDIR:-/tmp}/ledger.$$
mkdir -m 700 "$scratch"
trap 'rm -rf "$scratch"' EXIT
cited >"$scratch/numbers"
expand <"$scratch/numbers" >"$scratch/expanded"
sort -u "$scratch/expanded" >"$scratch/cited"
tested | sort -u >"$scratch/tested"
comm -23 "$scratch/cited" "$scratch/tested" | sed 's/.*/cited in nagata3.h, but not tested: (&)/'
comm -13 "$scratch/cited" "$scratch/tested" | sed 's/.*/tested, but not cited in nagata3.h: (&)/'
cmp -s "$scratch/cited" "$scratch/tested" || exit 1
[ -s "$scratch/cited" ]
echo "$(sed -n '$=' "$scratch/cited") equations cited, and as many tests"
