/* deflate, by the numbers of RFC 1951. */
#include "deflate.h"

#include "mesh.h"

#include <stdlib.h>

enum { WINDOW = 1 << 15, HASHES = 1 << 15, SHORTEST = 3, LONGEST = 258 };
enum { CHAIN = 4096, ENOUGH = 258 }; /* candidates for a match; a length that ends the search */
enum { REMOTE = 4096 };    /* from here on three literals are shorter than a copy of three */
enum { TOKENS = 1 << 14 }; /* of a block */
enum { LITERALS = 286, DISTANCES = 30, LENGTHS = 19, END = 256 };
enum { DEEPEST = 15, DEEPEST_LENGTH = 7 }; /* bits of a code */

/* A literal byte where the distance is 0, else a copy. */
typedef struct token {
    uint16_t value, distance;
} token;

/* The lengths of codes, and the codes, their first bit lowest. */
typedef struct code {
    int size;
    unsigned char bits[LITERALS];
    uint16_t word[LITERALS];
} code;

typedef struct stream {
    bytes *out;
    uint32_t held; /* bits not yet written, the first one lowest */
    int bits;
} stream;

void bytes_add(bytes *b, const void *data, size_t size)
{
    if (size > b->room - b->size) {
        unsigned char *old = b->data;
        b->room = 2 * b->room + size + 1024;
        b->data = allocate(b->room, 1);
        if (old) memcpy(b->data, old, b->size);
        free(old);
    }
    if (size) memcpy(b->data + b->size, data, size);
    b->size += size;
}

void bytes_add_byte(bytes *b, unsigned value)
{
    unsigned char byte = (unsigned char)(value & 255);
    bytes_add(b, &byte, 1);
}

/* At most 16 bits. */
static void put_bits(stream *s, unsigned value, int bits)
{
    s->held |= (uint32_t)value << s->bits;
    for (s->bits += bits; s->bits >= 8; s->bits -= 8) {
        bytes_add_byte(s->out, s->held);
        s->held >>= 8;
    }
}

static void put_code(stream *s, const code *c, int symbol)
{
    put_bits(s, c->word[symbol], c->bits[symbol]);
}

/* ---- Huffman codes ---- */

/* Two trees with the smallest weights become one, until one is left; depth[i] is then how far the
   leaf i is from the root. Returns the largest. */
static int huffman_depths(const uint32_t *weight, int n, unsigned char *depth)
{
    uint32_t w[2 * LITERALS];
    int parent[2 * LITERALS], i, made = n, root = -1, deepest = 0;
    for (i = 0; i < n; i++) w[i] = weight[i];
    for (;;) {
        int low[2] = {-1, -1};
        for (i = 0; i < made; i++) {
            if (!w[i]) continue;
            if (low[0] < 0 || w[i] < w[low[0]])
                low[1] = low[0], low[0] = i;
            else if (low[1] < 0 || w[i] < w[low[1]])
                low[1] = i;
        }
        root = low[0];
        if (low[1] < 0) break;
        w[made] = w[low[0]] + w[low[1]];
        parent[low[0]] = parent[low[1]] = made++;
        w[low[0]] = w[low[1]] = 0;
    }
    for (i = 0; i < n; i++) {
        int k = i, d = 0;
        if (weight[i])
            for (; k != root; k = parent[k]) d++;
        depth[i] = (unsigned char)d;
        if (d > deepest) deepest = d;
    }
    return deepest;
}

/* Codes of the same length count upwards (RFC 1951, 3.2.2). */
static void assign_words(code *c)
{
    unsigned next = 0;
    int bits, i, k;
    for (bits = 1; bits <= DEEPEST; bits++, next <<= 1)
        for (i = 0; i < c->size; i++) {
            unsigned word = 0;
            if (c->bits[i] != bits) continue;
            for (k = 0; k < bits; k++) word |= (next >> k & 1) << (bits - 1 - k);
            c->word[i] = (uint16_t)word;
            next++;
        }
}

/* Weights are halved until no code is longer than the limit. A lone symbol gets one bit. */
static void code_make(code *c, const uint32_t *count, int n, int limit)
{
    uint32_t weight[LITERALS];
    int i;
    memset(c, 0, sizeof *c);
    c->size = n;
    for (i = 0; i < n; i++) weight[i] = count[i];
    while (huffman_depths(weight, n, c->bits) > limit)
        for (i = 0; i < n; i++) weight[i] -= weight[i] / 2;
    for (i = 0; i < n; i++)
        if (count[i] && !c->bits[i]) c->bits[i] = 1;
    assign_words(c);
}

