/* joined.h: all that join.h makes of two meshes. Static, so that each test compiles the header with
 * what it tests. */
#ifndef JOINED_H
#define JOINED_H

#include "built.h"
#include "inputs.h"
#include "join.h"

extern const test_case tests_bridge[], tests_fujita[], tests_awkward[];

/* A mesh and one of its loops. It must not move. */
typedef struct body {
    n3_mesh mesh;
    n3_topology topology;
    void *work;
    int *scratch, *side;
    join_loop *loop;
    join_border border;
    join_vertex *vertex;
    join_rim rim;
} body;

typedef struct joined {
    join_status status;
    int item;
    join_bridge bridge;
    join_column *column;
    n3_vec *moved;
    n3_mesh mesh; /* of the arrays below */
    n3_topology topology;
    void *work;
    n3_vec *point;
    int *triangle;
} joined;

static inline void *topology_of(const n3_mesh *m, n3_topology *t)
{
    size_t size = n3_mesh_workspace(m);
    void *work = memory(size, 1);
    CHECK(n3_mesh_topology(m, work, size, t, NULL) == N3_OK, 0);
    return work;
}

static inline void body_open(const n3_mesh *m, body *p)
{
    size_t sides;
    p->mesh = *m;
    p->work = topology_of(m, &p->topology);
    sides = (size_t)join_border_sides(m, &p->topology);
    p->scratch = memory(3 * (size_t)m->triangles, sizeof *p->scratch);
    p->side = memory(sides, sizeof *p->side);
    p->loop = memory(sides, sizeof *p->loop);
    p->vertex = memory(sides, sizeof *p->vertex);
    p->border = join_border_make(&p->mesh, &p->topology, p->scratch, p->side, p->loop);
}

/* Takes the loop with the point; answers what join_rim_make does. */
static inline join_status body_take(body *p, int point)
{
    int loop = join_border_with(&p->border, point);
    return join_rim_make(&p->border, loop, 0, p->vertex, &p->rim);
}

static inline void body_free(body *p)
{
    free(p->work);
    free(p->scratch);
    free(p->side);
    free(p->loop);
    free(p->vertex);
}

/* From rims that are matched. Where the status is not JOIN_OK there is no mesh. */
static inline void join_rims(const body *a, const body *b, const join_options *o, int rows,
                             joined *j)
{
    memset(j, 0, sizeof *j);
    j->item = -1;
    j->column = memory((size_t)a->rim.count + (size_t)b->rim.count, sizeof *j->column);
    j->moved = memory((size_t)b->mesh.points, sizeof *j->moved);
    j->status = join_columns(&a->rim, &b->rim, o, j->column, j->moved, &j->bridge, &j->item);
    if (j->status != JOIN_OK) return;
    j->bridge.rows = rows;
    j->status = join_counts(&j->bridge, &j->mesh.points, &j->mesh.triangles);
    if (j->status != JOIN_OK) return;
    j->point = memory((size_t)j->mesh.points, sizeof *j->point);
    j->triangle = memory((size_t)j->mesh.triangles, 3 * sizeof *j->triangle);
    CHECK(join_mesh(&j->bridge, j->moved, j->point, j->triangle) == JOIN_OK, rows);
    j->mesh.point = &j->point->x;
    j->mesh.triangle = j->triangle;
    j->work = topology_of(&j->mesh, &j->topology);
}

static inline void joined_free(joined *j)
{
    free(j->column);
    free(j->moved);
    free(j->point);
    free(j->triangle);
    free(j->work);
}

/* One of the five inputs, with so many points around below and above, matched. */
typedef struct pair {
    tube tube[2];
    body a, b;
} pair;

static inline pair *pair_open(int number, int lower, int upper)
{
    pair *p = memory(1, sizeof *p);
    input_make(number, 0, lower, &p->tube[0]);
    input_make(number, 1, upper, &p->tube[1]);
    body_open(&p->tube[0].mesh, &p->a);
    body_open(&p->tube[1].mesh, &p->b);
    CHECK(body_take(&p->a, input_start(&p->tube[0], 0)) == JOIN_OK, number);
    CHECK(body_take(&p->b, input_start(&p->tube[1], 1)) == JOIN_OK, number);
    CHECK(join_rims_match(&p->a.rim, &p->b.rim, NULL, 0, NULL) == JOIN_OK, number);
    return p;
}

static inline void pair_free(pair *p)
{
    body_free(&p->a);
    body_free(&p->b);
    free(p);
}

static inline joined pair_join(const pair *p, int method, int rows)
{
    join_options o = {0, {0, 0}};
    joined j;
    o.method = method;
    join_rims(&p->a, &p->b, &o, rows, &j);
    return j;
}

/* ---- What is looked for in the result ---- */

static inline n3_vec corner_of(const joined *j, int triangle, int corner)
{
    return j->point[j->triangle[3 * triangle + corner]];
}

static inline n3_vec facet_normal(const joined *j, int triangle)
{
    n3_vec x = corner_of(j, triangle, 0);
    return n3_unit(n3_cross(n3_unit(n3_sub(corner_of(j, triangle, 1), x)),
                            n3_unit(n3_sub(corner_of(j, triangle, 2), x))));
}

/* Degrees between the triangles across a seam, 0 that with A, from least to most. Returns how many
   edges the seam has. */
static inline int seam(const joined *j, int which, double range[2])
{
    int e, k, count = 0, two[2];
    range[0] = 180, range[1] = 0;
    for (e = 0; e < j->topology.edges; e++) {
        n3_vec n[2];
        double angle;
        if (!n3i_is_regular(&j->mesh, &j->topology, e, two)) continue;
        if (joini_origin(&j->bridge, two[0] / 3) + joini_origin(&j->bridge, two[1] / 3) !=
            2 + which)
            continue;
        if (joini_origin(&j->bridge, two[0] / 3) == joini_origin(&j->bridge, two[1] / 3)) continue;
        for (k = 0; k < 2; k++) n[k] = facet_normal(j, two[k] / 3);
        angle = atan2((double)n3_len(n3_cross(n[0], n[1])), (double)n3_dot(n[0], n[1])) * 180 /
                3.14159265358979323846;
        if (angle < range[0]) range[0] = angle;
        if (angle > range[1]) range[1] = angle;
        count++;
    }
    return count;
}

/* Edges with one triangle; more than two or flipped ones count in *wrong. */
static inline int open_edges(const joined *j, int *wrong)
{
    int e, open = 0, two[2];
    *wrong = 0;
    for (e = 0; e < j->topology.edges; e++) {
        if (n3i_is_regular(&j->mesh, &j->topology, e, two)) continue;
        if (n3i_live_sides(&j->mesh, &j->topology, e, two) == 1)
            open++;
        else
            ++*wrong;
    }
    return open;
}

#endif
