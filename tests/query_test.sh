#!/bin/sh
# query_test.sh RAY GAP DEMO_MESH: the programs that ask patches.
ray=$1 gap=$2 demo=$3 passed=0 failed=0
scratch=${TMPDIR:-/tmp}/query_test.$$
mkdir -m 700 "$scratch"
trap 'rm -rf "$scratch"' EXIT

check() { # WHAT COMMAND...
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        echo "FAIL $what: $*"
        failed=$((failed + 1))
    fi
}

exits() { # STATUS COMMAND...
    want=$1
    shift
    "$@" >"$scratch/out" 2>"$scratch/err"
    [ $? -eq "$want" ]
}

# The finest meshes of the table: flat triangles are a hundredth off, the arc rule's patches not a
# millionth.
"$gap" >"$scratch/gaps"
check "six rows of gaps" [ "$(grep -c ', [0-9]* | [0-9.e-]* | [0-9.e-]* | [0-9.e-]* |$' \
    "$scratch/gaps")" -eq 6 ]
check "flat gaps" [ "$(grep -c '| 512, 512 | 1\..e-02 |' "$scratch/gaps")" -eq 2 ]
check "smooth gaps" [ "$(grep -c '| 512, 512 .*e-0[78] |$' "$scratch/gaps")" -eq 2 ]

"$demo" >"$scratch/in.obj"
check "a picture" exits 0 "$ray" "$scratch/in.obj" "$scratch/a.png" 64
check "is a PNG file" [ "$(dd if="$scratch/a.png" bs=1 skip=1 count=3 2>/dev/null)" = PNG ]
check "the same again" exits 0 "$ray" "$scratch/in.obj" "$scratch/b.png" 64
check "byte for byte" cmp "$scratch/a.png" "$scratch/b.png"
check "usage" exits 2 "$ray"
check "a name that is no picture's" exits 2 "$ray" "$scratch/in.obj" "$scratch/c.obj"
check "a size that is none" exits 2 "$ray" "$scratch/in.obj" "$scratch/c.png" 64x
check "a mesh that is not there" exits 1 "$ray" "$scratch/none.obj" "$scratch/c.png"
check "is named" grep -q "none.obj" "$scratch/err"
echo 'v 0 0 0' >"$scratch/point.obj"
check "a mesh without triangles" exits 1 "$ray" "$scratch/point.obj" "$scratch/c.png"
check "no picture of it" [ ! -e "$scratch/c.png" ]
echo "query: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
