/* STL: binary where the file has exactly the size that its count of triangles asks for, else
 * ASCII. The facets' normals are passed over; the triangles have better ones. */
#include "mesh_binary.h"

enum { HEADER = 84, FACET = 50, NORMAL = 12 }; /* bytes */

static const number_type count_type = {"uint32", 'u', 4}, coordinate = {"float32", 'f', 4};

/* A triangle with the next three points as its own. */
static void add_facet(mesh *m, const n3_vec x[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        m->point = room(m->point, m->points, sizeof *m->point);
        m->point[m->points++] = x[i];
    }
    mesh_add_triangle(m, m->points - 3, m->points - 2, m->points - 1);
    m->cells++;
}

static void read_binary(text *t, mesh *m)
{
    while (text_left(t) >= FACET) {
        n3_vec x[3];
        int i;
        skip_bytes(t, NORMAL);
        for (i = 0; i < 3; i++) {
            x[i].x = (n3_real)read_coordinate(t, &coordinate);
            x[i].y = (n3_real)read_coordinate(t, &coordinate);
            x[i].z = (n3_real)read_coordinate(t, &coordinate);
        }
        skip_bytes(t, 2);
        add_facet(m, x);
    }
}

static void read_facet(text *t, mesh *m)
{
    n3_vec x[3];
    int i;
    text_expect(t, "normal");
    text_next_line(t);
    text_expect(t, "outer");
    text_expect(t, "loop");
    for (i = 0; i < 3; i++) {
        text_expect(t, "vertex");
        x[i] = text_vec(t);
    }
    text_expect(t, "endloop");
    text_expect(t, "endfacet");
    add_facet(m, x);
}

static void read_ascii(text *t, mesh *m)
{
    token k;
    for (k = text_word(t); k.length; k = text_word(t)) {
        if (!token_is(k, "solid")) text_refuse(t, k, "where 'solid' should be");
        text_next_line(t);
        for (k = text_word(t); token_is(k, "facet"); k = text_word(t)) read_facet(t, m);
        if (!token_is(k, "endsolid")) text_refuse(t, k, "where 'facet' or 'endsolid' should be");
        text_next_line(t);
    }
}

/* The triangles that a binary file of this header has. */
static size_t get_count(text t)
{
    t.order = LITTLE;
    t.at = t.start + HEADER - 4;
    return (size_t)read_number(&t, &count_type);
}

/* Some binary files begin with "solid", as ASCII files do. */
int mesh_is_binary_stl(const char *data, size_t size)
{
    return size >= HEADER && (size - HEADER) % FACET == 0 &&
           (size - HEADER) / FACET == get_count(text_open("", data, size));
}

/* No other format has zero bytes and nothing to tell it by. */
int mesh_is_stl(const char *data, size_t size)
{
    text t = text_open("", data, size);
    return memchr(data, 0, size) || token_is(text_word(&t), "solid");
}

void mesh_read_stl(const char *path, const char *data, size_t size, mesh *m)
{
    text t = text_open(path, data, size);
    if (mesh_is_binary_stl(data, size)) {
        t.order = LITTLE;
        t.at = data + HEADER;
        read_binary(&t, m);
    } else if (!memchr(data, 0, size)) {
        read_ascii(&t, m);
    } else {
        double count = size >= HEADER ? (double)get_count(t) : 0;
        fail(path, 0, "binary STL of %.0f triangles is %.0f bytes long, this file %.0f", count,
             HEADER + FACET * count, (double)size);
    }
}
