"""Reads the pictures the program writes, with nothing but Python."""

import struct
import zlib


class Picture:
    """Rows from the top; pixels are tuples of R, G, B, A."""

    def __init__(self, rows):
        self.rows = rows
        self.height = len(rows)
        self.width = len(rows[0])

    def at(self, x, y):
        return self.rows[y][x]

    def centre(self):
        return self.at(self.width // 2, self.height // 2)

    def pixels(self):
        return (pixel for row in self.rows for pixel in row)

    def covered(self):
        return [pixel for pixel in self.pixels() if pixel[3] > 0]


def read_png(data):
    """Eight bits, RGB with or without alpha (PNG specification, filters of section 9)."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    position, packed = 8, b""
    while position < len(data):
        length, = struct.unpack_from(">I", data, position)
        kind, body = data[position + 4:position + 8], data[position + 8:position + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack_from(">I", data, position + 8 + length)[0]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack_from(">IIBB", body)
        packed += body if kind == b"IDAT" else b""
        position += 12 + length
    assert depth == 8 and colour in (2, 6)
    channels = 4 if colour == 6 else 3
    raw, stride = zlib.decompress(packed), width * channels
    rows, above = [], bytes(stride)
    for y in range(height):
        begin = y * (stride + 1)
        line = unfiltered(raw[begin], raw[begin + 1:begin + 1 + stride], above, channels)
        rows.append([(*line[x:x + 3], line[x + 3] if channels == 4 else 255) for x in range(0, stride, channels)])
        above = line
    return Picture(rows)


def unfiltered(kind, line, above, channels):
    if kind == 0:
        return line
    if kind == 2:
        return bytes((value + up) & 255 for value, up in zip(line, above))
    padding = bytes(channels)
    line = bytearray(padding) + line
    for i, (up, corner) in enumerate(zip(above, padding + above), channels):
        left = line[i - channels]
        if kind == 1:
            add = left
        elif kind == 3:
            add = (left + up) // 2
        else:
            to_left, to_up, to_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
            add = left if to_left <= to_up and to_left <= to_corner else up if to_up <= to_corner else corner
        line[i] = (line[i] + add) & 255
    return bytes(line[channels:])


def note_of_png(data):
    """The text "Opaline" (PNG specification, section 11.3.4.3)."""
    position = 8
    while position < len(data):
        length, = struct.unpack_from(">I", data, position)
        kind, body = data[position + 4:position + 8], data[position + 8:position + 8 + length]
        if kind == b"tEXt" and body.startswith(b"Opaline\0"):
            return body[8:].decode("ascii")
        position += 12 + length
    return None


def note_of_exr(data):
    """The attribute "opaline"."""
    position = 8
    while data[position]:
        name, kind, rest = data[position:].split(b"\0", 2)
        size, = struct.unpack_from("<I", rest)
        if (name, kind) == (b"opaline", b"string"):
            return rest[4:4 + size].decode("ascii")
        position += len(name) + len(kind) + 6 + size
    return None


def read_exr(data):
    """Scanlines, ZIP in blocks of 16, float channels (OpenEXR file layout); asserts that it is so."""
    assert data[:4] == b"\x76\x2f\x31\x01" and struct.unpack_from("<I", data, 4)[0] == 2
    position, attributes = 8, {}
    while data[position]:
        name, kind, rest = data[position:].split(b"\0", 2)
        position += len(name) + len(kind) + 2
        size, = struct.unpack_from("<I", data, position)
        attributes[name.decode()] = data[position + 4:position + 4 + size]
        position += 4 + size
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    assert attributes["compression"] == b"\3", "ZIP, 16 lines"
    names = [entry for entry in channel_names(attributes["channels"])]
    assert names == ["A", "B", "G", "R"], names
    rows = []
    offsets = struct.unpack_from(f"<{-(-height // 16)}Q", data, position + 1)
    for offset in offsets:
        _, size = struct.unpack_from("<iI", data, offset)
        lines = min(16, height - len(rows))
        values = struct.unpack(f"<{lines * width * 4}f",
                               unpacked(data[offset + 8:offset + 8 + size], lines * width * 16))
        for line in range(lines):
            a, b, g, r = (values[(line * 4 + c) * width:(line * 4 + c + 1) * width] for c in range(4))
            rows.append(list(zip(r, g, b, a)))
    return Picture(rows)


def channel_names(data):
    position = 0
    while data[position]:
        name = data[position:].split(b"\0", 1)[0]
        kind, = struct.unpack_from("<I", data, position + len(name) + 1)
        assert kind == 2, "float"
        yield name.decode()
        position += len(name) + 1 + 16


def unpacked(block, size):
    """Deflate, then undo the differences, then the two interleaved halves."""
    if len(block) == size:
        return block
    data = bytearray(zlib.decompress(block))
    for i in range(1, len(data)):
        data[i] = (data[i - 1] + data[i] - 128) & 255
    half = (len(data) + 1) // 2
    result = bytearray(len(data))
    result[0::2], result[1::2] = data[:half], data[half:]
    return bytes(result)


def write_png(rows):
    """Eight bits, RGB or RGB with alpha, unfiltered."""
    channels = len(rows[0][0])
    raw = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in rows)
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, {3: 2, 4: 6}[channels], 0, 0, 0)),
              (b"IDAT", zlib.compress(raw)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in chunks)


def write_exr(rows):
    """Float channels R G B A, scanlines, not compressed (OpenEXR file layout)."""
    width, height = len(rows[0]), len(rows)
    channels = b"".join(name + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in (b"A", b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = b"\x76\x2f\x31\x01" + struct.pack("<I", 2)
    for name, kind, value in [
            (b"channels", b"chlist", channels), (b"compression", b"compression", b"\0"),
            (b"dataWindow", b"box2i", window), (b"displayWindow", b"box2i", window), (b"lineOrder", b"lineOrder", b"\0"),
            (b"pixelAspectRatio", b"float", struct.pack("<f", 1)), (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)),
            (b"screenWindowWidth", b"float", struct.pack("<f", 1))]:
        header += name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value
    header += b"\0"
    size = 16 * width
    first = len(header) + 8 * height
    table = b"".join(struct.pack("<Q", first + y * (8 + size)) for y in range(height))
    lines = b"".join(struct.pack("<iI", y, size) +
                     b"".join(struct.pack(f"<{width}f", *(pixel[c] for pixel in row)) for c in (3, 2, 1, 0))
                     for y, row in enumerate(rows))
    return header + table + lines
