/* Joining points that are one: a hash over the points themselves, then, for a tolerance, over the
 * cells of a grid. */
#include "mesh.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct table {
    n3_vec *key;    /* of each point */
    int *head;      /* by hash, the first point; negative: none */
    int *next;      /* of each point, the next with this hash */
    uint32_t slots; /* a power of two */
} table;

static uint64_t mix(uint64_t h, n3_real x)
{
    double d = (double)x + 0.0; /* -0 equals 0 */
    uint64_t bits;
    memcpy(&bits, &d, sizeof bits);
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    return h ^ (h >> 32);
}

static int *slot(const table *t, n3_vec key)
{
    return &t->head[mix(mix(mix(0, key.x), key.y), key.z) & (t->slots - 1)];
}

static int same(n3_vec a, n3_vec b)
{
    return a.x >= b.x && a.x <= b.x && a.y >= b.y && a.y <= b.y && a.z >= b.z && a.z <= b.z;
}

static table table_make(int points)
{
    table t;
    uint32_t i;
    for (t.slots = 16; t.slots < (uint32_t)points; t.slots *= 2) continue;
    t.key = allocate((size_t)points, sizeof *t.key);
    t.next = allocate((size_t)points, sizeof *t.next);
    t.head = allocate(t.slots, sizeof *t.head);
    for (i = 0; i < t.slots; i++) t.head[i] = -1;
    return t;
}

static void table_free(table *t)
{
    free(t->key);
    free(t->next);
    free(t->head);
}

static void table_add(table *t, int point)
{
    int *head = slot(t, t->key[point]);
    t->next[point] = *head;
    *head = point;
}

int mesh_find_equal(const mesh *m, int *kept)
{
    table t = table_make(m->points);
    int i, j, equal = 0;
    for (i = 0; i < m->points; i++) {
        t.key[i] = m->point[i];
        for (j = *slot(&t, t.key[i]); j >= 0 && !same(t.key[i], t.key[j]); j = t.next[j]) continue;
        kept[i] = j < 0 ? i : j;
        if (j < 0)
            table_add(&t, i);
        else
            equal++;
    }
    table_free(&t);
    return equal;
}

static n3_vec cell(n3_vec x, n3_vec lo, n3_real size)
{
    return n3_v(floor((x.x - lo.x) / size), floor((x.y - lo.y) / size), floor((x.z - lo.z) / size));
}

/* The nearest point to i in one cell of the table, if it is nearer than the one found. */
static void find_nearer(const table *t, const mesh *m, int i, n3_vec key, n3_real *best, int *found)
{
    int j;
    for (j = *slot(t, key); j >= 0; j = t->next[j]) {
        n3_real far_off;
        if (!same(t->key[j], key)) continue;
        far_off = n3_len(n3_sub(m->point[i], m->point[j])) / m->reach;
        if (far_off < *best || (far_off <= *best && *found < 0)) *best = far_off, *found = j;
    }
}

/* The nearest point of the table to i within reach, -1 for none. Cells are so wide that what is
   within reach lies in two of them at most, along each axis. */
static int find_close(const table *t, const mesh *m, int i, n3_vec lo, n3_real size)
{
    const n3_vec reach = n3_v(m->reach, m->reach, m->reach);
    n3_vec from = cell(n3_sub(m->point[i], reach), lo, size);
    n3_vec to = cell(n3_add(m->point[i], reach), lo, size);
    n3_real best = 1;
    int found = -1, c;
    for (c = 0; c < 8; c++) {
        n3_vec key = n3_v(c & 1 ? to.x : from.x, c & 2 ? to.y : from.y, c & 4 ? to.z : from.z);
        if ((c & 1 && key.x <= from.x) || (c & 2 && key.y <= from.y) || (c & 4 && key.z <= from.z))
            continue;
        find_nearer(t, m, i, key, &best, &found);
    }
    return found;
}

static void join_close(mesh *m, int *kept, n3_vec lo)
{
    const n3_real size = 4 * m->reach;
    table t = table_make(m->points);
    int i, j;
    for (i = 0; i < m->points; i++) {
        if (kept[i] != i) {
            kept[i] = kept[kept[i]];
            continue;
        }
        t.key[i] = cell(m->point[i], lo, size);
        j = find_close(&t, m, i, lo, size);
        if (j < 0)
            table_add(&t, i);
        else
            kept[i] = j, m->welded++;
    }
    table_free(&t);
}

/* The lower corner of the box of all points; its diagonal into *diagonal. */
static n3_vec box(const mesh *m, n3_real *diagonal)
{
    n3_vec lo = m->points ? m->point[0] : n3_v(0, 0, 0), hi = lo;
    int i;
    for (i = 1; i < m->points; i++) box_add(&lo, &hi, m->point[i]);
    *diagonal = n3_len(n3_sub(hi, lo));
    return lo;
}

static void drop_triangles(mesh *m, const int *kept)
{
    int t, n = 0;
    for (t = 0; t < m->triangles; t++) {
        const int *from = m->triangle + 3 * t;
        int a = kept[from[0]], b = kept[from[1]], c = kept[from[2]], *to = m->triangle + 3 * n;
        if (a == b || b == c || c == a) continue;
        to[0] = a, to[1] = b, to[2] = c;
        memmove(m->corner + 3 * n, m->corner + 3 * t, 3 * sizeof *m->corner);
        m->cell[n] = m->cell[t];
        m->group[n++] = m->group[t];
    }
    m->collapsed += m->triangles - n;
    m->triangles = n;
}

/* Numbers the points that triangles use; kept becomes their new numbers. */
static void drop_points(mesh *m, int *kept)
{
    int i, j, n = 0;
    for (i = 0; i < m->points; i++) kept[i] = -1;
    for (i = 0; i < 3 * m->triangles; i++) kept[m->triangle[i]] = 0;
    for (i = 0; i < m->points; i++) {
        if (kept[i] < 0) continue;
        m->point[n] = m->point[i];
        for (j = 0; j < m->point_fields; j++) field_move_row(&m->point_field[j], i, n);
        kept[i] = n++;
    }
    for (i = 0; i < 3 * m->triangles; i++) m->triangle[i] = kept[m->triangle[i]];
    m->unused += m->points - m->joined - m->welded - n;
    m->points = n;
}

void mesh_join(mesh *m, n3_real relative)
{
    int *kept = allocate((size_t)m->points, sizeof *kept);
    n3_real diagonal;
    n3_vec lo = box(m, &diagonal);
    m->reach = relative * diagonal;
    m->joined = mesh_find_equal(m, kept);
    if (m->reach > 0) join_close(m, kept, lo);
    drop_triangles(m, kept);
    drop_points(m, kept);
    free(kept);
}
