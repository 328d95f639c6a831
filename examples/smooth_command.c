/* Words of the command line, for the programs that lay surfaces. */
#include "smooth_command.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

request request_plain(void)
{
    const request plain = {NULL, 0,   FACETS,      0,                0, -1,
                           800,  600, VIEW_SHADED, {30, 20, 1, 'z'}, 0};
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
