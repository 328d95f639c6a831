#!/bin/sh
# files_test.sh SMOOTH WRITE_SEEDS DUMP: what is read of files of every format, run from the top of
# the project. Three meshes stand in the seeds: faces, volumes, and what STL can hold of the faces.
smooth=$1 write_seeds=$2 dump=$3 suite=files program=$1
. tests/check.sh
mkdir "$dir/seeds" "$dir/out"
"$write_seeds" "$dir/seeds" || exit 1

# reads WANT FILE...: so the mesh in each of the files is.
reads() {
    want=$1
    shift
    for file; do same "$file" "$("$dump" "$file" 2>&1)" "$want"; done
}

# ---- Every variant of a format gives the same mesh and fields, to the last bit. ----
points='points (0 0 0) (2 0 0) (2 2 0) (0 2 0) (0 0 1) (2 0 1) (1 3 0.5)'
faces='0 4 3 of 0 (0 0 1) (0.5 0 1) (0.375 0 1)
0 1 5 of 1 (0 0 1) (0.125 0 1) (0.625 0 1)
0 5 4 of 1 (0 0 1) (0.625 0 1) (0.5 0 1)
2 6 3 of 2 (0.25 0 1) (0.75 0 1) (0.375 0 1)
2 3 0 of 2 (0.25 0 1) (0.375 0 1) (0 0 1)
2 0 1 of 2 (0.25 0 1) (0 0 1) (0.125 0 1)'
temperature="point field 'temperature' 1 real: 100 100.25 100.5 100.75 101 101.25 nan"
displacement="point field 'displacement' 3 real:\
 0 0 0 1 -0.5 0.125 2 -1 0.25 3 -1.5 0.375 4 -2 0.5 5 -2.5 0.625 6 -3 0.75"
label="point field 'label' 1 whole: 0 1 4 9 16 25 36"
reads "3 cells, 2 polygons, 0 skipped, 0 curved, 0 lost
$points
$faces
$temperature
$label
cell field 'stress' 1 real: 0 0.5 1
cell field 'material' 1 whole: 12 13 14" "$dir"/seeds/*.ply
reads "4 cells, 2 polygons, 2 skipped, 0 curved, 1 lost
$points
$faces
5 1 6 of 3 (0.625 0 1) (0.125 0 1) (0.75 0 1)
1 2 6 of 3 (0.125 0 1) (0.25 0 1) (0.75 0 1)
$temperature
$displacement
$label
cell field 'a < b' 1 real: 0 0.5 1 1.5
cell field 'material' 1 whole: 12 13 14 15" \
    "$dir"/seeds/faces_*.vtu "$dir"/seeds/grid_*.vtk "$dir"/seeds/polydata_*.vtk
msh="2 cells, 1 polygons, 2 skipped, 0 curved, 0 lost
$points
0 4 3 of 0
0 1 5 of 1
0 5 4 of 1
name 'wall #1' of 12, dimension 2
name 'inside' of 10, dimension 3"
groups="cell field 'gmsh:physical' 1 whole: 12 13
cell field 'gmsh:geometrical' 1 whole: 3 4"
reads "$msh
$temperature
$displacement
$groups
cell field 'id' 1 whole: 3 4
cell field 'a < b' 1 real: 0 0.5" "$dir"/seeds/faces1_*.msh
reads "$msh
point field 'id' 1 whole: 70 60 50 40 30 20 10
$temperature
$displacement
$groups
cell field 'id' 1 whole: 20 10
cell field 'a < b' 1 real: 0 0.5" "$dir"/seeds/faces10_*.msh
reads '2 cells, 0 polygons, 0 skipped, 0 curved, 0 lost
points (0 0 0) (2 0 0) (2 0 1) (0 0 0) (2 0 1) (0 0 1)
0 1 2 of 0
3 4 5 of 1' "$dir"/seeds/*.stl
reads "3 cells, 2 polygons, 0 skipped, 0 curved, 0 lost
$points
0 4 3 of 0 (0 0 1) (0.5 0 1) (0.375 0 1)
0 1 5 of 1 (0.75 0 1) (0.625 0 1) (0.125 0 1)
0 5 4 of 1 (0.75 0 1) (0.125 0 1) (0.25 0 1)
2 6 3 of 2
2 3 0 of 2
2 0 1 of 2" "$dir"/seeds/*.obj

# ---- Whatever its name is. ----
for file in usual_big.ply faces_text.stl faces.obj grid_5_big.vtk faces_appended_0_big.vtu \
    faces1_4_little.msh; do
    cp "$dir/seeds/$file" "$dir/name.stl"
    same "$file under another name" "$("$dump" "$dir/name.stl")" "$("$dump" "$dir/seeds/$file")"
    "$smooth" --quiet "$dir/name.stl" -o "$dir/out.obj" -n 1
    check "smooth of $file" [ -s "$dir/out.obj" ]
    rm -f "$dir/out.obj"
done

