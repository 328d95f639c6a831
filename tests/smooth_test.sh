#!/bin/sh
# smooth_test.sh SMOOTH DEMO_MESH: tests of the program smooth, run from the top of the project.
smooth=$1 demo_mesh=$2 suite=smooth program=$1
. tests/check.sh
meshes=../shared/meshes

quiet() { "$smooth" --quiet "$@"; }

# field NAME FILE OPTIONS...: what the report says.
field() {
    key=$1
    shift
    quiet "$@" --json | sed -n "s/^  \"$key\": \(.*[^,]\),*\$/\1/p"
}

# watertight OBJ: every edge is there once in each direction, no point twice.
watertight() {
    awk '$1 == "v" { if (($2, $3, $4) in point) bad++; point[$2, $3, $4] }
         $1 == "f" { for (i = 2; i <= 4; i++) { split($i, a, "/"); corner[i] = a[1] }
                     corner[5] = corner[2]
                     for (i = 2; i <= 4; i++) side[corner[i], corner[i + 1]]++ }
         END { for (s in side) { split(s, a, SUBSEP)
                                 if (side[s] != 1 || side[a[2], a[1]] != 1) bad++ }
               if (bad) print "    " bad " points or sides are wrong"
               exit bad > 0 }' "$1"
}

# obj TEXT: prints a file with the escapes of printf.
obj() { printf "$1" > "$dir/in.obj"; }

# ---- What may stand in an OBJ file: each of these is the same tetrahedron. ----
tetra='v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n'
obj "${tetra}f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
quiet "$dir/in.obj" -o "$dir/tetra.obj"
variant() {
    obj "$2"
    rm -f "$dir/out.obj"
    quiet "$dir/in.obj" -o "$dir/out.obj"
    check "OBJ with $1" cmp -s "$dir/out.obj" "$dir/tetra.obj"
}
faces='f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'
variant 'CR LF' \
    'v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1\r\nf 1 3 2\r\nf 1 2 4\r\nf 2 3 4\r\nf 3 1 4\r\n'
variant 'CR alone' \
    'v 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 1\rf 1 3 2\rf 1 2 4\rf 2 3 4\rf 3 1 4'
variant 'tabs and blanks' "\\tv  0\\t0 0 \\nv 1 0 0\\nv 0 1 0\\nv 0 0 1\\n$faces"
variant 'comments' "# v 9 9 9 \\\\\\n$tetra f 1 3 2 # and more\\nf 1 2 4 #\\nf 2 3 4\\nf 3 1 4\\n"
variant 'continued lines' \
    'v 0 0 \\\n0\nv 1 0\\\n 0\nv 0 1 0\nv 0 0 1\nf 1 \\\r\n3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4'
variant 'negative indices' "${tetra}f -4 -2 -3\\nf -4 -3 -1\\nf -3 -2 -1\\nf -2 -4 -1\\n"
variant 'v/t' "${tetra}vt 0 0\\nf 1/1 3/1 2/1\\nf 1/1 2/1 4/1\\nf 2/1 3/1 4/1\\nf 3/-1 1/1 4/1\\n"
variant 'weights and colours' \
    "v 0 0 0 1\\nv 1 0 0 .5 .5 .5\\nv 0 1 0 1 .5 .5 .5\\nv 0 0 1\\n$faces"
variant 'numbers of every form' "v 0. +.0 +0e5\\nv 1E0 0 0\\nv 0 10e-1 0\\nv 0 0 .01e+02\\n$faces"
variant 'unknown statements' \
    "mtllib a b\\no name\\n${tetra}usemtl x\\ng 1 2\\ns off\\n${faces}l 1 2\\n"
variant 'a byte order mark' "\\357\\273\\277$tetra$faces"
variant 'an unused and a double point' \
    "v 9 9 9\\n${tetra}v -0 0 -0\\nf 2 4 3\\nf 6 3 5\\nf 3 4 5\\nf 4 2 5\\n"
