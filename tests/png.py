"""A PNG file as its chunks and pixels, by zlib alone; every checksum is checked."""
import struct
import zlib


def unfilter(data, width, height, depth):
    """The rows without their filters; width in bytes."""
    rows, before = [], bytearray(width)
    for y in range(height):
        kind, *row = data[y * (width + 1):(y + 1) * (width + 1)]
        assert kind < 5, f"filter {kind}"
        for x in range(width if kind else 0):
            a = row[x - depth] if x >= depth else 0
            b = before[x]
            c = before[x - depth] if x >= depth else 0
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[x] = row[x] + (0, a, b, (a + b) // 2, nearest)[kind] & 255
        before = row
        rows.append(bytes(row))
    return rows


def read(data):
    """width, height, rows of RGB, the compressed and the expanded rows of the file."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no signature"
    at, chunks = 8, {}
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0] == zlib.crc32(name + body)
        chunks[name] = chunks.get(name, b"") + body
        at += 12 + size
    assert name == b"IEND" and at == len(data), "the end is not at the end"
    width, height, bits, kind = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    assert bits == 8 and kind in (0, 2, 3, 6)
    depth = {0: 1, 2: 3, 3: 1, 6: 4}[kind]
    plain = zlib.decompress(chunks[b"IDAT"])
    assert len(plain) == height * (width * depth + 1)
    rows = unfilter(plain, width * depth, height, depth)
    if kind == 0:
        rows = [bytes(v for v in row for _ in range(3)) for row in rows]
    if kind == 3:
        colours = chunks[b"PLTE"]
        rows = [b"".join(colours[3 * v:3 * v + 3] for v in row) for row in rows]
    if kind == 6:
        rows = [b"".join(row[4 * x:4 * x + 3] for x in range(width)) for row in rows]
    return width, height, rows, chunks[b"IDAT"], plain
