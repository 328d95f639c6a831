/* smooth.h: the surface that smooth lays over a mesh. */
#ifndef SMOOTH_H
#define SMOOTH_H

#include "mesh.h"
#include "picture_scene.h"

#include "brown/brown.h"

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
    const char *path; /* of the file that it comes from, for messages */
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
    n3_real cos_crease;
    int squares;     /* Brown's, each over two triangles that follow one another: */
    brown_square *square;
    int *half; /* of each triangle, 2 * its square, whose corners 0 1 2 it has, or 2 * its square
                  + 1 for 0 2 3; negative: it is a patch. NULL: they all are */
} surface;

/* Facets, elements with nodes on the surface, or with control points. */
enum { FACETS, QUADRATIC, CUBIC, BEZIER };

/* What to write, and how; tolerance 0: level or kind, where they are not 0, instead. */
typedef struct request {
    const char *path;
    int level, kind;   /* FACETS with level parts for each edge, or elements of another kind */
    n3_real tolerance; /* facets within this distance; */
    int relative;      /* of the bounding box's diagonal */
    int text;          /* or bytes, where the format knows both; negative: by the size */
    int width, height; /* of a picture */
    view view;
    camera camera;
    int drawn; /* something of a picture was asked for */
} request;

/* What went into the file; path NULL: nothing did. */
typedef struct product {
    const char *path, *kind; /* of its triangles: flat, quadratic or cubic */
    int triangles, points;
    int solids, sheets; /* STEP */
} product;

/* The mesh m must outlive the surface. cos_crease: of the angle between faces from which on an
   edge is sharp, where m has no normals of its own. */
void surface_make(const char *path, const mesh *m, const smooth_rule *rule, n3_real cos_crease,
                  surface *s);
void surface_free(surface *s);

/* n3_mesh_refine into room that is there, each but point may be NULL. */
void surface_refine(const surface *s, int level, n3_vec *point, int *triangle, n3_vec *normal,
                    int *corner);

/* Squares over the quads that the mesh had in the file, in place of patches. */
void surface_find_quads(const mesh *m, surface *s);

/* The same for squares that are known already: half and their number are set, and then, once this
   has made room, square and the control points of their sides in the net. */
void surface_take_squares(surface *s);

/* Where the triangle is half of a square: true, the derivatives by the square's parameters and the
   unit normal at those of the triangle. */
int surface_on_square(const surface *s, int triangle, n3_real u, n3_real v, n3_jet *jet,
                      n3_vec *normal);

/* The point and the unit normal at the parameters of a triangle; at t along a side of one. */
n3_vec surface_point(const surface *s, int triangle, n3_real u, n3_real v);
n3_vec surface_normal(const surface *s, int triangle, n3_real u, n3_real v);
n3_vec surface_side_normal(const surface *s, int side, n3_real t);

/* The corners of the i-th part of the row j of a triangle that is cut along its sides: how many
   parts they are from its first corner, in u and in v. */
void facet_places(int i, int j, int at[3][2]);

/* The unit normals over a triangle that is half of a square, as n3_lattice_normals has them for
   patches; over other triangles nothing is done. */
void surface_square_normals(const surface *s, int triangle, int level, n3_vec *normal);

/* The fewest parts for each edge with which facets are within the distance, as found in the middle
   of each and of its sides. */
int surface_level(const surface *s, n3_real distance);

/* What the header says of the mesh, with distances and jumps of the squares. */
n3_report surface_report(const surface *s);

/* The curve of an edge from its lower to its higher point. */
n3_edge surface_edge(const surface *s, int edge);
int surface_edges_with(const surface *s, unsigned flags);

/* The diagonal of the bounding box of its points. */
n3_real surface_size(const surface *s);

/* NULL, or why such a file cannot be: for people, to go behind its name. */
const char *product_refuse(const request *r);
/* True of formats that hold the surface itself, by control points. */
int product_is_exact(const request *r);
product product_write(const request *r, const mesh *m, const surface *s);

/* What reading has made of the file, never in silence: for stderr, a line for each. */
void report_reading(const char *in, const mesh *m);

/* One line for stderr; the whole story, as text or as JSON. */
void report_line(const char *in, const surface *s, const n3_report *r, const product *out);
void report_text(FILE *f, const char *in, const mesh *m, const surface *s, const n3_report *r,
                 const product *out);
void report_json(FILE *f, const char *in, const mesh *m, const surface *s, const n3_report *r,
                 const product *out);

#endif