variant 'a collapsed triangle' "${tetra}f 1 3 2\\nf 1 2 4\\nf 1 2 1\\nf 2 3 4\\nf 3 1 4\\n"

# ---- The same tetrahedron as STL. ----
facet() {
    printf 'facet normal 0 0 0\n outer loop\n'
    printf '  vertex %s %s %s\n' "$@"
    printf ' endloop\nendfacet\n'
}
{
    echo 'solid a # name'
    facet 0 0 0 0 1 0 1 0 0
    facet -0 0 0 1 0 0 0 0 1
    facet 1 0 0 0 1 0 0 0 1
    facet 0 1 0 0 0 0 0 0 1
    echo 'endsolid a'
} > "$dir/ascii.stl"
# In the order of the file the points are numbered otherwise: compare as sets.
shape() { sort "$1" | grep '^v ' | cksum; }
quiet "$dir/ascii.stl" -o "$dir/out.obj"
same 'ASCII STL' "$(shape "$dir/out.obj")" "$(shape "$dir/tetra.obj")"
tr 'a-z' 'A-Z' < "$dir/ascii.stl" | tr '\n' '\r' > "$dir/upper.STL"
quiet "$dir/upper.STL" -o "$dir/out.obj"
same 'ASCII STL in capitals' "$(shape "$dir/out.obj")" "$(shape "$dir/tetra.obj")"
quiet "$dir/ascii.stl" -o "$dir/binary.stl" -n 1
same 'size of a binary STL' "$(wc -c < "$dir/binary.stl" | tr -d ' ')" $((84 + 50 * 4))
quiet "$dir/binary.stl" -o "$dir/out.obj"
same 'binary STL' "$(shape "$dir/out.obj")" "$(shape "$dir/tetra.obj")"
{ printf 'solid'; tail -c +6 "$dir/binary.stl"; } > "$dir/solid.stl"
quiet "$dir/solid.stl" -o "$dir/out.obj"
same "binary STL that begins with 'solid'" "$(shape "$dir/out.obj")" "$(shape "$dir/tetra.obj")"

# ---- Polygons: a fan from the widest corner. ----
fan() {
    obj "$2"
    quiet "$dir/in.obj" -o "$dir/out.obj" -n 1
    same "$1" "$(grep '^f' "$dir/out.obj" | sed 's|//[0-9]*||g' | tr '\n' ';')" "$3"
}
fan 'a polygon with a corner inwards' 'v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n' \
    'f 4 5 1;f 4 1 2;f 4 2 3;'
fan 'a square' 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n' 'f 1 2 3;f 1 3 4;'
# Turned and moved its angles differ in the last bit, the second being the widest.
fan 'a square to seven digits' \
    'v 1.2493273 1.0726154 0\nv -.0446154 1.6433273 0\nv -.6153273 .3493846 0
v .6786154 -.2213273 0\nf 1 2 3 4\n' \
    'f 1 2 3;f 1 3 4;'
fan 'a trapezoid' 'v 0 0 0\nv 4 0 0\nv 3 1 0\nv 1 1 0\nf 1 2 3 4\n' 'f 3 4 1;f 3 1 2;'

