/* Gmsh's MSH, versions 2 and 4.1: sections of lines, whose numbers are text or bytes.
 *
 * Fields of the cells tell their groups, the numbers of their entities and their own, those of the
 * points their numbers: "gmsh:physical", "gmsh:geometrical", "id"; not where all are 0, the number
 * of the group or 1, or 1, 2, 3 and so on. Of several groups of an entity the first counts. Data of
 * nodes and elements become fields, NaN where there are none; but no field if they are of less than
 * an eighth. */
#include "mesh_binary.h"
#include "mesh_cells.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { PHYSICAL, GEOMETRICAL, CELL_ID, FIRST_FIELDS }; /* of cells; of points: the id alone */

/* What stands at a number. */
typedef struct link {
    int64_t number;
    int value;
} link;

typedef struct map {
    link *link;
    int count;
} map;

/* Rows of values, each of the node or element with a number. */
typedef struct values {
    token name;
    int of_cells, step, components;
    map row;
    double *value;
} values;

typedef struct reader {
    text text;
    mesh *mesh;
    int version;
    const number_type *size; /* of counts and of the numbers of things, in version 4 */
    map node, group;         /* the points of nodes; the physical groups of entities */
    cells cells;
    int datas;
    values *data;
} reader;

static const number_type int_type = {"", 'i', 4}, double_type = {"", 'f', 8};
static const number_type size_4 = {"", 'u', 4}, size_8 = {"", 'u', 8};

static int read_int(reader *r)
{
    double x = read_number(&r->text, &int_type);
    if (!(fabs(x) <= INT_MAX)) text_fail(&r->text, "%.17g is too large", x);
    return (int)x;
}

static int read_dimension(reader *r)
{
    int d = read_int(r);
    if (d < 0 || d > 3) text_fail(&r->text, "%d is no dimension", d);
    return d;
}

/* A count, or the number of a node or an element. */
static double read_size(reader *r)
{
    double x = read_number(&r->text, r->version < 4 ? &int_type : r->size);
    if (!is_exact(&x, 1)) text_fail(&r->text, "%.17g is too large", x);
    return x;
}

static void skip_ints(reader *r, double count)
{
    for (; count > 0; count--) read_int(r);
}

static void skip_doubles(reader *r, int count)
{
    for (; count > 0; count--) read_number(&r->text, &double_type);
}

static int compare_links(const void *a, const void *b)
{
    int64_t x = ((const link *)a)->number, y = ((const link *)b)->number;
    return (x > y) - (x < y);
}

static void map_add(map *m, double number, int value)
{
    m->link = room(m->link, m->count, sizeof *m->link);
    m->link[m->count].number = (int64_t)number;
    m->link[m->count++].value = value;
}

/* To be done before map_find(). False if a number is there twice. */
static int map_sort(map *m)
{
    int i, sorted = 1;
    for (i = 1; i < m->count; i++) sorted &= m->link[i - 1].number < m->link[i].number;
    if (sorted) return 1;
    qsort(m->link, (size_t)m->count, sizeof *m->link, compare_links);
    for (i = 1; i < m->count && m->link[i - 1].number < m->link[i].number; i++) continue;
    return i >= m->count;
}

/* The value at the number, -1 if there is none. Mostly the numbers have no gaps. */
static int map_find(const map *m, double number)
{
    const link key = {(int64_t)number, 0}, *found;
    int64_t guess = m->count ? key.number - m->link[0].number : -1;
    if (guess >= 0 && guess < m->count && m->link[guess].number == key.number)
        return m->link[guess].value;
    if (!m->count) return -1;
    found = bsearch(&key, m->link, (size_t)m->count, sizeof key, compare_links);
    return found ? found->value : -1;
}

static void append(field *f, int row, double x)
{
    f->value = room(f->value, row, sizeof *f->value);
    f->value[row] = x;
}

