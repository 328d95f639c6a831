/* From the surface to elements, with the fields of the mesh carried along. */
#include "smooth_grid.h"

#include <limits.h>
#include <stdlib.h>

typedef char numbers_are_double[sizeof(n3_real) == sizeof(double) ? 1 : -1];

static void too_many(const surface *s)
{
    fail(s->path, 0, "%d triangles would become too many", s->mesh.triangles);
}

static void grid_start(const mesh *m, const surface *s, int kind, int corners, grid *g)
{
    memset(g, 0, sizeof *g);
    g->mesh = m;
    g->surface = s;
    g->kind = kind;
    g->corners = corners;
    g->first = allocate((size_t)s->topology.edges + 1, sizeof *g->first);
}

/* The counts are known; with parents where there are fields to carry. */
static void grid_room(grid *g, unsigned with)
{
    size_t n = (size_t)g->elements, nodes = (size_t)g->nodes;
    g->node = allocate(nodes, sizeof *g->node);
    g->element = allocate(n, (size_t)g->corners * sizeof *g->element);
    if (with & (WITH_CORNER_NORMALS | WITH_NODE_NORMALS) && g->kind == FACETS) {
        g->normal = allocate((size_t)g->normals, sizeof *g->normal);
        g->corner = allocate(n, 3 * sizeof *g->corner);
    }
    g->origin = allocate(n, sizeof *g->origin);
    if (!(with & WITH_FIELDS && g->mesh->point_fields) && !g->surface->squares) return;
    g->parent = allocate(nodes, sizeof *g->parent);
    g->uv = allocate(nodes, 2 * sizeof *g->uv);
}

/* ---- Fields ---- */

/* Numbers of things have no mean: that of the next corner, of two as near the lower point. */
static double nearest(const grid *g, const field *f, int node, int component)
{
    const int *point = g->mesh->triangle + 3 * g->parent[node];
    n3_real w[3];
    int i, best = 0;
    w[1] = g->uv[2 * node], w[2] = g->uv[2 * node + 1], w[0] = 1 - w[1] - w[2];
    for (i = 1; i < 3; i++) {
        n3_real more = w[i] - w[best];
        if (more > N3_EPS || (more > -N3_EPS && point[i] < point[best])) best = i;
    }
    return f->value[(size_t)point[best] * (size_t)f->components + (size_t)component];
}

/* The points' own numbers, which no two share: new nodes go on from the highest. */
static void number_on(const grid *g, field *f)
{
    double most = g->mesh->highest;
    int i;
    for (i = 0; i < g->mesh->points; i++)
        if (f->value[i] > most) most = f->value[i];
    for (; i < g->nodes; i++) f->value[i] = most + i - g->mesh->points + 1;
}

static void take_nearest(const grid *g, const field *from, double *to)
{
    int i, k;
    for (i = g->mesh->points; i < g->nodes; i++)
        for (k = 0; k < from->components; k++) *to++ = nearest(g, from, i, k);
}

static void take_mean(const grid *g, const field *from, double *to)
{
    const surface *s = g->surface;
    const int points = g->mesh->points, rows = g->nodes - points;
    size_t i, n = (size_t)rows * (size_t)from->components;
    n3_mesh_field(&s->mesh, &s->topology, 1, from->components, from->value, g->parent + points,
                  g->uv + 2 * points, rows, to);
    for (i = 0; i < n && from->kind == COLOUR_BYTES; i++) to[i] = floor(to[i] + 0.5);
}

static void carry_field(const grid *g, const field *from, field *to)
{
    const size_t kept = (size_t)g->mesh->points * (size_t)from->components;
    *to = *from;
    to->value = allocate((size_t)g->nodes, (size_t)from->components * sizeof *to->value);
    memcpy(to->value, from->value, kept * sizeof *to->value);
    if (from->kind != NUMBERS)
        take_mean(g, from, to->value + kept);
    else if (from->components == 1 && strcmp(from->name, "id") == 0)
        number_on(g, to);
    else
        take_nearest(g, from, to->value + kept);
}

static void carry_fields(grid *g)
{
    const mesh *m = g->mesh;
    int i;
    if (m->point_fields) {
        g->point_field = allocate((size_t)m->point_fields, sizeof *g->point_field);
        for (i = 0; i < m->point_fields; i++)
            carry_field(g, &m->point_field[i], &g->point_field[i]);
    }
    if (!m->cell_fields) return;
    g->cell = allocate((size_t)g->elements, sizeof *g->cell);
    for (i = 0; i < g->elements; i++) g->cell[i] = m->cell[g->origin[i]];
}

/* ---- Normals ---- */

static int are_one(n3_vec a, n3_vec b) { return n3_dot(n3_unit(a), n3_unit(b)) >= 1 - 16 * N3_EPS; }

/* The mesh's own normal, to the bit, where the patch has the same. */
static n3_vec own_normal(const surface *s, int corner, n3_vec normal)
{
    n3_vec own = s->normal[s->corner[corner]];
    return are_one(own, normal) ? own : normal;
}

