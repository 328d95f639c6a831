/* VTU: VTK's unstructured grids in XML. A piece has arrays, whose numbers stand in them as text or
 * in base64, or behind all pieces as bytes or in base64; there their number of bytes comes first.
 *
 * Tags that are not known are passed over. */
#include "mesh_binary.h"
#include "mesh_cells.h"
#include "mesh_xml.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

enum { NONE, POINT_DATA, CELL_DATA, POINTS, CELLS }; /* what arrays are of */

typedef struct array {
    text text; /* what stands in the element; its tag is the place of messages */
    token name, type, format, offset;
    int section, components;
} array;

typedef struct reader {
    text text;
    mesh *mesh;
    cells cells;
    int is_vtu, order;        /* order: of bytes, as in text.order */
    const number_type *count; /* of an array's bytes */
    text appended;            /* the arrays behind the pieces; without a file: none */
    double taken;             /* bytes of them */
    int pieces, in_piece;
    int points_here, cells_here; /* of the piece */
    int section;
    token normals; /* the name of the array */
    int arrays;
    array *array; /* of the piece */
} reader;

static const number_type types[] = {{"uint32", 'u', 4},  {"uint64", 'u', 8}, {"int8", 'i', 1},
                                    {"uint8", 'u', 1},   {"int16", 'i', 2},  {"uint16", 'u', 2},
                                    {"int32", 'i', 4},   {"int64", 'i', 8},  {"float32", 'f', 4},
                                    {"float64", 'f', 8}, {NULL, 0, 0}};

/* A whole number from 0 on in an attribute; other if there is none. */
static double attribute_number(const reader *r, token value, double other)
{
    text t = r->text;
    double x;
    if (!value.length) return other;
    t.at = value.at;
    t.end = value.at + value.length;
    x = text_whole(&t);
    if (x < 0 || text_word(&t).length) text_refuse(&r->text, value, "is not a count");
    return x;
}

static int attribute_count(const reader *r, const tag *g, const char *name, int other)
{
    double x = attribute_number(r, xml_attribute(g, name), other);
    if (x > INT_MAX) text_fail(&r->text, "%s is too large", name);
    return (int)x;
}

static void begin_file(reader *r, const tag *g)
{
    token type = xml_attribute(g, "type"), header = xml_attribute(g, "header_type");
    token compressor = xml_attribute(g, "compressor");
    if (!type.length) text_fail(&r->text, "the file tells no type");
    if (!token_is(type, "unstructuredgrid"))
        text_refuse(&r->text, type, "where the type UnstructuredGrid should be");
    if (compressor.length)
        text_refuse(&r->text, compressor, "has compressed the file; only plain ones can be read");
    r->order = token_is(xml_attribute(g, "byte_order"), "bigendian") ? BIG : LITTLE;
    r->count = token_is(header, "uint64") ? &types[1] : &types[0];
    r->is_vtu = 1;
}

static void skip_space(text *t)
{
    while (t->at < t->end && isspace((unsigned char)*t->at)) t->at++;
}

/* Behind the _ are the arrays of all pieces. */
static void find_appended(reader *r)
{
    static const char word[] = "<AppendedData";
    const size_t n = sizeof word - 1;
    text t = r->text;
    token encoding;
    tag g;
    while ((t.at = memchr(t.at, '<', text_left(&t))) != NULL) {
        if (text_left(&t) > n && memcmp(t.at, word, n) == 0) break;
        t.at++;
    }
    if (!t.at || !xml_next(&t, &g)) return;
    encoding = xml_attribute(&g, "encoding");
    t.base64 = token_is(encoding, "base64");
    if (!t.base64 && !token_is(encoding, "raw"))
        text_refuse(&t, encoding, "where the encoding raw or base64 should be");
    skip_space(&t);
    if (*t.at != '_') text_fail(&t, "'_' should follow");
    t.at++;
    r->appended = t;
}

static void begin_piece(reader *r, const tag *g)
{
    if (r->in_piece) text_fail(&r->text, "a piece within a piece");
    r->in_piece = 1;
    r->section = NONE;
    r->arrays = 0;
    r->points_here = attribute_count(r, g, "NumberOfPoints", 0);
    r->cells_here = attribute_count(r, g, "NumberOfCells", 0);
}

static void add_array(reader *r, const tag *g)
{
    array a;
    const char *end;
    if (!r->in_piece || r->section == NONE) return;
    end = memchr(r->text.at, '<', text_left(&r->text));
    a.text = r->text;
    if (end) a.text.end = end;
    a.section = r->section;
    a.name = xml_attribute(g, "Name");
    a.type = xml_attribute(g, "type");
    a.format = xml_attribute(g, "format");
    a.offset = xml_attribute(g, "offset");
    a.components = attribute_count(r, g, "NumberOfComponents", 1);
    if (!a.components) a.components = 1;
    r->array = room(r->array, r->arrays, sizeof *r->array);
    r->array[r->arrays++] = a;
}

