"""Makes the test pictures of this folder. Needs cjpeg (libjpeg-turbo) and convert (ImageMagick 6) with WebP and TIFF.

    python3 make.py

All of them show the same scene of 64 x 32 pixels, if README.md says nothing else: red, green, blue and grey, each in a
quarter (from the top left, row by row). What can be written byte by byte is, so that what a file says is known.
"""
import struct
import subprocess
import zlib

import profiles

W, H = 64, 32
SCENE = [(200, 40, 40), (40, 160, 60), (40, 60, 200), (128, 128, 128)]


def at(x, y, w=W, h=H):
    return SCENE[(x * 2 // w) + 2 * (y * 2 // h)]


def pixels(change=lambda c: c, w=W, h=H):
    return [[change(at(x, y, w, h)) for x in range(w)] for y in range(h)]


def save(name, data):
    open(name, "wb").write(data)


def run(*command, stdin=None):
    return subprocess.run(command, input=stdin, stdout=subprocess.PIPE, check=True).stdout


def ppm(rows):
    return b"P6\n%d %d\n255\n" % (len(rows[0]), len(rows)) + b"".join(bytes(p) for r in rows for p in r)


def luma(c):
    return round(0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2])


def exif(orientation, order=">"):
    mark = b"MM\0*" if order == ">" else b"II*\0"
    # One entry: orientation, a short.
    return mark + struct.pack(order + "IHHHIHHI", 8, 1, 0x0112, 3, 1, orientation, 0, 0)


def stored(orientation, w=W, h=H):
    """The scene as a file of an orientation holds it: a viewer shows the file's (x, y) at `shown`."""
    shown = {
        1: lambda x, y: (x, y), 2: lambda x, y: (w - 1 - x, y), 3: lambda x, y: (w - 1 - x, h - 1 - y),
        4: lambda x, y: (x, h - 1 - y), 5: lambda x, y: (y, x), 6: lambda x, y: (w - 1 - y, x),
        7: lambda x, y: (w - 1 - y, h - 1 - x), 8: lambda x, y: (y, h - 1 - x),
    }[orientation]
    across, down = (w, h) if orientation < 5 else (h, w)
    return [[at(*shown(x, y)) for x in range(across)] for y in range(down)]


# JPEG ---------------------------------------------------------------------------------------------------------------


def after_start(jpeg, *segments):
    """Puts segments (kind, data) behind the start mark."""
    new = b"".join(bytes([0xFF, kind]) + struct.pack(">H", len(data) + 2) + data for kind, data in segments)
    return jpeg[:2] + new + jpeg[2:]


def icc_segments(icc):
    return (0xE2, b"ICC_PROFILE\0\x01\x01" + icc)


def flat_jpeg(colours, segments=()):
    """A baseline JPEG of four flat quarters, written here so that nothing converts its numbers. `colours` are the four
    stored pixels, of one to four channels."""
    channels = len(colours[0])
    out = b"\xFF\xD8"
    out += b"".join(bytes([0xFF, kind]) + struct.pack(">H", len(data) + 2) + data for kind, data in segments)
    out += b"\xFF\xDB\0\x43\0" + b"\x01" * 64
    out += b"\xFF\xC0" + struct.pack(">HBHHB", 8 + 3 * channels, 8, H, W, channels)
    out += b"".join(bytes([i + 1, 0x11, 0]) for i in range(channels))
    # All twelve sizes of a difference have codes of four bits; the end of a block is the one code of the second table.
    out += b"\xFF\xC4" + struct.pack(">H", 2 + 17 + 12) + b"\0" + bytes([0, 0, 0, 12] + [0] * 12) + bytes(range(12))
    out += b"\xFF\xC4" + struct.pack(">H", 2 + 17 + 1) + b"\x10" + bytes([1] + [0] * 15) + b"\0"
    out += b"\xFF\xDA" + struct.pack(">HB", 6 + 2 * channels, channels)
    out += b"".join(bytes([i + 1, 0]) for i in range(channels)) + b"\0\x3F\0"
    bits, last = "", [0] * channels
    for y in range(0, H, 8):
        for x in range(0, W, 8):
            for i, value in enumerate(colours[(x * 2 // W) + 2 * (y * 2 // H)]):
                level = 8 * (value - 128)
                difference, last[i] = level - last[i], level
                size = abs(difference).bit_length()
                bits += format(size, "04b")
                if size:
                    bits += format(difference if difference > 0 else difference + (1 << size) - 1, f"0{size}b")
                bits += "0"
    bits += "1" * (-len(bits) % 8)
    data = bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))
    return out + data.replace(b"\xFF", b"\xFF\0") + b"\xFF\xD9"


def adobe(transform):
    return (0xEE, b"Adobe" + struct.pack(">HHHB", 100, 0, 0, transform))


def inks(c):
    """Ink by the plain formula, 255 for full."""
    k = 255 - max(c)
    return [round(255 * (1 - v / (255 - k))) for v in c] + [k]


def ycc(c):
    r, g, b = c
    return [luma(c), round(128 - 0.168736 * r - 0.331264 * g + 0.5 * b), round(128 + 0.5 * r - 0.418688 * g - 0.081312 * b)]


def jpegs():
    best = ("cjpeg", "-quality", "97", "-sample", "1x1")
    scene = ppm(pixels())
    save("rgb.jpg", run(*best, stdin=scene))
    save("rgb-420.jpg", run("cjpeg", "-quality", "97", stdin=scene))
    save("rgb-progressive.jpg", run(*best, "-progressive", stdin=scene))
    save("rgb-restart.jpg", run(*best, "-restart", "1", stdin=scene))
    save("rgb-arithmetic.jpg", run(*best, "-arithmetic", stdin=scene))
    save("rgb-adobe.jpg", flat_jpeg(SCENE, [adobe(0)]))
    save("odd.jpg", run(*best, stdin=ppm(pixels(w=61, h=35))))
    # Wide enough for jpeg-decoder to use its worker threads.
    wide = ppm(pixels(w=144, h=72))
    save("wide.jpg", run("cjpeg", "-quality", "90", stdin=wide))
    save("wide-progressive.jpg", run("cjpeg", "-quality", "90", "-progressive", stdin=wide))
    save("grey.jpg", run(*best, "-grayscale", stdin=scene))
    save("grey-as-rgb.jpg", run(*best, stdin=ppm(pixels(lambda c: [luma(c)] * 3))))
    for o in range(1, 9):
        save(f"orient-{o}.jpg", after_start(run(*best, stdin=ppm(stored(o))), (0xE1, b"Exif\0\0" + exif(o, "<>"[o % 2]))))
    save("icc.jpg", after_start(run(*best, stdin=scene), icc_segments(profiles.swapped())))
    save("icc-table.jpg", after_start(run(*best, stdin=scene), icc_segments(profiles.scanner())))
    save("icc-broken.jpg", after_start(run(*best, stdin=scene), icc_segments(profiles.swapped()[:140])))
    save("grey-icc.jpg", after_start(run(*best, "-grayscale", stdin=scene), icc_segments(profiles.grey(1.0))))
    # Adobe's inks are upside down: 255 is no ink.
    ink = [inks(c) for c in SCENE]
    upside_down = [[255 - v for v in i] for i in ink]
    save("cmyk-adobe.jpg", flat_jpeg(upside_down, [adobe(0)]))
    save("cmyk-plain.jpg", flat_jpeg(ink))
    save("cmyk-icc.jpg", flat_jpeg(upside_down, [adobe(0), icc_segments(profiles.inks())]))
    # YCCK: the inks turned over once more are taken as red, green and blue; black stays as Adobe has it.
    save("ycck.jpg", flat_jpeg([ycc(i[:3]) + [255 - i[3]] for i in ink], [adobe(2)]))
    save("ycck-magick.jpg", run("convert", "ppm:-", "-colorspace", "CMYK", "-quality", "97", "jpg:-", stdin=scene))


# PNG ----------------------------------------------------------------------------------------------------------------


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(rows, colour, depth=8, before=(), behind=(), size=(W, H)):
    """`rows` of samples; `before` and `behind` are chunks (name, data) around the pixels."""
    raw = b""
    for row in rows:
        samples = [s for p in row for s in (p if isinstance(p, (list, tuple)) else [p])]
        if depth == 16:
            line = struct.pack(f">{len(samples)}H", *samples)
        else:
            bits = "".join(format(s, f"0{depth}b") for s in samples)
            line = int(bits, 2).to_bytes(len(bits) // 8, "big")
        raw += b"\0" + line
    out = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", *size, depth, colour, 0, 0, 0))
    out += b"".join(chunk(*c) for c in before) + chunk(b"IDAT", zlib.compress(raw, 9))
    return out + b"".join(chunk(*c) for c in behind) + chunk(b"IEND", b"")


def pngs():
    palette = [(b"PLTE", bytes(v for c in SCENE for v in c))]
    number = {c: i for i, c in enumerate(SCENE)}
    quarter = lambda c: number[c]
    save("rgb.png", png(pixels(), 2))
    save("grey.png", png(pixels(luma), 0))
    save("grey-as-rgb.png", png(pixels(lambda c: [luma(c)] * 3), 2))
    for depth in (1, 2, 4):  # quarters of the lightest and darkest, or of all
        save(f"grey-{depth}.png", png(pixels(lambda c: quarter(c) * ((1 << depth) - 1) // 3), 0, depth))
    # Sixteen bits: steps too fine for eight.
    save("rgb-16.png", png(pixels(lambda c: [v * 257 + 100 * quarter(c) for v in c]), 2, 16))
    save("grey-16.png", png(pixels(lambda c: 0x8000 + 0x40 * quarter(c)), 0, 16))
    save("palette-2.png", png(pixels(quarter), 3, 2, palette))
    save("palette-8-clear.png", png(pixels(quarter), 3, 8, palette + [(b"tRNS", bytes([255, 128, 0]))]))
    save("rgb-clear.png", png(pixels(), 2, 8, [(b"tRNS", struct.pack(">3H", *SCENE[1]))]))
    opacity = (255, 128, 0, 64)
    save("alpha.png", png(pixels(lambda c: (*c, opacity[quarter(c)])), 6))
    save("alpha-16.png", png(pixels(lambda c: [v * 257 for v in (*c, opacity[quarter(c)])]), 6, 16))
    save("grey-alpha.png", png(pixels(lambda c: (luma(c), opacity[quarter(c)])), 4))
    icc = lambda data: [(b"iCCP", b"test\0\0" + zlib.compress(data, 9))]
    save("icc.png", png(pixels(), 2, 8, icc(profiles.swapped())))
    save("icc-16-alpha.png", png(pixels(lambda c: [v * 257 for v in (*c, opacity[quarter(c)])]), 6, 16, icc(profiles.scanner())))
    save("icc-palette.png", png(pixels(quarter), 3, 2, icc(profiles.swapped()) + palette))
    save("icc-broken.png", png(pixels(), 2, 8, icc(profiles.swapped()[:140])))
    save("icc-wrong-kind.png", png(pixels(), 2, 8, icc(profiles.grey(1.0))))
    save("grey-icc.png", png(pixels(luma), 0, 8, icc(profiles.grey(1.0))))
    save("gamma-1.png", png(pixels(), 2, 8, [(b"gAMA", struct.pack(">I", 100000))]))
    save("orient-6-before.png", png(stored(6), 2, 8, [(b"eXIf", exif(6))], (), (H, W)))
    save("orient-8-behind.png", png(stored(8), 2, 8, (), [(b"eXIf", exif(8))], (H, W)))
    frame = lambda n: (b"fcTL", struct.pack(">IIIIIHHBB", n, W, H, 0, 0, 1, 10, 0, 0))
    second = struct.pack(">I", 2) + zlib.compress((b"\0" + b"\0\0\0" * W) * H, 9)
    save("animated.png", png(pixels(), 2, 8, [(b"acTL", struct.pack(">II", 2, 0)), frame(0)], [frame(1), (b"fdAT", second)]))
    for source in ("rgb", "grey-2", "rgb-16", "alpha", "palette-2"):
        out = ("-define", "png:preserve-colormap" if source.startswith("palette") else "png:include-chunk=none")
        save(f"{source}-interlaced.png", run("convert", f"{source}.png", *out, "-strip", "-interlace", "PNG", "png:-"))


# The others ---------------------------------------------------------------------------------------------------------


def tiff(rows, entries=(), order="<"):
    """An uncompressed RGB TIFF of 8 bits, with more entries (tag, type, count, value)."""
    size = (len(rows[0]), len(rows))
    data = b"".join(bytes(p) for r in rows for p in r)
    head = 8
    tags = [(256, 4, 1, size[0]), (257, 4, 1, size[1]), (258, 3, 3, head + len(data)), (259, 3, 1, 1), (262, 3, 1, 2),
            (273, 4, 1, head), (277, 3, 1, 3), (278, 4, 1, size[1]), (279, 4, 1, len(data)), *entries]
    out = (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", head + len(data) + 6) + data
    out += struct.pack(order + "3HH", 8, 8, 8, len(tags))
    for tag, kind, count, value in sorted(tags):
        small = struct.pack(order + "HH", value, 0) if kind == 3 and count == 1 else struct.pack(order + "I", value)
        out += struct.pack(order + "HHI", tag, kind, count) + small
    return out + b"\0" * 4


def bmp(rows):
    data = b"".join(b"".join(bytes(p[::-1]) for p in r) for r in rows[::-1])  # rows of 192 bytes need no padding
    head = struct.pack("<IIIHHIIIIII", 40, len(rows[0]), len(rows), 1, 24, 0, len(data), 2835, 2835, 0, 0)
    return b"BM" + struct.pack("<IHHI", 54 + len(data), 0, 0, 54) + head + data


def others():
    scene = ppm(pixels())
    rgb, alpha = "rgb.png", "alpha.png"
    save("rgb.webp", run("convert", rgb, "-define", "webp:lossless=true", "webp:-"))
    save("lossy.webp", run("convert", rgb, "-quality", "95", "webp:-"))
    save("alpha.webp", run("convert", alpha, "-define", "webp:lossless=true", "webp:-"))
    save("animated.webp", run("convert", rgb, "(", rgb, "-negate", ")", "-define", "webp:lossless=true", "webp:-"))
    turned = run("convert", "ppm:-", "-define", "webp:lossless=true", "webp:-", stdin=ppm(stored(6)))
    part = lambda name, data: name + struct.pack("<I", len(data)) + data + b"\0" * (len(data) % 2)
    body = b"WEBP" + part(b"VP8X", struct.pack("<I", 0x28) + struct.pack("<I", H - 1)[:3] + struct.pack("<I", W - 1)[:3])
    body += part(b"ICCP", profiles.swapped()) + turned[12:] + part(b"EXIF", exif(6))
    save("orient-6-icc.webp", b"RIFF" + struct.pack("<I", len(body)) + body)
    save("rgb.tif", tiff(pixels()))
    save("orient-7.tif", tiff(stored(7), [(274, 3, 1, 7)], ">"))
    for name, options in {
        "lzw": ("-compress", "LZW"), "deflate": ("-compress", "Zip"), "palette": ("-type", "Palette", "-compress", "None"),
        "cmyk": ("-colorspace", "CMYK", "-compress", "LZW"), "16": ("-depth", "16", "-compress", "LZW"),
    }.items():
        save(f"{name}.tif", run("convert", rgb, *options, "tif:-"))
    save("icc.tif", run("convert", rgb, "-profile", "swapped.icc", "-compress", "LZW", "tif:-"))
    save("alpha.tif", run("convert", alpha, "-compress", "LZW", "tif:-"))
    save("bilevel.tif", run("convert", "grey-1.png", "-compress", "Group4", "tif:-"))
    save("rgb.bmp", bmp(pixels()))
    save("palette.bmp", run("convert", rgb, "-type", "Palette", "BMP3:-"))
    save("rgb.gif", run("convert", rgb, "gif:-"))
    save("animated.gif", run("convert", rgb, "(", rgb, "-negate", ")", "gif:-"))
    save("clear.gif", run("convert", "palette-8-clear.png", "-channel", "A", "-threshold", "40%", "+channel", "gif:-"))
    save("rgb.ppm", scene)
    save("ascii.ppm", run("convert", "ppm:-", "-compress", "None", "ppm:-", stdin=ppm(pixels(w=16, h=8))))
    save("grey.pgm", b"P5\n%d %d\n255\n" % (W, H) + bytes(luma(c) for r in pixels() for c in r))
    save("grey-16.pgm", b"P5\n%d %d\n65535\n" % (W, H) + b"".join(struct.pack(">H", 0x8000 + 0x40 * SCENE.index(c)) for r in pixels() for c in r))
    save("bilevel.pbm", run("convert", "grey-1.png", "pbm:-"))
    save("rgb.pam", b"P7\nWIDTH %d\nHEIGHT %d\nDEPTH 3\nMAXVAL 255\nTUPLTYPE RGB\nENDHDR\n" % (W, H) + scene.split(b"255\n", 1)[1])


def drawings():
    import base64, gzip
    inside = base64.b64encode(open("palette-2.png", "rb").read()).decode()
    quarters = "".join(
        f'<path fill="rgb{c}" d="M{x} {y}h32v16h-32z"/>' for c, x, y in zip(SCENE, (0, 32, 0, 32), (0, 0, 16, 16))
    )
    start = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
    drawing = f'<?xml version="1.0"?>\n{start}width="64" height="32">{quarters}</svg>\n'
    save("rgb.svg", drawing.encode())
    save("rgb.svgz", gzip.compress(drawing.encode(), 9, mtime=0))
    save("viewbox.svg", f'{start}viewBox="0 0 64 32">{quarters}</svg>\n'.encode())
    save("picture-inside.svg", f'{start}width="64" height="32"><image width="64" height="32" xlink:href="data:image/png;base64,{inside}"/></svg>\n'.encode())
    linked = "".join(f'<image width="64" height="32" xlink:href="{h}"/>' for h in ("rgb.png", "http://localhost/rgb.png"))
    save("linked.svg", f'{start}width="64" height="32">{linked}</svg>\n'.encode())
    save("text.svg", f'{start}width="64" height="32"><text font-family="Block" font-size="32" x="0" y="32">A</text></svg>\n'.encode())


save("swapped.icc", profiles.swapped())
save("block.ttf", profiles.font())
jpegs()
pngs()
others()
drawings()