# ---- The boundary of volumes: closed, looking outwards, with the volumes' fields. ----
# volume: of what a dumped mesh encloses, six times.
volume() {
    awk '/^points/ { gsub(/[()]/, ""); for (i = 0; 3 * i + 2 <= NF; i++)
                       for (k = 0; k < 3; k++) x[i, k] = $(3 * i + 2 + k) }
         / of / && NF == 5 { for (k = 0; k < 3; k++)
             v += x[$1, k] * (x[$2, (k + 1) % 3] * x[$3, (k + 2) % 3] \
                            - x[$2, (k + 2) % 3] * x[$3, (k + 1) % 3]) }
         END { print v }'
}
for file in "$dir"/seeds/volumes*; do
    "$dump" --boundary "$file" > "$dir/dump"
    # The cube has 6, the pyramid 2, the wedge 3, the tetrahedron 1.
    same "volume in $file" "$(volume < "$dir/dump")" 12
    same "faces of $file" "$(grep '^[0-9].* of ' "$dir/dump")" \
        "$("$dump" --boundary "$dir/seeds/volumes_0.vtu" | grep '^[0-9].* of ')"
    check "its cells are the volumes" grep -q ' 1 whole: 10 11 12 13$' "$dir/dump"
    check "$file is closed" sh -c '"$0" --quiet "$1" --boundary --json | grep -q "closed\": true"' \
        "$smooth" "$file"
done

# ---- What single files have. ----
# holds NAME FILE-TEXT LINE...: each line is in what is read of the file, whose text has printf's
# escapes.
holds() {
    name=$1
    printf "$2" > "$dir/in"
    "$dump" "$dir/in" > "$dir/dump" 2>&1
    shift 2
    for line; do check "$name: $line" grep -qFx -- "$line" "$dir/dump"; done
}
ply='ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y
property float z\n'
ply_face='element face 1\nproperty list uchar int vertex_indices\n'
ply_end='end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'
holds 'PLY with CR alone' "$(printf %s "$ply$ply_face$ply_end" | sed 's/\\n/\\r/g')" '0 1 2 of 0'
holds 'PLY without faces of two' \
    "$(printf %s "$ply$ply_face" | sed 's/face 1/face 2/')${ply_end}2 0 1\n" \
    '1 cells, 0 polygons, 1 skipped, 0 curved, 0 lost'
holds 'PLY that tells nx alone' "${ply}property float nx\n\
${ply_face}end_header\n0 0 0 5\n1 0 0 6\n0 1 0 7\n3 0 1 2\n" \
    '0 1 2 of 0' "point field 'nx' 1 real: 5 6 7"

# vtu CELLS POINTDATA CONNECTIVITY OFFSETS TYPES
vtu_file='<VTKFile type="UnstructuredGrid"><UnstructuredGrid>'
ascii='type="Float64" format="ascii"'
piece() {
    printf %s "<Piece NumberOfPoints='$1' NumberOfCells='$2'><PointData $3</PointData><Points>\
<DataArray $ascii NumberOfComponents='3'>$4</DataArray></Points><Cells>\
<DataArray $ascii Name='connectivity'>$5</DataArray><DataArray $ascii Name='offsets'>$6</DataArray>\
<DataArray $ascii Name='types'>$7</DataArray></Cells></Piece>"
}
square='0 0 0 1 0 0 1 1 0 0 1 0'
holds 'VTU in three pieces' "$vtu_file$(
    piece 3 1 "><DataArray $ascii Name='a'>1 2 nan</DataArray>" '0 0 0 1 0 0 0 1 0' '0 1 2' 3 5
    piece 0 0 '>' '' '' '' ''
    piece 4 1 "><DataArray $ascii Name='a'>-1e-9 -INF 6 7</DataArray>" "$square" '0 1 2 3' 4 9)" \
    '2 cells, 1 polygons, 0 skipped, 0 curved, 0 lost' '0 1 2 of 0' '3 4 5 of 1' '3 5 6 of 1' \
    "point field 'a' 1 real: 1 2 nan -1.0000000000000001e-09 -inf 6 7"
normals="$ascii NumberOfComponents='3'>0 0 1 0 0 2 0 0 3 0 0 4</DataArray>"
holds 'VTU with an array Normals' "$vtu_file$(
    piece 4 1 "><DataArray Name='Normals' $normals" "$square" '3 0 1' 3 5)" \
    '3 0 1 of 0 (0 0 4) (0 0 1) (0 0 2)'
holds 'VTU that calls others its normals' "$vtu_file$(
    piece 4 1 "Normals='b'><DataArray Name='Normals' $normals<DataArray Name='b' $normals" \
        "$square" '3 0 1' 3 5)" \
    '3 0 1 of 0 (0 0 4) (0 0 1) (0 0 2)' "point field 'Normals' 3 real: 0 0 1 0 0 2 0 0 3 0 0 4"
