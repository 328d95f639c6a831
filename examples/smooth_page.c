/* HTML: the surface by every rule, in a page that turns it. The page is examples/page.html with the
 * model in the place of @MODEL@, as JSON with arrays in base64, and a picture in that of @STILL@.
 */
#include "smooth_picture.h"

#include <stdint.h>
#include <stdlib.h>

static const unsigned char page[] = {
#include "page.inc"
    0};

static const char *const rules[] = {"flat", "nagata", "pn", "paper", "arc", "fit"};

enum { RULES = 6 };

/* ---- Base64 ---- */

static void put_base64(output *o, const unsigned char *data, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    size_t i;
    for (i = 0; i < size; i += 3) {
        unsigned three = (unsigned)data[i] << 16;
        char four[4];
        int k;
        if (i + 1 < size) three |= (unsigned)data[i + 1] << 8;
        if (i + 2 < size) three |= data[i + 2];
        for (k = 0; k < 4; k++)
            four[k] = i + (size_t)k > size ? '=' : digits[three >> (18 - 6 * k) & 63];
        put_bytes(o, four, 4);
    }
}

/* An array that is filled number by number, little-endian. */
typedef struct packed {
    unsigned char *data;
    size_t size;
} packed;

static packed packed_make(size_t bytes)
{
    packed p = {NULL, 0};
    p.data = allocate(bytes, 1);
    return p;
}

static void pack_bits(packed *p, uint32_t bits)
{
    int k;
    for (k = 0; k < 4; k++) p->data[p->size++] = (unsigned char)(bits >> 8 * k & 255);
}

static void pack_vec(packed *p, n3_vec x)
{
    float part[3];
    uint32_t bits;
    int k;
    part[0] = (float)x.x;
    part[1] = (float)x.y;
    part[2] = (float)x.z;
    for (k = 0; k < 3; k++) {
        memcpy(&bits, &part[k], sizeof bits);
        pack_bits(p, bits);
    }
}

/* As a value of the JSON object; frees it. */
static void put_packed(output *o, const char *name, packed *p)
{
    put_text(o, ", \"");
    put_text(o, name);
    put_text(o, "\": \"");
    put_base64(o, p->data, p->size);
    put_text(o, "\"");
    free(p->data);
}

/* ---- JSON ---- */

/* Characters that would end a string or the script are escaped. */
static void put_string(output *o, const char *s)
{
    char escaped[8];
    put_text(o, "\"");
    for (; *s; s++) {
        unsigned c = (unsigned char)*s;
        if (c >= 32 && c != '"' && c != '\\' && c != '<' && c != 127) {
            put_bytes(o, s, 1);
        } else {
            snprintf(escaped, sizeof escaped, "\\u%04x", c);
            put_text(o, escaped);
        }
    }
    put_text(o, "\"");
}

static void put_named(output *o, const char *name, double x)
{
    put_text(o, ", \"");
    put_text(o, name);
    put_text(o, "\": ");
    put_number(o, x);
}

/* ---- The model ---- */

/* Coordinates go around the middle of the box, half of whose diagonal becomes 1. */
typedef struct space {
    n3_vec middle;
    n3_real unit;
} space;

static space find_space(const surface *s)
{
    n3_vec lo = s->net[0], hi = lo;
    space out;
    int i;
    for (i = 1; i < s->mesh.points; i++) {
        n3_vec x = s->net[i];
        lo = n3_v(x.x < lo.x ? x.x : lo.x, x.y < lo.y ? x.y : lo.y, x.z < lo.z ? x.z : lo.z);
        hi = n3_v(x.x > hi.x ? x.x : hi.x, x.y > hi.y ? x.y : hi.y, x.z > hi.z ? x.z : hi.z);
    }
    out.middle = n3_add(n3_mul((n3_real)1 / 2, lo), n3_mul((n3_real)1 / 2, hi));
    out.unit = n3_len(n3_sub(hi, out.middle));
    if (!(out.unit > 0)) out.unit = 1;
    return out;
}

