#!/usr/bin/env python3
"""Enlarges an 8-bit RGB PNG by an integer factor, each pixel to a square, so that single pixels can be seen on a page.

usage: enlarge.py FACTOR FILE.png    (the file is replaced)
"""
import struct
import sys
import zlib


def read_rows(data):
    """Width, height and the rows of an 8-bit RGB PNG, as bytes."""
    header, packed, at = None, b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    width, height, depth, color, _, _, interlace = header
    if (depth, color, interlace) != (8, 2, 0):
        sys.exit("enlarge.py: not an 8-bit RGB picture")
    raw, stride = zlib.decompress(packed), 3 * width
    rows, above = [], bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for x in range(stride):
            left, up, corner = (row[x - 3] if x >= 3 else 0), above[x], (above[x - 3] if x >= 3 else 0)
            if kind == 1:
                predicted = left
            elif kind == 2:
                predicted = up
            elif kind == 3:
                predicted = (left + up) // 2
            elif kind == 4:  # Paeth: the neighbour nearest to left + up - corner
                guess = left + up - corner
                predicted = min((left, up, corner), key=lambda value: abs(guess - value))
            else:
                predicted = 0
            row[x] = (row[x] + predicted) & 255
        rows.append(bytes(row))
        above = row
    return width, height, rows


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def main():
    factor, path = int(sys.argv[1]), sys.argv[2]
    with open(path, "rb") as file:
        width, height, rows = read_rows(file.read())
    large = b""
    for row in rows:
        wide = b"".join(row[x:x + 3] * factor for x in range(0, 3 * width, 3))
        large += (b"\0" + wide) * factor
    header = struct.pack(">IIBBBBB", width * factor, height * factor, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(large, 9)) +
                   chunk(b"IEND", b""))


main()
