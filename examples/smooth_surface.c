/* From a mesh to its surface: neighbours, creases, normals, the net of control points. */
#include "smooth.h"

#include "mesh_output.h"

#include <stdlib.h>

static n3_edge nagata_edge(n3_vertex a, n3_vertex b)
{
    n3_segment s = n3_segment_make(a, b);
    return n3_segment_raise(&s);
}

/* The third of the chord from x on, laid into the tangent plane there. */
static n3_vec pn_point(n3_vec x, n3_vec n, n3_vec chord)
{
    return n3_add(x, n3_mul((n3_real)1 / 3, n3_sub(chord, n3_mul(n3_dot(chord, n), n))));
}

/* The edge of a PN triangle (Vlachos et al. 2001, section 3). */
static n3_edge pn_edge(n3_vertex a, n3_vertex b)
{
    n3_edge e;
    e.p[0] = a.x;
    e.p[1] = pn_point(a.x, a.n, n3_sub(b.x, a.x));
    e.p[2] = pn_point(b.x, b.n, n3_sub(a.x, b.x));
    e.p[3] = b.x;
    return e;
}

static n3_edge flat_edge(n3_vertex a, n3_vertex b)
{
    a.n = b.n = n3_v(0, 0, 0);
    return pn_edge(a, b);
}

const smooth_rule *smooth_rule_find(const char *name)
{
    static const smooth_rule rules[] = {
        {"paper", N3_RULE_PAPER, NULL}, {"arc", N3_RULE_ARC, NULL},
        {"fit", N3_RULE_FIT, NULL},     {"nagata", N3_RULE_PAPER, nagata_edge},
        {"pn", N3_RULE_PAPER, pn_edge}, {"flat", N3_RULE_PAPER, flat_edge}};
    size_t i;
    for (i = 0; i < sizeof rules / sizeof *rules; i++)
        if (strcmp(rules[i].name, name) == 0) return &rules[i];
    return NULL;
}

static void check(const char *path, n3_status status, int item)
{
    if (status == N3_OK) return;
    if (item >= 0) fail(path, 0, "%s (number %d)", n3_status_text(status), item + 1);
    fail(path, 0, "%s", n3_status_text(status));
}

/* Sides between faces of different smoothing groups, or of none. */
static unsigned char *group_marks(const mesh *m, const n3_topology *t)
{
    unsigned char *mark = allocate((size_t)m->triangles, 3);
    int e, i;
    for (e = 0; e < t->edges; e++) {
        int group = m->group[t->side[t->first[e]] / 3], sharp = !group;
        for (i = t->first[e]; i < t->first[e + 1]; i++) sharp |= m->group[t->side[i] / 3] != group;
        for (i = t->first[e]; i < t->first[e + 1]; i++) mark[t->side[i]] = (unsigned char)sharp;
    }
    return mark;
}

static int count_inferred(const mesh *m)
{
    int i, n = 0;
    for (i = 0; i < 3 * m->triangles; i++)
        n += m->corner[i] < 0 || !(n3_len(m->normal[m->corner[i]]) > 0);
    return n;
}

static void make_normals(const char *path, const mesh *m, n3_real cos_crease, surface *s)
{
    unsigned char *mark = m->grouped ? group_marks(m, &s->topology) : NULL;
    int normals = 0, item = -1;
    n3_status status;
    s->normal = allocate((size_t)m->normals + 3 * (size_t)m->triangles, sizeof *s->normal);
    s->corner = allocate((size_t)m->triangles, 3 * sizeof *s->corner);
    progress("estimating normals", -1, 1);
    status = n3_mesh_normals(&s->mesh, &s->topology, cos_crease, mark, s->normal, s->corner,
                             &normals, &item);
    check(path, status, item);
    free(mark);
    s->mesh.normals = normals;
    s->mesh.normal = &s->normal->x;
    s->mesh.corner = s->corner;
    s->mesh.normal_stride = s->mesh.corner_stride = 0;
}

n3_edge surface_edge(const surface *s, int edge)
{
    n3_edge e;
    int end[2];
    n3_mesh_edge_ends(&s->mesh, &s->topology, edge, end);
    e.p[0] = s->net[end[0]];
    e.p[1] = s->net[s->mesh.points + 2 * edge];
    e.p[2] = s->net[s->mesh.points + 2 * edge + 1];
    e.p[3] = s->net[end[1]];
    return e;
}

int surface_edges_with(const surface *s, unsigned flags)
{
    int e, n = 0;
    for (e = 0; e < s->topology.edges; e++) n += (s->flags[e] & flags) != 0;
    return n;
}

/* The sum of the normals of the edge's faces at the point, each turned to the first's side. */
static n3_vec end_normal(const surface *s, int edge, int point)
{
    const n3_topology *t = &s->topology;
    n3_vec sum = n3_v(0, 0, 0);
    int k, i;
    for (k = t->first[edge]; k < t->first[edge + 1]; k++) {
        for (i = t->side[k] / 3 * 3; i < t->side[k] / 3 * 3 + 3; i++) {
            n3_vec n = s->normal[s->corner[i]];
            if (s->mesh.triangle[i] != point) continue;
            sum = n3_dot(sum, n) < 0 ? n3_sub(sum, n) : n3_add(sum, n);
        }
    }
    return n3_unit(sum);
}

