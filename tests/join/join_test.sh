#!/bin/sh
# join_test.sh JOIN SEAMS: tests of the program join, run from the top of the project.
join=$1 seams=$2 suite=join program=$1
. tests/check.sh
meshes=../shared/meshes
"$seams" "$dir"

quiet() { "$join" --quiet "$@"; }

# open_sides OBJ: sides of triangles without a partner that runs the other way, and those that are
# there twice.
open_sides() {
    awk '$1 == "f" { for (i = 2; i <= 4; i++) { split($i, a, "/"); corner[i] = a[1] }
                     corner[5] = corner[2]
                     for (i = 2; i <= 4; i++) side[corner[i], corner[i + 1]]++ }
         END { for (s in side) { split(s, a, SUBSEP)
                                 if (side[s] > 1) twice++
                                 if (!side[a[2], a[1]]) open++ }
               print open + 0, twice + 0 }' "$1"
}

# fails NAME STATUS TEXT OPTIONS...: ends with the status, says the text, and leaves no file.
fails() {
    what=$1 status=$2 text=$3
    shift 3
    rm -f "$dir/none.obj"
    said=$("$join" -o "$dir/none.obj" "$@" 2>&1)
    got=$?
    same "$what: status" "$got" "$status"
    case $said in
    *"$text"*) check "$what: message" true ;;
    *) same "$what: message" "$said" "$text" ;;
    esac
    check "$what: no file" [ ! -e "$dir/none.obj" ]
}

# obj NAME TEXT: a file with the escapes of printf.
obj() { printf "$2" >"$dir/$1.obj"; }

# ---- The five inputs: every method, both seams closed. ----
for input in circles square bent waves abrupt; do
    lower=$dir/${input}_lower.obj upper=$dir/${input}_upper.obj
    for method in nagata fujita straight; do
        quiet "$lower" "$upper" -o "$dir/out.obj" --method $method --rows 5
        same "$input, $method: closed along both seams" "$(open_sides "$dir/out.obj")" "48 0"
    done
done

# Both meshes stand in the file as they were.
sed 's/^v //;t;d' "$dir/bent_lower.obj" "$dir/bent_upper.obj" >"$dir/want"
quiet "$dir/bent_lower.obj" "$dir/bent_upper.obj" -o "$dir/out.obj"
sed 's/^v //;t;d' "$dir/out.obj" | sed 192q | awk '{ printf "%.17g %.17g %.17g\n", $1, $2, $3 }' |
    cmp -s - "$dir/want"
same 'points kept' $? 0
same 'the bridge is closed' "$(open_sides "$dir/out.obj")" '48 0'

# Every format that smooth writes.
for extension in obj stl ply vtu vtk msh step; do
    quiet "$dir/waves_lower.obj" "$dir/waves_upper.obj" -o "$dir/out.$extension" --rows 2
    check "$extension is written" [ -s "$dir/out.$extension" ]
done
quiet "$dir/out.ply" "$dir/circles_upper.obj" -o "$dir/three.obj" --loops v1,1
check 'a joined mesh can be joined again' [ -s "$dir/three.obj" ]
quiet "$dir/out.stl" "$dir/circles_upper.obj" -o "$dir/three.obj"
same 'STL is welded' "$(open_sides "$dir/three.obj" | cut -d' ' -f2)" 0