/* ---- Blocks ---- */

/* A length or a distance as its symbol, the bits that follow it and their number: symbols come in
   runs of per, of which each has one bit more than the one before. */
static int split(int value, int per, int *extra, int *bits)
{
    int symbol = 0;
    *bits = 0;
    for (*extra = value; *extra >= 1 << *bits; symbol++) {
        *extra -= 1 << *bits;
        if (symbol >= 2 * per - 1 && (symbol + 1) % per == 0) ++*bits;
    }
    return symbol;
}

static int length_symbol(int length, int *extra, int *bits)
{
    int symbol = split(length - SHORTEST, 4, extra, bits);
    if (length < LONGEST) return 257 + symbol;
    *extra = *bits = 0;
    return 285;
}

static int distance_symbol(int distance, int *extra, int *bits)
{
    return split(distance - 1, 2, extra, bits);
}

/* Runs of equal lengths as (symbol, extra bits): 16 repeats the last 3 to 6 times, 17 and 18 stand
   for 3 to 10 and 11 to 138 zeros. */
static int run_lengths(const unsigned char *length, int n, unsigned char (*run)[2])
{
    int i, made = 0, zeros, most;
    for (i = 0; i < n; made++) {
        int count = 1, value = length[i], before = i > 0 ? length[i - 1] : -1;
        while (i + count < n && length[i + count] == value) count++;
        zeros = value == 0;
        most = zeros ? 138 : 6;
        if (count > most) count = most;
        run[made][0] = (unsigned char)value;
        run[made][1] = 0;
        if (count < 3 || (!zeros && value != before)) {
            i++;
            continue;
        }
        run[made][0] = (unsigned char)(!zeros ? 16 : count > 10 ? 18 : 17);
        run[made][1] = (unsigned char)(count - (count > 10 ? 11 : 3));
        i += count;
    }
    return made;
}

static void put_codes(stream *s, const code *literal, const code *distance)
{
    static const int order[LENGTHS] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                       11, 4,  12, 3, 13, 2, 14, 1, 15};
    unsigned char length[LITERALS + DISTANCES], run[LITERALS + DISTANCES][2];
    uint32_t count[LENGTHS] = {0};
    int i, runs, used = LENGTHS, literals = LITERALS, distances = DISTANCES;
    code c;
    while (!literal->bits[literals - 1]) literals--;
    while (distances > 1 && !distance->bits[distances - 1]) distances--;
    memcpy(length, literal->bits, (size_t)literals);
    memcpy(length + literals, distance->bits, (size_t)distances);
    runs = run_lengths(length, literals + distances, run);
    for (i = 0; i < runs; i++) count[run[i][0]]++;
    code_make(&c, count, LENGTHS, DEEPEST_LENGTH);
    while (!c.bits[order[used - 1]]) used--;
    put_bits(s, (unsigned)(literals - 257), 5);
    put_bits(s, (unsigned)(distances - 1), 5);
    put_bits(s, (unsigned)(used - 4), 4);
    for (i = 0; i < used; i++) put_bits(s, c.bits[order[i]], 3);
    for (i = 0; i < runs; i++) {
        put_code(s, &c, run[i][0]);
        if (run[i][0] >= 16) put_bits(s, run[i][1], run[i][0] == 16 ? 2 : run[i][0] == 17 ? 3 : 7);
    }
}

static void put_tokens(stream *s, const token *t, int n, const code *literal, const code *distance)
{
    int i, extra, bits;
    for (i = 0; i < n; i++) {
        if (!t[i].distance) {
            put_code(s, literal, t[i].value);
            continue;
        }
        put_code(s, literal, length_symbol(t[i].value, &extra, &bits));
        put_bits(s, (unsigned)extra, bits);
        put_code(s, distance, distance_symbol(t[i].distance, &extra, &bits));
        put_bits(s, (unsigned)extra, bits);
    }
    put_code(s, literal, END);
}