# ---- What is refused: nothing is written, the message names the place. ----
# refuse NAME FILE REASON: REASON follows "smooth: FILE".
refuse() {
    rm -f "$dir/no.obj"
    got=$("$smooth" "$2" -o "$dir/no.obj" 2>&1)
    same "$1 is refused with status 1" $? 1
    same "$1" "$got" "smooth: $2$3"
    check "$1: no output" [ ! -e "$dir/no.obj" ]
}
refuse_obj() { obj "$2"; refuse "$1" "$dir/in.obj" "$3"; }
points='v 0 0 0\nv 1 0 0\nv 0 1 0\n'
refuse_obj 'a word for a number' 'v 0 0 0\nv 1 x 0\n' ":2: 'x' is not a finite number"
refuse_obj 'a number with a tail' 'v 0 0 0\nv 1 0 0,5\n' ":2: '0,5' is not a finite number"
refuse_obj 'a hexadecimal number' 'v 0 0 0x10\n' ":1: '0x10' is not a finite number"
refuse_obj 'nan' '#\n\nv 0 nan 0\n' ":3: 'nan' is not a finite number"
refuse_obj 'inf' 'v \\\n0 -inf 0\n' ":2: '-inf' is not a finite number"
refuse_obj 'a number beyond the range' 'v 1e999 0 0\n' ":1: '1e999' is too large, beyond 1e150"
refuse_obj 'two coordinates' 'v 1 0\nv 0 0 0\n' ':1: the end of the line is not a finite number'
refuse_obj 'a truncated file' 'v 1 0' ':1: the end of the file is not a finite number'
refuse_obj 'a fourth component' 'vn 1 0 0 0\n' ":1: '0' is one too many"
refuse_obj 'a face of two' "${points}f 1 2\\n" ':4: a face needs three corners, here are 2'
refuse_obj 'the point 0' "${points}f 1 2 0\\n" ':4: there is no point 0, only 3 so far'
refuse_obj 'a point beyond' "${points}f 1 2 4\\n" ':4: there is no point 4, only 3 so far'
refuse_obj 'a negative point beyond' "${points}f 1 2 -4\\n" \
    ':4: there is no point -4, only 3 so far'
refuse_obj 'a huge index' "${points}f 1 2 99999999999999999999\\n" \
    ':4: there is no point 2147483647, only 3 so far'
refuse_obj 'a missing normal' "${points}f 1//1 2//1 3//1\\n" \
    ':4: there is no normal 1, only 0 so far'
refuse_obj 'a corner of four' "${points}vn 0 0 1\\nf 1/1/1/1 2 3\\n" \
    ":5: '1/1/1/1' is not a face's corner"
refuse_obj 'a corner with a tail' "${points}f 1 2 3x\\n" ":4: '3x' is not a face's corner"
refuse_obj 'a word for a group' 's a\n' ":1: 'a' is not a smoothing group"
refuse_obj 'no triangle' "$points" ': there are no triangles in it'
refuse_obj 'an empty file' '' ': the file is empty'
obj "${points}f 1 2 2\\n"
same 'collapsed triangles alone' "$(quiet "$dir/in.obj" --report 2>&1)" \
    "smooth: $dir/in.obj: all its triangles have collapsed"
refuse_obj 'control characters' 'v 0 0 \033[31m\n' ":1: '?[31m' is not a finite number"
obj 'v 1e39 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\n'
same 'STL beyond single precision' "$(quiet "$dir/in.obj" -o "$dir/no.stl" 2>&1)" \
    "smooth: $dir/no.stl: a coordinate is too large for STL, beyond 3.40282e+38"
check 'none is written' [ ! -e "$dir/no.stl" ]
refuse 'an absent file' "$dir/absent.obj" ': No such file or directory'
mkdir "$dir/folder.obj"
refuse 'a folder' "$dir/folder.obj" ': Is a directory'
refuse_obj 'an unknown format' 'first, second\n' ': it is none of OBJ, STL, PLY, VTU, VTK and MSH'
sed 's/outer loop/outer/' "$dir/ascii.stl" > "$dir/bad.stl"
refuse 'ASCII STL without a loop' "$dir/bad.stl" ":4: 'vertex' where 'loop' should be"
sed '/endsolid/d' "$dir/ascii.stl" > "$dir/bad.stl"
refuse 'ASCII STL without its end' "$dir/bad.stl" \
    ":30: the end of the file where 'facet' or 'endsolid' should be"
head -c 283 "$dir/binary.stl" > "$dir/bad.stl"
refuse 'a truncated binary STL' "$dir/bad.stl" \
    ': binary STL of 4 triangles is 284 bytes long, this file 283'
# replace BEFORE BYTES FROM: the binary STL with other bytes after the first BEFORE, up to FROM.
replace() {
    {
        head -c "$1" "$dir/binary.stl"
        printf "$2"
        tail -c +"$3" "$dir/binary.stl"
    } > "$dir/bad.stl"
}
replace 80 '\377\377\377\377' 85
refuse 'a binary STL with a wild count' "$dir/bad.stl" \
    ': binary STL of 4294967295 triangles is 214748364834 bytes long, this file 284'
