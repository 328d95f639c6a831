/* VTU and legacy VTK. Text, or bytes: behind the XML of a VTU, little-endian; in a VTK, big-endian.
 */
#include "smooth_grid.h"

#include <stdlib.h>

enum { HEADER = 8 }; /* bytes of the number of bytes before each array of a VTU */

static int cell_type(const grid *g)
{
    static const int types[] = {5, 22, 69, 76};
    return types[g->kind];
}

static array connectivity_of(const grid *g)
{
    array a = {"connectivity", 0, INT32, 0, NULL, NULL, NULL, 0, 0};
    a.components = g->corners;
    a.rows = g->elements;
    a.whole = g->element;
    return a;
}

/* first, first + step, ... */
static array count_up(const char *name, int type, const grid *g, int first, int step)
{
    array a = {NULL, 1, 0, 0, NULL, NULL, NULL, 0, 0};
    a.name = name;
    a.type = type;
    a.rows = g->elements;
    a.first = first;
    a.step = step;
    return a;
}

/* ---- VTU ---- */

/* The bytes of the character of UTF-8 at s; 0 if none begins there that XML has. */
static size_t character_bytes(const char *s)
{
    const unsigned char *b = (const unsigned char *)s;
    size_t n = *b < ' ' ? 0 : *b < 0x80 ? 1 : *b < 0xc2 ? 0 : *b < 0xe0 ? 2 : *b < 0xf0 ? 3 : 4, i;
    if (*b > 0xf4) return 0;
    for (i = 1; i < n; i++)
        if ((b[i] & 0xc0) != 0x80) return 0;
    return n;
}

/* Names in attributes. */
static void put_escaped(output *o, const char *s)
{
    while (*s) {
        const char *as = *s == '&'   ? "&amp;"
                         : *s == '<' ? "&lt;"
                         : *s == '>' ? "&gt;"
                         : *s == '"' ? "&quot;"
                                     : NULL;
        size_t n = character_bytes(s);
        if (as || !n)
            put_text(o, as ? as : "_");
        else
            put_bytes(o, s, n);
        s += n ? n : 1;
    }
}

/* All arrays of a VTU, in the order of its sections. */
enum { POINT_DATA, CELL_DATA, POINTS, CELLS, SECTIONS };

typedef struct sections {
    array *list;
    int end[SECTIONS];
} sections;

static void append(sections *s, int *n, array a)
{
    s->list = room(s->list, *n, sizeof *s->list);
    s->list[(*n)++] = a;
}

static void append_all(sections *s, int *n, array *list)
{
    const array *a;
    for (a = list; a->name; a++) append(s, n, *a);
    free(list);
}

static sections sections_of(const grid *g)
{
    sections s = {NULL, {0}};
    int n = 0;
    append_all(&s, &n, grid_node_arrays(g));
    s.end[POINT_DATA] = n;
    append_all(&s, &n, grid_element_arrays(g));
    s.end[CELL_DATA] = n;
    append(&s, &n, grid_places(g));
    s.end[POINTS] = n;
    append(&s, &n, connectivity_of(g));
    append(&s, &n, count_up("offsets", INT64, g, g->corners, g->corners));
    append(&s, &n, count_up("types", UINT8, g, cell_type(g), 0));
    s.end[CELLS] = n;
    return s;
}

static double bytes_of(const array *a)
{
    return (double)a->rows * a->components * type_bytes(a->type);
}

/* In a list of cells the components are VTK's own affair. A single one goes without saying, and so
   meshio makes it a column. */
static void put_vtu_array(output *o, const array *a, int section, double *offset)
{
    static const char *const types[] = {"UInt8", "Int32", "Int64", "Float32", "Float64"};
    put_text(o, "<DataArray type=\"");
    put_text(o, types[a->type]);
    put_text(o, "\" Name=\"");
    put_escaped(o, a->name);
    if (a->components > 1 && section != CELLS) {
        put_text(o, "\" NumberOfComponents=\"");
        put_number(o, a->components);
    }
    put_text(o, output_is_text(o) ? "\" format=\"ascii\">\n" : "\" format=\"appended\" offset=\"");
    if (output_is_text(o)) {
        put_array(o, a);
        put_text(o, "</DataArray>\n");
    } else {
        put_number(o, *offset);
        put_text(o, "\"/>\n");
        *offset += HEADER + bytes_of(a);
    }
}