holds 'VTU of all kinds of faces' "$vtu_file$(
    piece 4 8 '>' "$square" \
        '0 1 2  0 1 3 2  0 1 2 3 0 1  0 1 2 3 0 1 2 3  0 1 2 0 1 2 0 1 2 0  0 1 2
        0 1 2 3 0 1 2 3  0 1' \
        '3 7 13 21 31 34 42 44' '5 8 22 23 69 76 36 7')" \
    '7 cells, 3 polygons, 1 skipped, 4 curved, 0 lost' \
    '0 1 2 of 0' '0 1 2 of 1' '0 2 3 of 1' '0 1 2 of 2' '0 1 2 of 3' '0 2 3 of 3' '0 1 2 of 4' \
    '0 1 2 of 5' '0 1 2 of 6' '0 2 3 of 6'
holds 'whole numbers beyond 2^53' "$vtu_file$(
    piece 3 1 "><DataArray type='Int64' format='ascii' Name='a'>0 1 9007199254740992</DataArray>" \
        '0 0 0 1 0 0 0 1 0' '0 1 2' 3 5)" \
    '1 cells, 0 polygons, 0 skipped, 0 curved, 1 lost'

vtk='# vtk DataFile Version 2.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 int\n0 0 0\n1 0 0 0 1 0\n'
vtk_face='POLYGONS 1 4\n3 0 1 2\n'
holds 'VTK with CR LF' "$(printf %s "$vtk$vtk_face" | sed 's/\\n/\\r\\n/g')" '0 1 2 of 0'
holds 'VTK with data of all kinds' "$vtk${vtk_face}POINT_DATA 3\nCOLOR_SCALARS c 2\n0 1 .2 .4 .6 .8
TEXTURE_COORDINATES t 2 float\n1 2 3 4 5 6\nEDGE_FLAGS e bit\n1 0 1\nFIELD f 1\nNormals 3 3 float
0 0 1 0 0 1 0 0 1\nCELL_DATA 1\nTENSORS m float\n1 2 3\n4 5 6\n7 8 9\nNORMALS n char\n0 0 1\n" \
    "point field 'c' 2 colours: 0 255 51 102 153 204" "point field 't' 2 real: 1 2 3 4 5 6" \
    "point field 'e' 1 whole: 1 0 1" "cell field 'm' 9 real: 1 2 3 4 5 6 7 8 9" \
    "cell field 'n' 3 whole: 0 0 1" '0 1 2 of 0 (0 0 1) (0 0 1) (0 0 1)'
holds 'VTK with bits' '# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\nPOINTS 3 char
\0\0\0\1\0\0\0\1\0\nPOLYGONS 1 4\n\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\nPOINT_DATA 3\nSCALARS b bit
LOOKUP_TABLE default\n\240\nSCALARS u unsigned_char 1\nLOOKUP_TABLE default\n\377\200\1' \
    "point field 'b' 1 whole: 1 0 1" "point field 'u' 1 whole: 255 128 1"

msh='$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 .5 0 0\n5 .5 .5 0
6 0 .5 0\n$EndNodes\n'
holds 'MSH of order 2 and 3' "$msh\$Elements\n3\n1 9 2 0 1 1 2 3 4 5 6\n2 15 0 1
3 21 2 0 1 3 2 1 1 1 1 1 1 1 1\n\$EndElements\n" \
    '2 cells, 0 polygons, 1 skipped, 2 curved, 0 lost' '0 1 2 of 0' '2 1 0 of 1' \
    "cell field 'id' 1 whole: 1 3"
holds 'MSH with entities of their own' "$msh\$Elements\n2\n1 2 2 7 7 1 2 3\n2 2 2 7 8 1 3 2
\$EndElements\n" "cell field 'gmsh:geometrical' 1 whole: 7 8"
holds 'MSH with data of some elements' "$msh\$Elements\n2\n1 2 2 7 0 1 2 3\n2 2 2 8 0 3 2 1
\$EndElements\n\$ElementData\n1\n\"a \$b\"\n1\n0\n3\n2\n1\n1\n2 5\n\$EndElementData
\$NodeData\n0\n0\n3\n0\n1\n0\n\$EndNodeData\n\$ElementNodeData\n1 2 3\n\$EndElementNodeData\n" \
    "cell field 'a \$b@2' 1 real: nan 5" "cell field 'gmsh:physical' 1 whole: 7 8" \
    '2 cells, 0 polygons, 0 skipped, 0 curved, 2 lost'

# Cells that are turned inside out, and a voxel, whose corners have another order than a cube's.
solid='0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1'
for cells in '12 0 1 2 3 4 5 6 7' '12 4 5 6 7 0 1 2 3' '11 0 1 3 2 4 5 7 6' '12 0 1 2 2 4 5 6 6' \
    '25 0 1 2 3 4 5 6 7 0 0 0 0 0 0 0 0 0 0 0 0' \
    '29 4 5 6 7 0 1 2 3 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0'; do
    points=${cells#* }
    # shellcheck disable=SC2086
    set -- $points
    printf '%s' "$vtu_file$(piece 8 1 '>' "$solid" "$points" $# "${cells%% *}")" > "$dir/in"
    "$dump" --boundary "$dir/in" > "$dir/dump"
    case $cells in *'2 2'*) want=3 ;; *) want=6 ;; esac
    same "the volume of $cells" "$(volume < "$dir/dump")" $want
