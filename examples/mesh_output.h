/* mesh_output.h: a file on its way out, and what is put into it: text, or numbers as bytes. */
#ifndef MESH_OUTPUT_H
#define MESH_OUTPUT_H

#include "mesh.h"

/* Types of numbers. In text all are decimal. */
enum { UINT8, INT32, INT64, FLOAT32, FLOAT64 };

typedef struct output output;

/* To be called first: interrupts then remove an unfinished file, and a pipe that closes or a file
   that grows too large is an error like any other. */
void output_catch_signals(void);

/* A file under a temporary name in the same folder, which closing turns into its name. What goes
   wrong ends the program and leaves neither. order: AS_TEXT, LITTLE or BIG, of put_value(). */
output *output_open(const char *path, int order);
void output_close(output *o);
const char *output_path(const output *o);
int output_is_text(const output *o);

void put_text(output *o, const char *s);
void put_bytes(output *o, const void *from, size_t bytes);

/* Decimal, with as many digits as bring back the same bits. */
void put_number(output *o, double x);
void put_vec(output *o, n3_vec a); /* with blanks between */

/* Decimal, or as bytes of this type; what separates them, in text alone. */
void put_value(output *o, int type, double x);
void put_separator(output *o, char c);

/* Bytes of a number of this type. */
int type_bytes(int type);

/* Says on stderr how far the work is, where that is a terminal and it takes more than a second; the
   next message overwrites it. done negative: not known. progress_hide() ends it. */
void progress(const char *work, double done, double all);
void progress_hide(void);

/* How long each kind of work took, on stderr. */
void progress_times(double triangles);

#endif
