#include "mesh_text.h"

#include <ctype.h>
#include <limits.h>
#include <stdlib.h>

enum { SHOWN = 40 }; /* characters of a token in a message */

/* Beyond this, squares of lengths overflow. */
static const double largest = 1e150;

text text_open(const char *file, char *data, size_t size)
{
    text t;
    size_t i, n = 0;
    for (i = 0; i < size; i++) {
        if (data[i] == '\r' && data[i + 1] == '\n') continue;
        data[n++] = data[i] == '\r' ? '\n' : data[i];
    }
    data[n] = 0;
    t.file = file;
    t.at = n >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? data + 3 : data; /* byte order mark */
    t.end = data + n;
    t.line = 1;
    return t;
}

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

static int is_continued(const char *at) { return at[0] == '\\' && at[1] == '\n'; }

int text_more(text *t)
{
    for (;; t->at++) {
        if (is_continued(t->at))
            t->at++, t->line++;
        else if (!is_blank(*t->at))
            break;
    }
    return t->at < t->end && *t->at != '\n' && *t->at != '#';
}

token text_token(text *t)
{
    token k;
    int more = text_more(t);
    k.at = t->at;
    while (more && t->at < t->end && !is_blank(*t->at) && *t->at != '\n' && !is_continued(t->at))
        t->at++;
    k.length = (size_t)(t->at - k.at);
    return k;
}

/* A comment ends with its line even behind a backslash: drawings in comments have them. */
int text_next_line(text *t)
{
    while (text_more(t)) text_token(t);
    t->at = memchr(t->at, '\n', (size_t)(t->end - t->at));
    if (!t->at) {
        t->at = t->end;
        return 0;
    }
    t->at++, t->line++;
    return t->at < t->end;
}

int token_is(token k, const char *word)
{
    size_t i;
    for (i = 0; i < k.length; i++)
        if (tolower((unsigned char)k.at[i]) != word[i] || !word[i]) return 0;
    return !word[i];
}

void text_refuse(const text *t, token k, const char *reason)
{
    char shown[SHOWN + 4];
    size_t i, n = k.length < SHOWN ? k.length : SHOWN;
    for (i = 0; i < n; i++) shown[i] = isprint((unsigned char)k.at[i]) ? k.at[i] : '?';
    memcpy(shown + n, n < k.length ? "..." : "", n < k.length ? 4 : 1);
    if (k.length) fail(t->file, t->line, "'%s' %s", shown, reason);
    fail(t->file, t->line, "%s %s", t->at < t->end ? "the end of the line" : "the end of the file",
         reason);
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
    double x = 0;
    if (!k.length || number_end(k.at) != k.at + k.length)
        text_refuse(t, k, "is not a finite number");
    x = strtod(k.at, NULL);
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