static n3_vec into(const space *p, n3_vec x)
{
    x = n3_sub(x, p->middle);
    return n3_v(x.x / p->unit, x.y / p->unit, x.z / p->unit);
}

static void put_points(output *o, const char *name, const space *p, const n3_vec *x, int n)
{
    packed out = packed_make(12 * (size_t)n);
    int i;
    for (i = 0; i < n; i++) pack_vec(&out, into(p, x[i]));
    put_packed(o, name, &out);
}

static void put_nodes(output *o, const surface *s)
{
    packed out = packed_make(40 * (size_t)s->mesh.triangles);
    int t, k, node[10];
    for (t = 0; t < s->mesh.triangles; t++) {
        n3_mesh_patch_nodes(&s->mesh, &s->topology, t, node);
        for (k = 0; k < 10; k++) pack_bits(&out, (uint32_t)node[k]);
    }
    put_packed(o, "nodes", &out);
}

/* A byte for each side. */
static void put_sharp(output *o, const surface *s)
{
    packed out = packed_make(3 * (size_t)s->mesh.triangles);
    int i;
    for (i = 0; i < 3 * s->mesh.triangles; i++) {
        int edge = s->topology.edge[i];
        unsigned sharp = edge < 0 ? 0 : s->flags[edge] & (N3_EDGE_CREASE | N3_EDGE_HALF_CREASE);
        out.data[out.size++] = sharp != 0;
    }
    put_packed(o, "sharp", &out);
}

/* A point and a unit normal for each corner; once where corners share both in a row. */
static void put_normals(output *o, const surface *s, const space *p)
{
    packed out = packed_make(72 * (size_t)s->mesh.triangles);
    int *last = allocate((size_t)s->mesh.normals, sizeof *last), i;
    for (i = 0; i < 3 * s->mesh.triangles; i++) {
        int point = s->mesh.triangle[i], normal = s->corner[i];
        if (normal < 0 || last[normal] == point + 1) continue;
        last[normal] = point + 1;
        pack_vec(&out, into(p, s->net[point]));
        pack_vec(&out, n3_unit(s->normal[normal]));
    }
    put_packed(o, "normals", &out);
    free(last);
}

static const char *base_name(const char *path)
{
    const char *at = path;
    for (; *path; path++)
        if (*path == '/' || *path == '\\') at = path + 1;
    return at;
}

/* What a rule's surface was like, as the text of --report. */
static void put_report(output *o, const mesh *m, const surface *s)
{
    const product none = {NULL, NULL, 0, 0, 0, 0};
    n3_report r = surface_report(s);
    FILE *f = tmpfile();
    size_t size;
    char *text;
    if (!f) fail(output_path(o), 0, "no temporary file for the report");
    report_text(f, base_name(s->path), m, s, &r, &none);
    size = (size_t)ftell(f);
    rewind(f);
    text = allocate(size + 1, 1);
    text[fread(text, 1, size, f)] = 0;
    fclose(f);
    put_string(o, text);
    free(text);
}

/* The control points of each rule beyond the mesh's own points, then the reports. */
static void put_rules(output *o, const mesh *m, const surface *s, const space *p)
{
    surface *made = allocate(RULES, sizeof *made);
    int i;
    put_text(o, ", \"nets\": {\"by\": 0");
    for (i = 0; i < RULES; i++) {
        surface_make(s->path, m, smooth_rule_find(rules[i]), s->cos_crease, &made[i]);
        put_points(o, rules[i], p, made[i].net + m->points, made[i].nodes - m->points);
    }
    put_text(o, "}, \"reports\": {");
    for (i = 0; i < RULES; i++) {
        put_text(o, i ? ", \"" : "\"");
        put_text(o, rules[i]);
        put_text(o, "\": ");
        put_report(o, m, &made[i]);
        surface_free(&made[i]);
    }
    put_text(o, "}");
    free(made);
}

