/* mesh_text.h: a cursor through a text of lines and tokens, for the readers of text files. */
#ifndef MESH_TEXT_H
#define MESH_TEXT_H

#include "mesh.h"

typedef struct text {
    const char *file;
    const char *at, *end; /* *end is a zero byte */
    long line;
} text;

typedef struct token {
    const char *at;
    size_t length;
} token;

/* Lines may end in CR LF, LF or CR; the data are rewritten in place to LF. */
text text_open(const char *file, char *data, size_t size);

/* Skips blanks, and line ends behind a backslash. True if a token follows on the line; a comment
   from # on is none. */
int text_more(text *t);

/* The next token of the line; at its end, one of length 0. */
token text_token(text *t);

/* To the start of the next line. False at the end of the text. */
int text_next_line(text *t);

/* True if the token is the word, which is in lower case; the token may be in any case. */
int token_is(token k, const char *word);

/* Stops the program: "'token' reason". */
void text_refuse(const text *t, token k, const char *reason);

/* The next token as a finite number, or the end of the program. */
n3_real text_number(text *t);
n3_vec text_vec(text *t);

/* Reads an integer and moves *at behind it; false if there is none. Beyond the range of an int the
   answer is its end. */
int text_integer(const char **at, const char *end, int *i);

#endif
