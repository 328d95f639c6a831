#include "mesh_text.h"
#include "mesh_number.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

enum { SHOWN = 40, REASON = 200 }; /* characters of a token, of a reason in a message */

/* Beyond this, squares of lengths overflow. */
static const double largest = 1e150;

text text_open(const char *file, const char *data, size_t size)
{
    text t;
    memset(&t, 0, sizeof t);
    t.file = file;
    t.start = t.token = data;
    t.at = size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? data + 3 : data;
    t.end = data + size;
    return t;
}

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

static int is_end(char c) { return c == '\n' || c == '\r'; }

/* Behind the line end at s; s itself if there is none. */
static const char *line_end(const char *s)
{
    return s[0] == '\r' && s[1] == '\n' ? s + 2 : s + is_end(*s);
}

static int is_continued(const text *t) { return !t->plain && t->at[0] == '\\' && is_end(t->at[1]); }

static long line_number(const text *t)
{
    const char *s = t->start, *next;
    long line = 1;
    for (; s<t->token; s = next> s ? next : s + 1) {
        next = line_end(s);
        line += next > s;
    }
    return line;
}

void text_fail(const text *t, const char *format, ...)
{
    char reason[REASON];
    size_t byte = (size_t)(t->token - t->start);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(reason, sizeof reason, format, arguments);
    va_end(arguments);
    if (!t->order) fail(t->file, line_number(t), "%s", reason);
    if (t->base64) byte = byte / 3 * 4;
    fail(t->file, 0, "byte %lu: %s", (unsigned long)(t->offset + byte), reason);
}

void text_refuse(const text *t, token k, const char *reason)
{
    char shown[SHOWN + 4];
    size_t i, n = k.length < SHOWN ? k.length : SHOWN;
    for (i = 0; i < n; i++) shown[i] = isprint((unsigned char)k.at[i]) ? k.at[i] : '?';
    memcpy(shown + n, n < k.length ? "..." : "", n < k.length ? 4 : 1);
    if (k.length) text_fail(t, "'%s' %s", shown, reason);
    text_fail(t, "the end of the %s %s", t->at < t->end ? "line" : "file", reason);
}

int text_more(text *t)
{
    for (; t->at < t->end; t->at++) {
        if (is_continued(t))
            t->at = line_end(t->at + 1) - 1;
        else if (!is_blank(*t->at))
            break;
    }
    return t->at < t->end && !is_end(*t->at) && (t->plain || *t->at != '#');
}

token text_token(text *t)
{
    token k;
    int more = text_more(t);
    k.at = t->token = t->at;
    while (more && t->at < t->end && !is_blank(*t->at) && !is_end(*t->at) && !is_continued(t))
        t->at++;
    k.length = (size_t)(t->at - k.at);
    return k;
}

token text_word(text *t)
{
    while (!text_more(t) && text_next_line(t)) continue;
    return text_token(t);
}

token text_line(text *t)
{
    token k;
    text_more(t);
    k.at = t->token = t->at;
    while (t->at < t->end && !is_end(*t->at)) t->at++;
    k.length = (size_t)(t->at - k.at);
    while (k.length && is_blank(k.at[k.length - 1])) k.length--;
    return k;
}

/* A comment ends with its line even behind a backslash: drawings in comments have them. */
int text_next_line(text *t)
{
    while (text_more(t)) text_token(t);
    while (t->at < t->end && !is_end(*t->at)) t->at++;
    if (t->at < t->end) t->at = line_end(t->at);
    return t->at < t->end;
}

int token_is(token k, const char *word)
{
    size_t i;
    for (i = 0; i < k.length; i++)
        if (tolower((unsigned char)k.at[i]) != word[i] || !word[i]) return 0;
    return !word[i];
}

void text_expect(text *t, const char *word)
{
    token k = text_word(t);
    char reason[40];
    if (token_is(k, word)) return;
    snprintf(reason, sizeof reason, "where '%s' should be", word);
    text_refuse(t, k, reason);
}

static const char *skip_digits(const char *s)
{
    while (*s >= '0' && *s <= '9') s++;
    return s;
}

/* Where the decimal number at s ends; s itself if there is none. strtod alone would take "nan",
   "infinity" and "0x1p3" as well. */
static const char *number_end(const char *s)
{
    const char *digits = s + (*s == '+' || *s == '-'), *end = skip_digits(digits), *e;
    int any = end > digits;
    if (*end == '.') {
        e = skip_digits(end + 1);
        any = any || e > end + 1;
        end = e;
    }
    if (!any) return s;
    if (*end != 'e' && *end != 'E') return end;
    digits = end + 1 + (end[1] == '+' || end[1] == '-');
    e = skip_digits(digits);
    return e > digits ? e : end;
}

n3_real text_number(text *t)
{
    token k = text_token(t);
    const char *end;
    double x = 0;
    if (!k.length || number_end(k.at) != k.at + k.length)
        text_refuse(t, k, "is not a finite number");
    x = number_parse(k.at, &end);
    if (!(fabs(x) <= largest)) text_refuse(t, k, "is too large, beyond 1e150");
    return (n3_real)x;
}

n3_vec text_vec(text *t)
{
    n3_vec a;
    a.x = text_number(t);
    a.y = text_number(t);
    a.z = text_number(t);
    return a;
}

/* Without its sign, one of the words for what is no finite number. */
static int is_special(token k)
{
    int sign = k.length && (*k.at == '-' || *k.at == '+');
    k.at += sign, k.length -= (size_t)sign;
    return token_is(k, "nan") || token_is(k, "inf") || token_is(k, "infinity");
}

double text_value(text *t)
{
    token k = text_word(t);
    const char *end;
    if (is_special(k)) return strtod(k.at, NULL);
    if (!k.length || number_end(k.at) != k.at + k.length) text_refuse(t, k, "is not a number");
    return number_parse(k.at, &end);
}

double text_whole(text *t)
{
    token k = text_word(t);
    const char *digits = k.at + (k.length && (*k.at == '-' || *k.at == '+'));
    const char *end;
    if (skip_digits(digits) != k.at + k.length || digits == k.at + k.length)
        text_refuse(t, k, "is not a whole number");
    return number_parse(k.at, &end);
}

int text_count(text *t, int most)
{
    double x = text_whole(t);
    if (!(x >= 0 && x <= most)) text_fail(t, "%.17g is not from 0 to %d", x, most);
    return (int)x;
}

int text_integer(const char **at, const char *end, int *i)
{
    const char *s = *at;
    int negative = s < end && *s == '-', n = 0;
    if (s < end && (*s == '-' || *s == '+')) s++;
    if (s >= end || !isdigit((unsigned char)*s)) return 0;
    for (; s < end && isdigit((unsigned char)*s); s++)
        n = n > (INT_MAX - 9) / 10 ? INT_MAX : 10 * n + (*s - '0');
    *i = negative ? -n : n;
    *at = s;
    return 1;
}
