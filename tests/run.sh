#!/bin/sh
# run.sh COMMAND...: runs each command, adds up what their last lines, '... N passed, M failed',
# say and prints the sum. A command that says nothing of the kind, or that ends badly without a
# failure to show for it, counts as one failure.
number='\([0-9]\{1,\}\)'
verdict="s/^/ /;s/.*[^0-9]$number passed, $number failed\$/\1 \2/p"
passed=0 failed=0
for command; do
    output=$(sh -c "$command")
    status=$?
    [ -z "$output" ] || printf '%s\n' "$output"
    last=$(printf '%s\n' "$output" | tail -n 1 | sed -n "$verdict")
    n=${last% *} m=${last#* }
    if [ -z "$last" ] || { [ "$status" -ne 0 ] && [ "$m" -eq 0 ]; }; then
        echo "$command: exit status $status"
        m=$((${m:-0} + 1))
    fi
    passed=$((passed + ${n:-0})) failed=$((failed + m))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
