/* STL: binary where the file has exactly the size that its count of triangles asks for, else
 * ASCII. The facets' normals are passed over; the triangles have better ones. */
#include "mesh_text.h"

#include <limits.h>
#include <stdint.h>

enum { HEADER = 84, FACET = 50, CORNER = 12 }; /* bytes */

static uint32_t get_count(const char *s)
{
    const unsigned char *b = (const unsigned char *)s;
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

static n3_real get_float(const char *path, const char *data, size_t at)
{
    uint32_t bits = get_count(data + at);
    float x;
    memcpy(&x, &bits, sizeof x);
    if ((bits >> 23 & 255) == 255)
        fail(path, 0, "byte %lu: not a finite number", (unsigned long)at);
    return (n3_real)x;
}

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

static void read_binary(const char *path, const char *data, size_t count, mesh *m)
{
    size_t t, i;
    for (t = 0; t < count; t++) {
        n3_vec x[3];
        for (i = 0; i < 3; i++) {
            size_t at = HEADER + FACET * t + CORNER * (i + 1);
            x[i].x = get_float(path, data, at);
            x[i].y = get_float(path, data, at + 4);
            x[i].z = get_float(path, data, at + 8);
        }
        add_facet(m, x);
    }
}

/* The next token, on this line or a later one. */
static token next_token(text *t)
{
    while (!text_more(t) && text_next_line(t)) continue;
    return text_token(t);
}

static void expect(text *t, const char *word)
{
    token k = next_token(t);
    char reason[40];
    if (token_is(k, word)) return;
    snprintf(reason, sizeof reason, "where '%s' should be", word);
    text_refuse(t, k, reason);
}

static void read_facet(text *t, mesh *m)
{
    n3_vec x[3];
    int i;
    expect(t, "normal");
    text_next_line(t);
    expect(t, "outer");
    expect(t, "loop");
    for (i = 0; i < 3; i++) {
        expect(t, "vertex");
        x[i] = text_vec(t);
    }
    expect(t, "endloop");
    expect(t, "endfacet");
    add_facet(m, x);
}

static void read_ascii(const char *path, char *data, size_t size, mesh *m)
{
    text t = text_open(path, data, size);
    token k;
    for (k = next_token(&t); k.length; k = next_token(&t)) {
        if (!token_is(k, "solid")) text_refuse(&t, k, "where 'solid' should be");
        text_next_line(&t);
        for (k = next_token(&t); token_is(k, "facet"); k = next_token(&t)) read_facet(&t, m);
        if (!token_is(k, "endsolid")) text_refuse(&t, k, "where 'facet' or 'endsolid' should be");
        text_next_line(&t);
    }
}

/* ASCII files begin with "solid", and so do some binary ones; only these have a zero byte. */
static int is_text(const char *data, size_t size) { return !memchr(data, 0, size); }

void mesh_read_stl(const char *path, char *data, size_t size, mesh *m)
{
    size_t count = size >= HEADER ? get_count(data + HEADER - 4) : 0;
    if (size >= HEADER && (size - HEADER) % FACET == 0 && (size - HEADER) / FACET == count) {
        if (count > INT_MAX / 3) fail(path, 0, "too many triangles: %lu", (unsigned long)count);
        read_binary(path, data, count, m);
    } else if (is_text(data, size)) {
        read_ascii(path, data, size, m);
    } else {
        fail(path, 0, "binary STL of %lu triangles is %.0f bytes long, this file %lu",
             (unsigned long)count, HEADER + FACET * (double)count, (unsigned long)size);
    }
}
