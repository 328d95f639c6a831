/* PLY: a header that tells what rows of numbers follow, as text or as bytes.
 *
 * Of the element vertex, x y z are the points and nx ny nz their normals; of the element face, the
 * list vertex_indices or vertex_index is the polygon. Their other single numbers are fields. All
 * other lists and elements are passed over. */
#include "mesh_binary.h"
#include "mesh_cells.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

typedef struct property {
    token name;
    const number_type *type, *count; /* count: of the length of a list; NULL: a single number */
    double *column;                  /* a single number's values, one in each row, where kept */
    int finite, polygon;
} property;

typedef struct element {
    token name;
    int rows, kept, properties; /* kept: its single numbers are */
    property *property;
} element;

typedef struct reader {
    text text;
    int order; /* of the numbers, as in text.order; negative: not yet known */
    int elements;
    element *element;
    int points;
    cells cells;
} reader;

static const number_type types[] = {{"char", 'i', 1},    {"uchar", 'u', 1},  {"short", 'i', 2},
                                    {"ushort", 'u', 2},  {"int", 'i', 4},    {"uint", 'u', 4},
                                    {"float", 'f', 4},   {"double", 'f', 8}, {"int8", 'i', 1},
                                    {"uint8", 'u', 1},   {"int16", 'i', 2},  {"uint16", 'u', 2},
                                    {"int32", 'i', 4},   {"uint32", 'u', 4}, {"float32", 'f', 4},
                                    {"float64", 'f', 8}, {NULL, 0, 0}};

static void read_format(reader *r)
{
    static const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    static const int orders[] = {AS_TEXT, LITTLE, BIG};
    token k = text_token(&r->text);
    int i;
    for (i = 0; i < 3 && !token_is(k, formats[i]); i++) continue;
    if (i == 3) text_refuse(&r->text, k, "is not a format of PLY");
    r->order = orders[i];
    k = text_token(&r->text);
    if (!token_is(k, "1.0")) text_refuse(&r->text, k, "is not the version 1.0 of PLY");
}

/* NULL for none. */
static element *find_element(const reader *r, const char *name)
{
    int i;
    for (i = 0; i < r->elements; i++)
        if (token_is(r->element[i].name, name)) return &r->element[i];
    return NULL;
}

static void read_element(reader *r)
{
    element e = {{NULL, 0}, 0, 0, 0, NULL};
    e.name = text_token(&r->text);
    if ((token_is(e.name, "vertex") && find_element(r, "vertex")) ||
        (token_is(e.name, "face") && find_element(r, "face")))
        text_refuse(&r->text, e.name, "is there already");
    e.rows = text_count(&r->text, INT_MAX);
    r->element = room(r->element, r->elements, sizeof *r->element);
    r->element[r->elements++] = e;
}

static void read_property(reader *r)
{
    property p = {{NULL, 0}, NULL, NULL, NULL, 0, 0};
    token k = text_token(&r->text);
    element *e;
    if (!r->elements) text_fail(&r->text, "a property before any element");
    e = &r->element[r->elements - 1];
    if (token_is(k, "list")) {
        p.count = type_find(&r->text, types, text_token(&r->text));
        k = text_token(&r->text);
    }
    p.type = type_find(&r->text, types, k);
    p.name = text_token(&r->text);
    if (!p.name.length) text_refuse(&r->text, p.name, "where a name should be");
    e->property = room(e->property, e->properties, sizeof *e->property);
    e->property[e->properties++] = p;
}

static void read_header(reader *r)
{
    text *t = &r->text;
    token k;
    text_expect(t, "ply");
    for (k = text_word(t); !token_is(k, "end_header"); k = text_word(t)) {
        if (token_is(k, "format"))
            read_format(r);
        else if (token_is(k, "element"))
            read_element(r);
        else if (token_is(k, "property"))
            read_property(r);
        else if (token_is(k, "comment") || token_is(k, "obj_info"))
            text_line(t);
        else
            text_refuse(t, k, "where a line of the header should begin");
        if (text_more(t)) text_refuse(t, text_token(t), "is one too many");
    }
    if (r->order < 0) text_fail(t, "the header tells no format");
    text_next_line(t);
    t->order = r->order;
}

/* The first property of this name that is a list, or is none; NULL for none. */
static property *find_property(const element *e, const char *name, int list)
{
    int i;
    for (i = 0; e && i < e->properties; i++)
        if (!e->property[i].count == !list && token_is(e->property[i].name, name))
            return &e->property[i];
    return NULL;
}

