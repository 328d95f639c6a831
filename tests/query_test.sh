#!/bin/sh
# query_test.sh RAY GAP DEMO_MESH: the programs that ask patches.
ray=$1 gap=$2 demo=$3 suite=query program=$1
. tests/check.sh

exits() { # STATUS COMMAND...
    want=$1
    shift
    "$@" >"$dir/out" 2>"$dir/err"
    [ $? -eq "$want" ]
}

# The finest meshes of the table: flat triangles are a hundredth off, the arc rule's patches not a
# millionth.
"$gap" >"$dir/gaps"
check "six rows of gaps" [ "$(grep -c ', [0-9]* | [0-9.e-]* | [0-9.e-]* | [0-9.e-]* |$' \
    "$dir/gaps")" -eq 6 ]
check "flat gaps" [ "$(grep -c '| 512, 512 | 1\..e-02 |' "$dir/gaps")" -eq 2 ]
check "smooth gaps" [ "$(grep -c '| 512, 512 .*e-0[78] |$' "$dir/gaps")" -eq 2 ]

"$demo" >"$dir/in.obj"
check "a picture" exits 0 "$ray" "$dir/in.obj" "$dir/a.png" 64
check "is a PNG file" [ "$(dd if="$dir/a.png" bs=1 skip=1 count=3 2>/dev/null)" = PNG ]
check "the same again" exits 0 "$ray" "$dir/in.obj" "$dir/b.png" 64
check "byte for byte" cmp "$dir/a.png" "$dir/b.png"
check "usage" exits 2 "$ray"
check "a name that is no picture's" exits 2 "$ray" "$dir/in.obj" "$dir/c.obj"
check "a size that is none" exits 2 "$ray" "$dir/in.obj" "$dir/c.png" 64x
check "a mesh that is not there" exits 1 "$ray" "$dir/none.obj" "$dir/c.png"
check "is named" grep -q "none.obj" "$dir/err"
echo 'v 0 0 0' >"$dir/point.obj"
check "a mesh without triangles" exits 1 "$ray" "$dir/point.obj" "$dir/c.png"
check "no picture of it" [ ! -e "$dir/c.png" ]
verdict
