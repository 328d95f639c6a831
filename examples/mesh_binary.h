/* mesh_binary.h: numbers in a file, as bytes or as text. */
#ifndef MESH_BINARY_H
#define MESH_BINARY_H

#include "mesh_text.h"

typedef struct number_type {
    const char *name; /* in lower case */
    char kind;        /* i: integer, u: without a sign, f: floating, b: a bit, x: not a number */
    int bytes;        /* 1, 2, 4 or 8 */
} number_type;

/* The type of this name, in a list that ends with a name of NULL, or the end of the program. */
const number_type *type_find(const text *t, const number_type *list, token name);

/* True for whole numbers from 0 to 255. */
int type_is_byte(const number_type *type);

/* What values of the type are, in rows of so many: bytes by three or four are colours. */
int type_values(const number_type *type, int components);

/* The bytes from here to the end. */
size_t text_left(const text *t);

/* Over so many bytes, which must be there. */
void skip_bytes(text *t, size_t bytes);

/* Stops the program if so many numbers cannot be in what is left: to be asked before memory is
   taken for them. A row has a fixed number of bytes where numbers are bytes, and of tokens. */
void check_left(const text *t, double rows, size_t bytes, size_t tokens);

/* The next number. An integer beyond 2^53 is rounded. */
double read_number(text *t, const number_type *type);

/* Finite, and no larger than that squares of lengths may overflow. */
int is_coordinate(double x);

/* The same, as a coordinate; as an integer from 0 to count - 1, the number of a thing. */
double read_coordinate(text *t, const number_type *type);
int read_index(text *t, const number_type *type, int count, const char *thing);

/* The next count numbers, in an array from allocate(). */
double *read_numbers(text *t, const number_type *type, double count);

/* Decodes base64 from here on, up to size bytes; the number of them, which is less where the base64
   ends before. */
size_t read_base64(const text *t, unsigned char *to, size_t size);

/* Whole numbers that a double may have rounded, or that an int does not hold. */
int is_exact(const double *value, size_t count);

#endif
