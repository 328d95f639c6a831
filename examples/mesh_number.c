/* Most numbers of a file have up to 17 digits and an exponent near 0. They are x = m 2^e with an
 * integer m of 53 bits, and x 10^k = m 5^k 2^(e + k) with m 5^k below 2^116: integers of 128 bits
 * tell exactly how far a decimal number is from x, and whether x is the nearest to it. The rest is
 * left to printf and strtod. */
#include "mesh_number.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POWERS = 28, LAST = 17 }; /* LAST: as many digits are always enough */

/* The least m of a number that is not subnormal. */
static const uint64_t least = (uint64_t)1 << 52;

static const uint64_t five[POWERS] = {
    1u, 5u, 25u, 125u, 625u, 3125u, 15625u, 78125u, 390625u, 1953125u, 9765625u, 48828125u,
    244140625u, 1220703125u, 6103515625u, 30517578125u, 152587890625u, 762939453125u,
    3814697265625u, 19073486328125u, 95367431640625u, 476837158203125u, 2384185791015625u,
    11920928955078125u, 59604644775390625u, 298023223876953125u, 1490116119384765625u,
    7450580596923828125u};

typedef struct wide {
    uint64_t hi, lo;
} wide;

static wide multiply(uint64_t a, uint64_t b)
{
    const uint64_t mask = 0xffffffffu;
    uint64_t ah = a >> 32, al = a & mask, bh = b >> 32, bl = b & mask;
    uint64_t low = al * bl, one = ah * bl + (low >> 32), two = al * bh + (one & mask);
    wide p;
    p.lo = two << 32 | (low & mask);
    p.hi = ah * bh + (one >> 32) + (two >> 32);
    return p;
}

/* |x| = m 2^e with least <= m < 2 least. False if x is zero, subnormal or not finite. */
static int take_apart(double x, uint64_t *m, int *e)
{
    uint64_t bits;
    int exponent;
    memcpy(&bits, &x, sizeof bits);
    exponent = (int)(bits >> 52 & 2047);
    *m = (bits & (least - 1)) | least;
    *e = exponent - 1075;
    return exponent > 0 && exponent < 2047;
}

/* |x| 10^k as a whole number and a rest of so many parts in 2^shift, both exact, with 17 digits in
   the whole number. */
typedef struct scaled {
    uint64_t m, whole, rest;
    int k, shift;
} scaled;

static int scale(double x, scaled *y)
{
    const uint64_t lowest = (uint64_t)10000000000000000u;
    int e, tries;
    if (!take_apart(x, &y->m, &e)) return 0;
    y->k = LAST - 1 - (int)floor((e + 53) * 0.30103);
    for (tries = 0; tries < 3; tries++) {
        wide p;
        y->shift = -e - y->k;
        if (y->k < 1 || y->k >= POWERS || y->shift < 1 || y->shift > 63) return 0;
        p = multiply(y->m, five[y->k]);
        if (p.hi >> y->shift) return 0;
        y->whole = p.hi << (64 - y->shift) | p.lo >> y->shift;
        y->rest = p.lo & (((uint64_t)1 << y->shift) - 1);
        if (y->whole >= lowest && y->whole / 10 < lowest) return 1;
        y->k += y->whole < lowest ? 1 : -1;
    }
    return 0;
}

/* The number with its last digits dropped, as many as unit has zeros, rounded to nearest. True if
   it reads as x: it lies within half of x's last bit, 5^k / 2 parts in 2^shift, which no number of
   decimal digits meets exactly; half of that below a power of two. */
static int shorten(const scaled *y, uint64_t unit, uint64_t *digits)
{
    const uint64_t half = (uint64_t)1 << (y->shift - 1);
    uint64_t above = y->whole % unit, off, most;
    int odd, up;
    *digits = y->whole / unit;
    odd = *digits & 1;
    if (unit > 1)
        up = above > unit / 2 || (above == unit / 2 && (y->rest || odd));
    else
        up = y->rest > half || (y->rest == half && odd);
    *digits += (uint64_t)up;
    most = five[y->k] >> (up || y->m > least ? 1 : 2);
    off = up ? unit - above - (y->rest > 0) : above;
    if (off > most >> y->shift) return 0;
    off = (off << y->shift) + (up && y->rest ? ((uint64_t)1 << y->shift) - y->rest : y->rest);
    return off <= most;
}

/* Eight digits at a time: the division of 32 bits is the faster one. */
static char *put_digits(char *to, uint64_t n, int count)
{
    int i = count;
    while (i > 0) {
        uint32_t part = (uint32_t)(n % 100000000);
        int stop = i > 8 ? i - 8 : 0;
        for (n /= 100000000; i > stop; part /= 10) to[--i] = (char)('0' + part % 10);
    }
    return to + count;
}

static int count_digits(uint64_t n)
{
    int count = 1;
    while (n >= 10) n /= 10, count++;
    return count;
}

static char *put_exponent(char *to, int exponent)
{
    int size = abs(exponent);
    *to++ = 'e';
    *to++ = exponent < 0 ? '-' : '+';
    return put_digits(to, (uint64_t)size, size > 99 ? 3 : 2);
}

