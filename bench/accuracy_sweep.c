/* accuracy_sweep.c: the paper's rule over tan_lo and tan_hi. */
#include "accuracy.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { VALUES = 8 };

/* Sums over the surfaces of the logarithms of the ratio to the figures with the defaults. */
typedef struct total { double distance, angle; } total;

/* Largest distance and angle over a regular and an irregular mesh. */
static figures worst(const surface *s, int level, const n3_options *o)
{
    figures both[2];
    int irregular;
    for (irregular = 0; irregular < 2; irregular++) {
        model m = model_make(s, level, irregular);
        n3_patch *p = patches_by_rule(&m, o);
        both[irregular] = measure(s, &m, p, 6);
        free(p);
        model_free(&m);
    }
    both[0].distance = fmax(both[0].distance, both[1].distance);
    both[0].angle = fmax(both[0].angle, both[1].angle);
    return both[0];
}

static void print_row(int level, const n3_options o[VALUES])
{
    total sum[VALUES] = {{0, 0}};
    int s, i;
    for (s = 0; s < SURFACES; s++) {
        figures usual = worst(&surfaces[s], level, NULL);
        for (i = 0; i < VALUES; i++) {
            figures r = worst(&surfaces[s], level, &o[i]);
            sum[i].distance += log(r.distance / usual.distance);
            sum[i].angle += log(r.angle / usual.angle);
        }
    }
    printf("| %d |", level + 1);
    for (i = 0; i < VALUES; i++)
        printf(" %.2f / %.2f |", exp(sum[i].distance / SURFACES), exp(sum[i].angle / SURFACES));
    printf("\n");
}

static void print_table(const char *name, const double value[VALUES], const n3_options o[VALUES])
{
    int i;
    printf("\n| mesh |");
    for (i = 0; i < VALUES; i++) printf(" %s = %g |", name, value[i]);
    printf("\n| ---");
    for (i = 0; i < VALUES; i++) printf(" | ---");
    printf(" |\n");
    for (i = 0; i < LEVELS; i++) print_row(i, o);
}

void sweep(void)
{
    static const double low[VALUES] = {1e-6, 0.01, 0.03, 0.05, 0.1, 0.2, 0.3, 0.5};
    static const double high[VALUES] = {1, 2, 3, 5, 10, 20, 50, 1e6};
    n3_options by_low[VALUES], by_high[VALUES];
    int i;
    for (i = 0; i < VALUES; i++) {
        by_low[i].rule = by_high[i].rule = N3_RULE_PAPER;
        by_low[i].tan_lo = (n3_real)low[i];
        by_high[i].tan_hi = (n3_real)high[i];
        by_low[i].tan_hi = by_high[i].tan_lo = 0;
    }
    printf("The paper's rule with other constants: largest distance and largest angle between\n"
           "normals, regular and irregular meshes, as multiples of those with the defaults,\n"
           "tan_lo = 0.1 and tan_hi = 10; geometric means over the surfaces.\n");
    print_table("tan_lo", low, by_low);
    print_table("tan_hi", high, by_high);
}
