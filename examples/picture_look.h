/* picture_look.h: what a sample of a scene looks like. */
#ifndef PICTURE_LOOK_H
#define PICTURE_LOOK_H

#include "picture_scene.h"

/* Spots and the eye are in the camera's axes: x to the right, y up, z towards the eye. unit:
   the length 1 of these axes, in the scene's. */
typedef struct look {
    view v;
    double range, unit, eye;
} look;

colour look_colour(const look *l, const spot *s);

/* The value that a map shows, and by what it changes with a surface so many times as large. */
double look_value(view v, const spot *s);
double look_unit(view v, double length);

void look_legend(picture *p, panel f, view v, double range);
int look_legend_height(panel f, view v);

#endif
