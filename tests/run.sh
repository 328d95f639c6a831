#!/bin/sh
# run.sh COMMAND...: runs the commands side by side, shows what they say in order, adds up what
# their last lines, '... N passed, M failed', say and prints the sum. A command that says nothing
# of the kind, or that ends badly without a failure to show for it, counts as one failure.
number='\([0-9]\{1,\}\)'
verdict="s/^/ /;s/.*[^0-9]$number passed, $number failed\$/\1 \2/p"
passed=0 failed=0
outputs=$(mktemp -d) || exit 1
trap 'rm -rf "$outputs"' EXIT
trap 'exit 1' HUP INT TERM
i=0
for command; do
    i=$((i + 1))
    { sh -c "$command"; echo $? >"$outputs/$i.status"; } >"$outputs/$i" 2>&1 &
done
wait
i=0
for command; do
    i=$((i + 1))
    status=$(cat "$outputs/$i.status")
    cat "$outputs/$i"
    last=$(tail -n 1 "$outputs/$i" | sed -n "$verdict")
    n=${last% *} m=${last#* }
    if [ -z "$last" ] || { [ "$status" -ne 0 ] && [ "$m" -eq 0 ]; }; then
        echo "$command: exit status $status"
        m=$((${m:-0} + 1))
    fi
    passed=$((passed + ${n:-0})) failed=$((failed + m))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