static double *read_counted(const reader *r, text *t, const number_type *type, double count)
{
    double bytes = read_number(t, r->count), want = count * type->bytes;
    if (bytes < want || bytes > want)
        text_fail(t, "an array of %.0f bytes, where %.0f should be", bytes, want);
    return read_numbers(t, type, count);
}

/* Decoded, the bytes are in no file: places in messages are where they would be without blanks. */
static double *read_encoded(const reader *r, const text *from, const number_type *type,
                            double count)
{
    text t = *from;
    double size = r->count->bytes + count * type->bytes, *x;
    unsigned char *bytes;
    if (size / 3 * 4 > (double)text_left(&t) + 3)
        text_fail(&t, "%.0f bytes in base64 should follow, %.0f are left", size,
                  (double)text_left(&t));
    bytes = allocate((size_t)size, 1);
    t.offset = (size_t)(from->at - from->start);
    t.start = t.at = (const char *)bytes;
    t.end = t.start + read_base64(from, bytes, (size_t)size);
    t.base64 = 1;
    x = read_counted(r, &t, type, count);
    free(bytes);
    return x;
}

/* The values of an array: rows times its components. */
static double *read_array(reader *r, const array *a, double rows)
{
    const number_type *type;
    text t = a->text;
    double *x, offset;
    if (!a->type.length || !a->format.length) text_fail(&t, "the array tells no type or no format");
    type = type_find(&t, types, a->type);
    rows *= a->components;
    if (!(rows > 0)) return allocate(0, sizeof *x);
    if (rows > INT_MAX / 6) text_fail(&t, "%.0f numbers are too many", rows);
    if (token_is(a->format, "ascii")) {
        x = read_numbers(&t, type, rows);
        if (text_word(&t).length) text_fail(&t, "more than %.0f numbers", rows);
        return x;
    }
    t.base64 = 1;
    if (token_is(a->format, "appended")) {
        t = r->appended;
        offset = attribute_number(r, a->offset, 0);
        if (!t.file || offset > (double)text_left(&t))
            text_fail(&a->text, "there are no %.0f bytes of appended data", offset);
        t.at += (size_t)offset;
        r->taken += rows * type->bytes;
        if (r->taken > (double)text_left(&r->appended))
            text_fail(&a->text, "the arrays are larger than the appended data");
    } else if (!token_is(a->format, "binary")) {
        text_refuse(&t, a->format, "is no format of arrays");
    }
    if (t.base64) skip_space(&t);
    t.order = r->order;
    return t.base64 ? read_encoded(r, &t, type, rows) : read_counted(r, &t, type, rows);
}

/* The array of a section; NULL stands for any name. */
static const array *find_array(const reader *r, int section, const char *name)
{
    int i;
    for (i = 0; i < r->arrays; i++)
        if (r->array[i].section == section && (!name || token_is(r->array[i].name, name)))
            return &r->array[i];
    text_fail(&r->text, "the piece has no array %s", name ? name : "of points");
    return NULL;
}

static n3_vec *add_vectors(reader *r, const array *a, n3_vec *list, int *count)
{
    double *x;
    int i;
    if (a->components != 3) text_fail(&a->text, "points of %d components", a->components);
    x = read_array(r, a, r->points_here);
    for (i = 0; i < r->points_here; i++) {
        const double *v = x + 3 * (size_t)i;
        if (!is_coordinate(v[0]) || !is_coordinate(v[1]) || !is_coordinate(v[2]))
            text_fail(&a->text, "the vector %d in it is not finite, or beyond 1e150", i);
        list = room(list, *count, sizeof *list);
        list[(*count)++] = n3_v((n3_real)v[0], (n3_real)v[1], (n3_real)v[2]);
    }
    free(x);
    return list;
}

/* The whole number i of an array, from least to most. */
static int int_at(const array *a, const double *x, int i, int least, int most)
{
    if (!(x[i] >= least && x[i] <= most && x[i] <= floor(x[i])))
        text_fail(&a->text, "the number %d in it, %.17g, is not a whole one from %d to %d", i, x[i],
                  least, most);
    return (int)x[i];
}

