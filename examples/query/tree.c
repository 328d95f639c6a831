#include "tree.h"

#include "mesh.h"

#include <math.h>
#include <stdlib.h>

/* Patches in a leaf at most; boxes that wait on a way through the tree, whose depth is the
   logarithm of the number of patches. */
enum { LEAF = 2, WAITING = 64 };

static n3_real part(n3_vec a, int k) { return k == 0 ? a.x : k == 1 ? a.y : a.z; }

static n3_vec larger(n3_vec a, n3_vec b)
{
    return n3_v(a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z);
}

static n3_box around(n3_box a, n3_box b)
{
    a.lo = n3_mul(-1, larger(n3_mul(-1, a.lo), n3_mul(-1, b.lo)));
    a.hi = larger(a.hi, b.hi);
    return a;
}

/* Twice the middle of a patch's box. */
static n3_vec middle(const n3_patch *p)
{
    n3_box box = n3_patch_box(p);
    return n3_add(box.lo, box.hi);
}

static void swap(tree *t, int i, int k)
{
    n3_patch p = t->patch[i];
    int was = t->was[i];
    t->patch[i] = t->patch[k];
    t->was[i] = t->was[k];
    t->patch[k] = p;
    t->was[k] = was;
}

/* Orders the patches of a node so that the lower half along an axis comes first (Hoare's select).
 */
static void halve(tree *t, int first, int last, int axis)
{
    int half = (first + last) / 2;
    while (last - first > 1) {
        n3_real pivot = part(middle(&t->patch[(first + last) / 2]), axis);
        int i = first, k = last - 1;
        while (i <= k) {
            while (part(middle(&t->patch[i]), axis) < pivot) i++;
            while (part(middle(&t->patch[k]), axis) > pivot) k--;
            if (i <= k) swap(t, i++, k--);
        }
        if (half <= k)
            last = k + 1;
        else if (half >= i)
            first = i;
        else
            return;
    }
}

static void grow(tree *t, int node, int first, int count, int *nodes)
{
    n3_vec size;
    int i, axis;
    tree_node *n = &t->node[node];
    n->box = n3_patch_box(&t->patch[first]);
    for (i = 1; i < count; i++) n->box = around(n->box, n3_patch_box(&t->patch[first + i]));
    n->first = first;
    n->count = count;
    if (count <= LEAF) return;
    size = n3_sub(n->box.hi, n->box.lo);
    axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    halve(t, first, first + count, axis);
    n->first = *nodes;
    n->count = 0;
    *nodes += 2;
    grow(t, n->first, first, count / 2, nodes);
    grow(t, n->first + 1, first + count / 2, count - count / 2, nodes);
}

tree tree_make(const n3_patch *p, int count)
{
    tree t;
    int i, nodes = 1;
    t.patches = count;
    t.patch = allocate((size_t)count, sizeof *t.patch);
    t.was = allocate((size_t)count, sizeof *t.was);
    t.node = allocate(2 * (size_t)count, sizeof *t.node);
    for (i = 0; i < count; i++) {
        t.patch[i] = p[i];
        t.was[i] = i;
    }
    grow(&t, 0, 0, count, &nodes);
    return t;
}

void tree_free(tree *t)
{
    free(t->patch);
    free(t->was);
    free(t->node);
}

/* Whether the ray may meet the box: between the planes across each axis, widened by what rounding
   makes of them, so that no box takes a hit from the patch that owns it. */
static int meets(n3_box box, n3_vec from, n3_vec along, n3_real t0, n3_real t1)
{
    int k;
    for (k = 0; k < 3; k++) {
        n3_real o = part(from, k), d = part(along, k), lo = part(box.lo, k), hi = part(box.hi, k);
        n3_real wide = 16 * N3_EPS * (n3i_abs(o) + n3i_abs(lo) + n3i_abs(hi)), a, b;
        lo = lo - o - wide;
        hi = hi - o + wide;
        if (!(n3i_abs(d) > 0)) {
            if (lo > 0 || hi < 0) return 0;
            continue;
        }
        a = (d > 0 ? lo : hi) / d;
        b = (d > 0 ? hi : lo) / d;
        if (a > t0) t0 = a;
        if (b < t1) t1 = b;
        if (t0 > t1) return 0;
    }
    return 1;
}

int tree_hit(const tree *t, n3_vec from, n3_vec along, n3_real t0, n3_real t1, n3_hit *hit)
{
    int stack[WAITING], count = 1, found = -1, i;
    stack[0] = 0;
    while (count > 0) {
        const tree_node *n = &t->node[stack[--count]];
        n3_hit h;
        if (!meets(n->box, from, along, t0, t1)) continue;
        for (i = n->first; i < n->first + n->count; i++)
            if (n3_patch_hit(&t->patch[i], from, along, t0, t1, &h)) {
                *hit = h;
                t1 = h.t;
                found = i;
            }
        if (n->count) continue;
        stack[count++] = n->first;
        stack[count++] = n->first + 1;
    }
    return found;
}

/* The square of the distance to a box, 0 inside. */
static n3_real distance2(n3_box box, n3_vec q)
{
    n3_vec away = larger(n3_sub(box.lo, q), n3_sub(q, box.hi));
    away = larger(away, n3_v(0, 0, 0));
    return n3_dot(away, away);
}

int tree_nearest(const tree *t, n3_vec q, n3_foot *foot)
{
    int stack[WAITING], count = 1, found = -1, i;
    stack[0] = 0;
    while (count > 0) {
        const tree_node *n = &t->node[stack[--count]];
        int second;
        if (found >= 0 && !(distance2(n->box, q) < foot->distance2)) continue;
        for (i = n->first; i < n->first + n->count; i++) {
            n3_foot f = n3_patch_nearest(&t->patch[i], q);
            if (found >= 0 && !(f.distance2 < foot->distance2)) continue;
            *foot = f;
            found = i;
        }
        if (n->count) continue;
        second = distance2(t->node[n->first].box, q) > distance2(t->node[n->first + 1].box, q);
        stack[count++] = n->first + !second;
        stack[count++] = n->first + second;
    }
    return found;
}
