#!/bin/sh
# pictures_test.sh SMOOTH DEMO_MESH: what smooth draws, run from the top of the project.
smooth=$1 demo_mesh=$2 suite=pictures program=$1
. tests/check.sh
"$demo_mesh" > "$dir/demo.obj"

draw() {
    "$smooth" "$@" --quiet --size 160x120 && return
    failed=$((failed + 1))
    echo "FAIL pictures: smooth $*" >&2
}
sum() { cksum < "$1"; }
differ() { ! cmp -s "$1" "$2"; }

# ---- Sizes, in bytes 17 to 24 of the file. ----
"$smooth" "$dir/demo.obj" -o "$dir/large.png" --quiet
same '800 by 600' "$(od -An -tu1 -j16 -N8 "$dir/large.png" | tr -s ' ')" ' 0 0 3 32 0 0 2 88'
"$smooth" "$dir/demo.obj" -o "$dir/wide.PNG" --quiet --size 300x16
same '300 by 16' "$(od -An -tu1 -j16 -N8 "$dir/wide.PNG" | tr -s ' ')" ' 0 0 1 44 0 0 0 16'
check 'the demonstration takes at most 50 KB' [ "$(wc -c < "$dir/large.png")" -lt 50000 ]

# ---- Every view and every rule has a picture of its own. ----
for view in shaded zebra isophote mean gauss net error; do
    draw "$dir/demo.obj" -o "$dir/$view.png" --view $view
    sum "$dir/$view.png"
done > "$dir/sums"
same 'the seven views differ' "$(sort -u "$dir/sums" | wc -l | tr -d ' ')" 7
for rule in flat nagata pn paper arc fit; do
    draw "$dir/demo.obj" -o "$dir/$rule.png" --view zebra --rule $rule
    sum "$dir/$rule.png"
done > "$dir/sums"
same 'the six rules differ' "$(sort -u "$dir/sums" | wc -l | tr -d ' ')" 6
check 'the same again is the same' cmp -s "$dir/zebra.png" "$dir/paper.png"
check 'shaded is the default' sh -c '"$1" "$2/demo.obj" -o "$2/plain.png" --quiet --size 160x120 &&
    cmp -s "$2/plain.png" "$2/shaded.png"' sh "$smooth" "$dir"

# ---- The camera. ----
# A turn by 90 degrees shows the same of the bottle, which is the same from all four sides, but for
# its mesh; half a turn and half a turn are none.
for option in '--turn 50' '--rise 60' '--zoom 2' '--up x' '--up y'; do
    # shellcheck disable=SC2086
    draw "$dir/demo.obj" -o "$dir/moved.png" $option
    check "$option moves it" differ "$dir/moved.png" "$dir/shaded.png"
done
draw "$dir/demo.obj" -o "$dir/a.png" --turn 180
draw "$dir/demo.obj" -o "$dir/b.png" --turn -180
check 'half turns to either side are the same' cmp -s "$dir/a.png" "$dir/b.png"
sed 's/^\(v[n]*\) \([^ ]*\) \([^ ]*\) \([^ ]*\)/\1 \4 \2 \3/' "$dir/demo.obj" > "$dir/x.obj"
draw "$dir/x.obj" -o "$dir/x.png" --up x
check 'with the axes in turn, x is up' cmp -s "$dir/x.png" "$dir/shaded.png"

# ---- Sizes of the mesh do not matter: powers of 2 change no bit of the picture. ----
awk '$1 == "v" { printf "v %.17g %.17g %.17g\n", $2 * 1024, $3 * 1024, $4 * 1024; next } 1' \
    "$dir/demo.obj" > "$dir/scaled.obj"
draw "$dir/scaled.obj" -o "$dir/scaled.png" --view zebra
check 'a thousand times as large' cmp -s "$dir/scaled.png" "$dir/zebra.png"
for unit in e-130 e130; do
    awk -v u=$unit '$1 == "v" { print "v", $2 u, $3 u, $4 u; next } 1' "$dir/demo.obj" \
        > "$dir/scaled.obj"
    draw "$dir/scaled.obj" -o "$dir/scaled.png" --view gauss
    check "in units of 1$unit" [ -s "$dir/scaled.png" ]
done

# ---- Dirty meshes have pictures too. ----
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n' > "$dir/line.obj"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 1 0 0\nvn 0 1 0\nf 1//1 2//2 3//3\n' > "$dir/odd.obj"
for mesh in line odd; do
    for view in shaded zebra mean gauss net error; do
        draw "$dir/$mesh.obj" -o "$dir/$mesh.png" --view $view
        check "$mesh, $view" [ -s "$dir/$mesh.png" ]
    done
done

# ---- The page: whole, and no name can end its script. ----
cp "$dir/demo.obj" "$dir/<b>\"demo.obj"
for mesh in '<b>"demo' scaled line odd; do
    draw "$dir/$mesh.obj" -o "$dir/page.html"
    check "the page of $mesh is whole" [ "$(tail -n 1 "$dir/page.html")" = '</html>' ]
    same "marks left in the page of $mesh" "$(grep -c '@MODEL@\|@STILL@\|<b>\|: -*nan\|: -*inf' \
        "$dir/page.html")" 0
done
draw "$dir/demo.obj" -o "$dir/page.html" --view net --rule arc --up y
check 'the page opens as asked for' grep -q '"rule": "arc", "view": "shaded", "show": \["net"\].*"axes": \[2, 0, 1\]' \
    "$dir/page.html"

# ---- Usage. ----
misuse() {
    "$smooth" "$dir/demo.obj" "$@" > "$dir/stdout" 2> "$dir/stderr"
    same "status of: $*" $? 2
    check "usage after: $*" grep -q '^usage: smooth' "$dir/stderr"
}
misuse -o "$dir/no.png" --view stripes
misuse -o "$dir/no.png" --view
misuse -o "$dir/no.png" --size 800
misuse -o "$dir/no.png" --size 800x
misuse -o "$dir/no.png" --size 15x600
misuse -o "$dir/no.png" --size 800x16385
misuse -o "$dir/no.png" --size 99999999999999999999x600
misuse -o "$dir/no.png" --size 800x600x3
misuse -o "$dir/no.png" --rise 91
misuse -o "$dir/no.png" --turn nan
misuse -o "$dir/no.png" --zoom 0
misuse -o "$dir/no.png" --up w
misuse -o "$dir/no.png" --up ''
misuse -o "$dir/no.png" -n 4
misuse -o "$dir/no.png" --text
misuse -o "$dir/no.html" --order 3
misuse -o "$dir/no.html" --quads brown
misuse -o "$dir/no.obj" --view zebra
check 'no output after bad usage' [ ! -e "$dir/no.png" ]
"$smooth" "$dir/demo.obj" -o "$dir/absent/out.png" 2> "$dir/stderr"
same 'status where the folder is absent' $? 1
check 'no temporary file is left' [ -z "$(find "$dir" -name '*.part*')" ]

verdict
