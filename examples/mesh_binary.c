#include "mesh_binary.h"

#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

const number_type *type_find(const text *t, const number_type *list, token name)
{
    for (; list->name; list++)
        if (token_is(name, list->name)) return list;
    text_refuse(t, name, "is not a type of numbers");
    return NULL;
}

int type_is_byte(const number_type *type) { return type->kind == 'u' && type->bytes == 1; }

int type_values(const number_type *type, int components)
{
    if (type->kind == 'f') return VALUES;
    return type_is_byte(type) && (components == 3 || components == 4) ? COLOUR_BYTES : NUMBERS;
}

size_t text_left(const text *t) { return (size_t)(t->end - t->at); }

void skip_bytes(text *t, size_t bytes)
{
    t->token = t->at;
    if (bytes > text_left(t))
        text_fail(t, "%.0f bytes should follow, %.0f are left", (double)bytes,
                  (double)text_left(t));
    t->at += bytes;
}

/* Between two tokens is a blank. */
void check_left(const text *t, double rows, size_t bytes, size_t tokens)
{
    text here = *t;
    double need = rows * (double)bytes, left = (double)text_left(t);
    if (t->order == AS_TEXT) need = 2 * rows * (double)tokens - 1;
    here.token = t->at;
    if (need > left)
        text_fail(&here, "%.0f bytes at least should follow, %.0f are left", need, left);
}

/* Of the number that was just passed. */
static uint64_t get_bits(const text *t, int bytes)
{
    const unsigned char *b = (const unsigned char *)t->token;
    uint64_t bits = 0;
    int i;
    for (i = 0; i < bytes; i++) bits = bits << 8 | b[t->order == BIG ? i : bytes - 1 - i];
    return bits;
}

static double get_float(uint64_t bits, int bytes)
{
    uint32_t half = (uint32_t)bits;
    float single;
    double x;
    memcpy(&single, &half, sizeof single);
    memcpy(&x, &bits, sizeof x);
    return bytes == 4 ? (double)single : x;
}

double read_number(text *t, const number_type *type)
{
    uint64_t bits, sign = (uint64_t)1 << (8 * type->bytes - 1);
    if (t->order == AS_TEXT) return type->kind == 'f' ? text_value(t) : text_whole(t);
    skip_bytes(t, (size_t)type->bytes);
    bits = get_bits(t, type->bytes);
    if (type->kind == 'f') return get_float(bits, type->bytes);
    if (type->kind == 'u' || bits < sign) return (double)bits;
    return -(double)(2 * sign - bits);
}

int is_coordinate(double x) { return fabs(x) <= 1e150; }

double read_coordinate(text *t, const number_type *type)
{
    double x = t->order == AS_TEXT ? text_value(t) : read_number(t, type);
    if (!(fabs(x) <= DBL_MAX)) text_fail(t, "not a finite number");
    if (!is_coordinate(x)) text_fail(t, "%g is too large, beyond 1e150", x);
    return x;
}

int read_index(text *t, const number_type *type, int count, const char *thing)
{
    double x = read_number(t, type);
    if (!(x >= 0 && x < count && x <= floor(x)))
        text_fail(t, "there is no %s %.17g, only 0 to %d", thing, x, count - 1);
    return (int)x;
}

/* The first of eight bits is the highest. */
static void read_bits(text *t, double *x, size_t count)
{
    size_t i;
    for (i = 0; i < count; i++) {
        if (i % 8 == 0) skip_bytes(t, 1);
        x[i] = (double)((unsigned char)t->at[-1] >> (7 - i % 8) & 1);
    }
}

double *read_numbers(text *t, const number_type *type, double count)
{
    const int bits = type->kind == 'b' && t->order != AS_TEXT;
    double *x;
    size_t n, i;
    check_left(t, bits ? ceil(count / 8) : count, (size_t)type->bytes, 1);
    n = (size_t)count;
    x = allocate(n, sizeof *x);
    if (bits) {
        read_bits(t, x, n);
    } else {
        for (i = 0; i < n; i++) x[i] = read_number(t, type);
    }
    return x;
}

static int sextet(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *found = c ? strchr(digits, c) : NULL;
    return found ? (int)(found - digits) : -1;
}

/* A digit is six bits. What bits are held before a =, fewer than eight, fill up the last digit. */
size_t read_base64(const text *t, unsigned char *to, size_t size)
{
    const char *at = t->at;
    uint32_t bits = 0;
    size_t n = 0;
    int held = 0;
    for (; at < t->end && n < size; at++) {
        int x = sextet(*at);
        if (x >= 0) {
            bits = bits << 6 | (uint32_t)x;
            held += 6;
        } else if (*at == '=') {
            held = 0;
        } else if (!isspace((unsigned char)*at)) {
            break;
        }
        if (held >= 8) {
            held -= 8;
            to[n++] = (unsigned char)(bits >> held & 255);
        }
    }
    return n;
}

int is_exact(const double *value, size_t count)
{
    const double most = 9007199254740992; /* 2^53, which 2^53 + 1 is rounded to */
    size_t i;
    for (i = 0; i < count; i++)
        if (!(fabs(value[i]) < most)) return 0;
    return 1;
}