done
holds 'volumes, to whom nobody told --boundary' "$vtu_file$(
    piece 8 1 '>' "$solid" '0 1 2 3 4 5 6 7' 8 12)" \
    "dump: $dir/in: there are no faces in it, 1 other cells; --boundary takes that of volumes"

# ---- What is refused: nothing is written, the message names the place. ----
# refuse NAME FILE-TEXT REASON: REASON follows "smooth: FILE".
refuse() {
    printf "$2" > "$dir/in"
    got=$("$smooth" "$dir/in" -o "$dir/no.obj" 2>&1)
    same "$1 is refused with status 1" $? 1
    same "$1" "$got" "smooth: $dir/in$3"
    check "$1: no output" [ ! -e "$dir/no.obj" ]
}
# change NAME SEED SED REASON: the seed, edited; whose REASON is as above.
change() {
    LC_ALL=C sed "$3" "$dir/seeds/$2" > "$dir/in"
    got=$("$smooth" "$dir/in" -o "$dir/no.obj" 2>&1)
    same "$1 is refused with status 1" $? 1
    same "$1" "$got" "smooth: $dir/in$4"
    check "$1: no output" [ ! -e "$dir/no.obj" ]
}
text=usual_text.ply
change 'PLY of another version' $text 's/ 1.0$/ 2.0/' ":2: '2.0' is not the version 1.0 of PLY"
change 'PLY of an unknown format' $text 's/ascii/morse/' ":2: 'morse' is not a format of PLY"
change 'PLY without a format' $text '/^format/d' ':16: the header tells no format'
change 'PLY of an unknown type' $text 's/float ny/quad ny/' ":9: 'quad' is not a type of numbers"
change 'PLY with a wild count' $text 's/vertex 7/vertex 9999999/' \
    ':18: 159999983 bytes at least should follow, 219 are left'
change 'PLY with a negative count' $text 's/vertex 7/vertex -7/' \
    ':4: -7 is not from 0 to 2147483647'
change 'PLY with an index beyond' $text 's/^3 0 4 3/3 0 4 7/' \
    ':25: there is no vertex 7, only 0 to 6'
change 'PLY with a negative index' $text 's/^3 0 4 3/3 0 4 -1/' \
    ':25: there is no vertex -1, only 0 to 6'
change 'PLY with a wild list' $text 's/^3 0 4 3/300 0 4 3/' \
    ':25: 599 bytes at least should follow, 49 are left'
change 'PLY with a word' $text 's/^3 0 4 3/3 0 four 3/' ":25: 'four' is not a whole number"
change 'PLY with nan for a coordinate' $text 's/^2 2 0/2 nan 0/' ':20: not a finite number'
change 'PLY with a number too large' $text 's/^2 2 0/2 1e151 0/' \
    ':20: 1e+151 is too large, beyond 1e150'
change 'PLY without z' $text 's/float z/float w/' \
    ': there is no element vertex with properties x, y and z'
change 'PLY with numbers behind' $text '$s/$/ 5/' ':27: more numbers than the header tells'
head -c 400 "$dir/seeds/usual_big.ply" > "$dir/cut"
change 'PLY cut short' ../cut '' ': byte 328: 252 bytes at least should follow, 72 are left'

text=faces_ascii_0_little.vtu
change 'VTU compressed' $text 's/ version=/ compressor="vtkZLibDataCompressor" version=/' \
    ":3: 'vtkZLibDataCompressor' has compressed the file; only plain ones can be read"
change 'VTK XML of another type' $text 's/UnstructuredGrid" /PolyData" /' \
    ":3: 'PolyData' where the type UnstructuredGrid should be"
refuse 'another XML' '<?xml?>\n<svg/>' ":2: 'svg' where VTKFile should be"
change 'VTU with a wild count' $text 's/NumberOfPoints="7"/NumberOfPoints="9999999"/' \
    ':31: 59999993 bytes at least should follow, 46 are left'
change 'VTU with a negative count' $text 's/NumberOfPoints="7"/NumberOfPoints="-7"/' \
    ":6: '-7' is not a count"
change 'VTU with too few numbers' $text 's/NumberOfPoints="7"/NumberOfPoints="6"/' \
    ':32: more than 18 numbers'
change 'VTU with a wild index' $text 's/^0 1 2 0 4 3/0 1 2 0 4 7/' \
    ':36: the number 5 in it, 7, is not a whole one from 0 to 6'
change 'VTU with wild offsets' $text 's/^1 3 6 10/1 3 2 10/' \
    ':39: the number 2 in it, 2, is not a whole one from 3 to 19'
change 'VTU with a wild type' $text 's/^1 3 5 9 7 6/1 3 5 12 7 6/' \
    ':42: a cell of type 12 has 4 points, not 8'