static void put_appended(output *o, const array *list, int n)
{
    int i;
    put_text(o, "<AppendedData encoding=\"raw\">\n_");
    for (i = 0; i < n; i++) {
        put_value(o, INT64, bytes_of(&list[i]));
        put_array(o, &list[i]);
    }
    put_text(o, "\n</AppendedData>\n");
}

void grid_write_vtu(output *o, const grid *g)
{
    static const char *const names[] = {"PointData", "CellData", "Points", "Cells"};
    sections s = sections_of(g);
    int section, i = 0;
    double offset = 0;
    put_text(o, "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n");
    put_text(o, "<Piece NumberOfPoints=\"");
    put_number(o, g->nodes);
    put_text(o, "\" NumberOfCells=\"");
    put_number(o, g->elements);
    put_text(o, "\">\n");
    for (section = 0; section < SECTIONS; section++) {
        put_text(o, "<");
        put_text(o, names[section]);
        put_text(o, section == POINT_DATA && g->node_normal ? " Normals=\"Normals\">\n" : ">\n");
        for (; i < s.end[section]; i++) put_vtu_array(o, &s.list[i], section, &offset);
        put_text(o, "</");
        put_text(o, names[section]);
        put_text(o, ">\n");
    }
    put_text(o, "</Piece>\n</UnstructuredGrid>\n");
    if (!output_is_text(o)) put_appended(o, s.list, s.end[CELLS]);
    put_text(o, "</VTKFile>\n");
    free(s.list);
}

/* ---- Legacy VTK ---- */

/* Names there have no blanks and other signs: VTK writes them as %20 and so on. */
static void put_encoded(output *o, const char *s)
{
    for (; *s; s++) {
        char code[4];
        if (*s > ' ' && *s < 127 && *s != '"' && *s != '%') {
            put_bytes(o, s, 1);
        } else {
            snprintf(code, sizeof code, "%%%02X", (unsigned)(unsigned char)*s);
            put_text(o, code);
        }
    }
}

/* A line of a keyword and numbers. */
static void put_line(output *o, const char *word, double one, double two, const char *end)
{
    put_text(o, word);
    put_number(o, one);
    if (two >= 0) put_text(o, " "), put_number(o, two);
    put_text(o, end);
}

static void put_field(output *o, const array *a)
{
    static const char *const types[] = {" unsigned_char\n", " int\n", " vtktypeint64\n", " float\n",
                                        " double\n"};
    put_encoded(o, a->name);
    put_line(o, " ", a->components, a->rows, types[a->type]);
    put_array(o, a);
    put_text(o, "\n");
}

static void put_fields(output *o, array *list)
{
    const array *a;
    int n = 0;
    while (list[n].name) n++;
    if (n) put_line(o, "FIELD FieldData ", n, -1, "\n");
    for (a = list; a->name; a++) put_field(o, a);
    free(list);
}

/* The number of nodes stands before those of each cell. */
static void put_cells(output *o, const grid *g)
{
    int i, k;
    put_line(o, "CELLS ", g->elements, (double)g->elements * (g->corners + 1), "\n");
    for (i = 0; i < g->elements; i++) {
        put_value(o, INT32, g->corners);
        for (k = 0; k < g->corners; k++) {
            put_separator(o, ' ');
            put_value(o, INT32, g->element[(size_t)i * (size_t)g->corners + (size_t)k]);
        }
        put_separator(o, '\n');
    }
    put_line(o, "\nCELL_TYPES ", g->elements, -1, "\n");
    for (i = 0; i < g->elements; i++) {
        put_value(o, INT32, cell_type(g));
        put_separator(o, '\n');
    }
}

void grid_write_vtk(output *o, const grid *g)
{
    array a = grid_places(g), *cell_arrays = grid_element_arrays(g);
    put_text(o, "# vtk DataFile Version 3.0\nsmooth\n");
    put_text(o, output_is_text(o) ? "ASCII\n" : "BINARY\n");
    put_line(o, "DATASET UNSTRUCTURED_GRID\nPOINTS ", g->nodes, -1, " double\n");
    put_array(o, &a);
    put_text(o, "\n");
    put_cells(o, g);
    put_line(o, "\nPOINT_DATA ", g->nodes, -1, "\n");
    put_fields(o, grid_node_arrays(g));
    if (cell_arrays->name) put_line(o, "CELL_DATA ", g->elements, -1, "\n");
    put_fields(o, cell_arrays);
}
