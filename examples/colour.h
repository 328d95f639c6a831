/* colour.h: colours by how they look. */
#ifndef COLOUR_H
#define COLOUR_H

/* Linear light in the primaries of sRGB, each 0 to 1 where a screen can show it. */
typedef struct colour { double r, g, b; } colour;

/* From OKLab (Ottosson 2020): lightness 0 to 1, a from green to red, b from blue to yellow. Equal
   distances in it look about equally large. */
colour colour_oklab(double L, double a, double b);
void colour_to_oklab(colour c, double lab[3]);

/* From and to the bytes of sRGB; colours that no screen can show go to the nearest byte. */
colour colour_srgb(int r, int g, int b);
void colour_bytes(colour c, unsigned char rgb[3]);

colour colour_mix(colour a, double t, colour b); /* a + t (b - a), in light */

/* Colour maps. Both run through OKLab at constant speed, within what a screen can show:

       sequential   t in [0, 1]    a helix of constant chroma from dark blue by green to yellow
       diverging    t in [-1, 1]   blue, nearly white at 0, orange: one straight line on each side,
                                   equally long and equally steep in lightness

   t outside is taken to the nearer end. */
colour colour_sequential(double t);
colour colour_diverging(double t);

#endif
