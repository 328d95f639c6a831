/* Lattices from files. */
#include "lattice.h"

#include "../mesh_text.h"

#include <math.h>
#include <stdlib.h>

enum { LARGEST = 10000 }; /* points along a curve */

/* Parameters beyond this are mistakes: tangents grow with their product. */
static const n3_real steepest = 1000;

typedef struct reader {
    text t;
    lattice *l;
    int points;           /* read so far */
    const char **rise[2]; /* where in the file a curve of a family got rise */
} reader;

static int points_of(const lattice *l, int family)
{
    return family ? l->view.rows : l->view.columns;
}

/* The i-th point of the family's curve j. */
static size_t index_of(const lattice *l, int family, int j, int i)
{
    return (size_t)(family ? i : j) * (size_t)l->view.columns + (size_t)(family ? j : i);
}

/* A number from 1 to most, less 1; or -1 for *, where that may stand. */
static int take_number(reader *r, const char *what, int most, int any)
{
    token k = text_token(&r->t);
    const char *at = k.at;
    int i = 0;
    if (any && token_is(k, "*")) return -1;
    if (!text_integer(&at, k.at + k.length, &i) || at != k.at + k.length)
        text_refuse(&r->t, k, "is not a number of a curve or a part");
    if (i < 1 || i > most) text_fail(&r->t, "%s %d is not from 1 to %d", what, i, most);
    return i - 1;
}

static void expect_end(reader *r)
{
    if (text_more(&r->t)) text_refuse(&r->t, text_token(&r->t), "is too much on this line");
}

static void read_size(reader *r)
{
    lattice *l = r->l;
    size_t points;
    int i, size[2];
    if (l->point) text_fail(&r->t, "there is a lattice already");
    for (i = 0; i < 2; i++) {
        token k = text_token(&r->t);
        const char *at = k.at;
        if (!text_integer(&at, k.at + k.length, &size[i]) || at != k.at + k.length)
            text_refuse(&r->t, k, "is not a number of points");
        if (size[i] < 2 || size[i] > LARGEST)
            text_fail(&r->t, "a lattice has from 2 to %d points along a curve, not %d", LARGEST,
                      size[i]);
    }
    l->view.columns = size[0];
    l->view.rows = size[1];
    points = (size_t)size[0] * (size_t)size[1];
    l->point = allocate(points, sizeof *l->point);
    l->view.point = l->point;
    for (i = 0; i < 2; i++) {
        l->shape[i] = allocate(points, sizeof *l->shape[i]);
        r->rise[i] = allocate((size_t)size[!i], sizeof *r->rise[i]);
    }
    l->view.u_shape = l->shape[0];
    l->view.v_shape = l->shape[1];
}

static void read_point(reader *r)
{
    if (r->points >= r->l->view.columns * r->l->view.rows)
        text_fail(&r->t, "a lattice of %d by %d has no more than %d points", r->l->view.columns,
                  r->l->view.rows, r->points);
    r->l->point[r->points++] = text_vec(&r->t);
}

/* The parameter of that name in a shape. */
static n3_real *parameter(brown_shape *p, token name)
{
    if (token_is(name, "tension")) return &p->tension;
    if (token_is(name, "bias")) return &p->bias;
    if (token_is(name, "continuity")) return &p->continuity;
    if (token_is(name, "t-continuity")) return &p->t_continuity;
    return token_is(name, "rise") ? &p->rise : NULL;
}

static void read_parameter(reader *r, int family)
{
    lattice *l = r->l;
    int i, j, points = points_of(l, family), curves = points_of(l, !family), given = 0;
    int curve = take_number(r, family ? "column" : "row", curves, 1);
    int first = curve < 0 ? 0 : curve, last = curve < 0 ? curves - 1 : curve;
    const char *place = r->t.token;
    token name = text_token(&r->t);
    brown_shape probe = {0, 0, 0, 0, 0};
    n3_real value = 0;
    if (!parameter(&probe, name))
        text_refuse(&r->t, name, "is none of tension, bias, continuity, t-continuity and rise");
    for (i = 0; i < points; i++) {
        if (i == 0 || given) value = text_number(&r->t);
        if (i == 0) given = text_more(&r->t);
        if (!(fabs(value) <= steepest)) text_fail(&r->t, "a parameter is from -1000 to 1000");
        for (j = first; j <= last; j++)
            *parameter(&l->shape[family][index_of(l, family, j, i)], name) = value;
    }
    for (j = first; j <= last && token_is(name, "rise"); j++) r->rise[family][j] = place;
}

