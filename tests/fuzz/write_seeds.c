/* write_seeds FOLDER [COUNT]: the seeds as files, or as many mutants of them. */
#include "mutate.h"

#include <stdio.h>
#include <stdlib.h>

static void write_file(const char *folder, const char *name, const char *data, size_t size)
{
    char path[1000];
    FILE *f;
    int bad;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    f = fopen(path, "wb");
    bad = !f || fwrite(data, 1, size, f) != size;
    if (f) bad |= fclose(f) != 0;
    if (!bad) return;
    perror(path);
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    static char data[MUTANT_MOST];
    const seed *list;
    const int seeds = seeds_make(&list), count = argc == 3 ? atoi(argv[2]) : 0;
    int i;
    if (argc != 2 && argc != 3) return 2;
    for (i = 0; i < seeds && !count; i++)
        write_file(argv[1], list[i].name, list[i].data, list[i].size);
    for (i = 0; i < count; i++) {
        char name[20];
        snprintf(name, sizeof name, "%d", i);
        write_file(argv[1], name, data, mutate((unsigned long)i, list, seeds, data));
    }
    return 0;
}