static void replace_edge(const surface *s, int edge)
{
    n3_vec *net = s->net + s->mesh.points + 2 * edge;
    n3_vertex v[2];
    n3_edge e;
    int end[2], i;
    n3_mesh_edge_ends(&s->mesh, &s->topology, edge, end);
    for (i = 0; i < 2; i++) {
        v[i].x = s->net[end[i]];
        v[i].n = end_normal(s, edge, end[i]);
    }
    e = s->rule->edge(v[0], v[1]);
    net[0] = e.p[1];
    net[1] = e.p[2];
}

/* (6.1.10) is the centre of all the comparison rules: it has quadratic precision, so that it keeps
   a raised quadratic patch, and it is the PN triangle's own. */
static void replace_net(const surface *s)
{
    const unsigned creased = N3_EDGE_CREASE | N3_EDGE_HALF_CREASE;
    const int centres = s->mesh.points + 2 * s->topology.edges;
    int i;
    for (i = 0; i < s->topology.edges; i++)
        if (!(s->flags[i] & creased) || s->rule->edge == flat_edge) replace_edge(s, i);
    for (i = 0; i < s->mesh.triangles; i++) {
        n3_patch p;
        n3_edge e[3];
        n3_mesh_patches(&s->mesh, &s->topology, s->net, i, i + 1, &p);
        n3_patch_edges(&p, e);
        s->net[centres + i] = n3_patch_centre(&e[0], &e[1], &e[2]);
    }
}

static void make_topology(const char *path, const mesh *m, surface *s)
{
    n3_status status;
    size_t size;
    int item = -1;
    memset(s, 0, sizeof *s);
    s->mesh.points = m->points;
    s->mesh.triangles = m->triangles;
    s->mesh.point = &m->point->x;
    s->mesh.triangle = m->triangle;
    if (m->normals) {
        s->mesh.normals = m->normals;
        s->mesh.normal = &m->normal->x;
        s->mesh.corner = m->corner;
    }
    size = n3_mesh_workspace(&s->mesh);
    s->work = allocate(size, 1);
    progress("finding neighbours", -1, 1);
    status = n3_mesh_topology(&s->mesh, s->work, size, &s->topology, &item);
    check(path, status, item);
}

/* Edges and triangles are made in pieces, on all cores where the compiler has OpenMP. */
enum { PIECE = 4096 };

static int piece_end(int first, int count)
{
    return count - first < PIECE ? count : first + PIECE;
}

static void make_net(const surface *s, const n3_options *o)
{
    const n3_mesh *m = &s->mesh;
    const n3_topology *t = &s->topology;
    int i;
    memcpy(s->net, m->point, (size_t)m->points * sizeof *s->net);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (i = 0; i < t->edges; i += PIECE)
        n3_mesh_edges(m, t, o, i, piece_end(i, t->edges), s->net, s->flags);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (i = 0; i < m->triangles; i += PIECE)
        n3_mesh_centres(m, t, o, i, piece_end(i, m->triangles), s->net);
}

void surface_refine(const surface *s, int level, n3_vec *point, int *triangle, n3_vec *normal,
                    int *corner)
{
    const n3_mesh *m = &s->mesh;
    const n3_topology *t = &s->topology;
    int i;
    memcpy(point, s->net, (size_t)m->points * sizeof *point);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (i = 0; i < t->edges; i += PIECE)
        n3_mesh_refine_edges(m, t, s->net, level, i, piece_end(i, t->edges), point);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (i = 0; i < m->triangles; i += PIECE)
        n3_mesh_refine_triangles(m, t, s->net, level, i, piece_end(i, m->triangles), point,
                                 triangle, normal, corner);
}

void surface_make(const char *path, const mesh *m, const smooth_rule *rule, n3_real cos_crease,
                  surface *s)
{
    n3_options options = {0, 0, 0};
    make_topology(path, m, s);
    make_normals(path, m, cos_crease, s);
    s->path = path;
    s->rule = rule;
    s->cos_crease = cos_crease;
    s->inferred = count_inferred(m);
    s->nodes = n3_mesh_nodes(&s->mesh, &s->topology);
    if (s->nodes < s->mesh.points) check(path, N3_BAD_COUNT, -1);
    s->net = allocate((size_t)s->nodes, sizeof *s->net);
    s->flags = allocate((size_t)s->topology.edges, sizeof *s->flags);
    options.rule = rule->rule;
    progress("bending edges", -1, 1);
    make_net(s, &options);
    if (rule->edge) replace_net(s);
}

void surface_free(surface *s)
{
    free(s->work);
    free(s->normal);
    free(s->corner);
    free(s->net);
    free(s->flags);
    free(s->square);
    free(s->half);
}

n3_real surface_size(const surface *s)
{
    n3_vec lo = s->net[0], hi = lo;
    int i;
    for (i = 1; i < s->mesh.points; i++) box_add(&lo, &hi, s->net[i]);
    return n3_len(n3_sub(hi, lo));
}