/* Once there is one own curve, all parts are held; the others are made when all has been read. */
static void read_curve(reader *r)
{
    lattice *l = r->l;
    token k = text_token(&r->t);
    int family = token_is(k, "v"), curve, part, parts;
    n3_edge *e;
    if (!family && !token_is(k, "u")) text_refuse(&r->t, k, "is neither u nor v");
    parts = points_of(l, family) - 1;
    curve = take_number(r, family ? "column" : "row", points_of(l, !family), 0);
    part = take_number(r, "part", parts, 0);
    if (!l->curve[family])
        l->curve[family] =
            allocate((size_t)points_of(l, !family), (size_t)parts * sizeof *l->curve[family]);
    e = &l->curve[family][(size_t)curve * (size_t)parts + (size_t)part];
    e->p[1] = text_vec(&r->t);
    e->p[2] = text_vec(&r->t);
    e->p[0].x = 1; /* given, until the ends are filled in */
}

static void read_line(reader *r)
{
    token k = text_token(&r->t);
    int size = token_is(k, "lattice");
    if (!size && !r->l->point) text_refuse(&r->t, k, "where 'lattice' should be");
    if (size)
        read_size(r);
    else if (token_is(k, "point"))
        read_point(r);
    else if (token_is(k, "u") || token_is(k, "v"))
        read_parameter(r, token_is(k, "v"));
    else if (token_is(k, "curve"))
        read_curve(r);
    else
        text_refuse(&r->t, k, "is none of lattice, point, u, v and curve");
    expect_end(r);
}

static void finish_curves(lattice *l, int family)
{
    int i, j, parts = points_of(l, family) - 1;
    for (j = 0; l->curve[family] && j < points_of(l, !family); j++)
        for (i = 0; i < parts; i++) {
            n3_edge *e = &l->curve[family][(size_t)j * (size_t)parts + (size_t)i];
            int given = e->p[0].x > 0;
            if (!given) *e = brown_lattice_curve(&l->view, family, j, i);
            e->p[0] = l->point[index_of(l, family, j, i)];
            e->p[3] = l->point[index_of(l, family, j, i + 1)];
        }
}

/* What the lattice as a whole lacks; of the rise of a curve, on its line. */
static void check(reader *r)
{
    const lattice *l = r->l;
    int points = l->view.columns * l->view.rows, item = 0, family;
    brown_status status;
    if (!l->point) fail(r->t.file, 0, "there is no lattice in it");
    if (r->points < points)
        fail(r->t.file, 0, "it has %d points, not %d by %d", r->points, l->view.columns,
             l->view.rows);
    status = brown_lattice_check(&l->view, &item);
    if (status == BROWN_OK) return;
    for (family = 0; family < 2; family++) {
        const char *at = r->rise[family][family ? item % l->view.columns : item / l->view.columns];
        if (status != BROWN_BAD_RISE || !at) continue;
        r->t.token = at;
        text_fail(&r->t, "%s", brown_status_text(status));
    }
    fail(r->t.file, 0, "%s (point %d)", brown_status_text(status), item + 1);
}

void lattice_read(const char *path, lattice *l)
{
    reader r;
    size_t size;
    char *data = file_read(path, &size);
    int family, more = size > 0;
    memset(l, 0, sizeof *l);
    memset(&r, 0, sizeof r);
    r.l = l;
    for (r.t = text_open(path, data, size); more; more = text_next_line(&r.t))
        if (text_more(&r.t)) read_line(&r);
    check(&r);
    for (family = 0; family < 2; family++) {
        finish_curves(l, family);
        free(r.rise[family]);
    }
    l->view.u_curve = l->curve[0];
    l->view.v_curve = l->curve[1];
    free(data);
}

void lattice_free(lattice *l)
{
    int family;
    free(l->point);
    for (family = 0; family < 2; family++) {
        free(l->shape[family]);
        free(l->curve[family]);
    }
}
