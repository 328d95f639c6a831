#!/bin/sh
# brown_test.sh BROWN SMOOTH: tests of the program brown and of smooth --quads brown, run from the top
# of the project.
brown=$1 smooth=$2 suite=brown program=$1
. tests/check.sh
shapes=examples/brown

# facts OBJ PROGRAM: what awk says of the points x, y, z of a file at its end.
facts() { awk "$2" "$1"; }

# ---- The shapes that come with it hold what they claim. ----

for shape in plane edge groove half_cylinder ghost_line; do
    check "$shape" "$brown" "$shapes/$shape.brown" -n 48 -o "$dir/$shape.obj" --quiet
done

check 'the plane is flat' facts "$dir/plane.obj" '
    $1 == "v" && $2 > 1.99 && $2 < 3.01 && $3 > 1.99 && $3 < 3.01 { n++; d = $4 - 2
                  if (d < -1e-14 || d > 1e-14) bad++ }
    END { exit bad || n != 49 * 49 }'
check 'the edge is sharp: normals differ there by over 40 degrees' facts "$dir/edge.obj" '
    function sharp(a, b) { return X[a]*X[b] + Y[a]*Y[b] + Z[a]*Z[b] < 0.76 }
    $1 == "v" { x[++n] = $2; y[n] = $3 }
    $1 == "vn" { X[++m] = $2; Y[m] = $3; Z[m] = $4 }
    $1 == "f" { for (i = 2; i <= 4; i++) { split($i, a, "//")
                if (x[a[1]] == 2 && y[a[1]] == 2) { if (k && sharp(k, a[2])) found = 1; k = a[2] } } }
    END { exit !found }'
check 'the floor of the groove is flat across' facts "$dir/groove.obj" '
    $1 == "v" && $2 > 2.399 && $2 < 3.601 { y = $3 ""
                  if (!(y in z)) z[y] = $4; d = $4 - z[y]; n++
                  if (d < -1e-14 || d > 1e-14) bad++ }
    END { exit bad || n < 49 * 100 }'
# The mean by the trapezoid rule; at the ends, in 3 * 90 + 1 columns, the error is 0.
"$brown" "$shapes/half_cylinder.brown" -n 90 -o "$dir/half_cylinder.obj" --quiet
check 'the half cylinder: mean error 0.0140 %, largest 0.0273 %' facts "$dir/half_cylinder.obj" '
    $1 == "v" { e = sqrt($3 * $3 + $4 * $4) - 1; e = e < 0 ? -e : e; sum += e; n++
                if (e > most) most = e }
    END { text = sprintf("%.4f %.4f", 100 * sum / (n - 271), 100 * most)
          if (text != "0.0140 0.0273") print "    " text
          exit text != "0.0140 0.0273" }'
check 'the ghost line is a crease at one end and smooth at the other' facts "$dir/ghost_line.obj" '
    $1 == "v" { x[++n] = $2; y[n] = $3 }
    $1 == "vn" { X[++m] = $2; Y[m] = $3; Z[m] = $4 }
    $1 == "f" { for (i = 2; i <= 4; i++) { split($i, a, "//"); p = a[1]; q = a[2]
                if (x[p] != 2) continue
                if (!(p in first)) first[p] = q
                r = first[p]; c = X[q]*X[r] + Y[q]*Y[r] + Z[q]*Z[r]
                if (y[p] <= 1 && c < 0.9) crease++
                if (y[p] >= 4 && c < 1 - 1e-12) bad++ } }
    END { exit bad || !crease }'

# ---- Formats, level and tolerance. ----

for kind in stl ply vtu vtk msh; do
    check ".$kind" "$brown" "$shapes/plane.brown" -o "$dir/plane.$kind" --quiet
    check ".$kind is there" test -s "$dir/plane.$kind"
done
for view in shaded zebra isophote mean gauss; do
    check "picture, $view" "$brown" "$shapes/plane.brown" --view $view --size 80x60 \
        -o "$dir/$view.png" --quiet
