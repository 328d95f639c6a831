/* VTK's legacy files of POLYDATA and UNSTRUCTURED_GRID, versions 1 to 5.1: keywords in lines, each
 * with its numbers behind, as text or as bytes, the highest first.
 *
 * What is of neither points nor cells is passed over. */
#include "mesh_binary.h"
#include "mesh_cells.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

enum { WHOLE, OF_POINTS, OF_CELLS }; /* what data are of */
enum { SECTIONS = 4, POLYVERTEX = 2, POLYLINE = 4 };
enum { SCALARS = -1, NORMALS = -2, TEXTURE = -3 }; /* in place of a number of components */

/* Cells whose kind is not yet known: where the points of each end. */
typedef struct cell_list {
    int count, *end, *point;
} cell_list;

typedef struct reader {
    text text;
    mesh *mesh;
    int version;
    int polydata;
    cells cells[SECTIONS]; /* in the order of the cell data; a grid has one section */
    cell_list list;        /* of a grid */
    int of, rows;          /* what the next data are of */
} reader;

typedef struct keyword {
    const char *word;
    void (*read)(reader *r, int argument);
    int argument;
} keyword;

static const number_type types[] = {{"unsigned_char", 'u', 1},
                                    {"char", 'i', 1},
                                    {"signed_char", 'i', 1},
                                    {"unsigned_short", 'u', 2},
                                    {"short", 'i', 2},
                                    {"unsigned_int", 'u', 4},
                                    {"int", 'i', 4},
                                    {"unsigned_long", 'u', 8},
                                    {"long", 'i', 8},
                                    {"vtktypeuint64", 'u', 8},
                                    {"vtktypeint64", 'i', 8},
                                    {"vtkidtype", 'i', 4},
                                    {"float", 'f', 4},
                                    {"double", 'f', 8},
                                    {"bit", 'b', 1},
                                    {"string", 's', 1},
                                    {NULL, 0, 0}};
static const number_type byte_type = {"", 'u', 1}, int_type = {"", 'i', 4},
                         float_type = {"", 'f', 4};

/* Of points or cells. */
static const number_type *read_type(reader *r)
{
    const number_type *type = type_find(&r->text, types, text_token(&r->text));
    if (strchr("bs", type->kind))
        text_fail(&r->text, "the type %s is not for points or cells", type->name);
    return type;
}

static int read_count(reader *r) { return text_count(&r->text, INT_MAX); }

/* The numbers that begin in the next line. */
static double *read_data(reader *r, const number_type *type, double count)
{
    text_next_line(&r->text);
    return read_numbers(&r->text, type, count);
}

/* True if the next word is this one, which is then passed. */
static int accept(reader *r, const char *word)
{
    text here = r->text;
    if (token_is(text_word(&r->text), word)) return 1;
    r->text = here;
    return 0;
}

static void read_dataset(reader *r, int unused)
{
    token k = text_token(&r->text);
    (void)unused;
    r->polydata = token_is(k, "polydata");
    if (!r->polydata && !token_is(k, "unstructured_grid"))
        text_refuse(&r->text, k, "where POLYDATA or UNSTRUCTURED_GRID should be");
}

static void read_points(reader *r, int unused)
{
    mesh *m = r->mesh;
    text *t = &r->text;
    const number_type *type;
    int i;
    (void)unused;
    if (m->point) text_fail(t, "there are points already");
    m->points = read_count(r);
    type = read_type(r);
    text_next_line(t);
    check_left(t, m->points, 3 * (size_t)type->bytes, 3);
    m->point = allocate((size_t)m->points, sizeof *m->point);
    for (i = 0; i < m->points; i++) {
        m->point[i].x = (n3_real)read_coordinate(t, type);
        m->point[i].y = (n3_real)read_coordinate(t, type);
        m->point[i].z = (n3_real)read_coordinate(t, type);
    }
}

/* A whole number from least to most. */
static int read_from(reader *r, const number_type *type, int least, int most)
{
    double x = read_number(&r->text, type);
    if (!(x >= least && x <= most && x <= floor(x)))
        text_fail(&r->text, "%.17g is not from %d to %d", x, least, most);
    return (int)x;
}

