/* The boundary of volume cells: the faces that one of them has. */
#include "mesh_cells.h"

#include <stdlib.h>

enum { SIDES = 6, CORNERS = 4 }; /* at most, of a cell and of a side */

typedef struct side {
    int key[CORNERS]; /* the points in order, -1 for a corner less */
    int cell, number;
} side;

/* The corners of each side, so that it looks outwards of a cell whose base looks inwards. */
static const char *const sides_of[][SIDES + 1] = {
    {"021", "013", "123", "203"},                     /* tetrahedron */
    {"0231", "4576", "0154", "1375", "3267", "2046"}, /* voxel */
    {"0321", "4567", "0154", "1265", "2376", "3047"}, /* hexahedron */
    {"021", "345", "0143", "1254", "2035"},           /* wedge */
    {"0321", "014", "124", "234", "304"}};            /* pyramid */

enum { BASES = sizeof sides_of / sizeof *sides_of };

/* NULL for a cell that is no volume. */
static const char *const *cell_sides(const cells *c, int i)
{
    const int base = cells_base(c->kind[i]);
    return base >= TETRA && base < TETRA + BASES ? sides_of[base - TETRA] : NULL;
}

static void sort(int *a, int n)
{
    int i, j;
    for (i = 1; i < n; i++) {
        int x = a[i];
        for (j = i; j > 0 && a[j - 1] > x; j--) a[j] = a[j - 1];
        a[j] = x;
    }
}

/* Equal points count once. False if fewer than three are left: cells that have collapsed to others
   have such sides. */
static int make_key(const int *p, const char *corner, const int *kept, int *key)
{
    int sorted[CORNERS], i, n = 0, k = 0;
    for (; corner[n]; n++) sorted[n] = kept[p[corner[n] - '0']];
    sort(sorted, n);
    for (i = 0; i < CORNERS; i++) key[i] = -1;
    for (i = 0; i < n; i++)
        if (i == 0 || sorted[i] != sorted[i - 1]) key[k++] = sorted[i];
    return k >= 3;
}

static int compare(const void *a, const void *b)
{
    const int *x = ((const side *)a)->key, *y = ((const side *)b)->key;
    int i;
    for (i = 0; i + 1 < CORNERS && x[i] == y[i]; i++) continue;
    return (x[i] > y[i]) - (x[i] < y[i]);
}

static side *list_sides(const cells *c, const int *kept, size_t *count)
{
    const char *const *corner;
    side *list;
    size_t n = 0;
    int i, j, unused;
    for (i = 0; i < c->count; i++)
        for (corner = cell_sides(c, i); corner && *corner; corner++) n++;
    list = allocate(n, sizeof *list);
    for (n = 0, i = 0; i < c->count; i++) {
        const int *p = cells_points(c, i, &unused);
        for (corner = cell_sides(c, i), j = 0; corner && corner[j]; j++) {
            list[n].cell = i, list[n].number = j;
            n += (size_t)make_key(p, corner[j], kept, list[n].key);
        }
    }
    *count = n;
    return list;
}

/* Bit j of a cell's mask: no other side is the same as its side j. */
static unsigned char *open_sides(const cells *c, const int *kept)
{
    unsigned char *mask = allocate((size_t)c->count, 1);
    size_t n, i, j;
    side *list = list_sides(c, kept, &n);
    qsort(list, n, sizeof *list, compare);
    for (i = 0; i < n; i = j) {
        for (j = i + 1; j < n && compare(&list[i], &list[j]) == 0; j++) continue;
        if (j == i + 1) mask[list[i].cell] |= (unsigned char)(1 << list[i].number);
    }
    free(list);
    return mask;
}

/* True if the sides look inwards: the cones from a corner to them have a negative volume. */
static int is_inside_out(const mesh *m, const int *p, const char *const *corner)
{
    n3_real volume = 0;
    for (; *corner; corner++) {
        n3_vec a[CORNERS];
        int i;
        for (i = 0; (*corner)[i]; i++)
            a[i] = n3_sub(m->point[p[(*corner)[i] - '0']], m->point[p[0]]);
        for (i = 2; (*corner)[i]; i++) volume += n3_dot(a[0], n3_cross(a[i - 1], a[i]));
    }
    return volume < 0;
}

static void add_sides(mesh *m, const int *p, const char *const *corner, int mask)
{
    const int turned = is_inside_out(m, p, corner);
    int j, i, n, q[CORNERS];
    for (j = 0; corner[j]; j++) {
        if (!(mask >> j & 1)) continue;
        n = (int)strlen(corner[j]);
        for (i = 0; i < n; i++) q[i] = p[corner[j][turned ? n - 1 - i : i] - '0'];
        mesh_add_polygon(m, n, q, m->normals ? q : NULL);
    }
}

void cells_take_boundary(const char *path, const cells *c, mesh *m)
{
    int *kept = allocate((size_t)m->points, sizeof *kept), i, n;
    unsigned char *mask;
    mesh_find_equal(m, kept);
    mask = open_sides(c, kept);
    for (i = 0; i < c->count; i++) {
        const char *const *corner = cell_sides(c, i);
        const int kind = c->kind[i], base = cells_base(kind), *p = cells_points(c, i, &n);
        m->cells = i;
        if (corner)
            add_sides(m, p, corner, mask[i]);
        else if (kind && (!base || base > QUAD))
            fail(path, 0, "the boundary of a cell of type %d is not known", kind);
        m->skipped += !corner;
        m->curved += mask[i] && cells_curved(kind, n);
    }
    free(mask);
    free(kept);
    if (!m->triangles) fail(path, 0, "there are no volume cells in it, whose boundary to take");
}
