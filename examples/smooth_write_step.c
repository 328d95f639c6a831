/* STEP, AP214, millimetres: the surface itself. Every patch is a face on a degenerate bicubic
 * B-spline surface; edge curves and vertices are shared. Triangles that hang together over edges
 * are a solid where they close, else a sheet. */
#include "smooth_grid.h"
#include "smooth_shells.h"

#include "mesh_number.h"

#include <ctype.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>

/* Instances are numbered as they are written; those of a kind follow each other, so that the number
   of each is known from the first. */
typedef struct step {
    output *o;
    const surface *s;
    shells shells;
    int last;                 /* the instance that was written last */
    int point, vertex, curve; /* of the first control point, point and edge */
    int face;                 /* of the first triangle */
} step;

/* Instances for each edge and each triangle; the last of them is the curve, the face. */
enum { EDGE_INSTANCES = 2, FACE_INSTANCES = 11 };

/* A real has a point, and a capital E. */
static void put_real(output *o, n3_real x)
{
    char s[NUMBER_SIZE + 2], *e;
    number_format(s, (double)x);
    e = strchr(s, 'e');
    if (e) *e = 'E';
    if (!e) e = s + strlen(s);
    if (!strchr(s, '.')) {
        memmove(e + 1, e, strlen(e) + 1);
        *e = '.';
    }
    put_text(o, s);
}

/* %d is a number in the text that follows the instance's own. */
static int put_instance(step *t, const char *format, ...)
{
    char s[600];
    va_list arguments;
    snprintf(s, sizeof s, "#%d=", ++t->last);
    put_text(t->o, s);
    va_start(arguments, format);
    vsnprintf(s, sizeof s, format, arguments);
    va_end(arguments);
    put_text(t->o, s);
    put_text(t->o, ";\n");
    return t->last;
}

static int put_point(step *t, n3_vec x)
{
    char s[20];
    snprintf(s, sizeof s, "#%d=", ++t->last);
    put_text(t->o, s);
    put_text(t->o, "CARTESIAN_POINT('',(");
    put_real(t->o, x.x);
    put_text(t->o, ",");
    put_real(t->o, x.y);
    put_text(t->o, ",");
    put_real(t->o, x.z);
    put_text(t->o, "));\n");
    return t->last;
}

/* ---- Geometry and topology ---- */

static int point_of(const step *t, int node) { return t->point + node; }
static int vertex_of(const step *t, int point) { return t->vertex + point; }

static void put_edge(step *t, int edge)
{
    const surface *s = t->s;
    int end[2], handle = s->mesh.points + 2 * edge, c;
    n3_mesh_edge_ends(&s->mesh, &s->topology, edge, end);
    c = put_instance(t,
                     "B_SPLINE_CURVE_WITH_KNOTS('',3,(#%d,#%d,#%d,#%d),.UNSPECIFIED.,.F.,.F.,(4,4),"
                     "(0.,1.),.UNSPECIFIED.)",
                     point_of(t, end[0]), point_of(t, handle), point_of(t, handle + 1),
                     point_of(t, end[1]));
    put_instance(t, "EDGE_CURVE('',#%d,#%d,#%d,.T.)", vertex_of(t, end[0]), vertex_of(t, end[1]),
                 c);
}

/* The rows of the net are the corner a, four times, two rows towards the opposite side, of which
   only the points inside are new, and that side. */
static int put_surface(step *t, int triangle)
{
    const surface *s = t->s;
    n3_patch p;
    n3_vec net[16];
    int node[10], i, inside[4];
    n3_mesh_patches(&s->mesh, &s->topology, s->net, triangle, triangle + 1, &p);
    n3_mesh_patch_nodes(&s->mesh, &s->topology, triangle, node);
    for (i = 0; i < 9; i++) node[i] = point_of(t, node[i]);
    n3_patch_bicubic(&p, net);
    for (i = 0; i < 4; i++) inside[i] = put_point(t, net[5 + i + 2 * (i / 2)]);
    return put_instance(
        t,
        "B_SPLINE_SURFACE_WITH_KNOTS('',3,3,((#%d,#%d,#%d,#%d),(#%d,#%d,#%d,#%d),"
        "(#%d,#%d,#%d,#%d),(#%d,#%d,#%d,#%d)),.UNSPECIFIED.,.F.,.F.,.F.,(4,4),(4,4),(0.,1.),"
        "(0.,1.),.UNSPECIFIED.)",
        node[0], node[0], node[0], node[0], node[3], inside[0], inside[1], node[8], node[4],
        inside[2], inside[3], node[7], node[1], node[5], node[6], node[2]);
}

