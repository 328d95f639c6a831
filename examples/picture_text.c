/* Letters made of strokes, so that they have every size. */
#include "picture.h"

#include <string.h>

/* A glyph is its character and then its strokes: points as pairs of digits, x to the right and y
   upwards, 2 on the baseline, 6 the height of small letters, 8 that of capitals. */
static const char *const glyphs[] = {"a3632 3526160503122233",
                                     "b0802 0516263533221203",
                                     "c3526160503122233",
                                     "d3832 3526160503122233",
                                     "e04343526160503122233",
                                     "f12172838 0626",
                                     "g3631201001 3526160503122233",
                                     "h0802 0516263532",
                                     "i0602 0808",
                                     "j161100 1818",
                                     "k0802 360432",
                                     "l080312",
                                     "m0206 05162522 25364542",
                                     "n0206 0516263532",
                                     "o162635332212030516",
                                     "p0600 0516263533221203",
                                     "q3630 3526160503122233",
                                     "r0206 05162635",
                                     "s35261605142433221203",
                                     "t18132232 0626",
                                     "u0603122233 3632",
                                     "v062246",
                                     "w0612253246",
                                     "x0632 0236",
                                     "y0622 462210",
                                     "z06360232",
                                     "A022842 1535",
                                     "B02082837362505 2534332202",
                                     "C4738180703123243",
                                     "D02082846442202",
                                     "E38080232 0525",
                                     "F380802 0525",
                                     "G47381807031232434525",
                                     "H0802 4842 0545",
                                     "I0802",
                                     "J3833221203",
                                     "K0802 480542",
                                     "L080232",
                                     "M0208254842",
                                     "N02084248",
                                     "O183847433212030718",
                                     "P02082837362505",
                                     "Q183847433212030718 2442",
                                     "R02082837362505 1532",
                                     "S372818070615253433221203",
                                     "T0848 2822",
                                     "U080312324348",
                                     "V082248",
                                     "W0812263248",
                                     "X0842 0248",
                                     "Y082548 2522",
                                     "Z08480242",
                                     "0182837332212030718",
                                     "10718120222",
                                     "207182837360232",
                                     "307182837362515 2534332212 1203",
                                     "422280434",
                                     "5380805253433221203",
                                     "63728180703122233342505",
                                     "7083812",
                                     "815060718283736251504031222333425",
                                     "90312223337281807061535",
                                     ".0202",
                                     ",0201",
                                     ":0202 0505",
                                     "'0807",
                                     "-0434",
                                     "+0444 2226",
                                     "/0139",
                                     "=0333 0535",
                                     "(19070311",
                                     ")09171301"};

static const char *find_glyph(char c)
{
    size_t i;
    for (i = 0; i < sizeof glyphs / sizeof *glyphs; i++)
        if (glyphs[i][0] == c) return glyphs[i] + 1;
    return "";
}

/* In the units of the strokes, with the gap to the next one; a character without strokes is a
   space. */
static int advance(const char *glyph)
{
    int widest = 0;
    if (!*glyph) return 3;
    for (; *glyph; glyph += glyph[0] == ' ' ? 1 : 2)
        if (*glyph != ' ' && *glyph - '0' > widest) widest = *glyph - '0';
    return widest + 2;
}

static void draw_glyph(picture *p, double x, double y, double unit, colour c, const char *glyph)
{
    double before[2] = {0, 0};
    int begun = 0;
    for (; *glyph; glyph += begun ? 2 : 1) {
        double at[2];
        if (*glyph == ' ') {
            begun = 0;
            continue;
        }
        at[0] = x + unit * (glyph[0] - '0');
        at[1] = y - unit * (glyph[1] - '2');
        if (begun) picture_line(p, before[0], before[1], at[0], at[1], 0.8 * unit, c);
        memcpy(before, at, sizeof at);
        begun = 1;
    }
}

double picture_text(picture *p, double x, double y, double size, int align, colour c,
                    const char *text)
{
    double unit = size / 6, width = -2 * unit;
    const char *s;
    for (s = text; *s; s++) width += unit * advance(find_glyph(*s));
    x -= width * (align + 1) / 2;
    for (s = text; *s; s++) {
        draw_glyph(p, x, y, unit, c, find_glyph(*s));
        x += unit * advance(find_glyph(*s));
    }
    return width;
}
