/* mesh_number.h: numbers as text and back, to the bit. */
#ifndef MESH_NUMBER_H
#define MESH_NUMBER_H

enum { NUMBER_SIZE = 32 }; /* characters, with the zero byte */

/* Writes x as printf's %.15g, %.16g or %.17g does, the first of them that reads as x again.
   Returns the number of characters, not counting the zero byte behind them. */
int number_format(char *to, double x);

/* The number that begins at the text, rounded to nearest as strtod does, and where it ends. The
   text is known to begin with a decimal number. */
double number_parse(const char *from, const char **end);

#endif
