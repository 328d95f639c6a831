#!/bin/sh
# check.sh: what the scripts of tests share. They set suite, their name, and program, what they
# test, and find an empty folder of their own beside it, dir. At the end they call verdict.
passed=0 failed=0
dir=$(dirname "${program:?}")/${suite:?}_test
rm -rf "$dir"
mkdir -p "$dir"

# check NAME COMMAND...: the command succeeds.
check() {
    name=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $suite: $name"
    fi
}

# same NAME GOT WANT
same() {
    [ "$2" = "$3" ] || printf '    got\n%s\n    want\n%s\n' "$2" "$3"
    check "$1" [ "$2" = "$3" ]
}

verdict() {
    echo "$suite: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}
