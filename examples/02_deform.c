/* 02_deform: a mesh is deformed at its nodes, and the smooth surface follows.
 *
 * A finite element program hands back a displacement for each node of a coarse mesh; wanted is the
 * deformed surface in between. Here the mesh is a torus and the displacement a known function, so
 * that the surface can be compared with the truth. */
#include "nagata3.h"

#include <math.h>
#include <stdio.h>

enum { NU = 24, NV = 16, POINTS = NU * NV, TRIANGLES = 2 * POINTS, EDGES = 3 * POINTS, PARTS = 4 };
enum { FINE = POINTS + (PARTS - 1) * EDGES + (PARTS - 1) * (PARTS - 2) / 2 * TRIANGLES };
enum { FINE_TRIANGLES = PARTS * PARTS * TRIANGLES };

static int triangle[TRIANGLES][3], corner[TRIANGLES][3], work[12 * TRIANGLES + 2];
static int fine_triangle[FINE_TRIANGLES][3];
static n3_vec normal[3 * TRIANGLES], net[POINTS + 2 * EDGES + TRIANGLES];

static n3_vec displacement(n3_vec x)
{
    return n3_v((n3_real)(0.2 * sin(x.y)), (n3_real)(0.2 * sin(x.z)), (n3_real)(0.2 * sin(x.x)));
}

/* A torus of radii 2 and 1, and its triangles. */
static void make_torus(n3_vec *point)
{
    const double turn = 2 * 3.14159265358979323846;
    int i, j, t = 0;
    for (i = 0; i < NU; i++)
        for (j = 0; j < NV; j++, t += 2) {
            double u = turn * i / NU, v = turn * j / NV, r = 2 + cos(v);
            int right = (i + 1) % NU * NV, up = (j + 1) % NV;
            point[i * NV + j] = n3_v((n3_real)(r * cos(u)), (n3_real)(r * sin(u)), (n3_real)sin(v));
            triangle[t][0] = triangle[t + 1][0] = i * NV + j;
            triangle[t][1] = right + j;
            triangle[t][2] = triangle[t + 1][1] = right + up;
            triangle[t + 1][2] = i * NV + up;
        }
}

static n3_status make_mesh(const n3_vec *node, n3_mesh *m, n3_topology *t)
{
    const n3_mesh empty = {POINTS, TRIANGLES, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0};
    *m = empty;
    m->point = &node->x;
    m->triangle = &triangle[0][0];
    return n3_mesh_topology(m, work, sizeof work, t, NULL);
}

/* The points of the smooth surface over the nodes, and the triangle, u and v of each. */
static n3_status refine(const n3_vec *node, n3_vec *fine, int *parent, n3_real *uv)
{
    n3_mesh m;
    n3_topology t;
    n3_status status = make_mesh(node, &m, &t);
    if (status == N3_OK)
        status = n3_mesh_normals(&m, &t, -1, NULL, normal, &corner[0][0], &m.normals, NULL);
    m.normal = &normal[0].x;
    m.corner = &corner[0][0];
    if (status == N3_OK) status = n3_mesh_net(&m, &t, NULL, net, NULL, NULL);
    if (status != N3_OK) return status;
    return n3_mesh_refine(&m, &t, net, PARTS, fine, &fine_triangle[0][0], NULL, NULL, parent, uv);
}

/* The places of the nodes, carried to the same triangles, u and v linearly, as any nodal field. */
static n3_status carry(const n3_vec *moved, const int *parent, const n3_real *uv, n3_vec *fine)
{
    n3_mesh m;
    n3_topology t;
    n3_status status = make_mesh(moved, &m, &t);
    if (status != N3_OK) return status;
    return n3_mesh_field(&m, &t, 1, 3, &moved->x, parent, uv, FINE, &fine->x);
}

/* The volume inside the refined triangles. */
static double volume(const n3_vec *x)
{
    double sum = 0;
    int i;
    for (i = 0; i < FINE_TRIANGLES; i++) {
        const int *t = fine_triangle[i];
        sum += (double)n3_dot(x[t[0]], n3_cross(x[t[1]], x[t[2]])) / 6;
    }
    return sum;
}

int main(void)
{
    static n3_vec node[POINTS], moved[POINTS], fine[FINE], flat[FINE], smooth[FINE], truth[FINE];
    static int parent[FINE];
    static n3_real uv[2 * FINE];
    n3_status status;
    int i;
    make_torus(node);
    for (i = 0; i < POINTS; i++) moved[i] = n3_add(node[i], displacement(node[i]));
    status = refine(node, fine, parent, uv);
    if (status == N3_OK) status = carry(moved, parent, uv, flat);
    if (status == N3_OK) status = refine(moved, smooth, NULL, NULL);
    if (status != N3_OK) {
        fprintf(stderr, "%s\n", n3_status_text(status));
        return 1;
    }
    for (i = 0; i < FINE; i++) truth[i] = n3_add(fine[i], displacement(fine[i]));
    printf("%d nodes moved, %d points between them followed; the volume inside is\n", POINTS,
           FINE - POINTS);
    printf("  %.3f  between the moved nodes on flat triangles\n", volume(flat));
    printf("  %.3f  on the smooth surface through the moved nodes\n", volume(smooth));
    printf("  %.3f  with every point of the surface moved by itself\n", volume(truth));
    return 0;
}
