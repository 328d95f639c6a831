#include "inflate.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 320 }; /* symbols */

typedef struct reader {
    const unsigned char *from;
    size_t size, bit;
    unsigned char *to;
    size_t made, room;
    int bad;
} reader;

/* How many codes there are of each length, and the symbols in the order of their codes. */
typedef struct tree {
    int count[16], symbol[MOST];
} tree;

static int bits(reader *r, int n)
{
    int i, value = 0;
    for (i = 0; i < n; i++, r->bit++) {
        if (r->bit / 8 >= r->size) r->bad = 1;
        if (r->bad) return 0;
        value |= (r->from[r->bit / 8] >> r->bit % 8 & 1) << i;
    }
    return value;
}

static void put(reader *r, int byte)
{
    if (r->made == r->room) {
        r->room = 2 * r->room + 4096;
        r->to = realloc(r->to, r->room);
        if (!r->to) exit(EXIT_FAILURE);
    }
    r->to[r->made++] = (unsigned char)byte;
}

static void tree_make(tree *t, const int *length, int n)
{
    int l, i, k = 0;
    memset(t, 0, sizeof *t);
    for (l = 1; l < 16; l++)
        for (i = 0; i < n; i++)
            if (length[i] == l) t->count[l]++, t->symbol[k++] = i;
}

static int decode(reader *r, const tree *t)
{
    int l, code = 0, first = 0, index = 0;
    for (l = 1; l < 16; l++) {
        code |= bits(r, 1);
        if (code - first < t->count[l]) return t->symbol[index + code - first];
        index += t->count[l];
        first = (first + t->count[l]) << 1;
        code <<= 1;
    }
    r->bad = 1;
    return 0;
}

static void read_trees(reader *r, tree *literal, tree *distance)
{
    static const int order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    int length[MOST] = {0}, literals = bits(r, 5) + 257, distances = bits(r, 5) + 1, i;
    int used = bits(r, 4) + 4, n = 0;
    for (i = 0; i < used; i++) length[order[i]] = bits(r, 3);
    tree_make(literal, length, 19);
    while (n < literals + distances && !r->bad) {
        int s = decode(r, literal), value = s == 16 && n ? length[n - 1] : 0, times = 1;
        if (s == 16) times = 3 + bits(r, 2);
        if (s == 17) times = 3 + bits(r, 3);
        if (s == 18) times = 11 + bits(r, 7);
        if ((s == 16 && !n) || n + times > literals + distances) r->bad = 1;
        for (; times > 0 && !r->bad; times--) length[n++] = s < 16 ? s : value;
    }
    if (!length[256] || literals > 286 || distances > 30) r->bad = 1;
    tree_make(literal, length, literals);
    tree_make(distance, length + literals, distances);
}

static void copy(reader *r, int symbol, const tree *distance)
{
    int extra = symbol < 265 || symbol == 285 ? 0 : (symbol - 261) / 4, length, d, i;
    length = symbol < 265 ? symbol - 254 : (((symbol - 257) % 4 + 4) << extra) + 3;
    if (symbol == 285) length = 258;
    length += bits(r, extra);
    symbol = decode(r, distance);
    extra = symbol < 4 ? 0 : symbol / 2 - 1;
    d = symbol < 4 ? symbol + 1 : ((symbol % 2 + 2) << extra) + 1;
    d += bits(r, extra);
    if ((size_t)d > r->made || d > 32768) r->bad = 1;
    for (i = 0; i < length && !r->bad; i++) put(r, r->to[r->made - (size_t)d]);
}

static void read_block(reader *r)
{
    tree literal, distance;
    if (bits(r, 2) != 2) r->bad = 1; /* no other kind is written */
    read_trees(r, &literal, &distance);
    while (!r->bad) {
        int symbol = decode(r, &literal);
        if (symbol == 256) break;
        if (symbol < 256)
            put(r, symbol);
        else
            copy(r, symbol, &distance);
    }
}

