#include "seeds.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- What is in the files. Coordinates and values are exact in single precision. ---- */

enum { POINTS = 7, CELLS = 6, VOLUME_POINTS = 12, VOLUMES = 4 };

static const double point[POINTS][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0},  {0, 2, 0},
                                        {0, 0, 1}, {2, 0, 1}, {1, 3, 0.5}};

typedef struct cell {
    int kind, n, corner[8]; /* kind: as in VTK */
} cell;

/* Of the formats, PLY takes the second to the last but one, MSH all but the last two. */
static const cell cells[CELLS] = {
    {1, 1, {0}},          {3, 2, {1, 2}},          {5, 3, {0, 4, 3}},
    {9, 4, {0, 1, 5, 4}}, {7, 5, {0, 1, 2, 6, 3}}, {6, 4, {5, 1, 6, 2}}};

/* A cube, a pyramid on it, a wedge beside it and a tetrahedron beside that. */
static const double volume_point[VOLUME_POINTS][3] = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0},     {0, 1, 0}, {0, 0, 1}, {1, 0, 1},
    {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 2}, {2, 0, 0}, {2, 1, 0}, {1.25, -1, 0.25}};
static const cell volumes[VOLUMES] = {{12, 8, {0, 1, 2, 3, 4, 5, 6, 7}},
                                      {14, 5, {4, 5, 6, 7, 8}},
                                      {13, 6, {1, 9, 5, 2, 10, 6}},
                                      {10, 4, {1, 9, 5, 11}}};

static double temperature(int i) { return i == 6 ? (double)NAN : 100 + i / 4.0; }
static double displacement(int i, int k) { return k == 0 ? i : k == 1 ? -i / 2.0 : i / 8.0; }
static double label(int i) { return i * i; }
static double normal(int i, int k) { return k == 0 ? i / 8.0 : k - 1; }
static double stress(int i) { return i / 2.0 - 1; }
static double material(int i) { return 10 + i; }

/* ---- Writing into memory. ---- */

enum { TEXT, LITTLE, BIG }; /* orders of numbers */

typedef struct out {
    char *data;
    size_t size, space;
    int order;
} out;

static void put(out *o, const void *data, size_t size)
{
    while (o->size + size > o->space) {
        o->space = 2 * o->space + 64;
        o->data = realloc(o->data, o->space);
        if (!o->data) abort();
    }
    if (size) memcpy(o->data + o->size, data, size);
    o->size += size;
}

static void say(out *o, const char *format, ...)
{
    char line[500];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    put(o, line, strlen(line));
}

typedef struct type {
    char kind; /* i: an integer, f: floating */
    int bytes;
    const char *name;
} type;

static void number(out *o, type t, double x)
{
    uint64_t bits = (uint64_t)(int64_t)(isnan(x) ? 0 : x);
    float single = (float)x;
    uint32_t half;
    char byte[8];
    int i;
    if (o->order == TEXT) {
        say(o, "%.17g ", x);
        return;
    }
    memcpy(&half, &single, sizeof half);
    if (t.kind == 'f' && t.bytes == 4) bits = half;
    if (t.kind == 'f' && t.bytes == 8) memcpy(&bits, &x, sizeof bits);
    for (i = 0; i < t.bytes; i++)
        byte[o->order == LITTLE ? i : t.bytes - 1 - i] = (char)(bits >> 8 * i & 255);
    put(o, byte, (size_t)t.bytes);
}

static void line_end(out *o)
{
    if (o->order == TEXT) say(o, "\n");
}

static void put_base64(out *o, const char *data, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    size_t i, j;
    for (i = 0; i < size; i += 3) {
        uint32_t bits = 0;
        char group[4];
        for (j = 0; j < 3; j++) bits = bits << 8 | (i + j < size ? (unsigned char)data[i + j] : 0);
        for (j = 0; j < 4; j++) group[j] = digits[bits >> (18 - 6 * j) & 63];
        if (i + 2 >= size) group[3] = '=';
        if (i + 1 >= size) group[2] = '=';
        put(o, group, 4);
    }
}

