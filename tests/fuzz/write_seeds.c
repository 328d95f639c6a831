/* write_seeds FOLDER: the seeds as files. */
#include "seeds.h"

#include <stdio.h>

int main(int argc, char **argv)
{
    const seed *list;
    int n = seeds_make(&list), i, bad = argc != 2;
    for (i = 0; i < n && !bad; i++) {
        char path[1000];
        FILE *f;
        snprintf(path, sizeof path, "%s/%s", argv[1], list[i].name);
        f = fopen(path, "wb");
        bad = !f || fwrite(list[i].data, 1, list[i].size, f) != list[i].size;
        if (f) bad |= fclose(f) != 0;
    }
    if (bad) fprintf(stderr, "write_seeds: cannot write\n");
    return bad;
}
