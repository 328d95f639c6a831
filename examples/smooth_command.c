/* Words of the command line, for the programs that lay surfaces. */
#include "smooth_command.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

request request_plain(void)
{
    const request plain = {NULL, 0, FACETS, 0, 0, -1, 800, 600, VIEW_SHADED, {30, 20, 1, 'z'}, 0};
    return plain;
}

void misuse(const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "%s: ", program);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fprintf(stderr, "\n%s", usage);
    exit(2);
}

n3_real option_number(const char *option, const char *value, double lo, double hi)
{
    char *end;
    double x = strtod(value, &end);
    if (end == value || *end || !(x >= lo && x <= hi))
        misuse("%s takes a number from %g to %g, not '%s'", option, lo, hi, value);
    return (n3_real)x;
}

int option_whole(const char *option, const char *value, int lo, int hi)
{
    n3_real x = option_number(option, value, lo, hi);
    if (x > floor(x)) misuse("%s takes a whole number, not '%s'", option, value);
    return (int)x;
}

void print_and_exit(const char *text)
{
    fputs(text, stdout);
    exit(fflush(stdout) || ferror(stdout) ? EXIT_FAILURE : EXIT_SUCCESS);
}

void option_tolerance(request *r, const char *option, const char *value)
{
    const double most = 1e100;
    char *end;
    double x = strtod(value, &end);
    r->relative = *end == '%';
    if (end == value || end[r->relative] || !(x > 0 && x <= most))
        misuse("%s takes a length or a percentage above 0, not '%s'", option, value);
    r->tolerance = (n3_real)(r->relative ? x / 100 : x);
}

static void read_size(request *r, const char *option, const char *value)
{
    const long most = 16384;
    char *end;
    long width = strtol(value, &end, 10), height = *end == 'x' ? strtol(end + 1, &end, 10) : 0;
    if (*end || width < 16 || height < 16 || width > most || height > most)
        misuse("%s takes WIDTHxHEIGHT, each from 16 to %ld, not '%s'", option, most, value);
    r->width = (int)width;
    r->height = (int)height;
}

/* What a picture shows, and from where. False if it is none of that. */
static int read_look(request *r, const char *a, const char *value)
{
    static const char *const known[] = {"--view", "--size", "--turn", "--rise", "--zoom", "--up"};
    size_t i, n = sizeof known / sizeof *known;
    for (i = 0; i < n && strcmp(a, known[i]); i++) continue;
    if (i == n) return 0;
    if (!value) misuse("%s takes a value", a);
    r->drawn = 1;
    if (i == 0 && view_find(value) < 0) misuse("there is no view '%s'", value);
    if (i == 0) r->view = (view)view_find(value);
    if (i == 1) read_size(r, a, value);
    if (i == 2) r->camera.turn = (double)option_number(a, value, -360, 360);
    if (i == 3) r->camera.rise = (double)option_number(a, value, -90, 90);
    if (i == 4) r->camera.zoom = (double)option_number(a, value, 0.01, 100);
    if (i == 5 && (strlen(value) != 1 || !strchr("xyz", value[0])))
        misuse("%s takes x, y or z, not '%s'", a, value);
    if (i == 5) r->camera.up = value[0];
    return 1;
}

int request_switch(request *r, const char *a)
{
    if (!strcmp(a, "--bezier"))
        r->kind = BEZIER;
    else if (!strcmp(a, "--text") || !strcmp(a, "--binary"))
        r->text = a[2] == 't';
    else
        return 0;
    return 1;
}

int request_value(request *r, const char *a, const char *value)
{
    static const char *const known[] = {"-o", "-n", "--tol", "--order"};
    size_t i, n = sizeof known / sizeof *known;
    for (i = 0; i < n && strcmp(a, known[i]); i++) continue;
    if (i == n) return read_look(r, a, value);
    if (!value) misuse("%s takes a value", a);
    if (i == 0) r->path = value;
    if (i == 1) r->level = option_whole(a, value, 1, 1000);
    if (i == 2) option_tolerance(r, a, value);
    if (i == 3) r->kind = option_whole(a, value, 2, 3) == 2 ? QUADRATIC : CUBIC;
    return 1;
}

void request_check(const request *r, int squares)
{
    if ((r->level > 0) + (r->tolerance > 0) + (r->kind != FACETS) > 1)
        misuse("-n, --tol, --order and --bezier exclude each other");
    if (r->path && product_refuse(r)) misuse("'%s' %s", r->path, product_refuse(r));
    if (squares && (r->kind == BEZIER || (r->path && product_is_exact(r))))
        misuse("Brown's squares have no control points for --bezier, .step and .html");
    if (squares && (r->view == VIEW_NET || r->view == VIEW_ERROR))
        misuse("Brown's squares have no view net and no view error");
}
