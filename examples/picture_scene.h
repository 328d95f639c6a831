/* picture_scene.h: pictures of cubic patches as they are.
 *
 * The patches are cut into triangles finer than the picture can show, and these tell only which
 * point (u, v) of which patch a sample sees: normal and curvature there are the patch's own. */
#ifndef PICTURE_SCENE_H
#define PICTURE_SCENE_H

#include "nagata3.h"
#include "picture.h"

/* shaded     lit from the upper left; a reddish surface shows its inner side
   zebra      stripes in a mirror: they break where normals jump and kink where curvature does
   isophote   stripes of equal angle between normal and light, wherever the eye is
   mean       mean curvature, positive where the surface bulges to the side of its normals
   gauss      Gaussian curvature
   net        shaded, with the control net
   error      distance from the flat triangle of the patch's corners */
typedef enum view {
    VIEW_SHADED,
    VIEW_ZEBRA,
    VIEW_ISOPHOTE,
    VIEW_MEAN,
    VIEW_GAUSS,
    VIEW_NET,
    VIEW_ERROR
} view;

/* The view of a name as above, -1 for none; and back. */
int view_find(const char *name);
const char *view_name(view v);

/* A line in space, width in pixels. What lies on a surface is seen in full. */
typedef struct stroke {
    n3_vec p[2];
    double width;
    colour c;
} stroke;

/* A place on the surface: its derivatives, by whatever parameters, its unit normal, and the corners
   of the flat triangle. */
typedef struct spot {
    n3_jet jet;
    n3_vec normal, corner[3];
} spot;

spot patch_spot(const n3_patch *p, double u, double v);

/* Where the surface is no patch, find() says what it is at u and v of the triangle instead, and is
   true; the patch then tells only how finely to cut it. find NULL: they all are patches. */
typedef struct scene {
    int patches, strokes;
    n3_patch *patch;
    stroke *stroke;
    int (*find)(const void *owner, int triangle, double u, double v, spot *out);
    const void *owner;
} scene;

void scene_add_stroke(scene *s, n3_vec p, n3_vec q, double width, colour c);
void scene_add_edge(scene *s, const n3_edge *e, double width, colour c);
void scene_add_net(scene *s); /* of all patches, with their sides */
void scene_add_room(scene *s, const scene *other); /* to be seen from where both can be seen */
void scene_free(scene *s);    /* both arrays, which come from allocate() */

/* Where the picture is taken from. up 'z': turned about the z axis from -y towards x, and lifted
   above the xy plane, in degrees; 'x' and 'y' alike, with the axes in turn. All of the scene is in
   it at zoom 1. */
typedef struct camera {
    double turn, rise, zoom;
    int up;
} camera;

/* A round number that few of the scene's values exceed: where a map's colours end. 0 where the view
   is no map. */
double scene_range(const scene *s, view v);

/* Into a part of a picture; range as above. Below maps there is a legend. */
void scene_draw(picture *p, panel f, const scene *s, camera c, view v, double range);

#endif
