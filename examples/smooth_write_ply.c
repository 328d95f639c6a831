/* PLY: facets, and for each vertex one normal. Where faces that meet at a node have different ones
 * because an edge between them is sharp, the node is written once for each. */
#include "smooth_grid.h"

#include <stdlib.h>

/* Corners of the mesh that hang together over smooth edges, as links to one of them. */
static int fan(int *link, int c)
{
    while (link[c] != c) c = link[c] = link[link[c]];
    return c;
}

static int is_smooth(const surface *s, int edge)
{
    const unsigned sharp = N3_EDGE_CREASE | N3_EDGE_HALF_CREASE | N3_EDGE_NON_MANIFOLD |
                           N3_EDGE_FLIPPED | N3_EDGE_BORDER;
    return !(s->flags[edge] & sharp);
}

static int next_corner(int c) { return c % 3 == 2 ? c - 2 : c + 1; }

/* The two sides of a smooth edge run in opposite directions. */
static int *make_fans(const grid *g)
{
    const n3_topology *t = &g->surface->topology;
    int *link = allocate((size_t)g->mesh->triangles, 3 * sizeof *link);
    int i;
    for (i = 0; i < 3 * g->mesh->triangles; i++) link[i] = i;
    for (i = 0; i < t->edges; i++) {
        const int *side = t->side + t->first[i];
        if (!is_smooth(g->surface, i)) continue;
        link[fan(link, side[0])] = fan(link, next_corner(side[1]));
        link[fan(link, next_corner(side[0]))] = fan(link, side[1]);
    }
    return link;
}

/* Vertex i < nodes is the first of node i; the others come behind, in the order of the facets. */
typedef struct vertices {
    int count, *node;
    int *fan;    /* which faces have it; NONE: not known yet */
    int *next;   /* of the same node, 0: there is no other */
    int *corner; /* three of each facet */
    n3_vec *normal;
} vertices;

enum { NONE = -2, ALL = -1 };

static void add_vertex(vertices *v, int node, int fan)
{
    int n = v->count;
    v->node = room(v->node, n, sizeof *v->node);
    v->fan = room(v->fan, n, sizeof *v->fan);
    v->next = room(v->next, n, sizeof *v->next);
    v->node[n] = node;
    v->fan[n] = fan;
    v->next[n] = 0;
    v->count++;
}

/* The edge of each node that is on one, -1 for the others. */
static int *node_edges(const grid *g)
{
    int *edge = allocate((size_t)g->nodes, sizeof *edge);
    int e, i;
    for (i = 0; i < g->nodes; i++) edge[i] = -1;
    for (e = 0; e < g->surface->topology.edges; e++)
        for (i = g->first[e]; i < g->first[e + 1]; i++) edge[i] = e;
    return edge;
}

/* Which of the faces at a node share its normal with this triangle: a fan, itself, or all. */
static int fan_of(const grid *g, int *link, const int *edge, int triangle, int node)
{
    int c = 3 * triangle;
    if (edge[node] >= 0) return is_smooth(g->surface, edge[node]) ? ALL : triangle;
    if (node >= g->mesh->points) return ALL;
    while (g->mesh->triangle[c] != node) c++;
    return fan(link, c);
}

static int vertex_of(vertices *v, int node, int fan)
{
    int i = node;
    if (v->fan[i] == NONE) v->fan[i] = fan;
    for (; v->fan[i] != fan; i = v->next[i]) {
        if (v->next[i]) continue;
        v->next[i] = v->count;
        add_vertex(v, node, fan);
    }
    return i;
}

static vertices make_vertices(const grid *g)
{
    vertices v = {0, NULL, NULL, NULL, NULL, NULL};
    int *link = make_fans(g), *edge = node_edges(g), i;
    for (i = 0; i < g->nodes; i++) add_vertex(&v, i, NONE);
    v.corner = allocate((size_t)g->elements, 3 * sizeof *v.corner);
    for (i = 0; i < 3 * g->elements; i++) {
        int node = g->element[i];
        v.corner[i] = vertex_of(&v, node, fan_of(g, link, edge, g->origin[i / 3], node));
    }
    v.normal = grid_mean_normals(g, v.corner, v.count);
    free(link);
    free(edge);
    return v;
}

/* PLY knows no integers of eight bytes. */
static int ply_type(int type) { return type == INT64 ? FLOAT64 : type; }

/* A name has no blanks; components are counted. */
static void put_properties(output *o, const array *a)
{
    static const char *const types[] = {"property uchar ", "property int ", NULL, NULL,
                                        "property double "};
    const char *c;
    int k;
    for (k = 0; k < a->components; k++) {
        put_text(o, types[ply_type(a->type)]);
        for (c = a->name; *c; c++) put_bytes(o, *c > ' ' && *c < 127 ? c : "_", 1);
        if (a->components > 1) put_text(o, "_"), put_number(o, k);
        put_text(o, "\n");
    }
}

static void put_row(output *o, const array *list, int row)
{
    int k;
    for (; list->name; list++)
        for (k = 0; k < list->components; k++) {
            put_separator(o, ' ');
            put_value(o, ply_type(list->type), array_value(list, row, k));
        }
    put_separator(o, '\n');
}

static void put_head(output *o, int vertex_count, const array *node_arrays, int faces,
                     const array *face_arrays)
{
    put_text(o, output_is_text(o) ? "ply\nformat ascii 1.0\n"
                                  : "ply\nformat binary_little_endian 1.0\n");
    put_text(o, "element vertex ");
    put_number(o, vertex_count);
    put_text(o, "\nproperty double x\nproperty double y\nproperty double z\n"
                "property double nx\nproperty double ny\nproperty double nz\n");
    for (; node_arrays->name; node_arrays++) put_properties(o, node_arrays);
    put_text(o, "element face ");
    put_number(o, faces);
    put_text(o, "\nproperty list uchar int vertex_indices\n");
    for (; face_arrays->name; face_arrays++) put_properties(o, face_arrays);
    put_text(o, "end_header\n");
}

static void put_vec_value(output *o, n3_vec a)
{
    put_value(o, FLOAT64, (double)a.x);
    put_separator(o, ' ');
    put_value(o, FLOAT64, (double)a.y);
    put_separator(o, ' ');
    put_value(o, FLOAT64, (double)a.z);
}

void grid_write_ply(output *o, const grid *g)
{
    vertices v = make_vertices(g);
    array *node_arrays = grid_node_arrays(g), *face_arrays = grid_element_arrays(g);
    int i, k;
    put_head(o, v.count, node_arrays, g->elements, face_arrays);
    for (i = 0; i < v.count; i++) {
        if (i % 4096 == 0) progress("writing", i, v.count);
        put_vec_value(o, g->node[v.node[i]]);
        put_separator(o, ' ');
        put_vec_value(o, v.normal[i]);
        put_row(o, node_arrays, v.node[i]);
    }
    for (i = 0; i < g->elements; i++) {
        if (i % 4096 == 0) progress("writing", i, g->elements);
        put_value(o, UINT8, 3);
        for (k = 0; k < 3; k++) {
            put_separator(o, ' ');
            put_value(o, INT32, v.corner[3 * i + k]);
        }
        put_row(o, face_arrays, i);
    }
    free(node_arrays);
    free(face_arrays);
    free(v.node);
    free(v.fan);
    free(v.next);
    free(v.corner);
    free(v.normal);
}