change 'VTU without an array' $text 's/"offsets"/"offset"/' ':46: the piece has no array offsets'
change 'VTU with nan for a coordinate' $text 's/^0 0 0 2/0 0 nan 2/' \
    ':31: the vector 0 in it is not finite, or beyond 1e150'
change 'VTU cut short' $text '47,$d;46d' ':45: the end of a piece is missing'
change 'VTU with a tag cut short' $text '45,$d;44s/>$//' ':44: the tag has no end'
change 'VTU with a comment without end' $text 's/ -->/ --/' ":2: '-->' should follow"
change 'VTU with an unknown format' $text '36s/ascii/morse/' ":36: 'morse' is no format of arrays"
refuse 'VTU whose pieces differ' "$vtu_file$(
    piece 3 1 '>' '0 0 0 1 0 0 0 1 0' '0 1 2' 3 5
    piece 3 1 "><DataArray type='Int8' format='ascii' Name='a'>0 1 2</DataArray>" \
        '0 0 0 1 0 0 0 1 0' '0 1 2' 3 5)" ':1: the first piece has other arrays'
raw=faces_appended_0_little.vtu
change 'VTU with appended data cut short' $raw '/AppendedData/d' \
    ':19: there are no 568 bytes of appended data'
change 'VTU with a wild offset' $raw 's/offset="568"/offset="9999"/' \
    ':19: there are no 9999 bytes of appended data'
change 'VTU with wrong bytes' $raw 's/NumberOfPoints="7"/NumberOfPoints="6"/' \
    ': byte 2071: an array of 168 bytes, where 144 should be'
change 'VTU with arrays upon each other' $raw \
    '/label/s/$/<DataArray type="Int64" NumberOfComponents="70" format="appended" offset="0"\/>/' \
    ':11: the arrays are larger than the appended data'
change 'VTU with wrong base64' faces_binary_64_little.vtu '32s/^.../(((/' \
    ': byte 2025: 4 bytes should follow, 0 are left'

text=grid_5_text.vtk
change 'VTK of another version' $text '1s/5.1/6.0/' ":1: '6.0' is not a version from 1.0 to 5.1"
change 'VTK of another set' $text 's/UNSTRUCTURED/RECTILINEAR/' \
    ":4: 'RECTILINEAR_GRID' where POLYDATA or UNSTRUCTURED_GRID should be"
change 'VTK with an unknown keyword' $text 's/^CELLS/SELLS/' \
    ":17: 'SELLS' where a keyword should be"
change 'VTK with a wild count' $text 's/^POINTS 7/POINTS 7777/' \
    ':11: 46661 bytes at least should follow, 807 are left'
change 'VTK with a wild index' $text 's/^0 1 5 4/0 1 7 4/' ':24: there is no point 7, only 0 to 6'
change 'VTK with wild offsets' $text 's/^0 1 3 6/0 1 3 2/' ':19: 2 is not from 3 to 19'
change 'VTK with an offset beyond' $text 's/^0 1 3 6/0 1 3 20/' ':19: 20 is not from 3 to 19'
change 'VTK with fewer types' $text 's/^CELL_TYPES 6/CELL_TYPES 5/' ':28: 5 types of 6 cells'
change 'VTK without types' $text '/^CELL_TYPES/,$d' ':28: the types of the cells are missing'
change 'VTK with data of others' $text 's/^CELL_DATA 6/CELL_DATA 5/' \
    ':30: data of 5, not of the 6 there are'
change 'VTK with rows of others' $text 's/^material 1 6/material 1 5/' \
    ':35: 5 rows of 1, where 6 rows should be'
change 'VTK with nan for a normal' $text 's/^0 0 1 0.125/0 0 nan 0.125/' \
    ':56: the normals before this are not all finite and below 1e150'
change 'VTK of mixed cells, with one too long' grid_3_text.vtk 's/^5 0 1 2 6/50 0 1 2 6/' \
    ':22: 50 is not from 0 to 9'
change 'VTK of mixed cells, with less numbers' grid_3_text.vtk 's/^CELLS 6 25/CELLS 6 26/' \
    ':23: the cells have 25 numbers, not 26'
head -c 400 "$dir/seeds/polydata_5_big.vtk" > "$dir/cut"
change 'VTK cut short' ../cut '' ': byte 362: 96 bytes at least should follow, 38 are left'
refuse 'points of bits' '# vtk DataFile Version 2.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 bit\n0' \
    ':5: the type bit is not for points or cells'

text=faces1_2_text.msh
change 'MSH of version 4.0' $text 's/^2.2 0/4 0/' \
    ":2: '4' is not the version 2 or 4.1 of the format"
