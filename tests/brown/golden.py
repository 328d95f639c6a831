#!/usr/bin/env python3
"""golden.py > golden.csv: Brown's squares in exact fractions.

Equation (1) as it stands, with the quotient rule: near a corner that loses every digit of a
floating-point number, and none of a fraction. A row: the square's seed and kind, u, v, then the
point, du, dv, duu, duv, dvv. square_make() of square.c makes the same squares from the seeds."""
from fractions import Fraction as F

COMPATIBLE, REMAINDERS, INCOMPATIBLE = range(3)
MASK = 2**64 - 1


class Rng:
    def __init__(self, state):
        self.state = state

    def next(self):
        self.state = z = (self.state + 0x9E3779B97F4A7C15) & MASK
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9 & MASK
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB & MASK
        return z ^ (z >> 31)

    def vec(self):
        return [F(self.next() % 33 - 16, 8) for _ in range(3)]


def square(seed, kind):
    """Bezier points of the four sides, and of h and r of the four fields."""
    r = Rng(seed)
    corner = [r.vec() for _ in range(4)]  # x00 x10 x01 x11
    ends = ((0, 1), (2, 3), (0, 2), (1, 3))
    side = [[corner[i], r.vec(), r.vec(), corner[j]] for i, j in ends]
    field = []
    for k in range(4):
        cross, end = (2, 0)[k > 1], k % 2
        h = [None, r.vec(), r.vec(), None]
        for i in range(2):
            p = side[cross + i][2 * end : 2 * end + 2]
            h[3 * i] = [3 * (q - o) for o, q in zip(*p)]
        if kind == INCOMPATIBLE:
            h[0], h[3] = r.vec(), r.vec()
        rest = [r.vec() if kind == REMAINDERS else [F(0)] * 3 for _ in range(4)]
        field.append((h, rest))
    return side, field


class Jet:
    """A number with its derivatives: x, du, dv, duu, duv, dvv."""

    def __init__(self, *c):
        self.c = c if len(c) == 6 else (c[0], 0, 0, 0, 0, 0)

    def __add__(self, o):
        return Jet(*(a + b for a, b in zip(self.c, o.c)))

    def __sub__(self, o):
        return Jet(*(a - b for a, b in zip(self.c, o.c)))

    def __mul__(self, o):
        a, au, av, auu, auv, avv = self.c
        b, bu, bv, buu, buv, bvv = o.c
        return Jet(a * b, au * b + a * bu, av * b + a * bv, auu * b + 2 * au * bu + a * buu,
                   auv * b + au * bv + av * bu + a * buv, avv * b + 2 * av * bv + a * bvv)

    def reciprocal(self):
        a, u, v, uu, uv, vv = self.c
        return Jet(1 / a, -u / a**2, -v / a**2, 2 * u * u / a**3 - uu / a**2,
                   2 * u * v / a**3 - uv / a**2, 2 * v * v / a**3 - vv / a**2)


ONE, TWO, THREE = Jet(1), Jet(2), Jet(3)


def bezier(p, t, k):
    s = ONE - t
    w = (s * s * s, THREE * s * s * t, THREE * s * t * t, t * t * t)
    return sum((w[i] * Jet(p[i][k]) for i in range(4)), Jet(0))


def brown(side, field, u, v, k):
    u, v = Jet(u, 1, 0, 0, 0, 0), Jet(v, 0, 1, 0, 0, 0)
    a, b = u * (ONE - u), v * (ONE - v)

    def loft(first, t, w):
        s = ONE - w
        h = (s * s * (ONE + TWO * w), w * w * (ONE + TWO * s), s * s * w, Jet(0) - w * w * s)
        c = [bezier(side[first + i], t, k) for i in range(2)]
        edge = t * (ONE - t)
        c += [bezier(f, t, k) + edge * edge * bezier(r, t, k) for f, r in field[first : first + 2]]
        return sum((x * y for x, y in zip(h, c)), Jet(0))

    whole = (a * a + b * b).reciprocal()
    return (b * b * whole * loft(2, v, u) + a * a * whole * loft(0, u, v)).c


def places():
    """Inside, then 2^-40 (for floats 2^-20) from each corner in several directions."""
    for i in range(1, 8, 2):
        for j in range(1, 8, 3):
            yield F(i, 8), F(j, 8)
    for e in (F(1, 2**40), F(1, 2**20)):
        for c in range(4):
            for i, j in ((1, 1), (1, 3), (2, 1), (0, 1), (1, 0), (1, 2**12)):
                yield abs(c % 2 - i * e), abs(c // 2 - j * e)


def main():
    for seed in range(12):
        side, field = square(seed, seed % 3)
        for n, (u, v) in enumerate(places()):
            if n % 4 != seed % 4:
                continue
            values = [brown(side, field, u, v, k) for k in range(3)]
            row = [float(values[k][q]) for q in range(6) for k in range(3)]
            print(",".join([str(seed), str(seed % 3)] + ["%.17g" % x for x in (u, v, *row)]))


if __name__ == "__main__":
    main()