/* What looks to its inside without being a cavity. */
static int is_turned(const shell *one) { return one->volume < 0 && one->around < 0; }

static void put_face(step *t, int triangle)
{
    const surface *s = t->s;
    const int turned = is_turned(&t->shells.shell[t->shells.of[triangle]]);
    int i, c, side[3], bound, on = put_surface(t, triangle);
    for (i = 0; i < 3; i++) {
        int a = s->mesh.triangle[3 * triangle + i],
            b = s->mesh.triangle[3 * triangle + (i + 1) % 3];
        c = t->curve + EDGE_INSTANCES * s->topology.edge[3 * triangle + i];
        side[i] = put_instance(t, "ORIENTED_EDGE('',*,*,#%d,%s)", c, a < b ? ".T." : ".F.");
    }
    c = put_instance(t, "EDGE_LOOP('',(#%d,#%d,#%d))", side[0], side[1], side[2]);
    bound = put_instance(t, "FACE_OUTER_BOUND('',#%d,%s)", c, turned ? ".F." : ".T.");
    put_instance(t, "ADVANCED_FACE('',(#%d),#%d,%s)", bound, on, turned ? ".F." : ".T.");
}

static void put_shape(step *t)
{
    const surface *s = t->s;
    int i, n = s->mesh.points + 2 * s->topology.edges;
    t->point = t->last + 1;
    for (i = 0; i < n; i++) put_point(t, s->net[i]);
    t->vertex = t->last + 1;
    for (i = 0; i < s->mesh.points; i++) put_instance(t, "VERTEX_POINT('',#%d)", point_of(t, i));
    t->curve = t->last + EDGE_INSTANCES;
    for (i = 0; i < s->topology.edges; i++) put_edge(t, i);
    t->face = t->last + FACE_INSTANCES;
    for (i = 0; i < s->mesh.triangles; i++) {
        if (i % 1024 == 0) progress("writing", i, s->mesh.triangles);
        put_face(t, i);
    }
}

/* ---- Bodies ---- */

/* A list of numbers, between what stands before and behind it. */
typedef struct list {
    int count, *number;
} list;

static void list_add(list *l, int number)
{
    l->number = room(l->number, l->count, sizeof *l->number);
    l->number[l->count++] = number;
}

static int put_list(step *t, const char *before, const list *l, const char *behind)
{
    char s[20];
    int i;
    snprintf(s, sizeof s, "#%d=", ++t->last);
    put_text(t->o, s);
    put_text(t->o, before);
    for (i = 0; i < l->count; i++) {
        snprintf(s, sizeof s, "%s#%d", i == 0 ? "" : i % 10 ? "," : ",\n", l->number[i]);
        put_text(t->o, s);
    }
    put_text(t->o, behind);
    put_text(t->o, ";\n");
    return t->last;
}

static int is_closed(const shell *one) { return one->volume < 0 || one->volume > 0; }

static int put_shell(step *t, const shell *one)
{
    list faces = {0, NULL};
    int i, n;
    for (i = one->first; i < one->first + one->count; i++)
        list_add(&faces, t->face + FACE_INSTANCES * t->shells.triangle[i]);
    n = put_list(t, is_closed(one) ? "CLOSED_SHELL('',(" : "OPEN_SHELL('',(", &faces, "))");
    free(faces.number);
    return n;
}

/* A cavity's faces look into it, out of the material. instance: of each shell. */
static int put_solid(step *t, const int *instance, int outer)
{
    char before[60];
    list cavities = {0, NULL};
    int k;
    for (k = t->shells.shell[outer].cavity; k >= 0; k = t->shells.shell[k].next)
        list_add(&cavities, put_instance(t, "ORIENTED_CLOSED_SHELL('',*,#%d,.T.)", instance[k]));
    if (!cavities.count) return put_instance(t, "MANIFOLD_SOLID_BREP('',#%d)", instance[outer]);
    snprintf(before, sizeof before, "BREP_WITH_VOIDS('',#%d,(", instance[outer]);
    k = put_list(t, before, &cavities, "))");
    free(cavities.number);
    return k;
}

static bodies put_bodies(step *t, list *items)
{
    const shells *all = &t->shells;
    int *instance = allocate((size_t)all->count, sizeof *instance), i;
    list sheets = {0, NULL};
    bodies made = {0, 0};
    for (i = 0; i < all->count; i++) instance[i] = put_shell(t, &all->shell[i]);
    for (i = 0; i < all->count; i++) {
        if (!is_closed(&all->shell[i])) list_add(&sheets, instance[i]);
        if (!is_closed(&all->shell[i]) || all->shell[i].around >= 0) continue;
        list_add(items, put_solid(t, instance, i));
        made.solids++;
    }
    made.sheets = sheets.count;
    if (sheets.count) list_add(items, put_list(t, "SHELL_BASED_SURFACE_MODEL('',(", &sheets, "))"));
    free(sheets.number);
    free(instance);
    return made;
}