done
check 'page' "$brown" "$shapes/edge.brown" -o "$dir/edge.html" --quiet
check 'page is whole' grep -q '</html>' "$dir/edge.html"
check 'pictures differ' sh -c "! cmp -s '$dir/shaded.png' '$dir/zebra.png'"
count() { sed -n 's/.*: \([0-9]*\) flat.*/\1/p'; }
triangles() { "$brown" "$shapes/plane.brown" -o "$dir/out.obj" "$@" 2>&1 | count; }
check 'level 1' [ "$(triangles -n 1)" = 50 ]
check 'level 3' [ "$(triangles -n 3)" = 450 ]
coarse=$(triangles --tol 0.01) fine=$(triangles --tol 0.001)
check 'a finer tolerance has more triangles' [ "$fine" -gt $((2 * coarse)) ]
check 'a tolerance in percent' [ "$(triangles --tol 0.1%)" -gt "$coarse" ]
check 'the surface reads back' "$smooth" "$dir/plane.obj" --rule flat -o "$dir/back.stl" --quiet

# ---- What is refused, and how: with the line. ----

# refused NAME STATUS WORDS TEXT: the file of this text is.
refused() {
    printf "$4" >"$dir/in.brown"
    rm -f "$dir/out.obj"
    "$brown" "$dir/in.brown" -o "$dir/out.obj" --quiet 2>"$dir/message"
    status=$?
    grep -qF -- "$3" "$dir/message" || sed 's/^/    /' "$dir/message"
    check "$1: status" [ $status = "$2" ]
    check "$1: message" grep -qF -- "$3" "$dir/message"
    check "$1: no file" [ ! -e "$dir/out.obj" ]
}
square='lattice 2 2\npoint 0 0 0\npoint 1 0 0\npoint 0 1 0\npoint 1 1 0\n'
three='lattice 2 3\npoint 0 0 0\npoint 1 0 0\npoint 0 1 1\npoint 1 1 1\npoint 0 2 0\npoint 1 2 0\n'
refused 'empty file' 1 'in.brown: ' ''
refused 'no lattice' 1 "in.brown:1: 'point' where 'lattice' should be" 'point 0 0 0\n'
refused 'one row' 1 'in.brown:1: a lattice has from 2 to 10000 points along a curve, not 1' \
    'lattice 3 1\n'
refused 'too large a lattice' 1 'in.brown:1: a lattice has from 2' 'lattice 3 99999999999999\n'
refused 'a second lattice' 1 'in.brown:6: there is a lattice already' "${square}lattice 2 2\n"
refused 'too few points' 1 'in.brown: it has 1 points, not 2 by 2' 'lattice 2 2\npoint 0 0 0\n'
refused 'too many points' 1 'in.brown:6: a lattice of 2 by 2 has no more than 4' \
    "${square}point 2 2 2\n"
refused 'no number' 1 "in.brown:3: 'x' is not a finite number" 'lattice 2 2\n\npoint 0 x 0\n'
refused 'no third coordinate' 1 'in.brown:2: the end of the line is not' 'lattice 2 2\npoint 0 1\n'
refused 'a word too many' 1 "in.brown:2: '4' is too much" 'lattice 2 2\npoint 0 1 2 4\n'
refused 'unknown word' 1 "in.brown:6: 'size' is none of" "${square}size 4\n"
refused 'unknown parameter' 1 "in.brown:6: 'sharpness' is none of" "${square}u 1 sharpness 1\n"
refused 'no such row' 1 'in.brown:6: row 3 is not from 1 to 2' "${square}u 3 bias 1\n"
refused 'no such column' 1 'in.brown:6: column 0 is not from 1' "${square}v 0 bias 1\n"
refused 'too few values' 1 'in.brown:7: the end of the line is not a finite' "${square}\nu 1 bias \n"
refused 'as few values' 1 'in.brown:8: the end of the line is' "${three}v 1 bias 1 2\n"
refused 'too many values' 1 'in.brown:6: ' "${square}u 1 bias 1 2 3\n"
refused 'too large a value' 1 'in.brown:6: a parameter is from -1000' "${square}u 1 bias 1e9\n"
refused 'rise without neighbours' 1 'in.brown:6: rise wants' "${square}u 1 rise 1\n"
refused 'rise in part' 1 'in.brown:8: rise wants' "${three}u 1 rise 1 0\n"
refused 'rise with tension' 1 'in.brown:9: rise wants' "${three}u 1 tension 1\nu 1 rise 1\n"
refused 'curve of neither' 1 "in.brown:6: 'w' is neither u nor v" "${square}curve w 1 1\n"
refused 'no such part' 1 'in.brown:6: part 2 is not from 1 to 1' "${square}curve u 1 2 0 0 0 0 0 0\n"
usage() {
    "$brown" "$@" >"$dir/message" 2>&1
    check "usage: $*" [ $? = 2 ]
}
usage
usage "$shapes/plane.brown"
usage "$shapes/plane.brown" -o "$dir/out.txt"
usage "$shapes/plane.brown" -o "$dir/out.step"
usage "$shapes/plane.brown" -o "$dir/out.obj" -n 0
usage "$shapes/plane.brown" -o "$dir/out.obj" -n 3 --tol 1
usage "$shapes/plane.brown" -o "$dir/out.obj" --rule arc
usage "$shapes/plane.brown" -o "$dir/out.obj" --view zebra
usage "$shapes/plane.brown" -o "$dir/out.png" --view net
usage "$shapes/plane.brown" -o "$dir/out.vtu" --bezier
check 'help' "$brown" --help >/dev/null

