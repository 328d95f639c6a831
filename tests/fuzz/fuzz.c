/* fuzz [COUNT [FIRST]]: mutants of all seeds, read under the sanitizers this is built with.
 * fuzz FILE...: these files, each with what came of it. */
#define _POSIX_C_SOURCE 200809L
#include "mutate.h"
#include "sandbox.h"

#include <ctype.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

enum { SECONDS = 10 }; /* for one file */

static volatile unsigned long current;

static void hang(int signal)
{
    (void)signal;
    fprintf(stderr, "fuzz: number %lu hangs\n", current);
    _exit(1);
}

static void keep(const char *data, size_t size, unsigned long number)
{
    char path[60];
    FILE *f;
    snprintf(path, sizeof path, "fuzz-%lu", number);
    f = fopen(path, "wb");
    if (f) fwrite(data, 1, size, f), fclose(f);
    fprintf(stderr, "fuzz: see %s\n", path);
}

static int run_worst(void)
{
    const seed *list;
    const int seeds = seeds_make_worst(&list);
    int i, faults = 0;
    for (i = 0; i < seeds; i++) {
        outcome o = sandbox_read(NULL, list[i].data, list[i].size, 0);
        printf("fuzz: %s takes %.1f times its size\n", list[i].name,
               (double)o.peak / (double)list[i].size);
        faults += o.fault != NULL || !o.accepted;
    }
    return faults;
}

static int run(unsigned long count, unsigned long first)
{
    static char data[MUTANT_MOST];
    const seed *list;
    const int seeds = seeds_make(&list);
    unsigned long accepted = 0, faults = (unsigned long)run_worst();
    for (current = first; current < first + count; current++) {
        size_t size = mutate(current, list, seeds, data);
        outcome o;
        if (!size) continue;
        alarm(SECONDS);
        o = sandbox_read(NULL, data, size, current / (unsigned long)seeds % 3 == 0);
        accepted += (unsigned long)o.accepted;
        if (!o.fault) continue;
        fprintf(stderr, "fuzz: number %lu: %s\n    %s\n", current, o.fault, o.message);
        keep(data, size, current);
        faults++;
    }
    printf("fuzz: %lu mutants of %d files, %lu of them read\n", count, seeds, accepted);
    printf("fuzz: %lu passed, %lu failed\n", count - faults, faults);
    return faults > 0;
}

static int run_file(const char *path)
{
    FILE *f = fopen(path, "rb");
    static char data[1 << 26];
    size_t size = f ? fread(data, 1, sizeof data, f) : 0;
    int boundary, faults = 0;
    if (!f) return 1;
    fclose(f);
    for (boundary = 0; boundary < 2; boundary++) {
        outcome o = sandbox_read(NULL, data, size, boundary);
        printf("%s: %lu bytes, memory %.1f times that, %s%s\n", path, (unsigned long)size,
               (double)o.peak / (double)size, o.accepted ? "read\n" : o.message,
               o.fault ? o.fault : "");
        faults += o.fault != NULL;
    }
    return faults;
}

int main(int argc, char **argv)
{
    int i, faults = 0;
    signal(SIGALRM, hang);
    if (argc < 2 || isdigit((unsigned char)*argv[1]))
        return run(argc > 1 ? strtoul(argv[1], NULL, 10) : 20000,
                   argc > 2 ? strtoul(argv[2], NULL, 10) : 0);
    for (i = 1; i < argc; i++) faults += run_file(argv[i]);
    return faults > 0;
}