replace 96 '\000\000\200\177' 101
refuse 'infinity in a binary STL' "$dir/bad.stl" ': byte 96: not a finite number'

# ---- Usage. ----
misuse() {
    "$smooth" "$@" > "$dir/stdout" 2> "$dir/stderr"
    same "status of: smooth $*" $? 2
    check "usage after: smooth $*" grep -q '^usage: smooth' "$dir/stderr"
    check "stdout of: smooth $*" [ ! -s "$dir/stdout" ]
}
misuse
misuse "$dir/tetra.obj"
misuse "$dir/tetra.obj" -o
misuse "$dir/tetra.obj" -o "$dir/no.xyz"
misuse "$dir/tetra.obj" -o "$dir/no.obj" -n 0
misuse "$dir/tetra.obj" -o "$dir/no.obj" -n 1.5
misuse "$dir/tetra.obj" -o "$dir/no.obj" -n 4x
misuse "$dir/tetra.obj" -o "$dir/no.obj" --rule cubic
misuse "$dir/tetra.obj" -o "$dir/no.obj" --crease nan
misuse "$dir/tetra.obj" -o "$dir/no.obj" --weld -1
misuse "$dir/tetra.obj" -o "$dir/no.obj" --bezier
misuse "$dir/tetra.obj" -o "$dir/no.obj" --order 2
misuse "$dir/tetra.obj" -o "$dir/no.vtu" --order 4
misuse "$dir/tetra.obj" -o "$dir/no.msh" --bezier
misuse "$dir/tetra.obj" -o "$dir/no.stl" --text
misuse "$dir/tetra.obj" -o "$dir/no.obj" --binary
misuse "$dir/tetra.obj" -o "$dir/no.step" -n 2
misuse "$dir/tetra.obj" -o "$dir/no.vtu" -n 2 --order 2
misuse "$dir/tetra.obj" -o "$dir/no.vtu" --tol 1 --bezier
for tolerance in 0 -1 nan inf 1%% 1x % ''; do
    misuse "$dir/tetra.obj" -o "$dir/no.obj" --tol "$tolerance"
done
misuse "$dir/tetra.obj" -o "$dir/no.obj" --frobnicate
misuse "$dir/tetra.obj" "$dir/tetra.obj" -o "$dir/no.obj"
for option in -h --help --version; do
    "$smooth" $option > "$dir/stdout" 2> "$dir/stderr"
    same "status of smooth $option" $? 0
    check "smooth $option prints on stdout" [ -s "$dir/stdout" -a ! -s "$dir/stderr" ]
done
check 'no output after bad usage' [ ! -e "$dir/no.obj" ]

# ---- The output: whole or absent. ----
same 'statistics are one line' \
    "$("$smooth" "$dir/tetra.obj" -o "$dir/out.obj" 2>&1 | wc -l | tr -d ' ')" 1
same '--quiet' "$(quiet "$dir/tetra.obj" -o "$dir/out.obj" 2>&1)" ''
got=$("$smooth" "$dir/tetra.obj" -o "$dir/absent/out.obj" 2>&1)
same 'status where the folder is absent' $? 1
same 'an absent folder' "$got" "smooth: $dir/absent/out.obj: No such file or directory"
"$smooth" "$dir/tetra.obj" -o "$dir/folder.obj" 2> "$dir/stderr"
same 'status where the output is a folder' $? 1
check 'no temporary file is left' [ -z "$(find "$dir" -name '*.part*')" ]
if [ -w /dev/full ]; then
    quiet "$dir/tetra.obj" --report > /dev/full 2> "$dir/stderr"
    same 'status of a report on a full disk' $? 1
else
    echo 'smooth: no /dev/full here, one test skipped'