# ---- Own curves and every parameter. ----

printf "${three}u * bias 0.5\nv 2 t-continuity 0 0.5 0 # more\ncurve u 2 1 .25 1 2 .5 1 2\n" \
    >"$dir/in.brown"
check 'own curves' "$brown" "$dir/in.brown" -n 2 -o "$dir/out.obj" --quiet
check 'own curves are taken' grep -q '^v 0.40625 1 1.75$' "$dir/out.obj"

# ---- Quads of meshes. ----

# A torus of 12 by 8 quads, R = 2, r = 1, with its normals.
awk 'BEGIN { pi = atan2(0, -1)
    for (i = 0; i < 12; i++) for (j = 0; j < 8; j++) {
        a = pi * i / 6; b = pi * j / 4; rho = 2 + cos(b)
        printf "v %.17g %.17g %.17g\n", rho * cos(a), rho * sin(a), sin(b)
        printf "vn %.17g %.17g %.17g\n", cos(b) * cos(a), cos(b) * sin(a), sin(b) }
    for (i = 0; i < 12; i++) for (j = 0; j < 8; j++) {
        k[1] = 8 * i + j; k[2] = 8 * ((i + 1) % 12) + j
        k[3] = 8 * ((i + 1) % 12) + (j + 1) % 8; k[4] = 8 * i + (j + 1) % 8
        printf "f"; for (c = 1; c <= 4; c++) printf " %d//%d", k[c] + 1, k[c] + 1; printf "\n" } }' \
    >"$dir/torus.obj"
figure() { "$smooth" "$dir/torus.obj" --json --quiet "$@" | sed -n 's/^  "jump_degrees": //p'; }
below() { awk "BEGIN { exit !($1 < $2) }"; }
check 'split quads bend where they meet' below 1 "$(figure --rule fit)"
check 'squares do not' below "$(figure --rule fit --quads brown)" 1e-9
check 'nor by the rule paper' below "$(figure --quads brown)" 1e-9
"$smooth" "$dir/torus.obj" --rule fit --quads brown -n 8 -o "$dir/out.obj" --quiet
check 'the torus to 3.5e-3' facts "$dir/out.obj" '
    $1 == "v" { d = sqrt($2 * $2 + $3 * $3) - 2; d = sqrt(d * d + $4 * $4) - 1
                if (d > 3.5e-3 || d < -3.5e-3) bad++ }
    END { exit bad || NR < 6000 }'
check 'it is closed' facts "$dir/out.obj" '
    $1 == "f" { for (i = 2; i <= 4; i++) { split($i, a, "/"); c[i] = a[1] }
                c[5] = c[2]; for (i = 2; i <= 4; i++) side[c[i], c[i + 1]]++ }
    END { for (s in side) { split(s, a, SUBSEP); if (side[s] != 1 || side[a[2], a[1]] != 1) bad++ }
          exit bad > 0 }'
for out in '--view zebra --size 80x60 -o out.png' '-n 3 -o out.ply' '--tol 1% -o out.stl' \
    '--order 2 -o out.vtu' '-o out.msh'; do
    check "smooth --quads brown $out" "$smooth" "$dir/torus.obj" --quads brown --quiet \
        ${out%out.*} "$dir/out.${out##*.}"
done
"$smooth" "$dir/torus.obj" --quads brown --bezier -o "$dir/out.vtu" 2>/dev/null
check 'no control points' [ $? = 2 ]

verdict
