/* VTU: the surface itself, as 10-node triangles. The nodes are those of the shared net: the points
 * of the mesh, two on each edge, one in each triangle. */
#include "smooth.h"

#include <stdlib.h>

enum { LAGRANGE = 69, BEZIER = 76 }; /* types of cells */

static const n3_real third = (n3_real)1 / 3;

/* The Lagrange triangle's nodes are the points of the surface at thirds. */
static void lagrange_nodes(const surface *s, n3_vec *node)
{
    const int points = s->mesh.points, edges = s->topology.edges;
    int i;
    memcpy(node, s->net, (size_t)points * sizeof *node);
    for (i = 0; i < edges; i++) {
        n3_edge e = surface_edge(s, i);
        node[points + 2 * i] = n3_edge_point(&e, third);
        node[points + 2 * i + 1] = n3_edge_point(&e, 2 * third);
    }
    for (i = 0; i < s->mesh.triangles; i++) {
        n3_patch p;
        n3_mesh_patches(&s->mesh, &s->topology, s->net, i, i + 1, &p);
        node[points + 2 * edges + i] = n3_patch_point(&p, third, third);
    }
}

/* At a node of several patches, the mean of their normals. */
static void node_normals(const surface *s, n3_vec *normal)
{
    static const int uv[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0},
                                  {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    int t, i, node[10];
    for (t = 0; t < s->mesh.triangles; t++) {
        n3_patch p;
        n3_mesh_patches(&s->mesh, &s->topology, s->net, t, t + 1, &p);
        n3_mesh_patch_nodes(&s->mesh, &s->topology, t, node);
        for (i = 0; i < 10; i++) {
            n3_vec n = n3_patch_normal(&p, uv[i][0] * third, uv[i][1] * third);
            normal[node[i]] = n3_add(normal[node[i]], n);
        }
    }
    for (i = 0; i < s->nodes; i++) normal[i] = n3_unit(normal[i]);
}

static void write_vectors(FILE *f, const char *name, const n3_vec *a, int n)
{
    int i;
    fprintf(f, "<DataArray type=\"Float64\" Name=\"%s\" NumberOfComponents=\"3\" ", name);
    fputs("format=\"ascii\">\n", f);
    for (i = 0; i < n; i++) write_vec(f, a[i]);
    fputs("</DataArray>\n", f);
}

static void write_cells(FILE *f, const surface *s, int type)
{
    const int n = s->mesh.triangles;
    int t, i, node[10];
    fputs("<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n", f);
    for (t = 0; t < n; t++) {
        n3_mesh_patch_nodes(&s->mesh, &s->topology, t, node);
        for (i = 0; i < 10; i++) fprintf(f, "%d%c", node[i], i < 9 ? ' ' : '\n');
    }
    fputs("</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n", f);
    for (t = 0; t < n; t++) fprintf(f, "%.0f\n", 10 * (t + 1.0));
    fputs("</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n", f);
    for (t = 0; t < n; t++) fprintf(f, "%d\n", type);
    fputs("</DataArray>\n</Cells>\n", f);
}

/* A node on a crease has one normal for faces that differ there: viewers are told to shade by the
   normals only where there is no crease. */
void surface_write_vtu(FILE *f, const surface *s, int bezier)
{
    n3_vec *a = allocate((size_t)s->nodes, sizeof *a);
    fprintf(f,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
            "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
            "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n",
            s->nodes, s->mesh.triangles);
    fprintf(f, "<PointData%s>\n",
            surface_edges_with(s, N3_EDGE_CREASE | N3_EDGE_HALF_CREASE) ? ""
                                                                        : " Normals=\"normal\"");
    node_normals(s, a);
    write_vectors(f, "normal", a, s->nodes);
    fputs("</PointData>\n<Points>\n", f);
    if (!bezier) lagrange_nodes(s, a);
    write_vectors(f, "points", bezier ? s->net : a, s->nodes);
    fputs("</Points>\n", f);
    write_cells(f, s, bezier ? BEZIER : LAGRANGE);
    fputs("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n", f);
    free(a);
}
