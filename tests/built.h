/* built.h: all that nagata3.h makes of a mesh. Here and not in a file of its own, so that each test
 * compiles it with what it tests. */
#ifndef BUILT_H
#define BUILT_H

#include "shapes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* m has the normals of corner and normal, packed. The mesh that it is built from must live as
   long. */
typedef struct built {
    n3_mesh m;
    n3_topology t;
    int nodes, *corner;
    n3_vec *normal, *net;
    unsigned *flags;
    void *work;
} built;

/* Zeroed memory, with room for one more; or the end of the program. */
static inline void *memory(size_t count, size_t size)
{
    void *p = calloc(count + 1, size);
    if (!p) abort();
    return p;
}

/* cos_crease is for normals that are not given. */
static inline built build_mesh(const n3_mesh *m, int rule, double cos_crease)
{
    built b;
    size_t size = n3_mesh_workspace(m);
    n3_options o = {0, 0, 0};
    int normals = 0;
    o.rule = rule;
    b.m = *m;
    b.work = memory(size, 1);
    CHECK(n3_mesh_topology(m, b.work, size, &b.t, NULL) == N3_OK, rule);
    b.normal = memory((size_t)(m->normals + 3 * m->triangles), sizeof *b.normal);
    b.corner = memory(3 * (size_t)m->triangles, sizeof *b.corner);
    CHECK(n3_mesh_normals(m, &b.t, (n3_real)cos_crease, NULL, b.normal, b.corner, &normals, NULL) ==
              N3_OK,
          rule);
    b.m.normal = &b.normal[0].x;
    b.m.normals = normals;
    b.m.corner = b.corner;
    b.m.normal_stride = b.m.corner_stride = 0;
    b.nodes = n3_mesh_nodes(&b.m, &b.t);
    b.net = memory((size_t)b.nodes, sizeof *b.net);
    b.flags = memory((size_t)b.t.edges, sizeof *b.flags);
    CHECK(n3_mesh_net(&b.m, &b.t, &o, b.net, b.flags, NULL) == N3_OK, rule);
    return b;
}

static inline built build(const shape *s, int rule, double cos_crease)
{
    n3_mesh m = shape_mesh(s);
    return build_mesh(&m, rule, cos_crease);
}

/* From the lower to the higher point. */
static inline n3_edge built_edge(const built *b, int edge)
{
    n3_edge e;
    int end[2];
    n3_mesh_edge_ends(&b->m, &b->t, edge, end);
    e.p[0] = b->net[end[0]];
    e.p[1] = b->net[b->m.points + 2 * edge];
    e.p[2] = b->net[b->m.points + 2 * edge + 1];
    e.p[3] = b->net[end[1]];
    return e;
}

static inline n3_patch built_patch(const built *b, int triangle)
{
    n3_patch p;
    n3_mesh_patches(&b->m, &b->t, b->net, triangle, triangle + 1, &p);
    return p;
}

/* How far a normal of a lattice may be from n3_patch_normal: 6 N3_NOISE (|du| + |dv|) / |du x dv|
   in a patch of size 1, and 4 eps for making it unit. */
static inline double normal_bound(const n3_patch *p, n3_real u, n3_real v)
{
    n3_jet j = n3_patch_jet(p, u, v);
    double size = 0, du = (double)n3_len(j.du), dv = (double)n3_len(j.dv), area;
    int i;
    for (i = 1; i < 10; i++) size = fmax(size, (double)n3_len(n3_sub(p->p[i], p->p[0])));
    if (!(du > 0 && dv > 0)) return 2;
    area = (double)n3_len(n3_cross(n3_mul(1 / n3_len(j.du), j.du), n3_mul(1 / n3_len(j.dv), j.dv)));
    return area > 0 ? 4 * EPS + 6 * (double)N3_NOISE * size * (1 / du + 1 / dv) / area : 2;
}

static inline void built_free(built *b)
{
    free(b->work);
    free(b->normal);
    free(b->corner);
    free(b->net);
    free(b->flags);
}

#endif
