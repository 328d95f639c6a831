#!/usr/bin/env bash
# programs.sh SMOOTH WRITE_SEEDS COUNT: mutants of the seeds through the whole program, which must
# end soon and in little memory, with its output written or with one line that says why not.
smooth=$1 write_seeds=$2 count=$3 passed=0 failed=0 written=0
dir=$(dirname "$smooth")/programs
rm -rf "$dir"
mkdir -p "$dir/in" "$dir/out"
"$write_seeds" "$dir/in" "$count" || exit 1

# bad FILE WHAT
bad() {
    failed=$((failed + 1))
    echo "FAIL programs: $dir/in/$1 $2"
}

# judge FILE STATUS: of what stands in the folders now.
judge() {
    left=$(cd "$dir/out" && echo *)
    lines=$(wc -l < "$dir/stderr")
    if [ "$2" -gt 1 ]; then
        bad "$1" "ended with $2"
    elif [ "$2" -eq 0 ] && [ "$left" != out.vtu ]; then
        bad "$1" "left $left"
    elif [ "$2" -eq 1 ] && [ "$left" != '*' ]; then
        bad "$1" "was refused, but left $left"
    elif [ "$2" -eq 1 ] && [ "$lines" -ne 1 ]; then
        bad "$1" "was refused in $lines lines"
    elif [ "$2" -eq 1 ] && ! grep -q "^smooth: $dir/in/$1:" "$dir/stderr"; then
        bad "$1" "was refused without its name"
    else
        passed=$((passed + 1)) written=$((written + 1 - $2))
    fi
}

i=0
while [ "$i" -lt "$count" ]; do
    options=(-o "$dir/out/out.vtu" --quiet)
    [ $((i % 3)) -ne 0 ] || options+=(--boundary)
    (
        ulimit -v 1000000
        ulimit -t 10
        exec "$smooth" "$dir/in/$i" "${options[@]}" 2> "$dir/stderr"
    )
    judge "$i" $?
    rm -f "$dir"/out/*
    i=$((i + 1))
done
echo "programs: $written files were written"
echo "programs: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
