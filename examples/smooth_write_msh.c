/* Gmsh MSH 2.2: groups and names, node numbers and element numbers where the mesh has them. */
#include "smooth_grid.h"

#include <stdlib.h>

enum { MOST = 9 }; /* components that a view of Gmsh can have: 1, 3 or 9 */

/* The number of a thing: that of the mesh, or counted from 1. */
typedef struct numbering {
    const field *id;
    const int *row; /* of the field; NULL: as they come */
} numbering;

static double number_of(const numbering *n, int i)
{
    if (!n->id) return i + 1.0;
    return n->id->value[n->row ? n->row[i] : i];
}

static int is_number(double x) { return x >= 1 && x <= 2147483647.0 && !(floor(x) < x); }

/* Usable are positive ones that are all different. */
static int usable(const numbering *n, int count)
{
    unsigned char *seen;
    double most = 0;
    int i, good = 1;
    if (!n->id) return 1;
    for (i = 0; i < count; i++) {
        double x = number_of(n, i);
        if (!is_number(x)) return 0;
        if (x > most) most = x;
    }
    if (most > 16.0 * count + 1e6) return 0;
    seen = allocate((size_t)most + 1, 1);
    for (i = 0; i < count; i++) good = good && !seen[(size_t)number_of(n, i)]++;
    free(seen);
    return good;
}

static void put_int(output *o, double x, char separator)
{
    put_value(o, INT32, x);
    put_separator(o, separator);
}

/* The groups and the numbers that stand in the elements and nodes are no data. */
static int is_data(const array *a, const numbering *n)
{
    return strcmp(a->name, "gmsh:physical") && strcmp(a->name, "gmsh:geometrical") &&
           !(n->id && a->name == n->id->name);
}

/* The boundary of volumes takes their groups. */
static int dimension_of(const mesh *m, int name)
{
    int dimension = m->name[name].dimension;
    return m->boundary && dimension >= 2 ? 5 - dimension : dimension;
}

static void put_names(output *o, const mesh *m)
{
    int i;
    const char *c;
    if (!m->names) return;
    put_text(o, "$PhysicalNames\n");
    put_number(o, m->names);
    for (i = 0; i < m->names; i++) {
        put_text(o, "\n");
        put_number(o, dimension_of(m, i));
        put_text(o, " ");
        put_number(o, m->name[i].number);
        put_text(o, " \"");
        for (c = m->name[i].name; *c; c++) put_bytes(o, *c == '"' || *c == '\n' ? "'" : c, 1);
        put_text(o, "\"");
    }
    put_text(o, "\n$EndPhysicalNames\n");
}

static void put_nodes(output *o, const grid *g, const numbering *n)
{
    int i, k;
    array a = grid_places(g);
    put_text(o, "$Nodes\n");
    put_number(o, g->nodes);
    put_text(o, "\n");
    for (i = 0; i < g->nodes; i++) {
        if (i % 4096 == 0) progress("writing", i, g->nodes);
        put_int(o, number_of(n, i), ' ');
        for (k = 0; k < 3; k++) {
            put_value(o, FLOAT64, array_value(&a, i, k));
            put_separator(o, k < 2 ? ' ' : '\n');
        }
    }
    put_text(o, "$EndNodes\n");
}

/* The group of an element, or what stands for none. */
static double group_of(const grid *g, const field *f, int i, double none)
{
    double x = f ? f->value[(size_t)g->cell[i] * (size_t)f->components] : none;
    return x >= -2147483647.0 && x <= 2147483647.0 ? floor(x) : none;
}

/* The physical group and the entity, of which Gmsh wants one for each group at least. */
static void put_groups(output *o, const grid *g, const field *physical, const field *entity, int i)
{
    double group = group_of(g, physical, i, 0);
    put_int(o, group, ' ');
    put_int(o, group_of(g, entity, i, group > 1 ? group : 1), ' ');
}

