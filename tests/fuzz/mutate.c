#include "mutate.h"

#include <ctype.h>
#include <stdint.h>
#include <string.h>

typedef struct file {
    uint64_t state; /* of the random numbers */
    char *data;
    size_t size;
    const seed *list;
    int seeds;
} file;

/* From 0 to below. */
static size_t pick(file *f, size_t below)
{
    uint64_t z = f->state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return below ? (size_t)((z ^ z >> 31) % below) : 0;
}

/* Puts other bytes in the place of some, as far as there is room. */
static void replace(file *f, size_t at, size_t old, const char *with, size_t size)
{
    size_t tail = f->size - at - old;
    if (at + size + tail > MUTANT_MOST) return;
    memmove(f->data + at + size, f->data + at + old, tail);
    memmove(f->data + at, with, size);
    f->size = at + size + tail;
}

static void truncate_it(file *f) { f->size = pick(f, f->size + 1); }

static void flip_bit(file *f)
{
    size_t i = pick(f, f->size);
    if (f->size) f->data[i] = (char)(f->data[i] ^ 1 << pick(f, 8));
}

static void set_byte(file *f)
{
    static const char bytes[] = "\0\1\2\3\4\377\200\177<>\"'/=$&_#%\\-.0 9e\n\r";
    if (f->size) f->data[pick(f, f->size)] = bytes[pick(f, sizeof bytes - 1)];
}

static int is_digit(char c) { return isdigit((unsigned char)c) != 0; }

/* A number in digits, from some place on; of size 0 if there is none. */
static size_t find_number(file *f, size_t *size)
{
    size_t at = pick(f, f->size), end;
    while (at < f->size && !is_digit(f->data[at])) at++;
    for (end = at; end < f->size && is_digit(f->data[end]);) end++;
    *size = end - at;
    return at;
}

static void swap_numbers(file *f)
{
    char first[32];
    size_t n, m, i = find_number(f, &n), j = find_number(f, &m);
    if (!n || n > sizeof first || i + n > j) return;
    memcpy(first, f->data + i, n);
    replace(f, i, n, f->data + j, m);
    replace(f, j + m - n, m, first, n);
}

/* Wild counts, indices and values. */
static void set_number(file *f)
{
    static const char *const numbers[] = {"0",
                                          "1",
                                          "2",
                                          "3",
                                          "-1",
                                          "7",
                                          "255",
                                          "256",
                                          "65536",
                                          "1000000",
                                          "2147483647",
                                          "2147483648",
                                          "4294967295",
                                          "-2147483648",
                                          "9007199254740992",
                                          "18446744073709551615",
                                          "99999999999999999999999",
                                          "nan",
                                          "-inf",
                                          "1e308",
                                          "1e999",
                                          "1e-320",
                                          "0.5",
                                          "0x10",
                                          ""};
    size_t n, i = find_number(f, &n);
    const char *x = numbers[pick(f, sizeof numbers / sizeof *numbers)];
    if (n) replace(f, i, n, x, strlen(x));
}

static void set_bytes(file *f)
{
    static const char bytes[][9] = {"\377\377\377\377\377\377\377\377",
                                    "\377\377\377\177\377\377\377\177",
                                    "\177\377\377\377\177\377\377\377",
                                    "\200\0\0\0\0\0\0\200",
                                    "\0\0\300\177\0\0\370\177",
                                    "\177\300\0\0\177\370\0\0",
                                    "\0\0\200\177\0\0\360\177",
                                    "\0\0\0\0\0\0\0\0",
                                    "\0\0\1\0\0\0\0\0",
                                    "\0\0\0\1\0\0\0\1"};
    size_t size = (size_t)1 << pick(f, 4), at = pick(f, f->size);
    if (at + size <= f->size)
        memcpy(f->data + at, bytes[pick(f, sizeof bytes / sizeof *bytes)] + 8 - size, size);
}

static void delete_range(file *f)
{
    size_t at = pick(f, f->size), n = pick(f, 1 + pick(f, f->size - at));
    replace(f, at, n, "", 0);
}

static void repeat_range(file *f)
{
    size_t at = pick(f, f->size), n = pick(f, 1 + pick(f, f->size - at)), times = 1 + pick(f, 30);
    while (times--) replace(f, at, 0, f->data + at, n);
}

/* A part of another seed. */
static void splice(file *f)
{
    const seed *other = &f->list[pick(f, (size_t)f->seeds)];
    size_t from = pick(f, other->size), n = pick(f, other->size - from);
    size_t at = pick(f, f->size), old = pick(f, 2) ? pick(f, f->size - at) : 0;
    replace(f, at, old, other->data + from, n);
}

static void nest(file *f)
{
    static const char *const words[] = {"<Piece>",
                                        "<a b='",
                                        "<DataArray>",
                                        "<!--",
                                        "\n$Nodes\n",
                                        "((",
                                        "\nproperty list uchar uchar a",
                                        "\nelement a 9",
                                        " 1",
                                        "\n",
                                        "\nPOINTS 1 bit\n",
                                        "\nFIELD a 9\n",
                                        "\nMETADATA\n",
                                        "\\\n"};
    const char *word = words[pick(f, sizeof words / sizeof *words)];
    size_t at = pick(f, f->size), times = 1 + pick(f, 1 + pick(f, 3000));
    while (times--) replace(f, at, 0, word, strlen(word));
}

size_t mutate(unsigned long number, const seed *list, int seeds, char *data)
{
    static void (*const mutations[])(file * f) = {
        truncate_it,  flip_bit,   flip_bit,     set_byte,     set_byte,
        swap_numbers, set_number, set_number,   set_number,   set_bytes,
        set_bytes,    splice,     delete_range, repeat_range, nest};
    const seed *from = &list[number % (unsigned long)seeds];
    file f = {0, NULL, 0, NULL, 0};
    size_t times;
    f.state = number * 0x9e3779b97f4a7c15u;
    f.data = data;
    f.size = from->size;
    f.list = list;
    f.seeds = seeds;
    memcpy(data, from->data, from->size);
    for (times = 1 + pick(&f, 3); times; times--)
        mutations[pick(&f, sizeof mutations / sizeof *mutations)](&f);
    return f.size;
}