static void add_cells(reader *r)
{
    const array *corner = find_array(r, CELLS, "connectivity");
    const array *offset = find_array(r, CELLS, "offsets"), *kind = find_array(r, CELLS, "types");
    const int n = r->cells_here, before = r->mesh->points - r->points_here;
    double *end = read_array(r, offset, n), *type = read_array(r, kind, n);
    int corners = int_at(offset, end, n - 1, 0, INT_MAX), i, j = 0;
    double *point = read_array(r, corner, corners);
    for (i = 0; i < n; i++) {
        int stop = int_at(offset, end, i, j, corners);
        for (; j < stop; j++)
            cells_add_point(&r->cells, before + int_at(corner, point, j, 0, r->points_here - 1));
        cells_add(&r->cells, &kind->text, int_at(kind, type, i, 0, 255));
    }
    free(end);
    free(type);
    free(point);
}

/* The values of the array, behind those that the field i has from the pieces before. */
static void add_values(reader *r, const array *a, int i)
{
    mesh *m = r->mesh;
    const int of_cells = a->section == CELL_DATA;
    const int rows = of_cells ? r->cells_here : r->points_here;
    const int before = (of_cells ? r->cells.count : m->points) - rows;
    int *fields = of_cells ? &m->cell_fields : &m->point_fields, j;
    field **list = of_cells ? &m->cell_field : &m->point_field, *f;
    double *x = read_array(r, a, rows);
    char *name = xml_decode(a->name);
    if (r->pieces == 0)
        field_add(list, fields, name, strlen(name), a->components, NULL)->kind =
            type_values(type_find(&a->text, types, a->type), a->components);
    f = i < *fields ? *list + i : NULL;
    if (!f || strcmp(f->name, name) != 0 || f->components != a->components)
        text_fail(&a->text, "the first piece has other arrays");
    for (j = 0; j < rows * a->components; j++) {
        const int k = before * f->components + j;
        f->value = room(f->value, k, sizeof *f->value);
        f->value[k] = x[j];
    }
    free(name);
    free(x);
}

static int is_normals(const reader *r, const array *a)
{
    if (a->section != POINT_DATA || a->components != 3) return 0;
    if (!r->normals.length) return token_is(a->name, "normals");
    return a->name.length == r->normals.length &&
           memcmp(a->name.at, r->normals.at, a->name.length) == 0;
}

static int is_number(const array *a)
{
    const number_type *type = types;
    while (type->name && !token_is(a->type, type->name)) type++;
    return type->name != NULL;
}

static void add_fields(reader *r)
{
    mesh *m = r->mesh;
    int i, used[CELLS] = {0};
    for (i = 0; i < r->arrays; i++) {
        const array *a = &r->array[i];
        if (a->section != POINT_DATA && a->section != CELL_DATA) continue;
        if (!is_number(a))
            m->lost_fields += r->pieces == 0;
        else if (is_normals(r, a))
            m->normal = add_vectors(r, a, m->normal, &m->normals);
        else
            add_values(r, a, used[a->section]++);
    }
    if (used[POINT_DATA] != m->point_fields || used[CELL_DATA] != m->cell_fields ||
        (m->normals && m->normals != m->points))
        text_fail(&r->text, "the first piece has other arrays");
}

/* A piece of nothing may have no arrays. */
static void end_piece(reader *r)
{
    mesh *m = r->mesh;
    if (!r->in_piece) return;
    r->in_piece = 0;
    r->section = NONE;
    if (!r->points_here && !r->cells_here) return;
    m->point = add_vectors(r, find_array(r, POINTS, NULL), m->point, &m->points);
    if (r->cells_here) add_cells(r);
    add_fields(r);
    r->pieces++;
}

static void read_tag(reader *r, const tag *g)
{
    static const char *const sections[] = {"", "pointdata", "celldata", "points", "cells"};
    const int begin = !g->end, end = g->end || g->empty;
    int i;
    if (!r->is_vtu && !token_is(g->name, "vtkfile"))
        text_refuse(&r->text, g->name, "where VTKFile should be");
    if (token_is(g->name, "vtkfile") && begin) begin_file(r, g);
    if (token_is(g->name, "piece") && begin) begin_piece(r, g);
    if (token_is(g->name, "piece") && end) end_piece(r);
    if ((token_is(g->name, "dataarray") || token_is(g->name, "array")) && begin) add_array(r, g);
    for (i = POINT_DATA; i <= CELLS; i++) {
        if (!token_is(g->name, sections[i])) continue;
        r->section = end ? NONE : i;
        if (begin && i == POINT_DATA) r->normals = xml_attribute(g, "Normals");
    }
}

void mesh_read_vtu(const char *path, const char *data, size_t size, mesh *m)
{
    reader r;
    tag g;
    memset(&r, 0, sizeof r);
    r.text = text_open(path, data, size);
    r.mesh = m;
    find_appended(&r);
    while (xml_next(&r.text, &g) && !token_is(g.name, "appendeddata")) read_tag(&r, &g);
    if (r.in_piece || !r.pieces) text_fail(&r.text, "the end of a piece is missing");
    free(r.array);
    cells_take(path, &r.cells, m);
}