/* Tells what is to be done with the properties. */
static void choose(reader *r)
{
    static const char *const finite[] = {"x", "y", "z", "nx", "ny", "nz"};
    element *vertex = find_element(r, "vertex"), *face = find_element(r, "face");
    property *p;
    int i;
    for (i = 0; i < 6; i++)
        if ((p = find_property(vertex, finite[i], 0))) p->finite = 1;
    if (!(p = find_property(face, "vertex_indices", 1))) p = find_property(face, "vertex_index", 1);
    if (p) p->polygon = 1;
    if (vertex) vertex->kept = 1;
    if (face) face->kept = 1;
    r->points = vertex ? vertex->rows : 0;
}

/* Memory for the single numbers, once it is known that all rows may be there. */
static void make_columns(const reader *r, element *e)
{
    size_t bytes = 0;
    int i;
    for (i = 0; i < e->properties; i++) {
        const property *p = &e->property[i];
        bytes += (size_t)(p->count ? p->count : p->type)->bytes;
    }
    check_left(&r->text, e->rows, bytes, (size_t)e->properties);
    for (i = 0; e->kept && i < e->properties; i++)
        if (!e->property[i].count)
            e->property[i].column = allocate((size_t)e->rows, sizeof(double));
}

static void read_list(reader *r, const property *p)
{
    text *t = &r->text;
    double length = read_number(t, p->count);
    size_t n, i;
    if (!(length >= 0 && length <= floor(length)))
        text_fail(t, "%g is not the length of a list", length);
    check_left(t, length, (size_t)p->type->bytes, 1);
    for (n = (size_t)length, i = 0; i < n; i++) {
        if (p->polygon)
            cells_add_point(&r->cells, read_index(t, p->type, r->points, "vertex"));
        else
            read_number(t, p->type);
    }
    if (p->polygon) cells_add(&r->cells, t, POLYGON);
}

static void read_row(reader *r, const element *e, int row)
{
    int i;
    for (i = 0; i < e->properties; i++) {
        const property *p = &e->property[i];
        double x;
        if (p->count) {
            read_list(r, p);
            continue;
        }
        x = (p->finite ? read_coordinate : read_number)(&r->text, p->type);
        if (p->column) p->column[row] = x;
    }
}

/* The three columns as vectors; NULL if there is one less. */
static n3_vec *take_vectors(const element *e, const char *x, const char *y, const char *z)
{
    property *p[3];
    n3_vec *a;
    int i;
    p[0] = find_property(e, x, 0), p[1] = find_property(e, y, 0), p[2] = find_property(e, z, 0);
    if (!p[0] || !p[1] || !p[2]) return NULL;
    a = allocate((size_t)e->rows, sizeof *a);
    for (i = 0; i < e->rows; i++)
        a[i] = n3_v((n3_real)p[0]->column[i], (n3_real)p[1]->column[i], (n3_real)p[2]->column[i]);
    for (i = 0; i < 3; i++) {
        free(p[i]->column);
        p[i]->column = NULL;
    }
    return a;
}

static int kind_of(const property *p)
{
    static const char *const colours[] = {"red", "green", "blue", "alpha"};
    int i;
    for (i = 0; i < 4; i++)
        if (token_is(p->name, colours[i]) && type_is_byte(p->type)) return COLOUR_BYTES;
    return p->type->kind == 'f' ? VALUES : NUMBERS;
}

/* The columns that are left become fields. */
static void take_fields(const element *e, field **list, int *fields)
{
    int i;
    for (i = 0; e && i < e->properties; i++) {
        const property *p = &e->property[i];
        if (p->column)
            field_add(list, fields, p->name.at, p->name.length, 1, p->column)->kind = kind_of(p);
    }
}

static void make_mesh(reader *r, mesh *m)
{
    const element *vertex = find_element(r, "vertex");
    m->points = r->points;
    m->point = take_vectors(vertex, "x", "y", "z");
    if (!m->point) fail(r->text.file, 0, "there is no element vertex with properties x, y and z");
    m->normal = take_vectors(vertex, "nx", "ny", "nz");
    if (m->normal) m->normals = m->points;
    take_fields(vertex, &m->point_field, &m->point_fields);
    take_fields(find_element(r, "face"), &m->cell_field, &m->cell_fields);
    cells_take(r->text.file, &r->cells, m);
}

static void free_elements(reader *r)
{
    int i;
    for (i = 0; i < r->elements; i++) free(r->element[i].property);
    free(r->element);
}

void mesh_read_ply(const char *path, const char *data, size_t size, mesh *m)
{
    reader r;
    int i, j;
    memset(&r, 0, sizeof r);
    r.text = text_open(path, data, size);
    r.text.plain = 1;
    r.order = -1;
    read_header(&r);
    choose(&r);
    for (i = 0; i < r.elements; i++) {
        element *e = &r.element[i];
        make_columns(&r, e);
        for (j = 0; e->properties && j < e->rows; j++) read_row(&r, e, j);
    }
    if (r.order == AS_TEXT && text_word(&r.text).length)
        text_fail(&r.text, "more numbers than the header tells");
    make_mesh(&r, m);
    free_elements(&r);
}