/* digits 10^-k as %.*g writes it with this precision. */
static char *put_decimal(char *to, uint64_t digits, int k, int precision)
{
    int count, exponent;
    while (digits % 10 == 0) digits /= 10, k--;
    count = count_digits(digits);
    exponent = count - 1 - k;
    if (exponent < -4 || exponent >= precision) {
        to = put_digits(to + 1, digits, count);
        to[-count - 1] = to[-count];
        to[-count] = '.';
        return put_exponent(count > 1 ? to : to - 1, exponent);
    }
    if (exponent < 0) {
        memcpy(to, "0.000", 5);
        return put_digits(to + 1 - exponent, digits, count);
    }
    if (k <= 0) {
        to = put_digits(to, digits, count);
        memset(to, '0', (size_t)-k);
        return to - k;
    }
    to = put_digits(to + 1, digits, count);
    memmove(to - count - 1, to - count, (size_t)(count - k));
    to[-k - 1] = '.';
    return to;
}

static int format_slowly(char *to, double x)
{
    int precision, n = 0;
    for (precision = 15; precision <= LAST; precision++) {
        double back;
        n = snprintf(to, NUMBER_SIZE, "%.*g", precision, x);
        back = strtod(to, NULL);
        if (back <= x && back >= x) break;
    }
    return n;
}

int number_format(char *to, double x)
{
    char *at = to;
    uint64_t unit = 100, digits;
    scaled y;
    int precision;
    if (x < 0) *at++ = '-';
    if (fabs(x) >= 1 && fabs(x) < 1e15 && !(floor(x) < x)) {
        at = put_decimal(at, (uint64_t)fabs(x), 0, LAST);
        *at = 0;
        return (int)(at - to);
    }
    if (!scale(x, &y)) return format_slowly(to, x);
    for (precision = 15; !shorten(&y, unit, &digits) && unit > 1; precision++) unit /= 10;
    at = put_decimal(at, digits, y.k - (LAST - precision), precision);
    *at = 0;
    return (int)(at - to);
}

/* A decimal number: digits 10^exponent; exact where it has at most 19 digits. */
typedef struct decimal {
    uint64_t digits;
    int exponent, exact;
} decimal;

static const char *read_digits(const char *s, decimal *d, int behind_point)
{
    const uint64_t limit = (uint64_t)1000000000000000000u;
    for (; *s >= '0' && *s <= '9'; s++) {
        if (d->digits >= limit) d->exact = 0;
        if (!d->exact) continue;
        d->digits = 10 * d->digits + (uint64_t)(*s - '0');
        d->exponent -= behind_point;
    }
    return s;
}

static const char *read_exponent(const char *s, decimal *d)
{
    int negative, n = 0;
    const char *at = s + 1;
    if (*s != 'e' && *s != 'E') return s;
    negative = *at == '-';
    if (*at == '-' || *at == '+') at++;
    if (*at < '0' || *at > '9') return s;
    for (; *at >= '0' && *at <= '9'; at++)
        if (n < 10000) n = 10 * n + (*at - '0');
    d->exponent += negative ? -n : n;
    return at;
}

/* a - b where it is not negative and fits 64 bits, else all ones. */
static uint64_t difference(wide a, wide b)
{
    uint64_t hi = a.hi - b.hi - (a.lo < b.lo);
    return hi ? (uint64_t)-1 : a.lo - b.lo;
}

/* digits 10^-k: the quotient is off by a bit or two; the m nearest to it is found from there. No
   number lies half-way between two, as 5^k is odd. False where something does not fit. */
static int divide(uint64_t digits, int k, double *x)
{
    uint64_t m;
    wide want;
    int e, shift, tries;
    double quotient = (double)digits / (double)five[k] / (double)((uint64_t)1 << k);
    if (!take_apart(quotient, &m, &e)) return 0;
    shift = -e - k;
    if (shift < 1 || shift > 63) return 0;
    want.hi = digits >> (64 - shift);
    want.lo = digits << shift;
    for (tries = 0; tries < 4 && m > least && m < 2 * least - 1; tries++) {
        wide got = multiply(m, five[k]);
        uint64_t above = difference(got, want), below = difference(want, got);
        *x = ldexp((double)m, e);
        if (above <= five[k] / 2 || below <= five[k] / 2) return 1;
        m += above < below ? (uint64_t)-1 : 1;
    }
    return 0;
}

double number_parse(const char *from, const char **end)
{
    const int negative = *from == '-';
    decimal d = {0, 0, 1};
    double x;
    *end = read_digits(from + (*from == '-' || *from == '+'), &d, 0);
    if (**end == '.') *end = read_digits(*end + 1, &d, 1);
    *end = read_exponent(*end, &d);
    if (d.exact && (d.digits == 0 || (d.exponent == 0 && d.digits < 2 * least)))
        x = (double)d.digits;
    else if (!d.exact || d.exponent >= 0 || -d.exponent >= POWERS ||
             !divide(d.digits, -d.exponent, &x))
        return strtod(from, NULL);
    return negative ? -x : x;
}
