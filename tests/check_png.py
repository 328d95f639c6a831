"""check_png.py FILE.png...: the files are valid and hardly larger than zlib makes them at its best.
check_png.py --same DIR1 DIR2: two galleries show the same. SVG: byte for byte. PNG: all but one in
a thousand of the pixels within 8 of 255, as roundings move the sides of stripes."""
import pathlib
import sys
import zlib

import png


def check_file(path):
    _, _, _, packed, plain = png.read(path.read_bytes())
    best = len(zlib.compress(plain, 9))
    assert len(packed) <= 1.02 * best + 64, f"{path}: {len(packed)} bytes, zlib {best}"


def check_same(one, two):
    if one.suffix != ".png":
        assert one.read_bytes() == two.read_bytes(), f"{one} and {two} differ"
        return
    a, b = (png.read(path.read_bytes()) for path in (one, two))
    assert a[:2] == b[:2], f"{one} and {two} are not of one size"
    off = sum(abs(x - y) > 8 for p, q in zip(a[2], b[2]) for x, y in zip(p, q) if p != q)
    assert off <= 3 * a[0] * a[1] / 1000, f"{one} and {two}: {off} samples differ"


def main(arguments):
    if arguments[0] != "--same":
        for name in arguments:
            check_file(pathlib.Path(name))
        return
    one, two = (sorted(pathlib.Path(name).iterdir()) for name in arguments[1:])
    assert [p.name for p in one] == [p.name for p in two], "not the same files"
    for a, b in zip(one, two):
        check_same(a, b)
    assert sum(p.stat().st_size for p in one) < 1 << 20, "more than 1 MB"


main(sys.argv[1:])