static void read_format(reader *r)
{
    text *t = &r->text;
    token k = text_word(t);
    int binary;
    r->version = k.length && *k.at == '2' ? 2 : 4;
    if (r->version == 4 && !token_is(k, "4.1"))
        text_refuse(t, k, "is not the version 2 or 4.1 of the format");
    binary = text_count(t, 1);
    k = text_token(t);
    if (!token_is(k, "4") && !token_is(k, "8")) text_refuse(t, k, "is not a size of 4 or 8 bytes");
    r->size = *k.at == '4' ? &size_4 : &size_8;
    if (!binary) return;
    text_next_line(t);
    t->order = text_left(t) && *t->at == 0 ? BIG : LITTLE;
    if (read_int(r) != 1) text_fail(t, "the number 1 should be here");
}

/* The line without its quotes. */
static token read_name(text *t)
{
    token k = text_line(t);
    if (k.length >= 2 && *k.at == '"' && k.at[k.length - 1] == '"') k.at++, k.length -= 2;
    return k;
}

static void read_names(reader *r)
{
    mesh *m = r->mesh;
    int n = text_count(&r->text, INT_MAX), i;
    for (i = 0; i < n; i++) {
        group_name g;
        double number;
        token k;
        g.dimension = text_count(&r->text, 3);
        number = text_whole(&r->text);
        if (!(fabs(number) <= INT_MAX)) text_fail(&r->text, "%.17g is too large", number);
        g.number = (int)number;
        k = read_name(&r->text);
        g.name = memcpy(allocate(k.length + 1, 1), k.at, k.length);
        m->name = room(m->name, m->names, sizeof *m->name);
        m->name[m->names++] = g;
    }
}

static double entity_key(int dimension, int number) { return dimension * 17179869184.0 + number; }

static void read_entity(reader *r, int dimension, int is_part)
{
    int number = read_int(r), physical = 0;
    double groups;
    if (is_part) {
        skip_ints(r, 2); /* what it is a part of */
        skip_ints(r, read_size(r));
    }
    skip_doubles(r, dimension ? 6 : 3); /* its place */
    groups = read_size(r);
    if (groups > 0) physical = read_int(r);
    skip_ints(r, groups - 1);
    if (dimension) skip_ints(r, read_size(r)); /* its boundary */
    map_add(&r->group, entity_key(dimension, number), abs(physical));
}

static void read_all_entities(reader *r, int are_parts)
{
    double count[4];
    int i;
    if (are_parts) {
        read_size(r);
        skip_ints(r, 2 * read_size(r));
    }
    for (i = 0; i < 4; i++) count[i] = read_size(r);
    for (i = 0; i < 4; i++)
        for (; count[i] > 0; count[i]--) read_entity(r, i, are_parts);
    map_sort(&r->group);
}

static void read_entities(reader *r) { read_all_entities(r, 0); }

static void read_parts(reader *r) { read_all_entities(r, 1); }

static void add_node(reader *r, double number)
{
    mesh *m = r->mesh;
    int i = r->node.count;
    if (!m->point_fields)
        field_add(&m->point_field, &m->point_fields, "id", 2, 1, NULL)->kind = NUMBERS;
    append(&m->point_field[0], i, number);
    map_add(&r->node, number, i);
}

static void read_point(reader *r)
{
    mesh *m = r->mesh;
    n3_vec *x;
    m->point = room(m->point, m->points, sizeof *m->point);
    x = &m->point[m->points++];
    x->x = (n3_real)read_coordinate(&r->text, &double_type);
    x->y = (n3_real)read_coordinate(&r->text, &double_type);
    x->z = (n3_real)read_coordinate(&r->text, &double_type);
}

static void read_block_of_nodes(reader *r)
{
    int dimension = read_dimension(r), has_parameters, i;
    double n;
    read_int(r);
    has_parameters = read_int(r);
    n = read_size(r);
    check_left(&r->text, n, (size_t)r->size->bytes + 24, 4);
    for (i = 0; i < n; i++) add_node(r, read_size(r));
    for (i = 0; i < n; i++) {
        read_point(r);
        if (has_parameters) skip_doubles(r, dimension);
    }
}

