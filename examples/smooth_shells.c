#include "smooth_shells.h"

#include <stdlib.h>

static int root(int *link, int i)
{
    while (link[i] != i) i = link[i] = link[link[i]];
    return i;
}

/* Triangles with an edge in common are in one shell; shells are numbered by their first one. */
static void find_shells(const n3_topology *t, shells *all)
{
    int i, e, *link = allocate((size_t)t->triangles, sizeof *link);
    for (i = 0; i < t->triangles; i++) link[i] = i;
    for (e = 0; e < t->edges; e++)
        for (i = t->first[e] + 1; i < t->first[e + 1]; i++) {
            int a = root(link, t->side[i - 1] / 3), b = root(link, t->side[i] / 3);
            link[a > b ? a : b] = a > b ? b : a;
        }
    all->of = allocate((size_t)t->triangles, sizeof *all->of);
    for (i = 0; i < t->triangles; i++)
        all->of[i] = link[i] == i ? all->count++ : all->of[root(link, i)];
    free(link);
}

static void sort_triangles(int triangles, shells *all)
{
    int i, first = 0;
    all->shell = allocate((size_t)all->count, sizeof *all->shell);
    all->triangle = allocate((size_t)triangles, sizeof *all->triangle);
    for (i = 0; i < triangles; i++) all->shell[all->of[i]].count++;
    for (i = 0; i < all->count; i++) {
        all->shell[i].first = first;
        first += all->shell[i].count;
        all->shell[i].count = 0;
        all->shell[i].around = all->shell[i].cavity = all->shell[i].next = -1;
    }
    for (i = 0; i < triangles; i++) {
        shell *to = &all->shell[all->of[i]];
        all->triangle[to->first + to->count++] = i;
    }
}

static void corners_of(const surface *s, int triangle, n3_vec from, n3_vec x[3])
{
    int i;
    for (i = 0; i < 3; i++) x[i] = n3_sub(s->net[s->mesh.triangle[3 * triangle + i]], from);
}

/* A volume is seen from the shell's first point, so that it does not depend on where that is. */
static void measure(const surface *s, const shells *all, shell *one)
{
    const n3_vec zero = n3_v(0, 0, 0);
    n3_vec x[3], origin;
    int i, k;
    corners_of(s, all->triangle[one->first], zero, x);
    origin = one->lo = one->hi = x[0];
    for (i = one->first; i < one->first + one->count; i++) {
        corners_of(s, all->triangle[i], zero, x);
        for (k = 0; k < 3; k++) box_add(&one->lo, &one->hi, x[k]);
        corners_of(s, all->triangle[i], origin, x);
        one->volume += n3_dot(n3_cross(x[0], x[1]), x[2]) / 6;
    }
}

static void measure_all(const surface *s, shells *all)
{
    const unsigned open = N3_EDGE_BORDER | N3_EDGE_NON_MANIFOLD | N3_EDGE_FLIPPED;
    int i;
    for (i = 0; i < all->count; i++) measure(s, all, &all->shell[i]);
    for (i = 0; i < s->topology.edges; i++)
        if (s->flags[i] & open)
            all->shell[all->of[s->topology.side[s->topology.first[i]] / 3]].volume = 0;
}

/* How often the shell winds round x: the solid angles of its triangles from there over 4 pi
   (Van Oosterom and Strackee 1983). */
static n3_real winding(const surface *s, const shells *all, const shell *one, n3_vec x)
{
    const n3_real half_sphere = (n3_real)(2 * 3.14159265358979323846);
    n3_real sum = 0;
    int i, k;
    for (i = one->first; i < one->first + one->count; i++) {
        n3_vec a[3];
        corners_of(s, all->triangle[i], x, a);
        for (k = 0; k < 3; k++) a[k] = n3_unit(a[k]);
        sum += atan2(n3_dot(n3_cross(a[0], a[1]), a[2]),
                     1 + n3_dot(a[0], a[1]) + n3_dot(a[1], a[2]) + n3_dot(a[2], a[0]));
    }
    return sum / half_sphere;
}

static int is_in_box(const shell *one, n3_vec x)
{
    return x.x >= one->lo.x && x.x <= one->hi.x && x.y >= one->lo.y && x.y <= one->hi.y &&
           x.z >= one->lo.z && x.z <= one->hi.z;
}

/* The smallest of the solids that the point lies in, -1 if it lies in none. */
static int solid_around(const surface *s, const shells *all, const int *solid, int solids, n3_vec x)
{
    int i, found = -1;
    for (i = 0; i < solids; i++) {
        const shell *one = &all->shell[solid[i]];
        if (found >= 0 && one->volume >= all->shell[found].volume) continue;
        if (is_in_box(one, x) && winding(s, all, one, x) > (n3_real)1 / 2) found = solid[i];
    }
    return found;
}

/* What looks to its inside is a cavity of the smallest solid that it lies in. */
static void find_cavities(const surface *s, shells *all)
{
    int *solid = allocate((size_t)all->count, sizeof *solid), solids = 0, i;
    for (i = 0; i < all->count; i++)
        if (all->shell[i].volume > 0) solid[solids++] = i;
    for (i = all->count - 1; i >= 0; i--) {
        shell *one = &all->shell[i];
        n3_vec x = s->net[s->mesh.triangle[3 * all->triangle[one->first]]];
        if (!(one->volume < 0)) continue;
        one->around = solid_around(s, all, solid, solids, x);
        if (one->around < 0) continue;
        one->next = all->shell[one->around].cavity;
        all->shell[one->around].cavity = i;
    }
    free(solid);
}

shells shells_find(const surface *s)
{
    shells all = {0, NULL, NULL, NULL};
    find_shells(&s->topology, &all);
    sort_triangles(s->mesh.triangles, &all);
    measure_all(s, &all);
    find_cavities(s, &all);
    return all;
}

void shells_free(shells *all)
{
    free(all->shell);
    free(all->triangle);
    free(all->of);
}
