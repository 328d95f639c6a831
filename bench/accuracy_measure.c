/* accuracy_measure.c: the patches of each method, and the measuring. */
#include "accuracy.h"

#include <math.h>
#include <stdlib.h>

const char *const method_name[METHODS] = {"flat",           "PN",  "Nagata", "paper",
                                          "paper, unclamped", "arc", "fit"};

/* ---- Patches ---- */

static n3_vec third(n3_vec x, n3_vec y) { return n3_mul((n3_real)1 / 3, n3_add(n3_add(x, x), y)); }

/* A side of a PN triangle: the thirds of the chord, each put into the tangent plane of its end; of
   a flat one without normals. */
static n3_edge pn_edge(n3_vertex a, n3_vertex b)
{
    n3_vec d = n3_sub(b.x, a.x);
    n3_edge e;
    e.p[0] = a.x;
    e.p[1] = n3_sub(third(a.x, b.x), n3_mul(n3_dot(d, a.n) / 3, a.n));
    e.p[2] = n3_add(third(b.x, a.x), n3_mul(n3_dot(d, b.n) / 3, b.n));
    e.p[3] = b.x;
    return e;
}

static n3_patch pn_patch(const n3_vertex v[3])
{
    n3_edge ab = pn_edge(v[0], v[1]), bc = pn_edge(v[1], v[2]), ca = pn_edge(v[2], v[0]);
    return n3_patch_from_edges(&ab, &bc, &ca, n3_patch_centre(&ab, &bc, &ca));
}

static n3_patch lone_patch(const model *m, int triangle, int method)
{
    n3_vertex v[3];
    n3_patch2 q;
    int i;
    for (i = 0; i < 3; i++) {
        int point = m->triangle[3 * triangle + i];
        v[i].x = m->point[point];
        v[i].n = method == FLAT ? n3_v(0, 0, 0) : m->normal[point];
    }
    if (method != NAGATA) return pn_patch(v);
    q = n3_patch2_make(v[0], v[1], v[2]);
    return n3_patch2_raise(&q);
}

n3_patch *patches_by_rule(const model *m, const n3_options *o)
{
    n3_patch *patch = take((size_t)m->mesh.triangles, sizeof *patch);
    n3_vec *net = take((size_t)n3_mesh_nodes(&m->mesh, &m->topology), sizeof *net);
    n3_mesh_net(&m->mesh, &m->topology, o, net, NULL, NULL);
    n3_mesh_patches(&m->mesh, &m->topology, net, 0, m->mesh.triangles, patch);
    free(net);
    return patch;
}

n3_patch *patches_make(const model *m, int method)
{
    n3_options o = {N3_RULE_PAPER, 0, 0};
    n3_patch *patch;
    int i;
    if (method == ARC) o.rule = N3_RULE_ARC;
    if (method == FIT) o.rule = N3_RULE_FIT;
    if (method == PAPER_FREE) {
        o.tan_lo = (n3_real)1e-6;
        o.tan_hi = (n3_real)1e6;
    }
    if (method >= PAPER) return patches_by_rule(m, &o);
    patch = take((size_t)m->mesh.triangles, sizeof *patch);
    for (i = 0; i < m->mesh.triangles; i++) patch[i] = lone_patch(m, i, method);
    return patch;
}

/* ---- Measures ---- */

double angle_between(n3_vec a, n3_vec b)
{
    return atan2((double)n3_len(n3_cross(a, b)), (double)n3_dot(a, b)) * 57.29577951308232088;
}

static n3_vec point_and_normal(const n3_patch *p, n3_real u, n3_real v, n3_vec *normal)
{
    n3_jet j = n3_patch_jet(p, u, v);
    n3_vec n = n3_cross(j.du, j.dv);
    *normal = n3_dot(n, n) > 0 ? n3_unit(n) : n3_patch_normal(p, u, v);
    return j.x;
}

/* The normal at the part i/n of the side from corner s of a patch. */
static n3_vec normal_on_side(const n3_patch *p, int s, int i, int n)
{
    n3_real w[3] = {0, 0, 0};
    n3_vec normal;
    w[s] = (n3_real)(n - i) / (n3_real)n;
    w[(s + 1) % 3] = (n3_real)i / (n3_real)n;
    point_and_normal(p, w[1], w[2], &normal);
    return normal;
}

int is_measured(const model *m, int triangle)
{
    return triangle < m->measured && triangle % ((m->measured / MOST) | 1) == 0;
}

/* The largest angle along the edge of this side to the other patch there, which runs back; 0 if
   it is taken from the other side, or there is none. */
static double jump_across(const model *m, const n3_patch *patch, int side, int n)
{
    const int *first = &m->topology.first[m->topology.edge[side]];
    double jump = 0;
    int i, other;
    if (first[1] - first[0] != 2) return 0;
    other = m->topology.side[first[0]] + m->topology.side[first[0] + 1] - side;
    if (other < side && is_measured(m, other / 3)) return 0;
    for (i = 0; i <= n; i++) {
        n3_vec here = normal_on_side(&patch[side / 3], side % 3, i, n);
        n3_vec there = normal_on_side(&patch[other / 3], other % 3, n - i, n);
        jump = fmax(jump, angle_between(here, there));
    }
    return jump;
}

void measure_at(const surface *s, const model *m, n3_vec x, n3_vec mine, figures *r)
{
    n3_vec true_normal, foot;
    double distance, angle;
    if (!surface_foot(s, m, x, &foot, &true_normal)) {
        r->lost++;
        return;
    }
    distance = (double)n3_len(n3_sub(x, foot));
    angle = angle_between(mine, true_normal);
    r->distance = fmax(r->distance, distance);
    r->angle = fmax(r->angle, angle);
    r->mean_distance += distance;
    r->mean_angle += angle;
}

figures measure(const surface *s, const model *m, const n3_patch *patch, int n)
{
    figures r = {0, 0, 0, 0, 0, 0};
    double count = 0;
    int f, i, j;
    for (f = 0; f < m->measured; f++) {
        if (!is_measured(m, f)) continue;
        count += (n + 1) * (n + 2) / 2;
        for (i = 0; i <= n; i++)
            for (j = 0; i + j <= n; j++) {
                n3_real u = (n3_real)i / (n3_real)n, v = (n3_real)j / (n3_real)n;
                n3_vec mine, x = point_and_normal(&patch[f], u, v, &mine);
                measure_at(s, m, x, mine, &r);
            }
        for (i = 0; i < 3; i++) r.jump = fmax(r.jump, jump_across(m, patch, 3 * f + i, n));
    }
    r.mean_distance /= count - (double)r.lost;
    r.mean_angle /= count - (double)r.lost;
    return r;
}