static uint32_t big_endian(const unsigned char *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

unsigned char *zlib_expand(const unsigned char *from, size_t size, size_t *out)
{
    reader r = {NULL, 0, 16, NULL, 0, 0, 0};
    uint32_t a = 1, b = 0;
    size_t i;
    int last = 0;
    if (size < 6 || from[0] != 0x78 || (from[0] * 256 + from[1]) % 31) return NULL;
    r.from = from;
    r.size = size - 4;
    while (!last && !r.bad) {
        last = bits(&r, 1);
        read_block(&r);
    }
    for (i = 0; i < r.made; i++) {
        a = (a + r.to[i]) % 65521;
        b = (b + a) % 65521;
    }
    if (r.bad || (r.bit + 7) / 8 != r.size || big_endian(from + r.size) != (b << 16 | a)) {
        free(r.to);
        return NULL;
    }
    *out = r.made;
    return r.to;
}

/* ---- PNG ---- */

static uint32_t crc(const unsigned char *p, size_t n)
{
    uint32_t c = ~(uint32_t)0;
    int k;
    for (; n > 0; n--, p++)
        for (c ^= *p, k = 0; k < 8; k++) c = c & 1 ? c >> 1 ^ 0xedb88320u : c >> 1;
    return ~c;
}

/* The data of the chunk at a place, which then is the next one's; NULL if it has another name. */
static const unsigned char *chunk(const unsigned char *file, size_t size, size_t *at,
                                  const char *name, size_t *length)
{
    const unsigned char *p = file + *at;
    if (size - *at < 12) return NULL;
    *length = big_endian(p);
    if (*length > size - *at - 12 || memcmp(p + 4, name, 4) != 0) return NULL;
    if (crc(p + 4, *length + 4) != big_endian(p + 8 + *length)) return NULL;
    *at += *length + 12;
    return p + 8;
}

static int nearest(int a, int b, int c)
{
    int pa = abs(b - c), pb = abs(a - c), pc = abs(a + b - 2 * c);
    if (pa <= pb && pa <= pc) return a;
    return pb <= pc ? b : c;
}

/* Takes the filters off the rows in place. False if one is none of the five. */
static int take_off(unsigned char *p, int width, int height, int depth)
{
    int x, y, stride = width + 1;
    for (y = 0; y < height; y++)
        for (x = 1; x <= width; x++) {
            unsigned char *q = p + (size_t)y * (size_t)stride + x;
            int a = x > depth ? q[-depth] : 0, b = y ? q[-stride] : 0;
            int c = x > depth && y ? q[-depth - stride] : 0, filter = q[-x];
            if (filter > 4) return 0;
            *q = (unsigned char)(*q + (filter == 1   ? a
                                       : filter == 2 ? b
                                       : filter == 3 ? (a + b) / 2
                                       : filter == 4 ? nearest(a, b, c)
                                                     : 0));
        }
    return 1;
}

unsigned char *png_decode(const unsigned char *file, size_t size, int *width, int *height)
{
    size_t at = 8, n, colours = 0, made, x, y;
    const unsigned char *head, *palette = NULL, *rows;
    unsigned char *data, *rgb;
    int depth, k;
    if (size < 8 || memcmp(file, "\x89PNG\r\n\x1a\n", 8) != 0) return NULL;
    head = chunk(file, size, &at, "IHDR", &n);
    if (!head || n != 13 || head[8] != 8 || head[10] || head[11] || head[12]) return NULL;
    *width = (int)big_endian(head);
    *height = (int)big_endian(head + 4);
    depth = head[9] == 2 ? 3 : 1;
    if (head[9] == 3) palette = chunk(file, size, &at, "PLTE", &colours);
    if (head[9] == 3 && (!palette || colours > 768 || colours % 3)) return NULL;
    rows = chunk(file, size, &at, "IDAT", &n);
    data = rows ? zlib_expand(rows, n, &made) : NULL;
    if (!data || made != (size_t)*height * ((size_t)(*width * depth) + 1)) return NULL;
    if (!chunk(file, size, &at, "IEND", &n) || at != size) return NULL;
    if (!take_off(data, *width * depth, *height, depth)) return NULL;
    rgb = malloc(3 * (size_t)*width * (size_t)*height);
    for (y = 0; rgb && y < (size_t)*height; y++)
        for (x = 0; x < (size_t)*width; x++)
            for (k = 0; k < 3; k++) {
                const unsigned char *p = data + y * (size_t)(*width * depth + 1) + 1;
                size_t i = (size_t)depth * x + (depth == 3 ? (size_t)k : 0);
                rgb[3 * (y * (size_t)*width + x) + (size_t)k] =
                    palette ? palette[3 * p[i] + k] : p[i];
            }
    free(data);
    return rgb;
}