static void read_nodes(reader *r)
{
    double n;
    if (r->version < 4) {
        n = text_count(&r->text, INT_MAX);
        text_next_line(&r->text);
        for (; n > 0; n--) {
            add_node(r, read_size(r));
            read_point(r);
        }
    } else {
        n = read_size(r);
        read_size(r), read_size(r), read_size(r); /* the nodes, their least and greatest number */
        for (; n > 0; n--) read_block_of_nodes(r);
    }
    if (!map_sort(&r->node)) text_fail(&r->text, "two nodes before here have the same number");
}

typedef struct element_type {
    unsigned char type, nodes, kind;
} element_type;

/* Elements of Gmsh up to the order 5, with the kinds that VTK has for them. */
static const element_type *find_type(reader *r, int type)
{
    static const element_type types[] = {
        {1, 2, 3},     {2, 3, 5},     {3, 4, 9},    {4, 4, 10},    {5, 8, 12},    {6, 6, 13},
        {7, 5, 14},    {8, 3, 68},    {9, 6, 69},   {10, 9, 70},   {11, 10, 71},  {12, 27, 72},
        {13, 18, 73},  {14, 14, 74},  {15, 1, 1},   {16, 8, 70},   {17, 20, 72},  {18, 15, 73},
        {19, 13, 74},  {20, 9, 69},   {21, 10, 69}, {22, 12, 69},  {23, 15, 69},  {24, 15, 69},
        {25, 21, 69},  {26, 4, 68},   {27, 5, 68},  {28, 6, 68},   {29, 20, 71},  {30, 35, 71},
        {31, 56, 71},  {32, 22, 71},  {33, 28, 71}, {36, 16, 70},  {37, 25, 70},  {38, 36, 70},
        {39, 12, 70},  {40, 16, 70},  {41, 20, 70}, {90, 40, 73},  {91, 75, 73},  {92, 64, 72},
        {93, 125, 72}, {94, 216, 72}, {99, 32, 72}, {100, 44, 72}, {101, 56, 72}, {106, 126, 73},
        {118, 30, 74}, {119, 55, 74}, {120, 91, 74}};
    size_t i, n = sizeof types / sizeof *types;
    for (i = 0; i < n && types[i].type != type; i++) continue;
    if (i == n) text_fail(&r->text, "the type %d of elements is not known", type);
    return &types[i];
}

/* Its nodes follow. */
static void add_element(reader *r, const element_type *e, double number, int physical,
                        int geometrical)
{
    static const char *const names[FIRST_FIELDS] = {"gmsh:physical", "gmsh:geometrical", "id"};
    const int row = r->cells.count;
    mesh *m = r->mesh;
    int i;
    for (i = m->cell_fields; i < FIRST_FIELDS; i++)
        field_add(&m->cell_field, &m->cell_fields, names[i], strlen(names[i]), 1, NULL)->kind =
            NUMBERS;
    for (i = 0; i < e->nodes; i++) {
        double node = read_size(r);
        int point = map_find(&r->node, node);
        if (point < 0) text_fail(&r->text, "there is no node %.17g", node);
        cells_add_point(&r->cells, point);
    }
    cells_add(&r->cells, &r->text, e->kind);
    append(&m->cell_field[PHYSICAL], row, physical);
    append(&m->cell_field[GEOMETRICAL], row, geometrical);
    append(&m->cell_field[CELL_ID], row, number);
}

/* As text, each element has its own head; as bytes, many have one. */
static void read_block_of_elements_2(reader *r, int *left)
{
    const int is_text = r->text.order == AS_TEXT;
    int first = read_int(r), second = read_int(r), tags = read_int(r), i;
    const element_type *e = find_type(r, is_text ? second : first);
    int n = is_text ? 1 : second;
    if (n < 1 || n > *left) text_fail(&r->text, "%d elements, where %d are left", n, *left);
    *left -= n;
    for (i = 0; i < n; i++) {
        double number = is_text ? first : read_size(r);
        int physical = tags > 0 ? read_int(r) : 0, geometrical = tags > 1 ? read_int(r) : 0;
        skip_ints(r, tags - 2);
        add_element(r, e, number, physical, geometrical);
    }
}