fi
echo old > "$dir/out.vtu"
(
    trap '' XFSZ
    ulimit -f 64 # not fewer: the runtime of OpenMP has a small file of its own
    quiet "$dir/tetra.obj" -n 100 -o "$dir/out.vtu" 2> "$dir/stderr"
)
same 'status where the file grows too large' $? 1
same 'what was there before stays' "$(cat "$dir/out.vtu")" old
check 'no half of a file is left' [ -z "$(find "$dir" -name '*.part*')" ]
echo precious > "$dir/out.obj.part0"
cp "$dir/tetra.obj" "$dir/both.obj"
quiet "$dir/both.obj" -o "$dir/both.obj"
quiet "$dir/tetra.obj" -o "$dir/out.obj"
check 'input and output may be one file' cmp -s "$dir/both.obj" "$dir/out.obj"
same 'no file is overwritten on the way' "$(cat "$dir/out.obj.part0")" precious

# ---- Values: what is read comes back. ----
obj 'v 0.1 1e-300 -1.7976931348623157e100\nv 0.30000000000000004 5e-324 123456789.123456789
v 1 0 0\nf 1 2 3\n'
quiet "$dir/in.obj" -o "$dir/out.obj" -n 1
same 'round trip' "$(grep '^v ' "$dir/out.obj")" 'v 0.1 1e-300 -1.7976931348623157e+100
v 0.30000000000000004 4.94065645841247e-324 123456789.12345679
v 1 0 0'

# ---- The rules, in the middle of a quarter circle: a = 45 degrees. ----
obj 'v 1 0 0\nv 0 1 0\nv 0 0 1\nvn 3 0 0\nvn 0 1 0\nvn 0 0 1e-5\nf 1//1 2//2 3//3\n'
middle() {
    quiet "$dir/in.obj" -o "$dir/out.obj" -n 2 --rule "$1"
    awk -v want="$2" '$1 == "v" && ++n == 4 {
        r = sqrt($2 * $2 + $3 * $3); d = r < want ? want - r : r - want
        if (d > 1e-14) print "    radius " r ", not " want
        exit d > 1e-14 }' "$dir/out.obj"
}
# cos a; (cos a + 1 / cos a) / 2; cos a (1 + sin^2 a / 2)
check 'rule flat' middle flat 0.70710678118654752
check 'rule nagata' middle nagata 1.06066017177982129
check 'rule paper' middle paper 1.06066017177982129
check 'rule pn' middle pn 0.88388347648318441

# The same octant in its middle: PN edges have 1, 1/3, 0 at their thirds and 1/2 in the centre,
# which makes (1 + 3 (8/3) + 6/2) / 27; the others have 1, 2/3, 0 and 2/3.
centroid() {
    quiet "$dir/in.obj" -o "$dir/out.obj" -n 3 --rule "$1"
    awk -v want="$2" '$1 == "v" { x = $2 } END { d = x - want; if (d < 0) d = -d
        if (d > 1e-14) print "    " x ", not " want; exit d > 1e-14 }' "$dir/out.obj"
}
check 'the centre by pn' centroid pn 0.44444444444444444
check 'the centre by nagata' centroid nagata 0.55555555555555556
check 'the centre by paper' centroid paper 0.55555555555555556

# ---- Facets within a distance of the octant; its bounding box has the diagonal sqrt 3. ----
same 'a wide distance' "$(field output_triangles "$dir/in.obj" -o "$dir/out.obj" --tol 1)" 1
quiet "$dir/in.obj" -o "$dir/out.obj" --tol 1e-3
quiet "$dir/in.obj" -o "$dir/percent.obj" --tol 0.057735026918962576%
check 'a distance in percent' cmp -s "$dir/out.obj" "$dir/percent.obj"
# Facets with sides s lie s^2 / 6 below the unit sphere: 21 parts of each edge are enough there.
triangles=$(grep -c '^f' "$dir/out.obj")
check "$triangles triangles for a thousandth" [ "$triangles" -gt 220 -a "$triangles" -lt 660 ]

