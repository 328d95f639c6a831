#include "colour.h"

#include <math.h>

static const double degree = 3.14159265358979323846 / 180;

/* Rows of the matrices of Ottosson's "A perceptual color space for image processing". */
colour colour_oklab(double L, double a, double b)
{
    double l = pow(L + 0.3963377774 * a + 0.2158037573 * b, 3);
    double m = pow(L - 0.1055613458 * a - 0.0638541728 * b, 3);
    double s = pow(L - 0.0894841775 * a - 1.2914855480 * b, 3);
    colour c;
    c.r = 4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s;
    c.g = -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s;
    c.b = -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s;
    return c;
}

void colour_to_oklab(colour c, double lab[3])
{
    double l = cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
    double m = cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
    double s = cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
    lab[0] = 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
    lab[1] = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    lab[2] = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
}

static double linear(int byte)
{
    double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

static unsigned char encoded(double x)
{
    double y = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
    return (unsigned char)(y > 0 ? y < 1 ? floor(255 * y + 0.5) : 255 : 0);
}

colour colour_srgb(int r, int g, int b)
{
    colour c;
    c.r = linear(r);
    c.g = linear(g);
    c.b = linear(b);
    return c;
}

void colour_bytes(colour c, unsigned char rgb[3])
{
    rgb[0] = encoded(c.r);
    rgb[1] = encoded(c.g);
    rgb[2] = encoded(c.b);
}

colour colour_mix(colour a, double t, colour b)
{
    a.r += t * (b.r - a.r);
    a.g += t * (b.g - a.g);
    a.b += t * (b.b - a.b);
    return a;
}

static colour from_hue(double L, double chroma, double hue)
{
    return colour_oklab(L, chroma * cos(hue * degree), chroma * sin(hue * degree));
}

/* Speed: the lightness rises by 0.6 and the hue turns by 180 degrees at chroma 0.095. */
colour colour_sequential(double t)
{
    t = t > 0 ? t < 1 ? t : 1 : 0;
    return from_hue(0.32 + 0.6 * t, 0.095, 285 - 180 * t);
}

colour colour_diverging(double t)
{
    double size = fabs(t) < 1 ? fabs(t) : 1;
    return from_hue(0.97 - 0.45 * size, 0.125 * size, t < 0 ? 255 : 55);
}
