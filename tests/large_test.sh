#!/usr/bin/env bash
# large_test.sh SMOOTH DEMO_MESH: two million triangles go through smooth in less than 2 GiB; what
# each kind of work takes is told.
smooth=$1 demo_mesh=$2 passed=0 failed=0
dir=$(dirname "$smooth")/large_test
rm -rf "$dir"
mkdir -p "$dir"
"$demo_mesh" > "$dir/demo.obj"
"$smooth" "$dir/demo.obj" -n 95 -o "$dir/in.stl" --quiet || exit 1
ulimit -v 2097152 # KiB
for options in '-n 1 -o out.stl' '--crease 180 -o out.vtu' '--tol 0.01% -o out.vtu'; do
    out=$dir/${options##* }
    echo "smooth in.stl $options"
    if "$smooth" "$dir/in.stl" ${options% *} "$out" --quiet --times 2>&1 && [ -s "$out" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL large: $options"
    fi
    rm -f "$out"
done
rm -rf "$dir"
echo "large: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
