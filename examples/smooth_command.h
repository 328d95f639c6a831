/* smooth_command.h: words of the command line, for the programs that lay surfaces. */
#ifndef SMOOTH_COMMAND_H
#define SMOOTH_COMMAND_H

#include "smooth.h"

/* Defined by each program: the lines that tell its usage. */
extern const char usage[];

/* What is asked for where no option says otherwise. */
request request_plain(void);

/* Prints the reason and the usage; ends the program with 2. */
void misuse(const char *format, ...);

/* To stdout, and the end of the program. */
void print_and_exit(const char *text);

/* The value of an option as a number from lo to hi, a whole one; a length, or so many percent. */
n3_real option_number(const char *option, const char *value, double lo, double hi);
int option_whole(const char *option, const char *value, int lo, int hi);
void option_tolerance(request *r, const char *option, const char *value);

#endif
