/* OBJ: the statements v, vn, f and s; all others, vt among them, are passed over.
 *
 * A smoothing group is a crease mark: an edge between faces of different groups, or of none, is
 * sharp. Exporters write a lone "s off" into every file, so that this counts only where some face
 * has a group. */
#include "mesh_text.h"

#include <stdlib.h>

typedef struct reader {
    text text;
    mesh *mesh;
    int *point, *normal; /* of a face's corners */
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
        text_fail(&r->text, "there is no %s %d, only %d so far", what, i, count);
    return i > 0 ? i - 1 : count + i;
}

/* v, v/t, v//n or v/t/n. */
static void read_corner(reader *r, int i)
{
    token k = text_token(&r->text);
    const char *at = k.at, *end = k.at + k.length;
    int unused;
    r->point[i] = read_index(r, k, &at, r->mesh->points, "point");
    r->normal[i] = -1;
    if (at < end && *at == '/') {
        at++;
        text_integer(&at, end, &unused);
        if (at < end && *at == '/' && ++at < end)
            r->normal[i] = read_index(r, k, &at, r->mesh->normals, "normal");
    }
    if (at < end) text_refuse(&r->text, k, "is not a face's corner");
}

static void read_face(reader *r)
{
    mesh *m = r->mesh;
    const int before = m->triangles;
    int n = 0, i;
    while (text_more(&r->text)) {
        r->point = room(r->point, n, sizeof *r->point);
        r->normal = room(r->normal, n, sizeof *r->normal);
        read_corner(r, n++);
    }
    if (n < 3) text_fail(&r->text, "a face needs three corners, here are %d", n);
    mesh_add_polygon(m, n, r->point, r->normal);
    for (i = before; i < m->triangles; i++) m->group[i] = r->group;
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

void mesh_read_obj(const char *path, const char *data, size_t size, mesh *m)
{
    static const statement statements[] = {
        {"v", read_point}, {"vn", read_normal}, {"f", read_face}, {"s", read_group}};
    reader r = {{0}, NULL, NULL, NULL, 0};
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
    free(r.point);
    free(r.normal);
}
