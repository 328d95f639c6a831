#!/bin/sh
# pictures.sh JOIN SMOOTH SEAMS FOLDER: the five inputs before they are joined and after, by every
# method, shaded and in zebra stripes.
join=$1 smooth=$2 seams=$3 dir=$4
set -e
mkdir -p "$dir"
"$seams" "$dir"

# both LOWER UPPER: two OBJ files in one; the normals of neither.
both() {
    awk '$1 == "v" { print; if (NR == FNR) points++ }
         $1 == "f" { for (i = 2; i <= 4; i++) if (NR > FNR) $i += points; print }' "$1" "$2"
}

draw() {
    for view in shaded zebra; do
        "$smooth" "$1" -o "${1%.obj}_$view.png" --view $view --size 300x350 --turn 150 --rise 12 --quiet
    done
}

for lower in "$dir"/*_lower.obj; do
    name=${lower%_lower.obj}
    both "$lower" "${name}_upper.obj" >"${name}_before.obj"
    draw "${name}_before.obj"
    for method in nagata fujita straight; do
        "$join" "$lower" "${name}_upper.obj" -o "$dir/joined.obj" --method $method --rows 9 --quiet
        sed '/^vn/d;s|//[0-9]*||g' "$dir/joined.obj" >"${name}_$method.obj"
        draw "${name}_$method.obj"
    done
done
rm "$dir/joined.obj"