/* Up to version 4: of each cell, how many points it has, and these. */
static cell_list read_mixed(reader *r, int count, int size)
{
    cell_list c = {0, NULL, NULL};
    int n = 0, stop;
    if (count > size) text_fail(&r->text, "%d cells of %d numbers", count, size);
    text_next_line(&r->text);
    check_left(&r->text, size, (size_t)int_type.bytes, 1);
    c.end = allocate((size_t)count, sizeof *c.end);
    c.point = allocate((size_t)size, sizeof *c.point);
    for (; c.count < count; c.count++) {
        stop = n + read_from(r, &int_type, 0, size - count - n);
        while (n < stop) c.point[n++] = read_index(&r->text, &int_type, r->mesh->points, "point");
        c.end[c.count] = n;
    }
    if (n + count != size)
        text_fail(&r->text, "the cells have %d numbers, not %d", n + count, size);
    return c;
}

/* From version 5 on: where the points of each cell begin, and an end; all their points. */
static cell_list read_split(reader *r, int offsets, int size)
{
    cell_list c = {0, NULL, NULL};
    const number_type *type = read_type(r);
    int i, n = 0;
    text_next_line(&r->text);
    check_left(&r->text, offsets, (size_t)type->bytes, 1);
    c.end = allocate((size_t)offsets, sizeof *c.end);
    if (offsets > 0) read_from(r, type, 0, 0);
    for (i = 1; i < offsets; i++) c.end[c.count++] = n = read_from(r, type, n, size);
    if (n != size) text_fail(&r->text, "the last cell ends at %d, not at %d", n, size);
    text_expect(&r->text, "connectivity");
    type = read_type(r);
    text_next_line(&r->text);
    check_left(&r->text, size, (size_t)type->bytes, 1);
    c.point = allocate((size_t)size, sizeof *c.point);
    for (i = 0; i < size; i++) c.point[i] = read_index(&r->text, type, r->mesh->points, "point");
    return c;
}

static cell_list read_list(reader *r)
{
    int count = read_count(r), size = read_count(r);
    return r->version >= 5 && accept(r, "offsets") ? read_split(r, count, size)
                                                   : read_mixed(r, count, size);
}

static void add_cell(reader *r, cells *c, const cell_list *list, int i, int kind)
{
    int j = i ? list->end[i - 1] : 0;
    for (; j < list->end[i]; j++) cells_add_point(c, list->point[j]);
    cells_add(c, &r->text, kind);
}

static void list_free(cell_list *list)
{
    free(list->end);
    free(list->point);
    memset(list, 0, sizeof *list);
}

static void read_section(reader *r, int section)
{
    static const int kinds[SECTIONS] = {POLYVERTEX, POLYLINE, POLYGON, STRIP};
    cells *c = &r->cells[section];
    cell_list list;
    int i;
    if (!r->polydata || c->count) text_fail(&r->text, "such cells do not belong here");
    list = read_list(r);
    for (i = 0; i < list.count; i++) add_cell(r, c, &list, i, kinds[section]);
    list_free(&list);
}

static void read_cells(reader *r, int unused)
{
    (void)unused;
    if (r->polydata || r->list.end) text_fail(&r->text, "such cells do not belong here");
    r->list = read_list(r);
}

static void read_kinds(reader *r, int unused)
{
    int n = read_count(r), i;
    (void)unused;
    if (n != r->list.count || r->cells[0].count)
        text_fail(&r->text, "%d types of %d cells", n, r->list.count);
    text_next_line(&r->text);
    for (i = 0; i < n; i++) add_cell(r, &r->cells[0], &r->list, i, read_from(r, &int_type, 0, 255));
    list_free(&r->list);
}

static void begin_data(reader *r, int of)
{
    int i, n = r->mesh->points;
    if (of == OF_CELLS)
        for (n = 0, i = 0; i < SECTIONS; i++) n += r->cells[i].count;
    r->rows = read_count(r);
    r->of = of;
    if (r->rows != n) text_fail(&r->text, "data of %d, not of the %d there are", r->rows, n);
}

/* Blanks and others stand in names as % and two hexadecimal digits. The result has the length of
   the name or less. */