/* ---- PLY. ---- */

static const type int8 = {'i', 1, "Int8"}, uint8 = {'i', 1, "UInt8"}, int16 = {'i', 2, "Int16"},
                  int32 = {'i', 4, "Int32"}, int64 = {'i', 8, "Int64"}, uint64 = {'i', 8, "UInt64"},
                  uint32 = {'i', 4, "UInt32"}, float32 = {'f', 4, "Float32"},
                  float64 = {'f', 8, "Float64"};

static void ply_head(out *o, const char *end)
{
    static const char *const orders[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    say(o, "ply%sformat %s 1.0%scomment a # of \\%s", end, orders[o->order], end, end);
}

/* As most programs write it. */
static void ply_usual(out *o)
{
    int i, j;
    ply_head(o, "\n");
    say(o, "element vertex %d\nproperty float x\nproperty float y\nproperty float z\n", POINTS);
    say(o, "property float nx\nproperty float ny\nproperty float nz\n");
    say(o, "property double temperature\nproperty int label\nelement face 3\n");
    say(o, "property list uchar int vertex_indices\nproperty float stress\n");
    say(o, "property int material\nend_header\n");
    for (i = 0; i < POINTS; i++) {
        for (j = 0; j < 3; j++) number(o, float32, point[i][j]);
        for (j = 0; j < 3; j++) number(o, float32, normal(i, j));
        number(o, float64, temperature(i));
        number(o, int32, label(i));
        line_end(o);
    }
    for (i = 2; i < 5; i++) {
        number(o, uint8, cells[i].n);
        for (j = 0; j < cells[i].n; j++) number(o, int32, cells[i].corner[j]);
        number(o, float32, stress(i));
        number(o, int32, material(i));
        line_end(o);
    }
}

/* Faces first, properties and types in disorder, further elements and lists, CR LF. */
static void ply_odd(out *o)
{
    const char *end = "\r\n";
    int i, j;
    ply_head(o, end);
    say(o, "element extra 2%sproperty list ushort double a%sproperty short b%s", end, end, end);
    say(o, "element face 3%sproperty float32 stress%sproperty uint8 material%s", end, end, end);
    say(o, "property list int8 float junk%sproperty list float uint16 vertex_index%s", end, end);
    say(o, "obj_info b%selement vertex %d%sproperty double temperature%s", end, POINTS, end, end);
    say(o, "property float64 nz%sproperty int16 y%sproperty list uint8 uint8 c%s", end, end, end);
    say(o, "property float32 x%sproperty float nx%sproperty double z%s", end, end, end);
    say(o, "property char ny%sproperty uint label%send_header%s", end, end, end);
    for (i = 0; i < 2; i++) {
        number(o, int16, i);
        for (j = 0; j < i; j++) number(o, float64, 0.5);
        number(o, int16, -1);
        line_end(o);
    }
    for (i = 2; i < 5; i++) {
        number(o, float32, stress(i));
        number(o, uint8, material(i));
        number(o, int8, 2), number(o, float32, 7), number(o, float32, 8);
        number(o, float32, cells[i].n);
        for (j = 0; j < cells[i].n; j++) number(o, int16, cells[i].corner[j]);
        line_end(o);
    }
    for (i = 0; i < POINTS; i++) {
        number(o, float64, temperature(i));
        number(o, float64, normal(i, 2));
        number(o, int16, point[i][1]);
        number(o, uint8, 1), number(o, uint8, 200);
        number(o, float32, point[i][0]);
        number(o, float32, normal(i, 0));
        number(o, float64, point[i][2]);
        number(o, int8, normal(i, 1));
        number(o, uint32, label(i));
        line_end(o);
    }
}

/* ---- VTU. ---- */

/* The values of an array. */
typedef struct list {
    double value[60];
    int n;
} list;

static void add(list *a, double x) { a->value[a->n++] = x; }

typedef struct vtu {
    out *o;
    const char *format; /* of arrays */
    int base64;
    type header, real, whole;
    out appended;
} vtu;

/* Writes the list and empties it. */
static void vtu_array(vtu *v, const char *name, type t, int components, list *a)
{
    const int is_text = !strcmp(v->format, "ascii");
    out bytes = {NULL, 0, 0, is_text ? TEXT : v->o->order};
    out *to = strcmp(v->format, "appended") ? v->o : &v->appended;
    int i;
    say(v->o, "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"%s\"", t.name,
        name, components, v->format);
    say(v->o, to == v->o ? ">\n" : " offset=\"%d\"/>\n", (int)to->size);
    if (!is_text) number(&bytes, v->header, a->n * t.bytes);
    for (i = 0; i < a->n; i++) number(&bytes, t, a->value[i]);
    if (v->base64)
        put_base64(to, bytes.data, bytes.size);
    else
        put(to, bytes.data, bytes.size);
    if (to == v->o) say(v->o, "\n<InformationKey name=\"a\"/></DataArray>\n");
    free(bytes.data);
    a->n = 0;
}

static void vtu_cells(vtu *v, const cell *c, int n)
{
    list a = {{0}, 0};
    int i, j, end = 0;
    say(v->o, "<Cells>\n");
    for (i = 0; i < n; i++)
        for (j = 0; j < c[i].n; j++) add(&a, c[i].corner[j]);
    vtu_array(v, "connectivity", v->whole, 1, &a);
    for (i = 0; i < n; i++) add(&a, end += c[i].n);
    vtu_array(v, "offsets", v->whole, 1, &a);
    for (i = 0; i < n; i++) add(&a, c[i].kind);
    vtu_array(v, "types", uint8, 1, &a);
    say(v->o, "</Cells>\n");
}

static void vtu_points(vtu *v, const double x[][3], int n)
{
    list a = {{0}, 0};
    int i;
    say(v->o, "<Points>\n");
    for (i = 0; i < 3 * n; i++) add(&a, x[i / 3][i % 3]);
    vtu_array(v, "Points", v->real, 3, &a);
    say(v->o, "</Points>\n");
}

static void vtu_data(vtu *v)
{
    list a = {{0}, 0};
    int i;
    say(v->o, "<PointData Scalars=\"temperature\" Normals=\"n &amp; m\">\n");
    for (i = 0; i < POINTS; i++) add(&a, temperature(i));
    vtu_array(v, "temperature", float64, 1, &a);
    for (i = 0; i < 3 * POINTS; i++) add(&a, normal(i / 3, i % 3));
    vtu_array(v, "n &amp; m", v->real, 3, &a);
    for (i = 0; i < 3 * POINTS; i++) add(&a, displacement(i / 3, i % 3));
    vtu_array(v, "displacement", v->real, 3, &a);
    for (i = 0; i < POINTS; i++) add(&a, label(i));
    vtu_array(v, "label", v->whole, 1, &a);
    say(v->o, "</PointData>\n<CellData>\n");
    for (i = 0; i < CELLS; i++) add(&a, stress(i));
    vtu_array(v, "a &lt; b", v->real, 1, &a);
    for (i = 0; i < CELLS; i++) add(&a, material(i));
    vtu_array(v, "material", v->whole, 1, &a);
    say(v->o, "<Array type=\"String\" Name=\"s\" format=\"ascii\">97 0</Array>\n</CellData>\n");
}

static void vtu_begin(vtu *v)
{
    say(v->o, "<?xml version=\"1.0\"?>\n<!-- <Piece> > -->\n<VTKFile type=\"UnstructuredGrid\" ");
    say(v->o, "version=\"1.0\" byte_order='%sEndian' header_type=\"%s\">\n<UnstructuredGrid>\n",
        v->o->order == BIG ? "Big" : "Little", v->header.name);
    say(v->o, "<FieldData><DataArray type=\"Float64\" Name=\"t\" format=\"ascii\">1</DataArray>");
    say(v->o, "</FieldData>\n");
}

static void vtu_end(vtu *v)
{
    say(v->o, "</UnstructuredGrid>\n");
    if (v->appended.size) {
        say(v->o, "<AppendedData encoding=\"%s\">\n  _", v->base64 ? "base64" : "raw");
        put(v->o, v->appended.data, v->appended.size);
        say(v->o, "\n</AppendedData>\n");
    }
    say(v->o, "</VTKFile>\n");
    free(v->appended.data);
}

static void vtu_faces(vtu *v, int pieces)
{
    vtu_begin(v);
    while (pieces-- > 0) {
        say(v->o, "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n", POINTS, CELLS);
        vtu_data(v);
        vtu_points(v, point, POINTS);
        vtu_cells(v, cells, CELLS);
        say(v->o, "</Piece>\n");
    }
    vtu_end(v);
}

static void vtu_volumes(vtu *v)
{
    list a = {{0}, 0};
    int i;
    vtu_begin(v);
    say(v->o, "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n<CellData>\n", VOLUME_POINTS,
        VOLUMES);
    for (i = 0; i < VOLUMES; i++) add(&a, material(i));
    vtu_array(v, "material", v->whole, 1, &a);
    say(v->o, "</CellData>\n");
    vtu_points(v, volume_point, VOLUME_POINTS);
    vtu_cells(v, volumes, VOLUMES);
    say(v->o, "</Piece>\n");
    vtu_end(v);
}

/* ---- Legacy VTK. ---- */

static void vtk_begin(out *o, int version, const char *set, const double x[][3], int n)
{
    int i;
    say(o, "# vtk DataFile Version %s\n\n%s\nDATASET %s\n", version == 5 ? "5.1" : "3.0",
        o->order == TEXT ? "ASCII" : "BINARY", set);
    say(o, "FIELD FieldData 2\nTIME 1 1 double\n");
    number(o, float64, 0.5);
    say(o, "\nw 1 1 string\n%s\n", o->order == TEXT ? "a%20b" : "\303a b");
    say(o, "POINTS %d float\n", n);
    for (i = 0; i < 3 * n; i++) number(o, float32, x[i / 3][i % 3]);
    say(o, "\nMETADATA\nINFORMATION 1\nNAME a LOCATION b\nDATA 2 0 1.5\n\n");
}

/* Those of a kind and of another; 0: all. */
static void vtk_cells(out *o, int version, const char *word, const cell *c, int n, int size)
{
    int i, j, end = 0;
    say(o, "%s %d %d\n", word, version == 5 ? n + 1 : n, version == 5 ? size : n + size);
    if (version == 5) {
        say(o, "OFFSETS vtktypeint64\n");
        number(o, int64, 0);
        for (i = 0; i < n; i++) number(o, int64, end += c[i].n);
        say(o, "\nCONNECTIVITY vtktypeint64\n");
    }
    for (i = 0; i < n; i++) {
        if (version != 5) number(o, int32, c[i].n);
        for (j = 0; j < c[i].n; j++) number(o, version == 5 ? int64 : int32, c[i].corner[j]);
        line_end(o);
    }
    say(o, "\n");
}

static void vtk_kinds(out *o, const cell *c, int n)
{
    int i;
    say(o, "CELL_TYPES %d\n", n);
    for (i = 0; i < n; i++) number(o, int32, c[i].kind);
    say(o, "\n");
}

static void vtk_data(out *o)
{
    int i;
    say(o, "CELL_DATA %d\nSCALARS a%%20%%3c%%20b double\nLOOKUP_TABLE default\n", CELLS);
    for (i = 0; i < CELLS; i++) number(o, float64, stress(i));
    say(o, "\nFIELD FieldData 2\nmaterial 1 %d unsigned_char\n", CELLS);
    for (i = 0; i < CELLS; i++) number(o, uint8, material(i));
    say(o, "\nMETADATA\nCOMPONENT_NAMES\na\n\ns 1 %d string\n", CELLS);
    for (i = 0; i < CELLS; i++) say(o, o->order == TEXT ? "a\n" : "\301a");
    say(o, "\nPOINT_DATA %d\nSCALARS temperature double 1\nLOOKUP_TABLE t\n", POINTS);
    for (i = 0; i < POINTS; i++) number(o, float64, temperature(i));
    say(o, "\nLOOKUP_TABLE t 1\n");
    for (i = 0; i < 4; i++) number(o, uint8, 1);
    say(o, "\nNORMALS n double\n");
    for (i = 0; i < 3 * POINTS; i++) number(o, float64, normal(i / 3, i % 3));
    say(o, "\nVECTORS displacement float\n");
    for (i = 0; i < 3 * POINTS; i++) number(o, float32, displacement(i / 3, i % 3));
    say(o, "\nFIELD FieldData 1\nlabel 1 %d vtkIdType\n", POINTS);
    for (i = 0; i < POINTS; i++) number(o, int32, label(i));
    say(o, "\n");
}

static void vtk_grid(out *o, int version)
{
    vtk_begin(o, version, "UNSTRUCTURED_GRID", point, POINTS);
    vtk_cells(o, version, "CELLS", cells, CELLS, 19);
    vtk_kinds(o, cells, CELLS);
    vtk_data(o);
}

/* The sections in another order than the data. */
static void vtk_polydata(out *o, int version)
{
    vtk_begin(o, version, "POLYDATA", point, POINTS);
    vtk_cells(o, version, "POLYGONS", cells + 2, 3, 12);
    vtk_cells(o, version, "VERTICES", cells, 1, 1);
    vtk_cells(o, version, "TRIANGLE_STRIPS", cells + 5, 1, 4);
    vtk_cells(o, version, "LINES", cells + 1, 1, 2);
    vtk_data(o);
}

static void vtk_volumes(out *o, int version)
{
    int i;
    vtk_begin(o, version, "UNSTRUCTURED_GRID", volume_point, VOLUME_POINTS);
    vtk_cells(o, version, "CELLS", volumes, VOLUMES, 23);
    vtk_kinds(o, volumes, VOLUMES);
    say(o, "CELL_DATA %d\nSCALARS material int 1\nLOOKUP_TABLE default\n", VOLUMES);
    for (i = 0; i < VOLUMES; i++) number(o, int32, material(i));
    say(o, "\n");
}

/* ---- MSH. ---- */

typedef struct msh {
    out *o;
    int version, step; /* step: between numbers of nodes, of elements, which then run downwards */
    type size;         /* of counts and numbers */
} msh;

static double msh_number(const msh *f, int i, int n)
{
    return f->step == 1 ? i + 1 : f->step * (n - i);
}

/* In version 4 each cell is on an entity of its own. */
static void msh_entities(const msh *f)
{
    out *o = f->o;
    int d, i, j;
    say(o, "$Entities\n");
    for (d = 0; d < 4; d++) number(o, f->size, CELLS);
    for (d = 0; d < 4; d++) {
        for (i = 0; i < CELLS; i++) {
            line_end(o);
            number(o, int32, i + 1);
            for (j = 0; j < (d ? 6 : 3); j++) number(o, float64, j);
            number(o, f->size, 2), number(o, int32, material(i)), number(o, int32, 99);
            if (d) number(o, f->size, 1), number(o, int32, 1);
        }
    }
    say(o, "\n$EndEntities\n");
}

static void msh_begin(const msh *f)
{
    out *o = f->o;
    say(o, "$MeshFormat\n%s %d %d\n", f->version == 4 ? "4.1" : "2.2", o->order != TEXT,
        f->size.bytes);
    if (o->order != TEXT) number(o, int32, 1), say(o, "\n");
    say(o, "$EndMeshFormat\n$Comments\n$Nodes are \"not here\"\n$EndComments\n");
    say(o, "$PhysicalNames\n2\n2 12 \"wall #1\"\n3 10 \"inside\"\n$EndPhysicalNames\n");
    if (f->version == 4) msh_entities(f);
}

static void msh_nodes_2(const msh *f, const double x[][3], int n)
{
    int i, j;
    say(f->o, "%d\n", n);
    for (i = 0; i < n; i++) {
        number(f->o, int32, msh_number(f, i, n));
        for (j = 0; j < 3; j++) number(f->o, float64, x[i][j]);
        line_end(f->o);
    }
}

/* In two blocks, the second with parameters. */
static void msh_nodes_4(const msh *f, const double x[][3], int n)
{
    out *o = f->o;
    int block, i, j;
    number(o, f->size, 2), number(o, f->size, n), number(o, f->size, 1), number(o, f->size, 99);
    for (block = 0; block < 2; block++) {
        int begin = block ? n / 2 : 0, end = block ? n : n / 2;
        line_end(o);
        number(o, int32, 2), number(o, int32, 1), number(o, int32, block);
        number(o, f->size, end - begin);
        line_end(o);
        for (i = begin; i < end; i++) number(o, f->size, msh_number(f, i, n));
        for (i = begin; i < end; i++) {
            line_end(o);
            for (j = 0; j < 3; j++) number(o, float64, x[i][j]);
            for (j = 0; j < 2 * block; j++) number(o, float64, 0.5);
        }
    }
}

static void msh_nodes(const msh *f, const double x[][3], int n)
{
    say(f->o, "$Nodes\n");
    (f->version == 4 ? msh_nodes_4 : msh_nodes_2)(f, x, n);
    say(f->o, "\n$EndNodes\n");
}

typedef struct msh_type {
    int type, dimension;
} msh_type;

/* Gmsh's type for a kind of VTK's. */
static msh_type msh_type_of(int kind)
{
    static const msh_type types[] = {{0, 0}, {15, 0}, {0, 0}, {1, 1}, {0, 0},
                                     {2, 2}, {0, 0},  {0, 0}, {0, 0}, {3, 2},
                                     {4, 3}, {0, 0},  {5, 3}, {6, 3}, {7, 3}};
    return types[kind];
}

static void msh_head_2(const msh *f, int is, int number_of, int i)
{
    out *o = f->o;
    if (o->order == TEXT) number(o, int32, number_of);
    number(o, int32, is);
    if (o->order != TEXT) number(o, int32, 1);
    number(o, int32, 3);
    if (o->order != TEXT) number(o, int32, number_of);
    number(o, int32, material(i)), number(o, int32, i + 1), number(o, int32, 0);
}

static void msh_elements(const msh *f, const cell *c, int n, int points)
{
    out *o = f->o;
    const type size = f->version == 4 ? f->size : int32;
    int i, j;
    say(o, "$Elements\n");
    for (i = 0; i < 4 && f->version == 4; i++) number(o, size, n);
    if (f->version == 2) say(o, "%d\n", n);
    for (i = 0; i < n; i++) {
        const msh_type t = msh_type_of(c[i].kind);
        const int number_of = (int)msh_number(f, i, n);
        line_end(o);
        if (f->version == 2) {
            msh_head_2(f, t.type, number_of, i);
        } else {
            number(o, int32, t.dimension), number(o, int32, i + 1), number(o, int32, t.type);
            number(o, size, 1), number(o, size, number_of);
        }
        for (j = 0; j < c[i].n; j++) number(o, size, msh_number(f, c[i].corner[j], points));
    }
    say(o, "\n$EndElements\n");
}

static void msh_data(const msh *f, const char *name, double (*value)(int i, int k), int n, int rows,
                     int components)
{
    out *o = f->o;
    const char *what = n == POINTS ? "Node" : "Element";
    int i, k;
    say(o, "$%sData\n1\n\"%s\"\n1\n0.5\n4\n0\n%d\n%d\n0\n", what, name, components, rows);
    for (i = 0; i < rows; i++) {
        number(o, int32, msh_number(f, i, n));
        for (k = 0; k < components; k++) number(o, float64, value(i, k));
        line_end(o);
    }
    say(o, "\n$End%sData\n", what);
}

static double temperature_k(int i, int k) { return temperature(i) + k; }
static double stress_k(int i, int k) { return stress(i) + k; }

static void msh_faces(const msh *f)
{
    msh_begin(f);
    msh_nodes(f, point, POINTS);
    msh_elements(f, cells, 4, POINTS);
    msh_data(f, "temperature", temperature_k, POINTS, POINTS - 1, 1);
    msh_data(f, "displacement", displacement, POINTS, POINTS, 3);
    msh_data(f, "a < b", stress_k, 4, 4, 1);
}

static void msh_volumes(const msh *f)
{
    msh_begin(f);
    msh_nodes(f, volume_point, VOLUME_POINTS);
    msh_elements(f, volumes, VOLUMES, VOLUME_POINTS);
}

/* ---- OBJ and STL. ---- */

static void obj(out *o)
{
    int i, j;
    say(o, "# a \\\nmtllib b\no c\n");
    for (i = 0; i < POINTS; i++) {
        say(o, "v %g %g %g\n", point[i][0], point[i][1], point[i][2]);
        say(o, "vn %g %g %g\nvt 0 1\n", normal(i, 0), normal(i, 1), normal(i, 2));
    }
    say(o, "s 1\n");
    for (i = 2; i < 5; i++) {
        say(o, i == 4 ? "s off\nf" : "f \\\r\n");
        for (j = 0; j < cells[i].n; j++) {
            int k = cells[i].corner[j] + 1;
            say(o, i == 2 ? " %d//%d" : i == 3 ? " %d/1/-%d" : " %d", k, k);
        }
        say(o, "\n");
    }
}

static void stl(out *o)
{
    char header[80] = "solid no text";
    int i, j, k;
    if (o->order == TEXT) {
        say(o, "solid a\n");
    } else {
        put(o, header, sizeof header);
        number(o, uint32, 2);
    }
    for (i = 0; i < 2; i++) {
        say(o, o->order == TEXT ? "facet normal " : "");
        for (j = 0; j < 3; j++) number(o, float32, 0);
        say(o, o->order == TEXT ? "\nouter loop\n" : "");
        for (j = 0; j < 3; j++) {
            say(o, o->order == TEXT ? "vertex " : "");
            for (k = 0; k < 3; k++) number(o, float32, point[cells[3].corner[j ? i + j : 0]][k]);
            line_end(o);
        }
        put(o, o->order == TEXT ? "endloop\nendfacet\n" : "\0", o->order == TEXT ? 17 : 2);
    }
    say(o, o->order == TEXT ? "endsolid a\n" : "");
}

/* ---- The list. ---- */

enum { MOST = 100 };

static seed all[MOST];
static int count, seeds_made; /* the latter without the worst ones */

static void keep(const out *o, const char *format, ...)
{
    char name[60];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(name, sizeof name, format, arguments);
    va_end(arguments);
    if (count == MOST) abort();
    memcpy(all[count].name, name, sizeof name);
    all[count].data = o->data;
    all[count++].size = o->size;
}

static const char *const orders[] = {"text", "little", "big"};

static out with_order(int order)
{
    out o = {NULL, 0, 0, 0};
    o.order = order;
    return o;
}

static void make_vtu(int variant)
{
    static const char *const formats[] = {"ascii", "binary", "appended", "appended"};
    const int order = variant & 1 ? BIG : LITTLE, format = variant / 4;
    out o = with_order(order);
    vtu v = {NULL,           NULL, 0, {'i', 4, "UInt32"}, {'f', 8, "Float64"}, {'i', 8, "Int64"},
             {NULL, 0, 0, 0}};
    v.o = &o;
    v.format = formats[format];
    v.base64 = format == 1 || format == 2;
    if (variant & 2) v.header = uint64, v.real = float32, v.whole = uint8;
    if (variant % 4 == 2) {
        vtu_volumes(&v);
        keep(&o, "volumes_%d.vtu", format);
    } else {
        vtu_faces(&v, 1);
        keep(&o, "faces_%s_%d_%s.vtu", v.format, v.base64 * 64, orders[order]);
    }
}

static void make_vtk(int variant)
{
    const int version = variant & 1 ? 5 : 3, order = variant & 2 ? BIG : TEXT;
    out o[3] = {with_order(order), with_order(order), with_order(order)};
    vtk_grid(&o[0], version);
    keep(&o[0], "grid_%d_%s.vtk", version, orders[order]);
    vtk_polydata(&o[1], version);
    keep(&o[1], "polydata_%d_%s.vtk", version, orders[order]);
    vtk_volumes(&o[2], version);
    keep(&o[2], "volumes_%d_%s.vtk", version, orders[order]);
}

static void make_msh(int variant)
{
    const int order = variant % 3;
    out faces = with_order(order), insides = faces;
    msh f = {NULL, 2, 1, {'i', 8, ""}};
    f.version = variant / 3 % 2 ? 4 : 2;
    f.step = variant / 6 ? 10 : 1;
    if (f.step == 10) f.size = int32;
    f.o = &faces;
    msh_faces(&f);
    keep(&faces, "faces%d_%d_%s.msh", f.step, f.version, orders[order]);
    f.o = &insides;
    msh_volumes(&f);
    keep(&insides, "volumes%d_%d_%s.msh", f.step, f.version, orders[order]);
}

static void make_others(int order)
{
    out usual = with_order(order), odd = usual, other = usual;
    ply_usual(&usual);
    keep(&usual, "usual_%s.ply", orders[order]);
    ply_odd(&odd);
    keep(&odd, "odd_%s.ply", orders[order]);
    if (order == BIG)
        obj(&other);
    else
        stl(&other);
    keep(&other, order == BIG ? "faces.obj" : "faces_%s.stl", orders[order]);
}

/* A triangle for each byte, and a few more than a power of two of them. */
static void make_worst(void)
{
    const int n = (1 << 17) + 10;
    out ply = with_order(LITTLE), vtk = with_order(BIG);
    int i;
    ply_head(&ply, "\n");
    say(&ply, "element vertex 3\nproperty char x\nproperty char y\nproperty char z\n");
    say(&ply, "element face 1\nproperty list int uchar vertex_index\nend_header\n");
    say(&vtk, "# vtk DataFile Version 5.1\n\nBINARY\nDATASET POLYDATA\nPOINTS 3 char\n");
    for (i = 0; i < 9; i++) number(&ply, int8, i % 4 == 3), number(&vtk, int8, i % 4 == 3);
    number(&ply, int32, n);
    say(&vtk, "\nTRIANGLE_STRIPS 2 %d\nOFFSETS int\n", n);
    number(&vtk, int32, 0), number(&vtk, int32, n);
    say(&vtk, "\nCONNECTIVITY char\n");
    for (i = 0; i < n; i++) number(&ply, uint8, i % 3), number(&vtk, uint8, i % 3);
    keep(&ply, "worst.ply");
    keep(&vtk, "worst.vtk");
}

int seeds_make(const seed **seeds)
{
    int i;
    *seeds = all;
    if (seeds_made) return seeds_made;
    for (i = 0; i < 3; i++) make_others(i);
    for (i = 0; i < 16; i++) make_vtu(i);
    for (i = 0; i < 4; i++) make_vtk(i);
    for (i = 0; i < 12; i++) make_msh(i);
    return seeds_made = count;
}

int seeds_make_worst(const seed **seeds)
{
    const int first = seeds_make(seeds);
    if (count == first) make_worst();
    *seeds += first;
    return count - first;
}
