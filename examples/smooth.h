/* smooth.h: the surface that smooth lays over a mesh. */
#ifndef SMOOTH_H
#define SMOOTH_H

#include "mesh.h"

/* How the edges' curves are made. The rules of the header know creases; the three others take the
   paper's curve there, so that the faces stay joined. */
typedef struct smooth_rule {
    const char *name;
    int rule;                                  /* of the header, for the edges that are left */
    n3_edge (*edge)(n3_vertex a, n3_vertex b); /* NULL: all edges as the header makes them */
} smooth_rule;

/* NULL if there is none of that name. */
const smooth_rule *smooth_rule_find(const char *name);

typedef struct surface {
    const smooth_rule *rule;
    n3_mesh mesh; /* with the normals below */
    n3_topology topology;
    void *work;
    n3_vec *normal;
    int *corner;
    int nodes;
    n3_vec *net;     /* nodes control points, shared between patches */
    unsigned *flags; /* of each edge */
    int inferred;    /* corners whose normal is not from the file */
} surface;

/* What went into the file; path NULL: nothing did. */
typedef struct product {
    const char *path, *kind; /* of its triangles: flat or cubic */
    int triangles, points;
} product;

/* The mesh m must outlive the surface. cos_crease: of the angle between faces from which on an
   edge is sharp, where m has no normals of its own. */
void surface_make(const char *path, const mesh *m, const smooth_rule *rule, n3_real cos_crease,
                  surface *s);
void surface_free(surface *s);

/* The curve of an edge from its lower to its higher point. */
n3_edge surface_edge(const surface *s, int edge);
int surface_edges_with(const surface *s, unsigned flags);

/* The surface as flat triangles, level^2 for each, with the patches' own normals. */
void surface_refine(const char *path, const surface *s, int level, mesh *out);

/* VTU: cubic triangles, Lagrange or Bezier, on shared nodes. */
void surface_write_vtu(FILE *f, const surface *s, int bezier);

/* One line for stderr; the whole story for stdout, as text or as JSON. */
void report_line(const char *in, const surface *s, const n3_report *r, const product *out);
void report_text(const char *in, const mesh *m, const surface *s, const n3_report *r,
                 const product *out);
void report_json(const char *in, const mesh *m, const surface *s, const n3_report *r,
                 const product *out);

#endif