/* Ranges in the coordinates of the page, and what makes the scene's numbers of them again. */
static void put_ranges(output *o, const scene *s, const space *p)
{
    const double unit = (double)p->unit;
    put_text(o, ", \"ranges\": {\"by\": 0");
    put_named(o, "mean", scene_range(s, VIEW_MEAN) * unit);
    put_named(o, "gauss", scene_range(s, VIEW_GAUSS) * unit * unit);
    put_named(o, "error", scene_range(s, VIEW_ERROR) / unit);
    put_text(o, "}, \"unit\": {\"by\": 0");
    put_named(o, "mean", 1 / unit);
    put_named(o, "gauss", 1 / unit / unit);
    put_named(o, "error", unit);
    put_text(o, "}");
}

/* Where the page opens. The page's axes are those of --up, the one that is up last. */
static void put_start(output *o, const request *r, const surface *s)
{
    const char *axes = r->camera.up == 'x'   ? "[1, 2, 0]"
                       : r->camera.up == 'y' ? "[2, 0, 1]"
                                             : "[0, 1, 2]";
    put_text(o, "\"name\": ");
    put_string(o, base_name(s->path));
    put_text(o, ", \"rule\": ");
    put_string(o, s->rule->name);
    put_text(o, ", \"view\": ");
    put_string(o, r->view == VIEW_NET ? "shaded" : view_name(r->view));
    put_text(o, r->view == VIEW_NET ? ", \"show\": [\"net\"]" : ", \"show\": []");
    put_named(o, "turn", r->camera.turn);
    put_named(o, "rise", r->camera.rise);
    put_named(o, "zoom", r->camera.zoom);
    put_text(o, ", \"axes\": ");
    put_text(o, axes);
}

/* Normals are drawn a third as long as a typical edge. */
static double normal_length(const surface *s, const space *p)
{
    double sum = 0;
    int i, end[2];
    for (i = 0; i < s->topology.edges; i++) {
        n3_mesh_edge_ends(&s->mesh, &s->topology, i, end);
        sum += (double)n3_len(n3_sub(into(p, s->net[end[0]]), into(p, s->net[end[1]])));
    }
    return s->topology.edges ? sum / s->topology.edges / 3 : 0;
}

static void put_model(output *o, const request *r, const mesh *m, const surface *s,
                      const scene *drawn)
{
    space p = find_space(s);
    put_text(o, "{");
    put_start(o, r, s);
    put_named(o, "normalLength", normal_length(s, &p));
    put_ranges(o, drawn, &p);
    put_points(o, "points", &p, s->net, s->mesh.points);
    put_nodes(o, s);
    put_sharp(o, s);
    put_normals(o, s, &p);
    put_rules(o, m, s, &p);
    put_text(o, "}");
}

static void put_still(output *o, const request *r, const scene *drawn)
{
    size_t size;
    unsigned char *file = surface_png(drawn, r, 640, 480, &size);
    put_base64(o, file, size);
    free(file);
}

/* The page up to a mark, which stands in it once; returns what follows the mark. */
static const char *put_until(output *o, const char *from, const char *mark)
{
    const char *at = strstr(from, mark);
    put_bytes(o, from, (size_t)(at - from));
    return at + strlen(mark);
}

product write_page(const request *r, const mesh *m, const surface *s)
{
    product out = {NULL, "cubic", 0, 0, 0, 0};
    const char *rest = (const char *)page;
    output *o = output_open(r->path, AS_TEXT);
    scene drawn;
    surface_scene(s, &drawn);
    progress("drawing", -1, 1);
    rest = put_until(o, rest, "@STILL@");
    put_still(o, r, &drawn);
    rest = put_until(o, rest, "@MODEL@");
    put_model(o, r, m, s, &drawn);
    put_text(o, rest);
    output_close(o);
    scene_free(&drawn);
    out.triangles = s->mesh.triangles;
    out.points = s->mesh.points;
    return out;
}
