/* accuracy: how far the surfaces of each method lie from the true ones. */
#include "accuracy.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const usage =
    "usage: accuracy [--csv | --short | --sweep | --quads] [SURFACE]...\n"
    "How far flat triangles, PN triangles, Nagata's patch and those of the paper's, the arc and\n"
    "the fit rule lie from surfaces that are known exactly: the largest distance and, after a\n"
    "slash, the largest angle between the normals in degrees; four meshes, each twice as fine.\n"
    "A SURFACE is a part of its name; the default is all.\n"
    "  --csv    comma-separated values, with the means\n"
    "  --short  the finest meshes only\n"
    "  --sweep  instead, the paper's rule over the constants that it leaves open\n"
    "  --quads  instead, Brown's squares and triangles over quads, with the jump of the normal\n";

/* One surface, kind of mesh and kind of normals: every method on every level. */
typedef struct block {
    const surface *s;
    int irregular, estimated;
    int triangles[LEVELS];
    figures r[METHODS][LEVELS];
} block;

enum { LONG, CSV, SHORT, SWEEP, QUADS, HELP };

static long lost; /* points without a nearest point, which there should not be */

static block block_make(const surface *s, int irregular, int estimated, int from)
{
    block b;
    int level, method;
    b.s = s;
    b.irregular = irregular;
    b.estimated = estimated;
    for (level = from; level < LEVELS; level++) {
        model m = model_make(s, level, irregular);
        if (estimated) model_estimate_normals(&m);
        b.triangles[level] = m.mesh.triangles;
        for (method = 0; method < METHODS; method++) {
            n3_patch *p = patches_make(&m, method);
            b.r[method][level] = measure(s, &m, p, s->alike && !irregular ? 24 : 12);
            lost += b.r[method][level].lost;
            free(p);
        }
        model_free(&m);
    }
    return b;
}

/* Each level halves the edges. */
static double order(double coarse, double fine) { return log2(coarse / fine); }

static void print_set(int irregular, int estimated)
{
    printf("%s mesh, %s normals\n\n", irregular ? "irregular" : "regular",
           estimated ? "estimated" : "exact");
}

static void print_long(const block *b)
{
    int method, i;
    printf("\n### %s, ", b->s->name);
    print_set(b->irregular, b->estimated);
    printf("| triangles |");
    for (i = 0; i < LEVELS; i++) printf(" %d |", b->triangles[i]);
    printf(" orders | mean | jump |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (method = 0; method < METHODS; method++) {
        const figures *r = b->r[method], *last = &r[LEVELS - 1];
        printf("| %s |", method_name[method]);
        for (i = 0; i < LEVELS; i++) printf(" %.2e / %.3g |", r[i].distance, r[i].angle);
        printf(" %.1f / %.1f |", order(last[-1].distance, last->distance),
               order(last[-1].angle, last->angle));
        printf(" %.1e / %.2g | %.2g |\n", last->mean_distance, last->mean_angle, last->jump);
    }
}

static void print_csv(const block *b)
{
    int method, i;
    for (method = 0; method < METHODS; method++)
        for (i = 0; i < LEVELS; i++) {
            const figures *r = &b->r[method][i];
            printf("\"%s\",%s,%s,\"%s\",%d,", b->s->name, b->irregular ? "irregular" : "regular",
                   b->estimated ? "estimated" : "exact", method_name[method], b->triangles[i]);
            printf("%.4e,%.4e,%.4e,%.4e,%.4e", r->distance, r->mean_distance, r->angle,
                   r->mean_angle, r->jump);
            if (i) printf(",%.2f", order(r[-1].distance, r->distance));
            if (i) printf(",%.2f", order(r[-1].angle, r->angle));
            printf(i ? "\n" : ",,\n");
        }
}

static void print_short(const block *b)
{
    int method;
    printf("| %s |", b->s->name);
    for (method = 0; method < METHODS; method++) {
        const figures *r = &b->r[method][LEVELS - 1];
        printf(" %.1e / %.2g |", r->distance, r->angle);
    }
    printf("\n");
}

static void print_head(int form, int irregular, int estimated)
{
    int i;
    if (form != SHORT) return;
    printf("\n### ");
    print_set(irregular, estimated);
    printf("| |");
    for (i = 0; i < METHODS; i++) printf(" %s |", method_name[i]);
    printf("\n| ---");
    for (i = 0; i < METHODS; i++) printf(" | ---");
    printf(" |\n");
}

static int wanted(const char *name, char **word)
{
    if (!*word) return 1;
    for (; *word; word++)
        if (strstr(name, *word)) return 1;
    return 0;
}

/* False if no surface has such a name. */
static int print_all(int form, char **word)
{
    static void (*const print[])(const block *) = {print_long, print_csv, print_short};
    int set, i, count = 0;
    if (form == CSV)
        printf("surface,mesh,normals,method,triangles,distance,mean_distance,angle,mean_angle,jump,"
               "distance_order,angle_order\n");
    for (i = 0; i < SURFACES; i++) count += wanted(surfaces[i].name, word);
    for (set = 0; set < 4 && count; set++) {
        int irregular = set & 1, estimated = set >> 1;
        print_head(form, irregular, estimated);
        for (i = 0; i < SURFACES; i++) {
            block b;
            if (!wanted(surfaces[i].name, word)) continue;
            b = block_make(&surfaces[i], irregular, estimated, form == SHORT ? LEVELS - 1 : 0);
            print[form](&b);
        }
    }
    return count;
}

/* -1: there is no such option. */
static int form_of(const char *word)
{
    static const char *const option[] = {"", "--csv", "--short", "--sweep", "--quads", "-h"};
    int form;
    if (!word || word[0] != '-') return LONG;
    for (form = CSV; form <= HELP; form++)
        if (!strcmp(word, option[form])) return form;
    return -1;
}

int main(int argc, char **argv)
{
    int form = form_of(argc > 1 ? argv[1] : NULL), known = form >= 0;
    if (form == HELP) printf("%s", usage);
    else if (form == SWEEP) sweep();
    else if (form == QUADS) lost = quads();
    else if (known) known = print_all(form, argv + 1 + (form != LONG));
    if (!known) fprintf(stderr, "accuracy: no such %s\n%s", form < 0 ? "option" : "surface", usage);
    if (lost) fprintf(stderr, "accuracy: %ld points have no nearest point on the surface\n", lost);
    return known ? lost != 0 : 2;
}
