/* mesh_xml.h: the tags of an XML file, one after another. */
#ifndef MESH_XML_H
#define MESH_XML_H

#include "mesh_text.h"

typedef struct tag {
    token name, attributes;
    int end, empty; /* </name>, <name/> */
} tag;

/* Moves behind the next tag, over text, comments and instructions; it becomes the place of
   messages. False if there is none. */
int xml_next(text *t, tag *g);

/* The value of an attribute as it stands there; of length 0 if there is none. */
token xml_attribute(const tag *g, const char *name);

/* The text of a value, with the five entities of XML decoded: from allocate(). */
char *xml_decode(token value);

#endif