static void own_normals(grid *g)
{
    int i;
    for (i = 0; i < 3 * g->elements; i++) {
        n3_vec *normal = &g->normal[g->corner[i]];
        int corner = 3 * g->origin[i / 3];
        if (g->element[i] >= g->mesh->points) continue;
        while (g->mesh->triangle[corner] != g->element[i]) corner++;
        *normal = own_normal(g->surface, corner, *normal);
    }
}

n3_vec *grid_mean_normals(const grid *g, const int *of, int count)
{
    n3_vec *mean = allocate((size_t)count, sizeof *mean);
    int i;
    for (i = 0; i < 3 * g->elements; i++)
        mean[of[i]] = n3_add(mean[of[i]], g->normal[g->corner[i]]);
    for (i = 0; i < count; i++) mean[i] = n3_unit(mean[i]);
    for (i = 0; i < 3 * g->elements; i++) {
        n3_vec normal = g->normal[g->corner[i]];
        if (are_one(normal, mean[of[i]])) mean[of[i]] = normal;
    }
    return mean;
}

/* ---- Facets ---- */

static void finish_facets(grid *g, unsigned with)
{
    if (g->normal) own_normals(g);
    if (with & WITH_NODE_NORMALS) g->node_normal = grid_mean_normals(g, g->element, g->nodes);
    if (with & WITH_FIELDS) carry_fields(g);
}

void grid_refine(const mesh *m, const surface *s, int level, unsigned with, grid *g)
{
    int i;
    grid_start(m, s, FACETS, 3, g);
    if (n3_mesh_refine_counts(&s->mesh, &s->topology, level, &g->nodes, &g->elements,
                              &g->normals) != N3_OK)
        too_many(s);
    grid_room(g, with);
    for (i = 0; i <= s->topology.edges; i++) g->first[i] = m->points + (level - 1) * i;
    surface_refine(s, level, g->node, g->element, g->normal, g->corner);
    n3_mesh_refine(&s->mesh, &s->topology, s->net, level, NULL, NULL, NULL, NULL, g->parent, g->uv);
    for (i = 0; i < g->elements; i++) g->origin[i] = i / (level * level);
    if (s->squares) grid_lay_squares(g, level);
    finish_facets(g, with);
}

void grid_adapt(const mesh *m, const surface *s, n3_real distance, unsigned with, grid *g)
{
    const int edges = s->topology.edges;
    n3_cut *cut = allocate((size_t)edges + (size_t)m->triangles, sizeof *cut);
    int i;
    grid_start(m, s, FACETS, 3, g);
    if (n3_mesh_cut(&s->mesh, &s->topology, s->net, distance, cut, &g->nodes, &g->elements,
                    &g->normals, NULL) != N3_OK)
        too_many(s);
    grid_room(g, with);
    for (i = 0; i <= edges; i++) g->first[i] = cut[i].first;
    n3_mesh_refine_cut(&s->mesh, &s->topology, s->net, cut, g->node, g->element, g->normal,
                       g->corner, g->origin, g->parent, g->uv);
    free(cut);
    finish_facets(g, with);
}

/* ---- Elements with nodes between their corners ---- */

/* In the order of the file formats: corners, sides, middle. */
static int element_nodes(const grid *g, int triangle, int node[10])
{
    const surface *s = g->surface;
    int i;
    n3_mesh_patch_nodes(&s->mesh, &s->topology, triangle, node);
    for (i = 0; i < 3 && g->kind == QUADRATIC; i++)
        node[3 + i] = g->first[s->topology.edge[3 * triangle + i]];
    return g->corners;
}

enum { BLOCK = 64 };

/* The normals of all patches at their nodes; places: where those of an element are in a lattice. */
static void sum_normals(grid *g, int level, const int *places)
{
    const surface *s = g->surface;
    const int size = (level + 1) * (level + 2) / 2;
    n3_patch patch[BLOCK];
    n3_vec normal[10 * BLOCK];
    int first, last, i, k;
    for (first = 0; first < g->elements; first = last) {
        last = g->elements - first < BLOCK ? g->elements : first + BLOCK;
        n3_mesh_patches(&s->mesh, &s->topology, s->net, first, last, patch);
        n3_lattice_normals(patch, 0, last - first, level, normal);
        for (i = first; i < last; i++) {
            n3_vec *own = normal + (i - first) * size;
            surface_square_normals(s, i, level, own);
            for (k = 0; k < g->corners; k++) {
                n3_vec *sum = &g->node_normal[g->element[i * g->corners + k]];
                *sum = n3_add(*sum, own[places[k]]);
            }
        }
    }
}

static void curve_normals(grid *g)
{
    static const int halves[] = {0, 2, 5, 1, 4, 3}, thirds[] = {0, 3, 9, 1, 2, 6, 8, 7, 4, 5};
    int i;
    g->node_normal = allocate((size_t)g->nodes, sizeof *g->node_normal);
    if (g->kind == QUADRATIC)
        sum_normals(g, 2, halves);
    else
        sum_normals(g, 3, thirds);
    for (i = 0; i < g->nodes; i++) g->node_normal[i] = n3_unit(g->node_normal[i]);
    for (i = 0; i < 3 * g->mesh->triangles; i++) {
        n3_vec *normal = &g->node_normal[g->mesh->triangle[i]];
        *normal = own_normal(g->surface, i, *normal);
    }
}