static void put_block(stream *s, const token *t, int n, int last)
{
    uint32_t literals[LITERALS] = {0}, distances[DISTANCES] = {0};
    code literal, distance;
    int i, extra, bits;
    literals[END] = 1;
    for (i = 0; i < n; i++) {
        literals[t[i].distance ? length_symbol(t[i].value, &extra, &bits) : t[i].value]++;
        if (t[i].distance) distances[distance_symbol(t[i].distance, &extra, &bits)]++;
    }
    code_make(&literal, literals, LITERALS, DEEPEST);
    code_make(&distance, distances, DISTANCES, DEEPEST);
    put_bits(s, (unsigned)last, 1);
    put_bits(s, 2, 2); /* codes of its own */
    put_codes(s, &literal, &distance);
    put_tokens(s, t, n, &literal, &distance);
}

/* ---- Matches ---- */

/* The places with the same hash, from the last one on: before[i % WINDOW] is the one before i. */
typedef struct finder {
    const unsigned char *data;
    size_t size;
    size_t *last, *before; /* of a hash; of a place; (size_t)-1: none */
} finder;

static unsigned hash(const unsigned char *p)
{
    uint32_t three = p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16;
    return three * 2654435761u >> 17;
}

static void remember(finder *f, size_t at)
{
    unsigned h;
    if (at + SHORTEST > f->size) return;
    h = hash(f->data + at);
    f->before[at % WINDOW] = f->last[h];
    f->last[h] = at;
}

/* The longest copy of what stands at a place, from the nearest place that has it. */
static token find(const finder *f, size_t at)
{
    size_t from, left = f->size - at, most = left < LONGEST ? left : LONGEST, best = SHORTEST - 1;
    token t;
    int tries;
    t.value = f->data[at];
    t.distance = 0;
    if (left < SHORTEST) return t;
    from = f->last[hash(f->data + at)];
    for (tries = CHAIN; tries > 0 && from != (size_t)-1 && at - from <= WINDOW - 1; tries--) {
        const unsigned char *a = f->data + at, *b = f->data + from;
        size_t n = 0;
        if (b[best] == a[best])
            while (n < most && a[n] == b[n]) n++;
        if (n > best) {
            best = n;
            t.value = (uint16_t)n;
            t.distance = (uint16_t)(at - from);
            if (n >= ENOUGH || n == most) break;
        }
        from = f->before[from % WINDOW];
    }
    if (t.distance > REMOTE && t.value == SHORTEST) t.distance = 0;
    if (!t.distance) t.value = f->data[at];
    return t;
}

/* A match waits for the next place, which may have a longer one. */
static void compress(stream *s, finder *f, token *block)
{
    size_t at = 0, k;
    int n = 0, known = 0;
    token here, next = {0, 0};
    while (at < f->size) {
        here = known ? next : find(f, at);
        known = 0;
        remember(f, at);
        if (here.distance && here.value < ENOUGH && at + 1 < f->size) {
            next = find(f, at + 1);
            known = next.distance && next.value > here.value;
            if (known) here.distance = 0;
            if (known) here.value = f->data[at];
        }
        if (n == TOKENS) put_block(s, block, n, 0);
        if (n == TOKENS) n = 0;
        block[n++] = here;
        for (k = 1; here.distance && k < here.value; k++) remember(f, at + k);
        at += here.distance ? here.value : 1u;
    }
    put_block(s, block, n, 1);
}

static uint32_t adler32(const unsigned char *data, size_t size)
{
    uint32_t a = 1, b = 0;
    size_t i;
    for (i = 0; i < size; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void zlib_compress(bytes *out, const unsigned char *data, size_t size)
{
    stream s = {NULL, 0, 0};
    finder f;
    token *block = allocate(TOKENS, sizeof *block);
    uint32_t sum = adler32(data, size);
    size_t i;
    int k;
    s.out = out;
    f.data = data;
    f.size = size;
    f.last = allocate(HASHES, sizeof *f.last);
    f.before = allocate(WINDOW, sizeof *f.before);
    for (i = 0; i < HASHES; i++) f.last[i] = (size_t)-1;
    bytes_add_byte(out, 0x78); /* deflate with a window of 32 KiB */
    bytes_add_byte(out, 0xda);
    compress(&s, &f, block);
    put_bits(&s, 0, (8 - s.bits) % 8);
    for (k = 24; k >= 0; k -= 8) bytes_add_byte(out, sum >> k);
    free(block);
    free(f.last);
    free(f.before);
}
