/* Cells of all kinds into triangles. */
#include "mesh_cells.h"
#include "mesh_binary.h"

#include <stdlib.h>

enum { KINDS = 256, PIXEL = 8, QUADRATIC_POLYGON = 36 };

void cells_add_point(cells *c, int point)
{
    c->point = room(c->point, c->corners, sizeof *c->point);
    c->point[c->corners++] = point;
}

int cells_base(int kind)
{
    static const unsigned char curved[][2] = {
        {21, 3},  {35, 3},  {68, 3},  {75, 3},  {22, 5},  {34, 5},  {69, 5},  {76, 5},
        {36, 7},  {23, 9},  {28, 9},  {30, 9},  {70, 9},  {77, 9},  {24, 10}, {71, 10},
        {78, 10}, {25, 12}, {29, 12}, {33, 12}, {72, 12}, {79, 12}, {26, 13}, {31, 13},
        {32, 13}, {73, 13}, {80, 13}, {27, 14}, {37, 14}, {74, 14}, {81, 14}};
    size_t i;
    if (kind <= 16) return kind;
    for (i = 0; i < sizeof curved / sizeof *curved; i++)
        if (curved[i][0] == kind) return curved[i][1];
    return 0;
}

/* Of the kinds up to 16; 0: any number. */
static int corners_of(int base)
{
    static const unsigned char corners[] = {0, 1, 0, 2, 0, 3, 0, 0, 4, 4, 4, 8, 8, 6, 5, 10, 12};
    return corners[base];
}

static void add(cells *c, int kind)
{
    c->kind = room(c->kind, c->count, sizeof *c->kind);
    c->end = room(c->end, c->count, sizeof *c->end);
    c->kind[c->count] = (unsigned char)kind;
    c->end[c->count++] = c->corners;
}

void cells_add(cells *c, const text *t, int kind)
{
    const int base = cells_base(kind), corners = corners_of(base);
    const int n = c->corners - (c->count ? c->end[c->count - 1] : 0);
    if (kind < 0 || kind >= KINDS) text_fail(t, "there is no type %d of cells", kind);
    if (corners && (n < corners || (n > corners && base == kind)))
        text_fail(t, "a cell of type %d has %d points, not %d", kind, n, corners);
    add(c, kind);
}

const int *cells_points(const cells *c, int i, int *n)
{
    int begin = i ? c->end[i - 1] : 0;
    *n = c->end[i] - begin;
    return *n ? c->point + begin : NULL;
}

static void cells_free(cells *c)
{
    free(c->kind);
    free(c->end);
    free(c->point);
    memset(c, 0, sizeof *c);
}

void cells_append(cells *c, cells *more)
{
    int i, j, n;
    for (i = 0; i < more->count; i++) {
        const int *p = cells_points(more, i, &n);
        for (j = 0; j < n; j++) cells_add_point(c, p[j]);
        add(c, more->kind[i]);
    }
    cells_free(more);
}

/* Every other triangle of a strip is turned round. */
static void add_strip(mesh *m, int n, const int *p)
{
    int i;
    for (i = 0; i + 2 < n; i++) {
        int c[3];
        c[0] = p[i], c[1] = p[i + 1 + i % 2], c[2] = p[i + 2 - i % 2];
        mesh_add_polygon(m, 3, c, m->normals ? c : NULL);
    }
}

/* False if the cell is no face. */
static int add_face(mesh *m, int kind, int n, const int *p)
{
    const int base = cells_base(kind);
    int c[4];
    if (kind == QUADRATIC_POLYGON) n /= 2;
    if (base == TRIANGLE) n = 3;
    if (base == QUAD) n = 4;
    if (base < TRIANGLE || base > QUAD || n < 3) return 0;
    if (base == PIXEL) {
        c[0] = p[0], c[1] = p[1], c[2] = p[3], c[3] = p[2];
        p = c;
    }
    if (base == STRIP)
        add_strip(m, n, p);
    else
        mesh_add_polygon(m, n, p, m->normals ? p : NULL);
    return 1;
}

int cells_curved(int kind, int n)
{
    const int base = cells_base(kind);
    return base != kind && (!corners_of(base) || n > corners_of(base));
}

static void take_faces(const cells *c, mesh *m)
{
    int i, n;
    for (i = 0; i < c->count; i++) {
        const int *p = cells_points(c, i, &n);
        m->cells = i;
        if (!add_face(m, c->kind[i], n, p))
            m->skipped++;
        else
            m->curved += cells_curved(c->kind[i], n);
    }
}

/* Numbers the cells that have triangles, and keeps their rows. */
static void keep_cells(mesh *m, int count)
{
    int *number = allocate((size_t)count, sizeof *number), i, j, n = 0;
    for (i = 0; i < m->triangles; i++) number[m->cell[i]] = 1;
    for (i = 0; i < count; i++) {
        if (!number[i]) continue;
        for (j = 0; j < m->cell_fields; j++) field_move_row(&m->cell_field[j], i, n);
        number[i] = n++;
    }
    for (i = 0; i < m->triangles; i++) m->cell[i] = number[m->cell[i]];
    m->cells = n;
    free(number);
}

/* Whole numbers beyond 2^53 are not what the file has: leaves their fields out. */
static void drop_inexact(mesh *m, field *list, int *fields, int rows)
{
    int i;
    for (i = *fields - 1; i >= 0; i--) {
        size_t n = (size_t)rows * (size_t)list[i].components;
        if (list[i].kind == VALUES || is_exact(list[i].value, n)) continue;
        field_drop(list, fields, i);
        m->lost_fields++;
    }
}

void cells_take(const char *path, cells *c, mesh *m)
{
    if (m->boundary)
        cells_take_boundary(path, c, m);
    else
        take_faces(c, m);
    drop_inexact(m, m->point_field, &m->point_fields, m->points);
    drop_inexact(m, m->cell_field, &m->cell_fields, c->count);
    keep_cells(m, c->count);
    cells_free(c);
}
