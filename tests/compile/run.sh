#!/bin/sh
# run.sh DIRECTORY, from the top of the project: the headers alone, in every dialect of CC and CXX
# and in both precisions, with the strictest warnings as errors; then twice in one file, in several
# files of one program, in both precisions in one program, and without a C library.
cc=${CC:-cc} cxx=${CXX:-c++} out=$1
strict="-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion
    -Wfloat-equal -Werror -I."
every="-Weverything -Wno-padded -Wno-declaration-after-statement"
passed=0 failed=0

check() {
    what=$1
    shift
    if "$@" >"$out/log" 2>&1; then
        passed=$((passed + 1))
    else
        echo "FAIL $what: $*"
        head -n 20 "$out/log"
        failed=$((failed + 1))
    fi
}

# A file that includes the headers twice and takes the address of every public function.
headers='nagata3.h examples/brown/brown.h examples/join/join.h'
every_function() {
    printf '#include "%s"\n' $headers $headers
    printf 'typedef void (*function)(void);\nextern const function functions[];\n'
    printf 'const function functions[] = {\n'
    for prefix in n3 brown join; do
        cat $headers |
            sed -n "s/^NAGATA3_API [^(]*[ *]\(${prefix}_[a-z0-9_]*\)(.*/    (function)\1,/p" |
            sort -u
    done
    printf '};\n'
}

# What the object of that file still needs are these four functions at most.
freestanding() {
    $cc -std=c99 $strict "$@" -ffreestanding -fno-stack-protector -c "$out/all.c" -o "$out/all.o" &&
        nm -u "$out/all.o" >"$out/undefined" &&
        ! grep -vwE 'sqrt|fabs|memcpy|memset' "$out/undefined"
}

# Two files in double and one in float, with the compiler and the flags given.
one_program() {
    "$@" $strict -c tests/compile/part.c -o "$out/double.o" &&
        "$@" $strict -DNAGATA3_FLOAT -c tests/compile/part.c -o "$out/float.o" &&
        "$@" $strict -c tests/compile/main.c -o "$out/main.o" &&
        "$@" -x none "$out/main.o" "$out/double.o" "$out/float.o" -o "$out/main" -lm &&
        "$out/main"
}

mkdir -p "$out"
every_function >"$out/all.c"
clang=$($cc --version | grep -c clang)
for precision in -UNAGATA3_FLOAT -DNAGATA3_FLOAT; do
    object="$strict $precision -c $out/all.c -o $out/all.o"
    for dialect in c99 c11 c17 c2x; do
        check "$dialect" $cc -std=$dialect $object
    done
    for dialect in c++98 c++11 c++14 c++17 c++20; do
        check "$dialect" $cxx -x c++ -std=$dialect $object
    done
    [ "$clang" -eq 0 ] || check 'every warning' $cc -std=c99 $every $object
    check freestanding freestanding $precision -O1
    check 'freestanding, optimised' freestanding $precision -O3
done
check 'one program in C' one_program $cc -std=c99
check 'one program in C++98' one_program $cxx -x c++ -std=c++98
check 'one program in C++17' one_program $cxx -x c++ -std=c++17
[ "$clang" -ne 0 ] || check 'one program, linked as a whole' one_program $cxx -x c++ -O2 -flto -Wodr
echo "dialects of $cc and $cxx: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
