"""ICC profiles and a font of our own, for make.py. Only Python's own library is used."""
import struct


def s15(value):
    return struct.pack(">i", round(value * 65536))


def xyz(values):
    return b"XYZ \0\0\0\0" + b"".join(s15(v) for v in values)


def gamma(value):
    return b"curv\0\0\0\0" + struct.pack(">IH", 1, round(value * 256)) + b"\0\0"


def text(words):
    words = words.encode()
    desc = b"desc\0\0\0\0" + struct.pack(">I", len(words) + 1) + words + b"\0"
    desc += b"\0" * (4 + 4 + 2 + 1 + 67)
    return desc + b"\0" * (-len(desc) % 4)


def profile(kind, space, pcs, tags):
    tags = [(b"desc", text("test profile")), (b"cprt", b"text\0\0\0\0none\0\0\0\0"), (b"wtpt", xyz(D50))] + tags
    table, data, at = b"", b"", 128 + 4 + 12 * len(tags)
    for name, body in tags:
        table += name + struct.pack(">II", at + len(data), len(body))
        data += body
    rest = struct.pack(">I", len(tags)) + table + data
    head = struct.pack(">I4sI4s4s4s", 128 + len(rest), b"\0" * 4, 0x02400000, kind, space, pcs)
    head += struct.pack(">6H", 2026, 1, 1, 0, 0, 0) + b"acsp" + b"\0" * 28 + b"".join(s15(v) for v in D50)
    return head.ljust(128, b"\0") + rest


D50 = (0.9642, 1.0, 0.8249)
# The colours of sRGB as its own profile has them (adapted to D50).
RED, GREEN, BLUE = (0.4360, 0.2225, 0.0139), (0.3851, 0.7169, 0.0971), (0.1431, 0.0606, 0.7139)


def swapped():
    """RGB whose red channel drives green, green drives blue and blue drives red; gamma 1.8."""
    colours = [(b"rXYZ", xyz(GREEN)), (b"gXYZ", xyz(BLUE)), (b"bXYZ", xyz(RED))]
    return profile(b"mntr", b"RGB ", b"XYZ ", colours + [(n, gamma(1.8)) for n in (b"rTRC", b"gTRC", b"bTRC")])


def grey(exponent):
    return profile(b"mntr", b"GRAY", b"XYZ ", [(b"kTRC", gamma(exponent))])


def lab(rgb):
    """Linear sRGB to the 16-bit Lab of version 2 profiles."""
    value = [sum(c[i] * v for c, v in zip((RED, GREEN, BLUE), rgb)) / D50[i] for i in range(3)]
    f = [v ** (1 / 3) if v > 0.008856 else 7.787 * v + 16 / 116 for v in value]
    numbers = (116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2]))
    codes = (numbers[0] * 652.8, (numbers[1] + 128) * 256, (numbers[2] + 128) * 256)
    return struct.pack(">3H", *(min(65535, max(0, round(c))) for c in codes))


def table_profile(kind, space, channels, colour):
    """A profile made of a table with two entries for each channel; `colour` gives the linear sRGB of a corner."""
    body = b"mft2\0\0\0\0" + bytes([channels, 3, 2, 0])
    body += b"".join(s15(v) for v in (1, 0, 0, 0, 1, 0, 0, 0, 1)) + struct.pack(">HH", 2, 2)
    body += struct.pack(">HH", 0, 65535) * channels
    for corner in range(2 ** channels):
        body += lab(colour([corner >> (channels - 1 - i) & 1 for i in range(channels)]))
    body += struct.pack(">HH", 0, 65535) * 3
    return profile(kind, space, b"Lab ", [(b"A2B0", body)])


def inks():
    """CMYK whose first ink is yellow, second cyan and third magenta."""
    return table_profile(
        b"prtr", b"CMYK", 4, lambda c: [(1 - c[1]) * (1 - c[3]), (1 - c[2]) * (1 - c[3]), (1 - c[0]) * (1 - c[3])]
    )


def scanner():
    """RGB made of a table; red drives green, green drives blue and blue drives red."""
    return table_profile(b"scnr", b"RGB ", 3, lambda c: [c[2], c[0], c[1]])


def font():
    """A TrueType font named Block whose letter A is a full square of one em."""
    square = struct.pack(">hhhhh", 1, 0, 0, 1000, 1000) + struct.pack(">HH", 3, 0) + b"\x01" * 4
    square += struct.pack(">4h", 0, 0, 1000, 0) + struct.pack(">4h", 0, 1000, 0, -1000)
    glyphs = square  # glyph 0 is empty, glyph 1 the square
    names = [(1, "Block"), (2, "Regular"), (4, "Block"), (6, "Block")]
    strings = [(n, t.encode("utf-16-be")) for n, t in names]
    records, store = b"", b""
    for n, s in strings:
        records += struct.pack(">6H", 3, 1, 0x409, n, len(s), len(store))
        store += s
    cmap = struct.pack(">HHHHI", 0, 1, 3, 1, 12)
    cmap += struct.pack(">8H", 4, 32, 0, 4, 4, 1, 0, 65) + struct.pack(">HHHH", 0xFFFF, 0, 65, 0xFFFF)
    cmap += struct.pack(">hhHH", 1 - 65, 1, 0, 0)
    os2 = struct.pack(">HhHHH", 4, 1000, 400, 5, 0) + struct.pack(">11h", *[0] * 11) + b"\0" * 10
    os2 += struct.pack(">4I", 1, 0, 0, 0) + b"TEST" + struct.pack(">3H", 0x40, 65, 65)
    os2 += struct.pack(">3hHH", 1000, 0, 0, 1000, 0) + struct.pack(">2I", 1, 0) + struct.pack(">hhHHH", 500, 1000, 0, 32, 1)
    tables = {
        b"OS/2": os2,
        b"cmap": cmap,
        b"glyf": glyphs,
        b"head": struct.pack(">IIIIHH", 0x10000, 0x10000, 0, 0x5F0F3CF5, 0, 1000) + b"\0" * 16
        + struct.pack(">4hHHhhh", 0, 0, 1000, 1000, 0, 8, 2, 0, 0),
        b"hhea": struct.pack(">IhhhH", 0x10000, 1000, 0, 0, 1000) + b"\0" * 22 + struct.pack(">H", 2),
        b"hmtx": struct.pack(">HhHh", 1000, 0, 1000, 0),
        b"loca": struct.pack(">HHH", 0, 0, len(glyphs) // 2),
        b"maxp": struct.pack(">IHHHHH", 0x10000, 2, 4, 1, 0, 0) + struct.pack(">HHHHHHHHH", 2, 0, 0, 0, 0, 0, 0, 0, 0),
        b"name": struct.pack(">HHH", 0, len(strings), 6 + len(records)) + records + store,
        b"post": struct.pack(">I", 0x30000) + b"\0" * 28,
    }
    head = struct.pack(">IHHHH", 0x10000, len(tables), 128, 3, len(tables) * 16 - 128)
    at, out, body = 12 + 16 * len(tables), b"", b""
    for name, data in tables.items():
        out += name + struct.pack(">III", 0, at + len(body), len(data))
        body += data + b"\0" * (-len(data) % 4)
    return head + out + body
