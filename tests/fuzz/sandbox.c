/* All is built with -Dfree=sandbox_free; memory comes from allocate() and room() alone, whose
 * source is here once more, on memory that is counted. */
#define _POSIX_C_SOURCE 200809L
#undef free
#include "sandbox.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

typedef struct block {
    void *p;
    size_t size;
} block;

const char program[] = "fuzz";

void sandbox_free(void *p);

static block *blocks;
static size_t block_count, block_space; /* blocks that are held */
static size_t live, peak, most;         /* bytes */
static jmp_buf back;
static const char *file_data, *fault;
static size_t file_size;
static outcome result;

static size_t find_block(const void *p)
{
    size_t i = block_count;
    while (i && blocks[i - 1].p != p) i--;
    return i;
}

static void add_block(void *p, size_t size)
{
    if (block_count == block_space) {
        block_space = 2 * block_space + 64;
        blocks = realloc(blocks, block_space * sizeof *blocks);
        if (!blocks) abort();
    }
    blocks[block_count].p = p;
    blocks[block_count++].size = size;
    live += size;
    if (live > peak) peak = live;
}

void sandbox_free(void *p)
{
    size_t i = find_block(p);
    free(p);
    if (!i) return;
    live -= blocks[i - 1].size;
    blocks[i - 1] = blocks[--block_count];
}

/* Memory beyond the promise is not had, so that nothing worse happens. */
static void *counted_calloc(size_t count, size_t size)
{
    void *p;
    if (size && count > (live < most ? most - live : 0) / size) {
        fault = "too much memory";
        return NULL;
    }
    p = calloc(count ? count : 1, size);
    if (p) add_block(p, count * size);
    return p;
}

static void *counted_malloc(size_t size) { return counted_calloc(1, size); }

/* The old block and the new one are there at once, as they may be. */
static void *counted_realloc(void *old, size_t size)
{
    void *p = counted_malloc(size);
    size_t i = find_block(old), n = i ? blocks[i - 1].size : 0;
    if (p && old) memcpy(p, old, n < size ? n : size);
    if (p) sandbox_free(old);
    return p;
}

static void come_back(int status)
{
    (void)status;
    longjmp(back, 1);
}

static FILE *open_memory(const char *path, const char *mode)
{
    (void)path;
    return fmemopen((void *)(size_t)file_data, file_size, mode);
}

#define malloc  counted_malloc
#define calloc  counted_calloc
#define realloc counted_realloc
#define free    sandbox_free
#define exit    come_back
#define fopen   open_memory
#define fail    file_fail
void file_fail(const char *file, long line, const char *format, ...);
#include "../../examples/mesh_file.c"
#undef malloc
#undef calloc
#undef realloc
#undef free
#undef exit
#undef fopen
#undef fail

void fail(const char *file, long line, const char *format, ...)
{
    int n = snprintf(result.message, sizeof result.message, "%s:%ld: ", file, line);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(result.message + n, sizeof result.message - (size_t)n, format, arguments);
    va_end(arguments);
    longjmp(back, 1);
}

static int are_in(const int *list, int n, int least, int below)
{
    int i;
    for (i = 0; i < n && list[i] >= least && list[i] < below; i++) continue;
    return i == n;
}

/* What the mesh promises. */
static const char *find_fault(const mesh *m)
{
    int i;
    for (i = 0; i < m->points; i++)
        if (!(n3_len(m->point[i]) < (n3_real)1e151)) return "a wild point";
    for (i = 0; i < m->normals; i++)
        if (!(n3_len(m->normal[i]) < (n3_real)1e151)) return "a wild normal";
    if (m->triangles < 1) return "no triangle";
    if (!are_in(m->triangle, 3 * m->triangles, 0, m->points)) return "a wild triangle";
    if (!are_in(m->corner, 3 * m->triangles, -1, m->normals)) return "a wild corner";
    if (!are_in(m->cell, m->triangles, 0, m->cells)) return "a wild cell";
    if (m->cells > m->triangles) return "a cell without triangles";
    return NULL;
}

static double sum_fields(const field *list, int fields, int rows)
{
    double sum = 0;
    int i, j;
    for (i = 0; i < fields; i++)
        for (j = 0; j < rows * list[i].components; j++)
            sum += list[i].value[j] + (double)strlen(list[i].name);
    return sum;
}

static void use(mesh *m)
{
    volatile double sum;
    fault = find_fault(m);
    if (fault) return;
    most = (size_t)-1;
    mesh_join(m, 0);
    sum = sum_fields(m->point_field, m->point_fields, m->points);
    sum += sum_fields(m->cell_field, m->cell_fields, m->cells);
    (void)sum;
    mesh_free(m);
    if (block_count) fault = "lost memory";
}

/* One line of what can be printed. */
static int is_message(const char *s)
{
    while (*s >= 32 && *s <= 126) s++;
    return !*s;
}

outcome sandbox_read(void (*read)(const char *path, const char *data, size_t size, mesh *m),
                     const char *data, size_t size, int boundary)
{
    static mesh m;
    char *copy = malloc(size + 1);
    if (!copy) abort();
    memcpy(copy, data, size);
    copy[size] = 0;
    file_data = data, file_size = size;
    live = peak = 0;
    most = MEMORY_TIMES * size + MEMORY_MORE;
    fault = NULL;
    memset(&m, 0, sizeof m);
    memset(&result, 0, sizeof result);
    if (setjmp(back) == 0) {
        m.boundary = boundary;
        if (read)
            read("FILE", copy, size, &m);
        else
            mesh_read("FILE", boundary, &m);
        result.accepted = 1;
        result.peak = peak;
        if (m.triangles) use(&m);
    }
    if (!result.accepted) result.peak = peak;
    if (!result.accepted && !fault && (!*result.message || !is_message(result.message)))
        fault = "no message, or an odd one";
    while (block_count) free(blocks[--block_count].p);
    free(copy);
    result.fault = fault;
    return result;
}