/* In bytes, a head stands before all elements of one type: the type, their number, that of tags. */
static void put_elements(output *o, const grid *g, const numbering *nodes, const numbering *n)
{
    static const int types[] = {2, 9, 21};
    const mesh *m = g->mesh;
    const field *physical = mesh_field_find(m->cell_field, m->cell_fields, "gmsh:physical");
    const field *entity = mesh_field_find(m->cell_field, m->cell_fields, "gmsh:geometrical");
    int i, k;
    put_text(o, "$Elements\n");
    put_number(o, g->elements);
    put_text(o, "\n");
    if (!output_is_text(o))
        put_int(o, types[g->kind], ' '), put_int(o, g->elements, ' '), put_int(o, 2, '\n');
    for (i = 0; i < g->elements; i++) {
        const int *node = g->element + (size_t)i * (size_t)g->corners;
        if (i % 4096 == 0) progress("writing", i, g->elements);
        put_int(o, number_of(n, i), ' ');
        if (output_is_text(o)) put_int(o, types[g->kind], ' '), put_int(o, 2, ' ');
        put_groups(o, g, physical, entity, i);
        for (k = 0; k < g->corners; k++)
            put_int(o, number_of(nodes, node[k]), k < g->corners - 1 ? ' ' : '\n');
    }
    put_text(o, "$EndElements\n");
}

/* One view: the components from first on, filled up with zeros. */
static void put_view(output *o, const char *section, const array *a, int first, int count,
                     const numbering *n)
{
    int i, k, width = count == 1 ? 1 : count <= 3 ? 3 : MOST;
    char name[40];
    snprintf(name, sizeof name, count == a->components ? "\"\n" : " %d\"\n", first);
    put_text(o, "$");
    put_text(o, section);
    put_text(o, "\n1\n\"");
    put_text(o, a->name);
    put_text(o, name);
    put_text(o, "1\n0\n3\n0\n");
    put_number(o, width);
    put_text(o, "\n");
    put_number(o, a->rows);
    put_text(o, "\n");
    for (i = 0; i < a->rows; i++) {
        put_int(o, number_of(n, i), ' ');
        for (k = 0; k < width; k++) {
            put_value(o, FLOAT64, k < count ? array_value(a, i, first + k) : 0);
            put_separator(o, k < width - 1 ? ' ' : '\n');
        }
    }
    put_text(o, "$End");
    put_text(o, section);
    put_text(o, "\n");
}

static void put_views(output *o, const char *section, array *list, const numbering *n)
{
    const array *a;
    int k;
    for (a = list; a->name; a++) {
        if (!is_data(a, n)) continue;
        if (a->components <= MOST)
            put_view(o, section, a, 0, a->components, n);
        else
            for (k = 0; k < a->components; k++) put_view(o, section, a, k, 1, n);
    }
    free(list);
}

void grid_write_msh(output *o, const grid *g)
{
    const mesh *m = g->mesh;
    numbering nodes = {NULL, NULL}, elements = {NULL, NULL};
    if (g->point_field) nodes.id = mesh_field_find(g->point_field, m->point_fields, "id");
    if (g->cell) elements.id = mesh_field_find(m->cell_field, m->cell_fields, "id");
    elements.row = g->cell;
    if (!usable(&nodes, g->nodes)) nodes.id = NULL;
    if (!usable(&elements, g->elements)) elements.id = NULL;
    put_text(o, output_is_text(o) ? "$MeshFormat\n2.2 0 8\n" : "$MeshFormat\n2.2 1 8\n");
    if (!output_is_text(o)) put_int(o, 1, ' '), put_text(o, "\n");
    put_text(o, "$EndMeshFormat\n");
    put_names(o, m);
    put_nodes(o, g, &nodes);
    put_elements(o, g, &nodes, &elements);
    put_views(o, "NodeData", grid_node_arrays(g), &nodes);
    put_views(o, "ElementData", grid_element_arrays(g), &elements);
}
