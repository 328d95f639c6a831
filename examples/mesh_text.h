/* mesh_text.h: a cursor through a file of lines and tokens, for the readers. */
#ifndef MESH_TEXT_H
#define MESH_TEXT_H

#include "mesh.h"

typedef struct text {
    const char *file;
    const char *start, *at, *end; /* *end may be read */
    const char *token;            /* where the last one begins: the place of messages */
    int plain;     /* # begins no comment and a backslash joins no lines: they are part of tokens */
    int order;     /* of the bytes of numbers; AS_TEXT: they are tokens */
    size_t offset; /* in the file, of the start */
    int base64;    /* the bytes stand in it four for three */
} text;

typedef struct token {
    const char *at;
    size_t length;
} token;

/* Lines may end in CR LF, LF or CR. A byte order mark is passed over. */
text text_open(const char *file, const char *data, size_t size);

/* Stops the program: file and line, or the byte where numbers are bytes, and the reason. */
void text_fail(const text *t, const char *format, ...);

/* The same with "'token' reason". */
void text_refuse(const text *t, token k, const char *reason);

/* Skips blanks, and line ends behind a backslash. True if a token follows on the line; a comment
   from # on is none. */
int text_more(text *t);

/* The next token of the line; at its end, one of length 0. */
token text_token(text *t);

/* The next token, on this line or a later one; at the end of the text, one of length 0. */
token text_word(text *t);

/* The rest of the line, without the blanks round it. */
token text_line(text *t);

/* To the start of the next line. False at the end of the text. */
int text_next_line(text *t);

/* True if the token is the word, which is in lower case; the token may be in any case. */
int token_is(token k, const char *word);

/* The next word must be this one. */
void text_expect(text *t, const char *word);

/* The next token of the line as a finite number, or the end of the program. */
n3_real text_number(text *t);
n3_vec text_vec(text *t);

/* The next word as a number, which may be infinite or none; as an integer. */
double text_value(text *t);
double text_whole(text *t);

/* The next word as an integer from 0 to most. */
int text_count(text *t, int most);

/* Reads an integer and moves *at behind it; false if there is none. Beyond the range of an int the
   answer is its end. */
int text_integer(const char **at, const char *end, int *i);

#endif