static token decode(token name, char *to)
{
    token k = {NULL, 0};
    size_t i;
    k.at = to;
    for (i = 0; i < name.length; i++) {
        char hex[3] = {0};
        if (name.at[i] == '%' && i + 2 < name.length && isxdigit((unsigned char)name.at[i + 1]) &&
            isxdigit((unsigned char)name.at[i + 2])) {
            memcpy(hex, name.at + i + 1, 2);
            i += 2;
        }
        to[k.length++] = *hex ? (char)strtol(hex, NULL, 16) : name.at[i];
    }
    return k;
}

static int are_coordinates(const double *x, size_t count)
{
    size_t i;
    for (i = 0; i < count && is_coordinate(x[i]); i++) continue;
    return i == count;
}

static void take_normals(reader *r, double *x)
{
    mesh *m = r->mesh;
    int i;
    if (!are_coordinates(x, 3 * (size_t)m->points))
        text_fail(&r->text, "the normals before this are not all finite and below 1e150");
    m->normal = allocate((size_t)m->points, sizeof *m->normal);
    for (i = 0; i < m->points; i++, x += 3)
        m->normal[i] = n3_v((n3_real)x[0], (n3_real)x[1], (n3_real)x[2]);
    m->normals = m->points;
}

/* What becomes of an array, from allocate(). */
static void take(reader *r, token name, int components, int kind, double *x)
{
    mesh *m = r->mesh;
    char *decoded = allocate(name.length + 1, 1);
    name = decode(name, decoded);
    if (r->of == OF_POINTS && components == 3 && !m->normal && token_is(name, "normals")) {
        take_normals(r, x);
        free(x);
    } else if (r->of == OF_POINTS) {
        field_add(&m->point_field, &m->point_fields, name.at, name.length, components, x)->kind =
            kind;
    } else if (r->of == OF_CELLS) {
        field_add(&m->cell_field, &m->cell_fields, name.at, name.length, components, x)->kind =
            kind;
    } else {
        free(x);
    }
    free(decoded);
}

/* A keyword with a name and a type; argument: the components. */
static void read_attribute(reader *r, int argument)
{
    static const token normals = {"normals", 7};
    text *t = &r->text;
    token name = text_token(t);
    int components = argument;
    const number_type *type;
    if (r->of == WHOLE) text_fail(t, "data of neither points nor cells");
    if (argument == NORMALS) components = 3;
    if (argument == NORMALS && r->of == OF_POINTS) name = normals;
    if (argument == TEXTURE) components = text_count(t, 3);
    type = type_find(t, types, text_token(t));
    if (type->kind == 's') text_fail(t, "texts where numbers should be");
    if (argument == SCALARS) {
        components = text_more(t) ? text_count(t, 4) : 1;
        text_expect(t, "lookup_table");
        text_token(t);
    }
    if (!components) text_fail(t, "data of no components");
    take(r, name, components, type_values(type, components),
         read_data(r, type, (double)r->rows * components));
}

/* Bytes; in a text these are numbers up to 1. */
static void read_colours(reader *r, int unused)
{
    const int is_text = r->text.order == AS_TEXT;
    token name = text_token(&r->text);
    int components = text_count(&r->text, 4);
    size_t n = (size_t)r->rows * (size_t)components, i;
    double *x;
    (void)unused;
    if (r->of == WHOLE || !components) text_fail(&r->text, "colours of nothing");
    x = read_data(r, is_text ? &float_type : &byte_type, (double)r->rows * components);
    for (i = 0; is_text && i < n; i++) x[i] = floor(255 * x[i] + 0.5);
    take(r, name, components, COLOUR_BYTES, x);
}

static void skip_table(reader *r, int unused)
{
    text_token(&r->text);
    (void)unused;
    free(read_data(r, r->text.order == AS_TEXT ? &float_type : &byte_type, 4.0 * read_count(r)));
}

/* Up to an empty line. */
static void skip_metadata(reader *r, int unused)
{
    (void)unused;
    while (text_next_line(&r->text) && text_more(&r->text)) continue;
}

/* One in each line; or as bytes behind their number, which takes 1, 2, 4 or 8 bytes, as its two
   highest bits tell. */