static void read_block_of_elements_4(reader *r)
{
    int dimension = read_dimension(r), entity = read_int(r);
    const element_type *e = find_type(r, read_int(r));
    int physical = map_find(&r->group, entity_key(dimension, entity));
    double n = read_size(r);
    for (; n > 0; n--) add_element(r, e, read_size(r), physical > 0 ? physical : 0, entity);
}

static void read_elements(reader *r)
{
    int left;
    double n;
    if (r->version < 4) {
        left = text_count(&r->text, INT_MAX);
        text_next_line(&r->text);
        while (left > 0) read_block_of_elements_2(r, &left);
    } else {
        n = read_size(r);
        read_size(r), read_size(r), read_size(r); /* elements, least and greatest number */
        for (; n > 0; n--) read_block_of_elements_4(r);
    }
}

static void read_rows(reader *r, values *d, int rows)
{
    const size_t k = (size_t)d->components;
    size_t j;
    int i;
    check_left(&r->text, rows, 4 + 8 * k, 1 + k);
    d->value = allocate((size_t)rows * k, sizeof *d->value);
    for (i = 0; i < rows; i++) {
        map_add(&d->row, read_int(r), i);
        for (j = 0; j < k; j++) d->value[(size_t)i * k + j] = read_number(&r->text, &double_type);
    }
    map_sort(&d->row);
}

static void read_data(reader *r, int of_cells)
{
    text *t = &r->text;
    values d;
    int n, i, rows;
    memset(&d, 0, sizeof d);
    d.of_cells = of_cells;
    for (n = text_count(t, INT_MAX), i = 0; i < n; i++) {
        if (!text_next_line(t)) text_fail(t, "the data have no end");
        if (i == 0) d.name = read_name(t);
    }
    for (n = text_count(t, INT_MAX); n > 0; n--) text_value(t); /* the time */
    n = text_count(t, INT_MAX);
    if (n < 3) text_fail(t, "of step, components and rows, there are %d", n);
    d.step = text_count(t, INT_MAX);
    d.components = text_count(t, INT_MAX);
    rows = text_count(t, INT_MAX);
    for (; n > 3; n--) text_whole(t);
    if (!d.components) text_fail(t, "data of no components");
    text_next_line(t);
    read_rows(r, &d, rows);
    r->data = room(r->data, r->datas, sizeof *r->data);
    r->data[r->datas++] = d;
}

static void read_node_data(reader *r) { read_data(r, 0); }

static void read_element_data(reader *r) { read_data(r, 1); }

/* Behind the $End with this name. */
static void skip_section(reader *r, token name)
{
    text *t = &r->text;
    const char *s = t->at;
    const size_t n = name.length - 1;
    while ((s = memchr(s, '$', (size_t)(t->end - s))) != NULL) {
        if ((size_t)(t->end - s) >= n + 4 && memcmp(s, "$End", 4) == 0 &&
            memcmp(s + 4, name.at + 1, n) == 0)
            break;
        s++;
    }
    if (!s) text_refuse(t, name, "has no end");
    t->at = s + 4 + n;
}

static void read_section(reader *r, token name)
{
    static const struct section {
        const char *begin, *end;
        void (*read)(reader *r);
    } sections[] = {{"$meshformat", "$endmeshformat", read_format},
                    {"$physicalnames", "$endphysicalnames", read_names},
                    {"$entities", "$endentities", read_entities},
                    {"$partitionedentities", "$endpartitionedentities", read_parts},
                    {"$nodes", "$endnodes", read_nodes},
                    {"$elements", "$endelements", read_elements},
                    {"$nodedata", "$endnodedata", read_node_data},
                    {"$elementdata", "$endelementdata", read_element_data}};
    size_t i, n = sizeof sections / sizeof *sections;
    for (i = 0; i < n && !token_is(name, sections[i].begin); i++) continue;
    if (*name.at != '$') text_refuse(&r->text, name, "where a section should begin");
    if (i < n && i > 0 && !r->version) text_refuse(&r->text, name, "before the format is told");
    if (i == n) {
        skip_section(r, name);
        r->mesh->lost_fields += token_is(name, "$elementnodedata");
    } else {
        text_next_line(&r->text);
        sections[i].read(r);
        name = text_word(&r->text);
        if (!token_is(name, sections[i].end))
            text_refuse(&r->text, name, "where the section should end");
    }
}