change 'MSH with a wild size' $text 's/^2.2 0 8/2.2 0 7/' ":2: '7' is not a size of 4 or 8 bytes"
change 'MSH without its format' $text '1,3d' ":4: '\$PhysicalNames' before the format is told"
change 'MSH with a wild count' $text '/Nodes$/{n;s/7/8/;}' ":22: '\$EndNodes' is not a whole number"
change 'MSH with nan for a coordinate' $text 's/^3 2 2 0/3 2 nan 0/' ':16: not a finite number'
change 'MSH with two of a number' $text 's/^3 2 2 0/2 2 2 0/' \
    ':20: two nodes before here have the same number'
change 'MSH with an unknown node' $text 's/^3 2 3 12 3 0 1 5 4/3 2 3 12 3 0 1 5 9/' \
    ':28: there is no node 9'
change 'MSH with an unknown type' $text 's/^3 2 3 12 3 0/3 34 3 12 3 0/' \
    ':28: the type 34 of elements is not known'
change 'MSH with a section without end' $text '/EndElements/d' \
    ":30: '\$NodeData' where the section should end"
change 'MSH with a comment without end' $text '/EndComments/d' ":4: '\$Comments' has no end"
change 'MSH with wild data' $text '/NodeData$/,/EndNodeData/s/^4$/2/' \
    ':36: of step, components and rows, there are 2'
head -c 500 "$dir/seeds/faces1_4_big.msh" > "$dir/cut"
change 'MSH cut short' ../cut '' ': byte 499: 8 bytes should follow, 1 are left'
change 'MSH with another 1' faces1_2_little.msh '3s/^./7/' ': byte 20: the number 1 should be here'

# ---- What is written: fields between points and of children, groups, numbers. ----
# The points are numbered from 0; the first and the cell of one point are left out.
cat > "$dir/one.vtk" << 'END'
# vtk DataFile Version 3.0

ASCII
DATASET UNSTRUCTURED_GRID
POINTS 4 double
9 9 9 0 0 0 4 0 0 0 4 0
CELLS 2 6
3 1 2 3 1 0
CELL_TYPES 2
5 1
POINT_DATA 4
FIELD point 4
height 1 4 double
9 0 0.25 2
flow%20rate 3 4 float
0 0 0 0 0 1 0 2 0 4 0 0
label 1 4 int
9 10 20 30
colour 3 4 unsigned_char
9 9 9 255 0 0 0 255 0 0 0 255
CELL_DATA 2
FIELD cell 2
gmsh:physical 1 2 int
7 8
a<b&c 1 2 double
0.5 1
END
quiet() { "$smooth" --quiet "$@"; }
head='cells, 0 polygons, 0 skipped, 0 curved, 0 lost'
points='points (0 0 0) (4 0 0) (0 4 0) (2 0 0) (2 2 0) (0 2 0)'
halves="point field 'height' 1 real: 0 0.25 2 0.125 1.125 1
point field 'flow rate' 3 real: 0 0 1 0 2 0 4 0 0 0 1 0.5 2 1 0 2 0 0.5
point field 'label' 1 whole: 10 20 30 10 20 10
point field 'colour' 3 colours: 255 0 0 0 255 0 0 0 255 128 128 0 0 128 128 128 0 128
point field 'id' 1 whole: 1 2 3 4 5 6
cell field 'gmsh:physical' 1 whole: 7 7 7 7
cell field 'a<b&c' 1 real: 0.5 0.5 0.5 0.5"
# wrote FILE: what is read of it, without normals.
wrote() { "$dump" "$1" | sed '/ of /s/ (.*//'; }
for coding in --text --binary; do
    for file in one.vtu one.vtk one.ply one.msh; do
        quiet "$dir/one.vtk" -n 2 -o "$dir/out/$file" $coding
    done
    for file in one.vtu one.vtk; do
        same "$file $coding" "$(wrote "$dir/out/$file")" "4 $head
$points
0 3 5 of 0
4 5 3 of 1
3 1 4 of 2
5 4 2 of 3
$halves"
    done
    same "fields in PLY $coding" "$(wrote "$dir/out/one.ply" | grep field)" \
        "$(echo "$halves" | sed "/flow/c\\
point field 'flow_rate_0' 1 real: 0 0 4 0 2 2\\
point field 'flow_rate_1' 1 real: 0 2 0 1 1 0\\
point field 'flow_rate_2' 1 real: 1 0 0 0.5 0 0.5
s/a<b/a<b/
/colour/c\\
point field 'colour_0' 1 whole: 255 0 0 128 0 128\\
point field 'colour_1' 1 whole: 0 255 0 128 128 0\\
point field 'colour_2' 1 whole: 0 0 255 0 128 128")"
    same "fields in MSH $coding" "$(wrote "$dir/out/one.msh" | grep field)" \
        "$(echo "$halves" | sed "s/ whole: 10/ real: 10/;s/colours:/real:/;/'id'/d")"
done