static void skip_texts(reader *r, double count)
{
    text *t = &r->text;
    double i, length;
    text_next_line(t);
    for (i = 0; i < count && text_left(t); i++) {
        static const int more[4] = {7, 3, 1, 0};
        const unsigned char *first = (const unsigned char *)t->at;
        int j, bytes;
        if (t->order == AS_TEXT) {
            text_next_line(t);
            continue;
        }
        bytes = more[*first >> 6];
        length = *first & 63;
        skip_bytes(t, 1);
        for (j = 0; j < bytes; j++) length = 256 * length + read_number(t, &byte_type);
        check_left(t, length, 1, 1);
        skip_bytes(t, (size_t)length);
    }
}

static void read_array(reader *r)
{
    text *t = &r->text;
    token name = text_word(t);
    int components = text_count(t, INT_MAX), rows = text_count(t, INT_MAX);
    const number_type *type = type_find(t, types, text_token(t));
    if (r->of != WHOLE && (rows != r->rows || !components))
        text_fail(t, "%d rows of %d, where %d rows should be", rows, components, r->rows);
    if (type->kind == 's') {
        skip_texts(r, (double)rows * components);
        r->mesh->lost_fields += r->of != WHOLE;
        return;
    }
    take(r, name, components, type_values(type, components),
         read_data(r, type, (double)rows * components));
}

static void read_field(reader *r, int unused)
{
    int i, n;
    (void)unused;
    text_token(&r->text);
    n = read_count(r);
    for (i = 0; i < n; i++) {
        read_array(r);
        if (accept(r, "metadata")) skip_metadata(r, 0);
    }
}

static void read_header(reader *r)
{
    text *t = &r->text;
    token k;
    text_expect(t, "#");
    text_expect(t, "vtk");
    text_expect(t, "datafile");
    text_expect(t, "version");
    k = text_token(t);
    r->version = k.length ? *k.at - '0' : 0;
    if (r->version < 1 || r->version > 5 || k.length < 2 || k.at[1] != '.')
        text_refuse(t, k, "is not a version from 1.0 to 5.1");
    text_next_line(t); /* to the title, which may be empty */
    text_next_line(t);
    k = text_word(t);
    if (token_is(k, "binary"))
        t->order = BIG;
    else if (!token_is(k, "ascii"))
        text_refuse(t, k, "where ASCII or BINARY should be");
}

static void read_keyword(reader *r, token k)
{
    static const keyword keywords[] = {{"dataset", read_dataset, 0},
                                       {"points", read_points, 0},
                                       {"vertices", read_section, 0},
                                       {"lines", read_section, 1},
                                       {"polygons", read_section, 2},
                                       {"triangle_strips", read_section, 3},
                                       {"cells", read_cells, 0},
                                       {"cell_types", read_kinds, 0},
                                       {"point_data", begin_data, OF_POINTS},
                                       {"cell_data", begin_data, OF_CELLS},
                                       {"field", read_field, 0},
                                       {"scalars", read_attribute, SCALARS},
                                       {"vectors", read_attribute, 3},
                                       {"normals", read_attribute, NORMALS},
                                       {"tensors", read_attribute, 9},
                                       {"tensors6", read_attribute, 6},
                                       {"texture_coordinates", read_attribute, TEXTURE},
                                       {"global_ids", read_attribute, 1},
                                       {"pedigree_ids", read_attribute, 1},
                                       {"edge_flags", read_attribute, 1},
                                       {"color_scalars", read_colours, 0},
                                       {"lookup_table", skip_table, 0},
                                       {"metadata", skip_metadata, 0}};
    size_t i, n = sizeof keywords / sizeof *keywords;
    for (i = 0; i < n && !token_is(k, keywords[i].word); i++) continue;
    if (i == n) text_refuse(&r->text, k, "where a keyword should be");
    keywords[i].read(r, keywords[i].argument);
}

void mesh_read_vtk(const char *path, const char *data, size_t size, mesh *m)
{
    reader r;
    token k;
    int i;
    memset(&r, 0, sizeof r);
    r.text = text_open(path, data, size);
    r.text.plain = 1;
    r.mesh = m;
    read_header(&r);
    for (k = text_word(&r.text); k.length; k = text_word(&r.text)) read_keyword(&r, k);
    if (r.list.count) text_fail(&r.text, "the types of the cells are missing");
    for (i = 1; i < SECTIONS; i++) cells_append(&r.cells[0], &r.cells[i]);
    list_free(&r.list);
    cells_take(path, &r.cells[0], m);
}
