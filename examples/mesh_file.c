/* Whole files in; memory; the end of the program. */
#include "mesh.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>

void fail(const char *file, long line, const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "%s: %s:", program, file);
    if (line > 0) fprintf(stderr, "%ld:", line);
    fputc(' ', stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(EXIT_FAILURE);
}

static void out_of_memory(void)
{
    fprintf(stderr, "%s: out of memory\n", program);
    exit(EXIT_FAILURE);
}

void *allocate(size_t count, size_t size)
{
    void *p = calloc(count ? count : 1, size);
    if (!p) out_of_memory();
    return p;
}

void *room(void *array, int count, size_t size)
{
    size_t n = (size_t)count;
    if (n & (n - 1)) return array;
    if (n > (size_t)-1 / 2 / size || count > INT_MAX / 6) out_of_memory();
    array = realloc(array, (n ? 2 * n : 1) * size);
    if (!array) out_of_memory();
    return array;
}

char *file_read(const char *path, size_t *size)
{
    size_t space = 1 << 16, used = 0, got;
    char *data = malloc(space + 1);
    FILE *f = fopen(path, "rb");
    if (!f) fail(path, 0, "%s", strerror(errno));
    while (data && (got = fread(data + used, 1, space - used, f)) > 0) {
        used += got;
        if (used == space) data = space < (size_t)-1 / 4 ? realloc(data, (space *= 2) + 1) : NULL;
    }
    if (!data) out_of_memory();
    if (ferror(f)) fail(path, 0, "%s", strerror(errno));
    fclose(f);
    data[used] = 0;
    *size = used;
    return data;
}

int has_extension(const char *path, const char *extension)
{
    size_t n = strlen(path), k = strlen(extension), i;
    if (n <= k) return 0;
    for (i = 0; i < k; i++)
        if (tolower((unsigned char)path[n - k + i]) != extension[i]) return 0;
    return 1;
}
