/* tree.h: many patches, asked as one: the first hit of a ray, the nearest point. */
#ifndef TREE_H
#define TREE_H

#include "nagata3.h"

/* A box around patches: those of its two nodes, which follow one another from first on, or, with
   count > 0, the patches first up to but not with first + count. */
typedef struct tree_node {
    n3_box box;
    int first, count;
} tree_node;

typedef struct tree {
    int patches;
    n3_patch *patch; /* in another order than they were given: */
    int *was;        /* which they were */
    tree_node *node; /* the first is the root */
} tree;

/* Of one patch at least. To be freed. */
tree tree_make(const n3_patch *p, int count);
void tree_free(tree *t);

/* The patch that a ray hits first, by its place in t->patch, and the hit; -1: none. */
int tree_hit(const tree *t, n3_vec from, n3_vec along, n3_real t0, n3_real t1, n3_hit *hit);

/* The patch nearest to a point, and the foot on it. */
int tree_nearest(const tree *t, n3_vec q, n3_foot *foot);

#endif
