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

/* The value of an option as a number from lo to hi, a whole one. */
n3_real option_number(const char *option, const char *value, double lo, double hi);
int option_whole(const char *option, const char *value, int lo, int hi);

/* The value as a length, or with % of a diagonal. */
void option_tolerance(request *r, const char *option, const char *value);

/* Options that say what to write: those without and those with a value. False if it is none. */
int request_switch(request *r, const char *a);
int request_value(request *r, const char *a, const char *value);

/* Once all are read. squares: some of the surface is Brown's. */
void request_check(const request *r, int squares);

#endif
