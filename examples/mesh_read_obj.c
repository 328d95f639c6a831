/* OBJ: the statements v, vn, f and s; all others, vt among them, are passed over.
 *
 * A smoothing group is a crease mark: an edge between faces of different groups, or of none, is
 * sharp. Exporters write a lone "s off" into every file, so that this counts only where some face
 * has a group. */
#include "mesh_text.h"

#include <stdlib.h>

typedef struct corner {
    int point, normal;
} corner;

typedef struct reader {
    text text;
    mesh *mesh;
    corner *polygon;
    int group;
} reader;

typedef struct statement {
    const char *word;
    void (*read)(reader *r);
} statement;

static void read_point(reader *r)
{
    mesh *m = r->mesh;
    m->point = room(m->point, m->points, sizeof *m->point);
    m->point[m->points++] = text_vec(&r->text);
    while (text_more(&r->text)) text_number(&r->text); /* a weight, a colour */
}

static void read_normal(reader *r)
{
    mesh *m = r->mesh;
    m->normal = room(m->normal, m->normals, sizeof *m->normal);
    m->normal[m->normals++] = text_vec(&r->text);
}

/* The index behind *at, which counts from 1, or from the end when negative. */
static int read_index(const reader *r, token k, const char **at, int count, const char *what)
{
    int i;
    if (!text_integer(at, k.at + k.length, &i)) text_refuse(&r->text, k, "is not a face's corner");
    if (i == 0 || i > count || i < -count)
        fail(r->text.file, r->text.line, "there is no %s %d, only %d so far", what, i, count);
    return i > 0 ? i - 1 : count + i;
}

/* v, v/t, v//n or v/t/n. */
static corner read_corner(reader *r)
{
    token k = text_token(&r->text);
    const char *at = k.at, *end = k.at + k.length;
    corner c;
    int unused;
    c.point = read_index(r, k, &at, r->mesh->points, "point");
    c.normal = -1;
    if (at < end && *at == '/') {
        at++;
        text_integer(&at, end, &unused);
        if (at < end && *at == '/' && ++at < end)
            c.normal = read_index(r, k, &at, r->mesh->normals, "normal");
    }
    if (at < end) text_refuse(&r->text, k, "is not a face's corner");
    return c;
}

/* How wide the polygon's corner i is, from 0 for a spike over 1 for a right angle and 2 for a
   straight one to 4; N looks to the polygon's front. */
static n3_real width(const mesh *m, const corner *c, int n, int i, n3_vec N)
{
    n3_vec x = m->point[c[i].point];
    n3_vec to = n3_unit(n3_sub(m->point[c[(i + 1) % n].point], x));
    n3_vec from = n3_unit(n3_sub(m->point[c[(i + n - 1) % n].point], x));
    n3_real cosine = n3_dot(to, from);
    return n3_dot(n3_cross(to, from), N) >= 0 ? 1 - cosine : 3 + cosine;
}

/* The corner from which a fan splits the polygon: the widest, the first of equal ones. That is
   right for convex polygons and for those with one corner that looks inwards. */
static int fan_corner(const mesh *m, const corner *c, int n)
{
    const n3_real noise = (n3_real)1e-6; /* rounded corners of a square are equal to this */
    n3_vec N = n3_v(0, 0, 0), o = m->point[c[0].point];
    n3_real size = 0, best, w;
    int i, found = 0;
    for (i = 1; i < n; i++) size += n3_len(n3_sub(m->point[c[i].point], o));
    if (n == 3 || !(size > 0)) return 0;
    for (i = 1; i + 1 < n; i++)
        N = n3_add(N, n3_cross(n3_mul(1 / size, n3_sub(m->point[c[i].point], o)),
                               n3_mul(1 / size, n3_sub(m->point[c[i + 1].point], o))));
    best = width(m, c, n, 0, N);
    for (i = 1; i < n; i++)
        if ((w = width(m, c, n, i, N)) > best + noise) best = w, found = i;
    return found;
}

static void read_face(reader *r)
{
    mesh *m = r->mesh;
    int n = 0, first, i, j;
    while (text_more(&r->text)) {
        r->polygon = room(r->polygon, n, sizeof *r->polygon);
        r->polygon[n++] = read_corner(r);
    }
    if (n < 3) fail(r->text.file, r->text.line, "a face needs three corners, here are %d", n);
    m->polygons += n > 3;
    first = fan_corner(m, r->polygon, n);
    for (i = 1; i + 1 < n; i++) {
        corner c[3];
        c[0] = r->polygon[first];
        c[1] = r->polygon[(first + i) % n];
        c[2] = r->polygon[(first + i + 1) % n];
        mesh_add_triangle(m, c[0].point, c[1].point, c[2].point);
        for (j = 0; j < 3; j++) m->corner[3 * (m->triangles - 1) + j] = c[j].normal;
        m->group[m->triangles - 1] = r->group;
    }
    m->cells++;
    m->grouped |= r->group != 0;
}

static void read_group(reader *r)
{
    token k = text_token(&r->text);
    const char *at = k.at;
    if (token_is(k, "off")) {
        r->group = 0;
    } else if (token_is(k, "on")) {
        r->group = 1;
    } else if (!text_integer(&at, k.at + k.length, &r->group) || at != k.at + k.length) {
        text_refuse(&r->text, k, "is not a smoothing group");
    }
}

void mesh_read_obj(const char *path, char *data, size_t size, mesh *m)
{
    static const statement statements[] = {
        {"v", read_point}, {"vn", read_normal}, {"f", read_face}, {"s", read_group}};
    reader r = {{0}, NULL, NULL, 0};
    size_t i;
    r.text = text_open(path, data, size);
    r.mesh = m;
    do {
        token k = text_token(&r.text);
        for (i = 0; i < sizeof statements / sizeof *statements; i++) {
            if (!token_is(k, statements[i].word)) continue;
            statements[i].read(&r);
            if (text_more(&r.text)) text_refuse(&r.text, text_token(&r.text), "is one too many");
            break;
        }
    } while (text_next_line(&r.text));
    free(r.polygon);
}
