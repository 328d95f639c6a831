#include "mesh_xml.h"

#include <ctype.h>

static int begins(const char *s, const char *end, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(end - s) >= n && memcmp(s, word, n) == 0;
}

/* Behind the next occurrence of the word. */
static void skip_to(text *t, const char *word)
{
    while (t->at < t->end && !begins(t->at, t->end, word)) t->at++;
    if (t->at == t->end) text_fail(t, "'%s' should follow", word);
    t->at += strlen(word);
}

static int is_space(char c) { return isspace((unsigned char)c) != 0; }

/* Of a tag or of an attribute, from *at on. */
static token take_name(const char **at, const char *end)
{
    token k;
    k.at = *at;
    while (*at < end && !is_space(**at) && !(**at && strchr("/>='\"", **at))) ++*at;
    k.length = (size_t)(*at - k.at);
    return k;
}

/* A value in quotes; *at stands on the first one. */
static token take_quoted(const char **at, const char *end)
{
    token k;
    const char *close = memchr(*at + 1, **at, (size_t)(end - *at - 1));
    k.at = *at + 1;
    k.length = (size_t)((close ? close : end) - k.at);
    *at = close ? close + 1 : end;
    return k;
}

/* Behind the tag, whose < is the place; a > in quotes does not end it. */
static void read_tag(text *t, tag *g)
{
    t->at++;
    g->end = t->at < t->end && *t->at == '/';
    t->at += g->end;
    g->name = take_name(&t->at, t->end);
    g->attributes.at = t->at;
    while (t->at < t->end && *t->at != '>') {
        if (*t->at == '"' || *t->at == '\'')
            take_quoted(&t->at, t->end);
        else
            t->at++;
    }
    if (t->at >= t->end) text_fail(t, "the tag has no end");
    g->empty = t->at[-1] == '/';
    g->attributes.length = (size_t)(t->at++ - g->attributes.at);
}

int xml_next(text *t, tag *g)
{
    const char *s;
    while ((s = memchr(t->at, '<', (size_t)(t->end - t->at))) != NULL) {
        t->at = t->token = s;
        if (begins(s, t->end, "<!--")) {
            skip_to(t, "-->");
        } else if (begins(s, t->end, "<?") || begins(s, t->end, "<!")) {
            skip_to(t, ">");
        } else {
            read_tag(t, g);
            return 1;
        }
    }
    return 0;
}

token xml_attribute(const tag *g, const char *name)
{
    const char *at = g->attributes.at, *end = at + g->attributes.length;
    token none = {"", 0}, word = none;
    while (at < end) {
        if (*at == '"' || *at == '\'') {
            token value = take_quoted(&at, end);
            if (word.length == strlen(name) && memcmp(word.at, name, word.length) == 0)
                return value;
            word = none;
        } else if (is_space(*at) || *at == '=' || *at == '/') {
            at++;
        } else {
            word = take_name(&at, end);
        }
    }
    return none;
}

char *xml_decode(token value)
{
    static const char *const entities[] = {"&lt;", "<",      "&gt;", ">",      "&amp;",
                                           "&",    "&quot;", "\"",   "&apos;", "'"};
    const char *at = value.at, *end = at + value.length;
    char *decoded = allocate(value.length + 1, 1), *to = decoded;
    size_t i;
    while (at < end) {
        for (i = 0; i < 10 && !begins(at, end, entities[i]); i += 2) continue;
        *to++ = i < 10 ? *entities[i + 1] : *at;
        at += i < 10 ? strlen(entities[i]) : 1;
    }
    return decoded;
}
