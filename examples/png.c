/* PNG, by the numbers of the specification's second edition. */
#include "png.h"

#include "deflate.h"
#include "mesh.h"

#include <stdlib.h>

enum { GREY = 0, RGB = 2, PALETTE = 3 }; /* colour types */
enum { FILTERS = 5, ENTRIES = 256, SLOTS = 4 * ENTRIES };

/* The picture as the file has it: rows of so many bytes a pixel. */
typedef struct image {
    int width, height, type, depth; /* bytes */
    unsigned char *row;
    unsigned char palette[3 * ENTRIES];
    int colours;
} image;

static void put_32(bytes *b, uint32_t value)
{
    int k;
    for (k = 24; k >= 0; k -= 8) bytes_add_byte(b, value >> k);
}

static uint32_t crc32(const unsigned char *data, size_t size)
{
    uint32_t crc = 0xffffffffu;
    size_t i;
    int k;
    for (i = 0; i < size; i++) {
        crc ^= data[i];
        for (k = 0; k < 8; k++) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return crc ^ 0xffffffffu;
}

static void put_chunk(bytes *b, const char *name, const unsigned char *data, size_t size)
{
    size_t start;
    put_32(b, (uint32_t)size);
    start = b->size;
    bytes_add(b, name, 4);
    bytes_add(b, data, size);
    put_32(b, crc32(b->data + start, size + 4));
}

/* ---- Colour types ---- */

static int is_grey(const unsigned char *rgb, size_t pixels)
{
    size_t i;
    for (i = 0; i < pixels; i++)
        if (rgb[3 * i] != rgb[3 * i + 1] || rgb[3 * i] != rgb[3 * i + 2]) return 0;
    return 1;
}

/* Where the colour is, or would be, in a table of slots that hold the number of a colour. */
static int colour_slot(const image *m, const int *slot, const unsigned char *c)
{
    int k = (c[0] * 7 + c[1] * 61 + c[2] * 211) % SLOTS;
    while (slot[k] >= 0 && memcmp(m->palette + 3 * slot[k], c, 3) != 0) k = (k + 1) % SLOTS;
    return k;
}

/* Pixels as numbers of colours, in the order in which these appear. False if there are too many. */
static int find_palette(image *m, const unsigned char *rgb, size_t pixels)
{
    int slot[SLOTS], k;
    size_t i;
    for (k = 0; k < SLOTS; k++) slot[k] = -1;
    for (i = 0; i < pixels; i++) {
        k = colour_slot(m, slot, rgb + 3 * i);
        if (slot[k] < 0) {
            if (m->colours == ENTRIES) return 0;
            memcpy(m->palette + 3 * m->colours, rgb + 3 * i, 3);
            slot[k] = m->colours++;
        }
        m->row[i] = (unsigned char)slot[k];
    }
    return 1;
}

static void image_make(image *m, int width, int height, const unsigned char *rgb)
{
    size_t pixels = (size_t)width * (size_t)height, i;
    memset(m, 0, sizeof *m);
    m->width = width;
    m->height = height;
    m->depth = 1;
    m->row = allocate(pixels, 3);
    if (is_grey(rgb, pixels)) {
        m->type = GREY;
        for (i = 0; i < pixels; i++) m->row[i] = rgb[3 * i];
    } else if (find_palette(m, rgb, pixels)) {
        m->type = PALETTE;
    } else {
        m->type = RGB;
        m->depth = 3;
        memcpy(m->row, rgb, 3 * pixels);
    }
}

/* ---- Filters ---- */

/* Whichever of left, above and corner is nearest to left + above - corner. */
static int paeth(int left, int above, int corner)
{
    int p = above - corner, q = left - corner, r = abs(p + q);
    p = abs(p);
    q = abs(q);
    return p <= q && p <= r ? left : q <= r ? above : corner;
}

static unsigned char filtered(const image *m, int filter, const unsigned char *row, int y, int x)
{
    int left = x < m->depth ? 0 : row[x - m->depth], width = m->width * m->depth;
    int above = y == 0 ? 0 : row[x - width];
    int corner = x < m->depth || y == 0 ? 0 : row[x - m->depth - width];
    int guess = 0;
    if (filter == 1) guess = left;
    if (filter == 2) guess = above;
    if (filter == 3) guess = (left + above) / 2;
    if (filter == 4) guess = paeth(left, above, corner);
    return (unsigned char)((row[x] - guess) & 255);
}

/* The filter whose bytes, taken as signed, are the smallest in sum. */
static int best_filter(const image *m, const unsigned char *row, int y)
{
    long best = -1;
    int filter, x, chosen = 0;
    for (filter = 0; filter < FILTERS; filter++) {
        long sum = 0;
        for (x = 0; x < m->width * m->depth; x++) {
            int b = filtered(m, filter, row, y, x);
            sum += b < 128 ? b : 256 - b;
        }
        if (best >= 0 && sum >= best) continue;
        best = sum;
        chosen = filter;
    }
    return chosen;
}

/* The rows, each behind the number of its filter; with filters or all as they are. */
static unsigned char *filter_rows(const image *m, int filters, size_t *size)
{
    size_t width = (size_t)m->width * (size_t)m->depth;
    unsigned char *out = allocate((size_t)m->height, width + 1), *to = out;
    int y, x;
    for (y = 0; y < m->height; y++) {
        const unsigned char *row = m->row + (size_t)y * width;
        int filter = filters ? best_filter(m, row, y) : 0;
        *to++ = (unsigned char)filter;
        for (x = 0; x < (int)width; x++) *to++ = filtered(m, filter, row, y, x);
    }
    *size = (size_t)(to - out);
    return out;
}

/* Filters help where colours change gradually and do harm where they repeat. */
static bytes compress_rows(const image *m)
{
    bytes out[2] = {{NULL, 0, 0}, {NULL, 0, 0}};
    int i, better;
    for (i = 0; i < 2; i++) {
        size_t size;
        unsigned char *row = filter_rows(m, i, &size);
        zlib_compress(&out[i], row, size);
        free(row);
    }
    better = out[1].size < out[0].size;
    free(out[!better].data);
    return out[better];
}

unsigned char *png_encode(int width, int height, const unsigned char *rgb, size_t *size)
{
    bytes out = {NULL, 0, 0}, head = {NULL, 0, 0}, rows;
    image m;
    image_make(&m, width, height, rgb);
    put_32(&head, (uint32_t)width);
    put_32(&head, (uint32_t)height);
    bytes_add_byte(&head, 8); /* bits of a sample */
    bytes_add_byte(&head, (unsigned)m.type);
    bytes_add(&head, "\0\0", 3); /* deflate, the five filters, no interlace */
    bytes_add(&out, "\x89PNG\r\n\x1a\n", 8);
    put_chunk(&out, "IHDR", head.data, head.size);
    if (m.type == PALETTE) put_chunk(&out, "PLTE", m.palette, 3 * (size_t)m.colours);
    rows = compress_rows(&m);
    put_chunk(&out, "IDAT", rows.data, rows.size);
    put_chunk(&out, "IEND", NULL, 0);
    free(head.data);
    free(rows.data);
    free(m.row);
    *size = out.size;
    return out.data;
}

void png_write(FILE *f, int width, int height, const unsigned char *rgb)
{
    size_t size;
    unsigned char *data = png_encode(width, height, rgb, &size);
    fwrite(data, 1, size, f);
    free(data);
}