# ---- Options ----
lower=$dir/circles_lower.obj upper=$dir/circles_upper.obj
count() { grep -c "^$1 " "$dir/out.obj"; }
quiet "$lower" "$upper" -o "$dir/out.obj" --rows 7
same 'rows: points' "$(count v)" $((96 + 96 + 7 * 24))
same 'rows: triangles' "$(count f)" $((144 + 144 + 8 * 48))
quiet "$lower" "$upper" -o "$dir/out.obj" --rows 0
same 'no rows' "$(count f)" $((144 + 144 + 48))
quiet "$lower" "$upper" -o "$dir/out.obj" --tol 0.01%
many=$(count v)
quiet "$lower" "$upper" -o "$dir/out.obj" --tol 0.0004
check 'tolerances: percent and length' [ "$many" -gt "$(count v)" ]
quiet "$lower" "$upper" -o "$dir/out.obj" --method straight
same 'straight lines need no rows' "$(count v)" 192
quiet "$lower" "$upper" -o "$dir/one.obj" --loops 1,1
quiet "$lower" "$upper" -o "$dir/two.obj" --loops v1,v1
quiet "$lower" "$upper" -o "$dir/out.obj"
check 'loops by number and by point differ' [ -s "$dir/one.obj" ]
cmp -s "$dir/two.obj" "$dir/out.obj"
same 'another loop makes another bridge' $? 1
same 'the other loops are closed too' "$(open_sides "$dir/two.obj")" '48 0'
quiet "$lower" "$upper" -o "$dir/nearest.obj" --loops v96,v1
cmp -s "$dir/nearest.obj" "$dir/out.obj"
same 'the nearest loops are taken' $? 0
quiet "$lower" "$upper" -o "$dir/turned.obj" --start 73,5
cmp -s "$dir/turned.obj" "$dir/out.obj"
same 'start' $? 1
same 'start: closed' "$(open_sides "$dir/turned.obj")" '48 0'
quiet "$lower" "$upper" -o "$dir/turned.obj" --direction with
same 'direction: closed' "$(open_sides "$dir/turned.obj")" '48 0'
quiet "$lower" "$upper" -o "$dir/turned.obj" --direction against
cmp -s "$dir/turned.obj" "$dir/out.obj"
same 'direction as found' $? 0
quiet "$lower" "$upper" -o "$dir/weak.obj" --strength 0.5,2
cmp -s "$dir/weak.obj" "$dir/out.obj"
same 'strength' $? 1
said=$("$join" "$lower" "$upper" -o "$dir/out.obj" --rows 3 2>&1 | grep 'seams')
same 'what it says of the seams' "$said" \
    "join: the seams bend by at most 3.25 degrees at $lower, 7.58 at $upper"
same 'quiet' "$(quiet "$lower" "$upper" -o "$dir/out.obj" 2>&1)" ''
awk '$1 == "f" { print $1, $2, $4, $3; next } { print }' "$upper" >"$dir/inside_out.obj"
said=$("$join" "$lower" "$dir/inside_out.obj" -o "$dir/out.obj" 2>&1 | grep -c 'turned inside out')
same 'inside out: said' "$said" 1
same 'inside out: closed' "$(open_sides "$dir/out.obj")" '48 0'

# Normals in the files, which their triangles do not have.
sheet='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn -1 0 1\nvn 1 0 1\n'
obj sheet "${sheet}f 1//1 2//2 3//2\\nf 1//1 3//2 4//1\\n"
obj apart 'v 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\nf 3 2 1\nf 4 3 1\n'
quiet "$dir/sheet.obj" "$dir/apart.obj" -o "$dir/out.obj" --rows 4
quiet "$dir/sheet.obj" "$dir/apart.obj" -o "$dir/other.obj" --rows 4 --normals
cmp -s "$dir/out.obj" "$dir/other.obj"
same 'normals' $? 1
same 'two sheets make a closed body' "$(open_sides "$dir/out.obj")" '0 0'