/* The nodes of an element of the degree 2 or 3 are the points of a refinement with as many parts,
   and numbered as these; control points have the places of cubic nodes. */
void grid_curve(const mesh *m, const surface *s, int kind, unsigned with, grid *g)
{
    const int level = kind == QUADRATIC ? 2 : 3;
    int i, node[10];
    grid_start(m, s, kind, level == 2 ? 6 : 10, g);
    if (n3_mesh_refine_counts(&s->mesh, &s->topology, level, &g->nodes, NULL, NULL) != N3_OK)
        too_many(s);
    g->elements = m->triangles;
    if (g->elements > INT_MAX / g->corners) too_many(s);
    grid_room(g, with);
    for (i = 0; i <= s->topology.edges; i++) g->first[i] = m->points + (level - 1) * i;
    surface_refine(s, level, g->node, NULL, NULL, NULL);
    n3_mesh_refine(&s->mesh, &s->topology, s->net, level, NULL, NULL, NULL, NULL, g->parent, g->uv);
    if (s->squares) grid_lay_squares(g, level);
    if (kind == BEZIER) memcpy(g->node, s->net, (size_t)g->nodes * sizeof *g->node);
    for (i = 0; i < g->elements; i++) {
        int n = element_nodes(g, i, node);
        memcpy(g->element + i * n, node, (size_t)n * sizeof *node);
        g->origin[i] = i;
    }
    if (with & WITH_NODE_NORMALS) curve_normals(g);
    if (with & WITH_FIELDS) carry_fields(g);
}

void grid_free(grid *g)
{
    int i;
    for (i = 0; g->point_field && i < g->mesh->point_fields; i++) free(g->point_field[i].value);
    free(g->point_field);
    free(g->node);
    free(g->element);
    free(g->origin);
    free(g->first);
    free(g->normal);
    free(g->corner);
    free(g->node_normal);
    free(g->parent);
    free(g->uv);
    free(g->cell);
}

/* ---- Arrays ---- */

const field *mesh_field_find(const field *list, int fields, const char *name)
{
    int i;
    for (i = 0; i < fields; i++)
        if (strcmp(list[i].name, name) == 0) return &list[i];
    return NULL;
}

double array_value(const array *a, int row, int component)
{
    size_t i = (size_t)(a->map ? a->map[row] : row) * (size_t)a->components + (size_t)component;
    if (a->real) return a->real[i];
    return a->whole ? a->whole[i] : a->first + a->step * row;
}

void put_array(output *o, const array *a)
{
    int row, k;
    for (row = 0; row < a->rows; row++) {
        if (row % 4096 == 0) progress("writing", row, a->rows);
        for (k = 0; k < a->components; k++) {
            if (k) put_separator(o, ' ');
            put_value(o, a->type, array_value(a, row, k));
        }
        put_separator(o, '\n');
    }
}

/* The type with the fewest bytes that holds all numbers of things, or bytes of colours. */
static int type_of(const field *f, int rows)
{
    const double exact = 9007199254740992; /* 2^53 */
    size_t i, n = (size_t)rows * (size_t)f->components;
    int type = f->kind == COLOUR_BYTES ? UINT8 : INT32;
    if (f->kind == VALUES) return FLOAT64;
    for (i = 0; i < n; i++) {
        double x = f->value[i];
        if (!(fabs(x) <= exact) || x > floor(x)) return FLOAT64;
        if (type == UINT8 && !(x >= 0 && x <= 255)) type = INT32;
        if (!(x >= INT_MIN && x <= INT_MAX)) type = INT64;
    }
    return type;
}

static array array_of(const char *name, int components, int rows, int type, const double *real)
{
    array a = {NULL, 0, 0, 0, NULL, NULL, NULL, 0, 0};
    a.name = name;
    a.components = components;
    a.type = type;
    a.rows = rows;
    a.real = real;
    return a;
}

array *grid_node_arrays(const grid *g)
{
    const int fields = g->point_field ? g->mesh->point_fields : 0;
    array *list = allocate((size_t)fields + 2, sizeof *list), *to = list;
    int i;
    if (g->node_normal) *to++ = array_of("Normals", 3, g->nodes, FLOAT64, &g->node_normal->x);
    for (i = 0; i < fields; i++) {
        const field *f = &g->point_field[i];
        *to++ = array_of(f->name, f->components, g->nodes, type_of(f, g->nodes), f->value);
    }
    return list;
}

array *grid_element_arrays(const grid *g)
{
    const mesh *m = g->mesh;
    const int n = g->cell ? m->cell_fields : 0;
    array *list = allocate((size_t)n + 1, sizeof *list);
    int i;
    for (i = 0; i < n; i++) {
        const field *f = &m->cell_field[i];
        list[i] = array_of(f->name, f->components, g->elements, type_of(f, m->cells), f->value);
        list[i].map = g->cell;
    }
    return list;
}

array grid_places(const grid *g) { return array_of("points", 3, g->nodes, FLOAT64, &g->node->x); }