# Numbers of nodes go on from the highest in the file; those of elements stay while each has one
# triangle; the groups of volumes go to their boundary.
msh_file() {
    printf '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n%s 7 "skin"\n' "$1"
    printf '%s 8 "a \047core\047"\n$EndPhysicalNames\n$Nodes\n%s\n$EndNodes\n' "$2" "$3"
    printf '$Elements\n%s\n$EndElements\n' "$4"
}
corners='9 0 0 0
5 3 0 0
6 0 3 0'
msh_file 2 3 "4
$corners
99 0 0 3" '2
40 2 2 7 3 9 5 6
41 4 2 8 4 9 5 6 99' > "$dir/in.msh"
quiet "$dir/in.msh" -o "$dir/out/two.msh" --order 2
same 'MSH of order 2' "$(cat "$dir/out/two.msh")" "$(msh_file 2 3 "6
$corners
100 1.5 0 0
101 1.5 1.5 0
102 0 1.5 0" '1
40 9 2 7 3 9 5 6 100 101 102')"
quiet "$dir/in.msh" -o "$dir/out/one.msh" -n 2
check 'MSH of facets has the numbers of their cells' \
    [ "$(sed -n '/^"id"/,/^\$End/p' "$dir/out/one.msh" | grep -c ' 40$')" = 4 ]
quiet "$dir/in.msh" -o "$dir/out/one.msh" -n 1 --boundary
same 'MSH of the boundary' "$(sed '/ElementData/,$d' "$dir/out/one.msh")" "$(msh_file 3 2 "4
$corners
99 0 0 3" '4
1 2 2 8 4 9 6 5
2 2 2 8 4 9 5 99
3 2 2 8 4 5 6 99
4 2 2 8 4 6 9 99')"

# ---- Own files, read again, are written again byte for byte. ----
cat > "$dir/ball.vtk" << 'END'
# vtk DataFile Version 3.0

ASCII
DATASET POLYDATA
POINTS 6 double
1 0 0 -1 0 0 0 1.1 0 0 -1 0 0 0 1 0 0 -1.3
POLYGONS 8 32
3 0 2 4 3 2 1 4 3 1 3 4 3 3 0 4 3 2 0 5 3 1 2 5 3 3 1 5 3 0 3 5
POINT_DATA 6
FIELD point 2
third 1 6 double
0.1 0.2 0.3333333333333333 1e-300 -5e300 0.7
pair 2 6 int
1 2 3 4 5 6 7 8 9 10 11 -12
CELL_DATA 8
FIELD cell 2
id 1 8 int
18 17 16 15 14 13 12 11
tensor 9 8 double
1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9
1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8.5 .1
END
# again FILE OPTIONS...: a file of the ball in the format of this name, what it becomes, and that.
again() {
    name=$1 type=${1#*.} coding=$2
    shift 2
    quiet "$dir/ball.vtk" --crease 180 "$@" $coding -o "$dir/out/one.$type"
    case $* in -n* | --tol*) set -- -n 1 ;; esac
    for i in one two; do
        next=two
        [ $i = one ] || next=three
        quiet "$dir/out/$i.$type" --crease 180 "$@" $coding -o "$dir/out/$next.$type"
    done
    check "$name $* $coding again" cmp -s "$dir/out/two.$type" "$dir/out/three.$type"
    [ "$type" = msh ] ||
        check "$name $* $coding" cmp -s "$dir/out/one.$type" "$dir/out/two.$type"
}
for coding in --text --binary; do
    for type in vtu vtk msh ply; do
        again $type $coding -n 1
        again $type $coding -n 3
        again $type $coding --tol 3%
        [ $type = ply ] || again $type $coding --order 2
        [ $type = ply ] || again $type $coding --order 3
    done
    again vtu $coding --bezier
    again vtk $coding --bezier
done
quiet "$dir/ball.vtk" -n 3 -o "$dir/out/one.obj"
quiet "$dir/out/one.obj" -n 1 -o "$dir/out/two.obj"
# corners FILE: of each face of an OBJ file the places and normals.
corners() {
    awk '$1 == "v" { v[++n] = $0 } $1 == "vn" { vn[++k] = $0 }
         $1 == "f" { for (i = 2; i <= 4; i++) { split($i, c, "//"); print v[c[1]], vn[c[2]] } }' "$1"
}
same 'OBJ again' "$(corners "$dir/out/two.obj" | cksum)" "$(corners "$dir/out/one.obj" | cksum)"
quiet "$dir/ball.vtk" -n 3 -o "$dir/out/one.stl"
quiet "$dir/out/one.stl" -n 1 -o "$dir/out/two.stl"
quiet "$dir/out/two.stl" -n 1 -o "$dir/out/three.stl"
check 'STL again' cmp -s "$dir/out/two.stl" "$dir/out/three.stl"

# Sharp edges: a point of PLY for each normal, which reading joins; no normals in VTU.
points='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n'
printf "${points}f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n" > "$dir/cube.obj"
quiet "$dir/cube.obj" -n 1 -o "$dir/out/cube.ply"
check 'PLY has three points at each corner' grep -qx 'element vertex 24' "$dir/out/cube.ply"
quiet "$dir/out/cube.ply" -n 1 -o "$dir/out/two.ply"
check 'PLY of a cube again' cmp -s "$dir/out/cube.ply" "$dir/out/two.ply"
quiet "$dir/cube.obj" -n 1 -o "$dir/out/cube.vtu"
check 'VTU of a cube has no normals' sh -c '! grep -q Normals "$0"' "$dir/out/cube.vtu"