# above A B: A > B, for decimal numbers.
above() { awk "BEGIN { exit !($1 > $2) }"; }

# ---- The demonstration's mesh. ----
demo="$dir/demo.obj"
"$demo_mesh" > "$demo"
check 'the demonstration is closed' watertight "$demo"
same 'its triangles' "$(field triangles "$demo")" 224
same 'its sharp edges' "$(field crease_edges "$demo")" 32
check 'it has S-shaped edges' [ "$(field s_shaped_edges "$demo")" -ge 16 ]
for rule in paper arc fit nagata pn flat; do
    for level in 1 2 5; do
        quiet "$demo" -o "$dir/out.obj" -n $level --rule $rule
        same "triangles of $rule $level" "$(grep -c '^f' "$dir/out.obj")" $((224 * level * level))
        check "$rule $level is watertight" watertight "$dir/out.obj"
    done
done
for rule in nagata pn; do
    quiet "$demo" -o "$dir/out.obj" --rule $rule
    # The rim is sharp: its curves stay in the plane of the base, to the last bits of coordinates.
    check "the base by $rule is flat" awk '$1 == "v" && $4 < -1e-15 { exit 1 }' "$dir/out.obj"
done
quiet "$demo" -o "$dir/out.stl" -n 3
quiet "$dir/out.stl" -o "$dir/out.obj" -n 1 --weld 0
check 'as STL it is watertight' watertight "$dir/out.obj"

same 'no patch of it folds' "$(field folding_patches "$demo")" 0
check "Nagata's own patches fold at its inflections" \
    [ "$(field folding_patches "$demo" --rule nagata)" -gt 0 ]

# ---- VTU: 10 nodes for each triangle, shared; Lagrange nodes are points of the surface. ----
nodes() { sed -n '/Name="points"/,/DataArray>/p' "$1" | grep -v '<'; }
cells() { sed -n '/Name="connectivity"/,/DataArray>/p' "$1" | grep -v '<'; }
quiet "$demo" -o "$dir/lagrange.vtu"
quiet "$demo" -o "$dir/bezier.VTU" --bezier
for file in lagrange.vtu bezier.VTU; do
    same "nodes of $file" "$(nodes "$dir/$file" | wc -l | tr -d ' ')" $((114 + 2 * 336 + 224))
    same "cells of $file" "$(cells "$dir/$file" | awk 'NF == 10' | wc -l | tr -d ' ')" 224
    same "nodes in the cells of $file" \
        "$(cells "$dir/$file" | tr ' ' '\n' | sort -nu | sed -n '1p;$p' | tr '\n' ' ')" '0 1009 '
    check "$file counts them" grep -q 'NumberOfPoints="1010" NumberOfCells="224"' "$dir/$file"
done
same 'type 69' "$(grep -cx 69 "$dir/lagrange.vtu")" 224
same 'type 76' "$(grep -cx 76 "$dir/bezier.VTU")" 224
check 'both have the same cells' [ "$(cells "$dir/lagrange.vtu")" = "$(cells "$dir/bezier.VTU")" ]
# The Lagrange node at a third of the first edge and the one at the centre, from the control
# points, to a few units of the last of 53 bits of coordinates up to 3.
{ nodes "$dir/bezier.VTU"; nodes "$dir/lagrange.vtu"; cells "$dir/bezier.VTU"; } | awk '
    function compare(want, got) { d = want - got; if (d < 0) d = -d; if (d > worst) worst = d }
    NF == 3 { for (i = 1; i <= 3; i++) x[n + 0, i] = $i; n++ }
    NF == 10 { for (i = 1; i <= 3; i++) {
            compare((8 * x[$1, i] + 12 * x[$4, i] + 6 * x[$5, i] + x[$2, i]) / 27, x[n / 2 + $4, i])
            c = 6 * x[$10, i]
            for (k = 1; k <= 9; k++) c += (k <= 3 ? 1 : 3) * x[$k, i]
            compare(c / 27, x[n / 2 + $10, i]) } }
    END { if (worst > 1e-14) print "    off by " worst; exit !(n && worst <= 1e-14) }'