# ---- What cannot be ----
box='v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'
obj closed "$box"
obj sheets 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n'
obj nan 'v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n'
obj unused 'v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.5 0.5 0\nf 2 3 5\nf 3 4 5\nf 4 2 5\n'
fails 'closed' 1 'closed.obj: it is closed' "$lower" "$dir/closed.obj"
fails 'no loop' 1 'sheets.obj: the border is no loop' "$dir/sheets.obj" "$upper"
fails 'NaN' 1 "nan.obj:2: 'nan'" "$dir/nan.obj" "$upper"
fails 'the same twice' 1 'the loops are in the same place' "$lower" "$lower"
fails 'no such loop' 1 'there is no loop 3, only 2' "$lower" "$upper" --loops 3,1
fails 'no such point' 1 'there is no point 97' "$lower" "$upper" --loops v97,v1
fails 'a point left out' 1 'there is no point 1;' "$dir/unused.obj" "$upper" --loops v1,v1
fails 'a point inside' 1 'the point 30 is not on the border' "$lower" "$upper" --loops v30,v1
fails 'a start elsewhere' 1 'the point 30 is not on loop' "$lower" "$upper" --start 30,1
fails 'unequal' 1 'different numbers of points' "$lower" "$dir/sheet.obj" --method fujita
fails 'too many rows' 1 'too many rows' "$lower" "$upper" --tol 1e-50
fails 'one file' 2 'two files' "$lower"
fails 'three files' 2 'two files at a time' "$lower" "$lower" "$lower"
fails 'no such option' 2 "there is no option '--row'" "$lower" "$upper" --row 3
fails 'no value' 2 '--rows takes a value' "$lower" "$upper" --rows
fails 'no number' 2 '--rows takes a number' "$lower" "$upper" --rows x
fails 'no such method' 2 "--method has no 'x'" "$lower" "$upper" --method x
fails 'one loop' 2 '--loops takes two' "$lower" "$upper" --loops 1
fails 'too strong' 2 'a --strength below 1' "$lower" "$upper" --method fujita --strength 1,1
fails 'no such file' 1 'none_such.obj: No such file' "$lower" "$dir/none_such.obj"
same 'no output' "$("$join" "$lower" "$upper" 2>&1 | head -n 1)" \
    'join: no file to write; -o OUT names it'
"$join" "$lower" "$upper" -o "$dir/out.xyz" 2>/dev/null
same 'no such format' $? 2
version=$(sed -n 's/^.define NAGATA3_VERSION "\(.*\)"/\1/p' nagata3.h)
same 'version' "$("$join" --version)" "join $version"
"$join" --help >"$dir/help"
same 'help' $? 0
check 'help fits' [ "$(awk 'length > 100' "$dir/help" | wc -l)" -eq 0 ]

# Points keep the numbers of the file.
quiet "$dir/unused.obj" "$upper" -o "$dir/out.obj" --loops v2,v1
check 'numbers of the file' [ -s "$dir/out.obj" ]

# ---- Real meshes ----
move() { awk -v dx="$2" -v dz="$3" '$1 == "v" { $2 += dx; $4 += dz } { print }' "$1"; }
if [ -e $meshes/gc_cat_head.obj ]; then
    cat=$meshes/gc_cat_head.obj
    move $cat 3 0 >"$dir/cat.obj"
    said=$("$join" $cat "$dir/cat.obj" -o "$dir/out.obj" --rows 63 2>&1 | grep 'seams')
    same 'two cats' "$said" \
        "join: the seams bend by at most 2.88 degrees at $cat, 3.43 at $dir/cat.obj"
    said=$("$join" $cat "$dir/cat.obj" -o "$dir/out.obj" 2>&1 | grep -c 'the bridge folds')
    same 'two cats, side by side: folds are told' "$said" 1
    same 'two cats: closed' "$(open_sides "$dir/out.obj")" '0 0'
    awk '$1 == "v" { $3 = -$3 - 3; $4 = -$4 } { print }' $cat >"$dir/cat.obj"
    said=$("$join" $cat "$dir/cat.obj" -o "$dir/out.obj" --rows 31 2>&1 | grep 'seams')
    same 'two cats, neck to neck' "$said" \
        "join: the seams bend by at most 4.36 degrees at $cat, 4.36 at $dir/cat.obj"
    said=$("$join" $cat "$dir/cat.obj" -o "$dir/out.obj" 2>&1 | grep -c 'the bridge folds')
    same 'two cats, neck to neck: no folds' "$said" 0
    quiet $meshes/gc_lego.ply "$dir/cat.obj" -o "$dir/out.obj"
    same 'a brick and a cat: closed' "$(open_sides "$dir/out.obj")" '0 0'
    quiet $meshes/osd_loop_saddle_edgecorner.obj $cat -o "$dir/out.obj"
    same 'a saddle and a cat: closed' "$(open_sides "$dir/out.obj")" '0 0'
    fails 'a Moebius band' 1 'the border is no loop' $meshes/gc_moebius.obj $cat
    fails 'three sheets' 1 'the border is no loop' $cat $meshes/gc_fan3.obj
    fails 'a torus' 1 'it is closed' $meshes/cad_torus.obj $cat
else
    echo "skip the shared meshes: $meshes is not there"
fi

verdict