# A NaN, which not all programs read in texts; names that XML does not have.
sed 's/^0.1 0.2/nan 0.2/;s/^third/%C3%A9%E9%01/' "$dir/ball.vtk" > "$dir/nan.vtk"
quiet "$dir/nan.vtk" -o "$dir/out/nan.vtu"
check 'a NaN is written in bytes' grep -q 'encoding="raw"' "$dir/out/nan.vtu"
check 'names are what XML has' grep -q "Name=\"$(printf '\303\251__')\"" "$dir/out/nan.vtu"
quiet "$dir/nan.vtk" -o "$dir/out/nan.vtu" --text
check 'or as text, if one wants it' grep -qx nan "$dir/out/nan.vtu"

# ---- STEP: every instance is there once and what it names is; the faces close. ----
# step FILE WORD...: how often each of the words begins an instance.
step() {
    file=$1
    shift
    for word; do printf '%s ' "$(grep -c "^#[0-9]*=$word(" "$file")"; done
}
entities='VERTEX_POINT EDGE_CURVE ADVANCED_FACE CLOSED_SHELL OPEN_SHELL MANIFOLD_SOLID_BREP
    BREP_WITH_VOIDS SHELL_BASED_SURFACE_MODEL'
is_whole() {
    awk 'match($0, /^#[0-9]+=/) { if (substr($0, 1, RLENGTH - 1) in known) bad++
                                  known[substr($0, 1, RLENGTH - 1)]; sub(/^#[0-9]+/, "") }
         { while (match($0, /#[0-9]+/)) { named[substr($0, RSTART, RLENGTH)]
                                          $0 = substr($0, RSTART + RLENGTH) } }
         END { for (n in named) if (!(n in known)) bad++
               if (bad) print "    " bad " instances are wrong"
               exit bad > 0 }' "$1"
}
# Each edge has two sides, one in each direction.
closes() { grep -o "ORIENTED_EDGE.*" "$1" | sort | uniq -c | awk '$1 != 1 { exit 1 }'; }
quiet "$dir/cube.obj" -o "$dir/out/cube.step"
same 'STEP of a cube' "$(step "$dir/out/cube.step" $entities)" '8 18 12 1 0 1 0 0 '
# cubes [TURNED]: a cube of side 4 and within it another one, which may look to its inside.
cubes() {
    awk '/^v/ { print "v", 4 * $2 - 1, 4 * $3 - 1, 4 * $4 - 1 }' "$dir/cube.obj"
    grep '^v' "$dir/cube.obj"
    grep '^f' "$dir/cube.obj"
    awk -v turned="$1" '/^f/ { if (turned) print "f", $5 + 8, $4 + 8, $3 + 8, $2 + 8
                               else print "f", $2 + 8, $3 + 8, $4 + 8, $5 + 8 }' "$dir/cube.obj"
}
cubes turned > "$dir/cavity.obj"
quiet "$dir/cavity.obj" -o "$dir/out/cavity.step"
same 'STEP of a cavity' "$(step "$dir/out/cavity.step" $entities)" '16 36 24 2 0 0 1 0 '
cubes '' > "$dir/two.obj"
quiet "$dir/two.obj" -o "$dir/out/two.step"
same 'STEP of two solids' "$(step "$dir/out/two.step" $entities)" '16 36 24 2 0 2 0 0 '
sed '$d' "$dir/two.obj" > "$dir/open.obj"
quiet "$dir/open.obj" -o "$dir/out/open.stp"
same 'STEP of a solid and a sheet' "$(step "$dir/out/open.stp" $entities)" '16 35 22 1 1 1 0 1 '
awk '/^f/ { print "f", $5, $4, $3, $2 } /^v/' "$dir/cube.obj" > "$dir/turned.obj"
quiet "$dir/turned.obj" -o "$dir/out/turned.step"
same 'STEP of a cube turned inside out' "$(step "$dir/out/turned.step" $entities)" \
    '8 18 12 1 0 1 0 0 '
check 'its faces are turned' sh -c '! grep -q "FACE.*\.T\.);" "$0"' "$dir/out/turned.step"
for file in "$dir"/out/*.st*p; do check "$file is whole" is_whole "$file"; done
for file in cube cavity two turned; do check "$file closes" closes "$dir/out/$file.step"; done

# ---- The report, where nobody takes it. ----
{
    sleep 1
    "$smooth" "$dir/cube.obj" --quiet --report 2> "$dir/stderr"
    echo $? > "$dir/status"
} | :
same 'status of a report into a closed pipe' "$(cat "$dir/status")" 1
check 'what it says' grep -q '^smooth: standard output: ' "$dir/stderr"

verdict