/* Steps but the first have their number in the name. */
static char *data_name(const values *d)
{
    const size_t n = d->name.length;
    char *name = allocate(n + 16, 1);
    memcpy(name, d->name.at, n);
    if (d->step) snprintf(name + n, 16, "@%d", d->step);
    return name;
}

/* False if the data are of too few of the things whose numbers are in id: a field of NaN would take
   memory out of all proportion. */
static int add_data(const values *d, const double *id, int rows, field **list, int *fields)
{
    const size_t k = (size_t)d->components;
    double *value;
    char *name;
    int i, found = 0;
    size_t j;
    if (d->row.count < rows / 8) return 0;
    for (i = 0; i < rows; i++) found += map_find(&d->row, id[i]) >= 0;
    if (!found || found < rows / 8) return 0;
    value = allocate((size_t)rows * k, sizeof *value);
    for (i = 0; i < rows; i++) {
        int row = map_find(&d->row, id[i]);
        for (j = 0; j < k; j++)
            value[(size_t)i * k + j] = row < 0 ? (double)NAN : d->value[(size_t)row * k + j];
    }
    name = data_name(d);
    field_add(list, fields, name, strlen(name), d->components, value);
    free(name);
    return 1;
}

/* 1, 2, 3 and so on. */
static int are_counted(const double *value, int rows)
{
    int i;
    for (i = 0; i < rows && value[i] >= i + 1 && value[i] <= i + 1; i++) continue;
    return i == rows;
}

/* 0; or, for entities that say nothing beyond their groups, the group's number and at least 1. */
static int are_plain(const double *value, const double *group, int rows)
{
    int i;
    for (i = 0; i < rows; i++) {
        double want = !group ? 0 : group[i] > 1 ? group[i] : 1;
        if (value[i] < want || value[i] > want) return 0;
    }
    return 1;
}

static void drop_plain(mesh *m)
{
    const double *group;
    if (m->points && are_counted(m->point_field[0].value, m->points))
        field_drop(m->point_field, &m->point_fields, 0);
    if (!m->cell_fields) return;
    group = m->cell_field[PHYSICAL].value;
    if (are_counted(m->cell_field[CELL_ID].value, m->cells))
        field_drop(m->cell_field, &m->cell_fields, CELL_ID);
    if (are_plain(m->cell_field[GEOMETRICAL].value, group, m->cells))
        field_drop(m->cell_field, &m->cell_fields, GEOMETRICAL);
    if (are_plain(group, NULL, m->cells)) field_drop(m->cell_field, &m->cell_fields, PHYSICAL);
}

static void finish(reader *r, mesh *m)
{
    int i;
    for (i = 0; i < r->datas; i++) {
        const values *d = &r->data[i];
        if (d->of_cells && m->cells)
            m->lost_fields += !add_data(d, m->cell_field[CELL_ID].value, m->cells, &m->cell_field,
                                        &m->cell_fields);
        else if (!d->of_cells && m->points)
            m->lost_fields +=
                !add_data(d, m->point_field[0].value, m->points, &m->point_field, &m->point_fields);
    }
    drop_plain(m);
}

static void free_reader(reader *r)
{
    int i;
    for (i = 0; i < r->datas; i++) {
        free(r->data[i].row.link);
        free(r->data[i].value);
    }
    free(r->data);
    free(r->node.link);
    free(r->group.link);
}

void mesh_read_msh(const char *path, const char *data, size_t size, mesh *m)
{
    reader r;
    token k;
    memset(&r, 0, sizeof r);
    r.text = text_open(path, data, size);
    r.text.plain = 1;
    r.mesh = m;
    for (k = text_word(&r.text); k.length; k = text_word(&r.text)) read_section(&r, k);
    cells_take(path, &r.cells, m);
    finish(&r, m);
    free_reader(&r);
}