same 'Lagrange nodes are points of the surface' $? 0

# ---- Creases, by angle and by smoothing groups, on a cube. ----
cube='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n'
sides='f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n'
obj "$cube$sides"
cp "$dir/in.obj" "$dir/cube.obj"
same 'a cube has 12 sharp edges' "$(field crease_edges "$dir/cube.obj")" 12
same 'none with --crease 91' "$(field crease_edges "$dir/cube.obj" --crease 91)" 0
same 'six polygons' "$(field polygons "$dir/cube.obj")" 6
# To a few units of the last of 53 bits of coordinates up to 1.
check 'a cube stays flat' above 1e-15 "$(field distance "$dir/cube.obj")"
obj "${cube}s off\\n$sides"
same "a lone 's off' says nothing" "$(field crease_edges "$dir/in.obj" --crease 91)" 0
obj "${cube}s 1\\nf 4 3 2 1\\nf 5 6 7 8\\ns 2\\nf 1 2 6 5\\nf 2 3 7 6\\nf 3 4 8 7\\nf 4 1 5 8\\n"
same 'the edges between two groups' "$(field crease_edges "$dir/in.obj" --crease 91)" 8
obj "${cube}s 1\\nf 4 3 2 1\\ns 0\\nf 5 6 7 8\\nf 1 2 6 5\\nf 2 3 7 6\\nf 3 4 8 7\\nf 4 1 5 8\\n"
same 'every edge outside of groups' "$(field crease_edges "$dir/in.obj" --crease 91)" 12

# ---- Welding: the tetrahedron with one point of a facet 1e-7 aside. ----
sed '10,16s/vertex 1 0 0/vertex 1.0000001 0 1e-7/' "$dir/ascii.stl" > "$dir/loose.stl"
same 'the default closes it' "$(field closed "$dir/loose.stl")" true
same 'one point was welded' "$(field welded_points "$dir/loose.stl")" 1
same 'joining equal points does not' "$(field closed "$dir/loose.stl" --weld 0)" false
# A sheet of 10 x 10 squares, each triangle's points apart by up to 1.04e-5, which is 0.73e-6 of
# the diagonal.
awk 'function jitter() { seed = (seed * 1103 + 12345) % 65536; return (seed / 32768 - 1) * 3e-6 }
     function point(x, y) { printf "vertex %.9f %.9f %.9f\n", x + jitter(), y + jitter(), jitter() }
     function triangle(x, y, i, j, k, l) {
         print "facet normal 0 0 0\nouter loop"
         point(x, y); point(x + i, y + j); point(x + k, y + l)
         print "endloop\nendfacet" }
     BEGIN { print "solid"
         for (x = 0; x < 10; x++) for (y = 0; y < 10; y++) {
             triangle(x, y, 1, 0, 1, 1); triangle(x, y, 1, 1, 0, 1) }
         print "endsolid" }' > "$dir/sheet.stl"
same 'points of the sheet' "$(field points "$dir/sheet.stl")" 121
same 'border of the sheet' "$(field border_edges "$dir/sheet.stl")" 40
same 'a coarse weld is counted' "$(field collapsed_triangles "$dir/cube.obj" --weld 0.6)" 8

# ---- The shared meshes, where they are. ----
if [ -d "$meshes" ]; then
    for file in "$meshes"/*.obj "$meshes"/*.STL; do
        for out in out.obj out.stl out.vtu; do
            rm -f "$dir/$out"
            quiet "$file" -o "$dir/$out" -n 2
            check "$file gives $out" [ -s "$dir/$out" ]
        done
        if [ "$(field closed "$file")" = true ]; then
            check "$file is watertight" watertight "$dir/out.obj"
        fi
    done
    same 'the CAD part closes' "$(field closed "$meshes/tm_featuretype.STL")" true
    same 'the capsule closes' "$(field closed "$meshes/tm_capsule.obj")" true
else
    echo "smooth: $meshes is absent, its meshes are skipped"
fi

verdict