/* ---- The file ---- */

/* Millimetres; what lies within a ten millionth of the size is one. */
static int put_context(step *t)
{
    char before[100];
    int length, angle, solid, uncertainty;
    n3_real size = surface_size(t->s);
    length = put_instance(t, "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    angle = put_instance(t, "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    solid = put_instance(t, "(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    snprintf(before, sizeof before, "#%d=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(",
             uncertainty = ++t->last);
    put_text(t->o, before);
    put_real(t->o, size * (n3_real)1e-7);
    snprintf(before, sizeof before, "),#%d,'distance_accuracy_value','');\n", length);
    put_text(t->o, before);
    return put_instance(t,
                        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#"
                        "%d))GLOBAL_UNIT_ASSIGNED_CONTEXT((#%d,#%d,#%d))REPRESENTATION_CONTEXT('','"
                        "'))",
                        uncertainty, length, angle, solid);
}

/* The representation, by what is in it; the axes come first. */
static int put_representation(step *t, const list *items, bodies made)
{
    char behind[20];
    int context = put_context(t);
    snprintf(behind, sizeof behind, "),#%d)", context);
    if (!made.sheets) return put_list(t, "ADVANCED_BREP_SHAPE_REPRESENTATION('',(", items, behind);
    if (!made.solids)
        return put_list(t, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(", items, behind);
    return put_list(t, "SHAPE_REPRESENTATION('',(", items, behind);
}

static int put_axes(step *t)
{
    int origin = put_point(t, n3_v(0, 0, 0)), z = put_instance(t, "DIRECTION('',(0.,0.,1.))");
    int x = put_instance(t, "DIRECTION('',(1.,0.,0.))");
    return put_instance(t, "AXIS2_PLACEMENT_3D('',#%d,#%d,#%d)", origin, z, x);
}

static void put_product(step *t, const char *name, int representation)
{
    int context, part, formation, definition, shape;
    context = put_instance(t, "APPLICATION_CONTEXT('automotive design')");
    put_instance(t,
                 "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000"
                 ",#%d)",
                 context);
    part = put_instance(t, "PRODUCT_CONTEXT('',#%d,'mechanical')", context);
    part = put_instance(t, "PRODUCT('%s','%s','',(#%d))", name, name, part);
    put_instance(t, "PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#%d))", part);
    formation = put_instance(t, "PRODUCT_DEFINITION_FORMATION('','',#%d)", part);
    definition =
        put_instance(t, "PRODUCT_DEFINITION_CONTEXT('part definition',#%d,'design')", context);
    definition = put_instance(t, "PRODUCT_DEFINITION('design','',#%d,#%d)", formation, definition);
    shape = put_instance(t, "PRODUCT_DEFINITION_SHAPE('','',#%d)", definition);
    put_instance(t, "SHAPE_DEFINITION_REPRESENTATION(#%d,#%d)", shape, representation);
}

/* The name of the file without folders; other than letters, digits and a few signs become "_". */
static void make_name(const char *path, char name[64])
{
    const char *sign = "-+.()_ ", *base = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    size_t i;
    for (i = 0; i < 63 && base[i]; i++)
        name[i] = isalnum((unsigned char)base[i]) || strchr(sign, base[i]) ? base[i] : '_';
    name[i] = 0;
}

bodies surface_write_step(output *o, const char *path, const surface *s)
{
    step t;
    list items = {0, NULL};
    bodies made;
    char name[64];
    if (EDGE_INSTANCES * (double)s->topology.edges + FACE_INSTANCES * (double)s->mesh.triangles +
            2.0 * s->nodes >
        INT_MAX - 1000)
        fail(path, 0, "too many triangles for STEP");
    memset(&t, 0, sizeof t);
    t.o = o;
    t.s = s;
    make_name(path, name);
    t.shells = shells_find(s);
    put_text(o, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('");
    put_text(o, name);
    put_text(o, "','',(''),(''),'','smooth','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n"
                "DATA;\n");
    list_add(&items, put_axes(&t));
    put_shape(&t);
    made = put_bodies(&t, &items);
    put_product(&t, name, put_representation(&t, &items, made));
    put_text(o, "ENDSEC;\nEND-ISO-10303-21;\n");
    free(items.number);
    shells_free(&t.shells);
    return made;
}
