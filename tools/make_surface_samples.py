#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the small files of instruments that the tests and the fuzzers of the readers begin with.

    tools/make_surface_samples.py            writes them into tests/fuzz/corpus
    tools/make_surface_samples.py --check    compares them with those that are there

Every file is a map of 3 rows and 4 columns, height (row, column) = 10 row + column^2 in units of the form, from the
top; row 1, column 2 is missing where the form has missing points. The heads of src/io/*.cpp have the layouts."""
import io
import pathlib
import struct
import sys
import zipfile
import zlib

ROWS, COLUMNS = 3, 4
POINTS = [(row, column) for row in range(ROWS) for column in range(COLUMNS)]


def heights(missing=None, points=POINTS):
    return [missing if missing is not None and at == (1, 2) else 10 * at[0] + at[1] ** 2 for at in points]


def placed(size, *fields):
    """Bytes of that size with fields (place, format of struct, values)."""
    data = bytearray(size)
    for place, form, *values in fields:
        struct.pack_into(form, data, place, *values)
    return bytes(data)


def archive(files):
    """A zip archive, always the same."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as packed:
        for name, content in files:
            packed.writestr(zipfile.ZipInfo(name), content)
    return out.getvalue()


def metropro():
    """Steps of 0.5 um; heights in 2^-15 of 2 x 0.5 x 0.5 um; one frame of intensities of 2 x 1."""
    header = placed(834, (0, "4B", 0x88, 0x1B, 0x03, 0x6F), (6, ">I", 834), (52, ">3H", 2, 1, 1),
                    (68, ">2H", COLUMNS, ROWS), (164, ">2f", 0.5, 0.5e-6), (176, ">f", 2), (184, ">f", 0.5e-6),
                    (218, ">h", 1), (258, "7s", b"a plate"))
    return header + bytes(4) + struct.pack(">12i", *heights(2147483640))


def vk4():
    """Steps of 0.5 and 0.25 um, heights of 16 bits in 100 pm; places: settings at 84, image at 268."""
    places = placed(84, (0, "4s", b"VK4_"), (12, "<I", 84), (36, "<I", 268))
    settings = placed(184, (168, "<3I", 500000, 250000, 100))
    image = placed(796, (0, "<5I", COLUMNS, ROWS, 16, 0, 24))
    return places + settings + image + struct.pack("<12H", *heights())


def vk6():
    return b"VK6" + struct.pack("<I", 2) + b"BM" + archive([("Vk4File", vk4())])


def opd(size=2):
    """Pixels of 0.5 um with an aspect of 0.5, wavelength 600 nm, Mult 8; columns from the bottom."""
    points = [(ROWS - 1 - row, column) for column in range(COLUMNS) for row in range(ROWS)]
    numbers = heights(32767 if size == 2 else 1e38, points)
    blocks = [(b"RAW_DATA", 3, struct.pack("<3H12" + ("h" if size == 2 else "f"), COLUMNS, ROWS, size, *numbers)),
              (b"Image", 3, struct.pack("<3H12B", COLUMNS, ROWS, 1, *heights())),
              (b"Wavelength", 7, struct.pack("<f", 600)), (b"Mult", 6, struct.pack("<h", 8)),
              (b"Pixel_size", 7, struct.pack("<f", 0.5e-3)), (b"Aspect", 7, struct.pack("<f", 0.5)),
              (b"Title", 5, b"a plate\0")]
    directory = [(b"Directory", 1, 24 * (len(blocks) + 1))] + [(name, kind, len(data)) for name, kind, data in blocks]
    entries = b"".join(struct.pack("<16shiH", name, kind, length, 0) for name, kind, length in directory)
    return b"\1\0" + entries + b"".join(data for name, kind, data in blocks)


def al3d():
    """Steps of 0.5 and 0.25 um, heights in m."""
    tags = [("Version", 1), ("TagCount", 6), ("Cols", COLUMNS), ("Rows", ROWS), ("PixelSizeXMeter", 0.5e-6),
            ("PixelSizeYMeter", 0.25e-6), ("DepthImageOffset", 700), ("InvalidPixelValue", "-1.0")]
    head = b"AliconaImaging\0\r\n" + b"".join(struct.pack("<20s30s2s", key.encode(), str(value).encode(), b"\r\n")
                                              for key, value in tags)
    values = [z if z == -1 else z * 2.0**-20 for z in heights(-1)]
    return head + bytes(700 - len(head)) + struct.pack("<12f", *values)


def plu():
    """Steps of 0.5 and 0.25 um, heights in um, one picture."""
    header = placed(500, (0, "24s", b"Fri Mar 10 16:35:59 2023"), (388, "<2I", ROWS, COLUMNS),
                    (404, "<2f", 0.5, 0.25), (428, "<I", 3), (489, "B", 1), (492, "B", 1))
    return header + struct.pack("<2I12f2f", ROWS, COLUMNS, *heights(1000001), 0, 29) + bytes(3 * ROWS * COLUMNS)


def plux():
    """Steps of 0.5 and 0.25 um, heights in um."""
    index = (f"<xml><GENERAL><IMAGE_SIZE_X>{COLUMNS}</IMAGE_SIZE_X><IMAGE_SIZE_Y>{ROWS}</IMAGE_SIZE_Y>"
             "<FOV_X>0.5</FOV_X><FOV_Y>0.25</FOV_Y><DATE>10 March 2023 16:35:59</DATE></GENERAL>"
             "<LAYER_0><FILENAME_Z>LAYER_0.raw</FILENAME_Z></LAYER_0>"
             "<INFO><ITEM_0><NAME>Device</NAME><VALUE>S neox</VALUE></ITEM_0></INFO></xml>")
    return archive([("index.xml", index), ("LAYER_0.raw", struct.pack("<12f", *heights(float("nan"))))])


def padded(data):
    return data + bytes(-len(data) % 4)


def netcdf(points=(("x", COLUMNS, 2.0), ("y", ROWS, 0.75))):
    """Steps of 0.5 and 0.25 um, heights in um over (x, y), with a mask; or a profile."""
    def name(title):
        return struct.pack(">I", len(title)) + padded(title.encode())

    def attributes(**values):
        return struct.pack(">2I", 12, len(values)) + b"".join(
            name(key) + (struct.pack(">2I", 2, len(value)) + padded(value.encode()) if isinstance(value, str) else
                         struct.pack(">2Id", 6, 1, value)) for key, value in values.items())

    at = [(row, column) for column in range(points[0][1]) for row in range(points[1][1] if len(points) > 1 else 1)]
    over = list(range(len(points)))
    variables = [("heights", over, attributes(unit="um"), 6, struct.pack(f">{len(at)}d", *heights(points=at)))]
    variables += [(axis, [i], attributes(length=length, unit="um"), 4, bytes(4 * count))
                  for i, (axis, count, length) in enumerate(points)]
    if len(points) > 1:
        variables.append(("mask", over, attributes(), 1, padded(bytes(one == (1, 2) for one in at))))

    def header(place):
        out = struct.pack(">4s3I", b"CDF\1", 0, 10, len(points))
        out += b"".join(name(axis) + struct.pack(">I", count) for axis, count, length in points)
        out += attributes(history="small") + struct.pack(">2I", 11, len(variables))
        for title, dimensions, stated, kind, data in variables:
            out += name(title) + struct.pack(f">{len(dimensions) + 1}I", len(dimensions), *dimensions) + stated
            out += struct.pack(">3I", kind, len(data), place)
            place += len(data)
        return out

    return header(len(header(0))) + b"".join(data for *rest, data in variables)


def text(value, form="<I"):
    return struct.pack(form, len(value)) + value


def sized(content):
    """The text after the length of its length, and its length."""
    return b"\2" + text(content, "<H")


def item(title, kind, content=b""):
    return text(title.encode()) + bytes([kind]) + content


def folder(title, *items):
    return item(title, 0x7D, sized(b"".join(items) + item("", 0x7F) + bytes(2)))


def quantity(title, value, unit):
    return item(title, 0x13, sized(struct.pack("<d", value) + text(b"Length") + text(unit.encode())))


def opdx_file(*folders):
    return b"VCA DATA\1\0\0\x55" + b"".join(folders) + item("", 0x7F)


def opdx(profile=False):
    """Steps of 0.5 and 0.25 um, heights in 2 nm; or a profile of 20 points."""
    if profile:
        numbers = heights(points=[(0, column) for column in range(20)])
        array = text(b"d") + sized(bytes(5) + struct.pack("<20d", *numbers))
        data = folder("1D_Data", folder("Raw", item("NumPoints", 6, struct.pack("<i", 20)),
                                        item("DataKind", 0x12, sized(b"Height")),
                                        item("Array", 0x40, array),
                                        quantity("Extent", 9.5, "\u00b5m"), quantity("DataScale", 2, "nm")))
        channels = folder("1D_Channels", item("Height", 0x42, text(b"S") + sized(text(b"Raw"))))
        return opdx_file(data, folder("MetaData", item("DataKind", 0x12, sized(b"Surface Profile")), channels))
    matrix = struct.pack("<2I12f", ROWS, COLUMNS, *heights(float("nan")))
    fields = [item("Dimension1Points", 6, struct.pack("<i", ROWS)),
              item("Dimension2Points", 6, struct.pack("<i", COLUMNS)),
              quantity("Dimension1Extent", 0.5, "\u00b5m"), quantity("Dimension2Extent", 1.5, "\u00b5m"),
              quantity("DataScale", 2, "nm"), item("Matrix", 0x45, text(b"Matrix<float>") + sized(matrix)),
              item("DataKind", 0x12, sized(b"Height"))]
    names = item("Height", 0x42, text(b"S") + sized(text(b"Other") + text(b"Raw")))
    return opdx_file(folder("2D_Data", folder("Raw", *fields), folder("Other", *fields)),
                     folder("MetaData", item("Stamp", 0x15, bytes(9)), item("DataKind", 0x12, sized(b"Surface Height")),
                            item("PrimaryData2D", 0x12, sized(b"Raw")), folder("2D_Channels", names)))


def zygo():
    """Steps of 0.5 um; heights in 2^-15 of 2 x 0.5 x 0.5 um, as those of metropro; intensities of 2 x 1."""
    header = ["Zygo ASCII Data File - Format 2", '1 9 1 2 "Tue Aug 25 16:59:23 2026"', "0 0 2 1 1 255", f"0 0 {COLUMNS} {ROWS}",
              '"a comment"', '"serial"', '"a plate   "', "0 0.5 5e-07 0.3 2 1 5e-07 1787677163", '640 480 5 0 0 0 "20X"',
              "2 0 0 0 0 0 0 0.0 0 0", "1 0 7 2 100 0 0 0 0", '0 ""', "1 0", '"1X"']
    rows = [" ".join(str(z) for z in heights(2147483640)[start:start + 10]) for start in (0, 10)]
    return "\n".join([*header, "#", "17 4", "#", *rows, "#", ""]).encode()


LIMITS = (10.0, 11.5, 0.0, 0.5, 0.0, 29.0)  # of x, y and z: steps of 0.5 and 0.25


def surfer_text():
    head = ["DSAA", f"{COLUMNS} {ROWS}", *(f"{low} {high}" for low, high in zip(LIMITS[::2], LIMITS[1::2]))]
    values = heights("1.70141e+038")
    rows = [" ".join(map(str, values[start:start + COLUMNS])) for start in range(0, len(values), COLUMNS)]
    return "\r\n".join([*head, *rows, ""]).encode()


def surfer_6():
    return struct.pack("<4s2h6d12f", b"DSBB", COLUMNS, ROWS, *LIMITS, *heights(1.70141e38))


def surfer_7():
    grid = struct.pack("<2i8d", ROWS, COLUMNS, LIMITS[0], LIMITS[2], 0.5, 0.25, *LIMITS[4:], 0, 1e30)
    sections = [(b"DSRB", struct.pack("<i", 2)), (b"GRID", grid), (b"FLTI", bytes(8)),
                (b"DATA", struct.pack("<12d", *heights(1e30)))]
    return b"".join(struct.pack("<4si", tag, len(content)) + content for tag, content in sections)


def element(kind, content, order):
    if 0 < len(content) <= 4:
        return struct.pack(order + "I", len(content) << 16 | kind) + content.ljust(4, b"\0")
    return struct.pack(order + "2I", kind, len(content)) + content + bytes(-len(content) % 8)


def variable(title, rows, values, order="<", stored=(9, "d"), flags=6):
    """A matrix of MATLAB with these values, column after column."""
    columns = len(values) // rows
    kind, form = stored
    return element(14, element(6, struct.pack(order + "2I", flags, 0), order) + element(5, struct.pack(order + "2i", rows, columns), order) +
                   element(1, title.encode(), order) + element(kind, struct.pack(f"{order}{len(values)}{form}", *values), order), order)


def mat(*variables, order="<"):
    text = b"MATLAB 5.0 MAT-file, a small one".ljust(124)
    return text + struct.pack(order + "H", 256) + (b"IM" if order == "<" else b"MI") + b"".join(variables)


BY_COLUMN = [(row, column) for column in range(COLUMNS) for row in range(4)]


def mat_map(order="<", packed=False):
    """Steps of 0.5 and 0.25 from x and y, with words before them; or the same in zlib streams, stored. The last row is a fourth, that
    a map has at least, and is missing."""
    values = [float("nan") if at == (1, 2) or at[0] == 3 else 10 * at[0] + at[1] ** 2 for at in BY_COLUMN]
    parts = [variable("note", 1, [104, 105], order, (4, "H"), 4), variable("z", 4, values, order),
             variable("x", 1, [10, 10.5, 11, 11.5], order), variable("y", 4, [0, 0.25, 0.5, 0.75], order)]
    if packed:
        parts = [struct.pack("<2I", 15, len(stream)) + stream for stream in (zlib.compress(part, 0) for part in parts)]
    return mat(*parts, order=order)


def mat_profile():
    """A column of integers over positions at steps of 0.5."""
    at = range(20)
    return mat(variable("trace", 20, heights(points=[(0, column) for column in at]), stored=(4, "H"), flags=11),
               variable("X", 20, [0.5 * column for column in at]))


def mesh(line):
    r"""Places of 0.5 and 0.25 um, and the triangles of the cells, by \p line of a place, a height and of three places."""
    places = [line((column / 2, row / 4), z) for (row, column), z in zip(POINTS, heights(float("nan")))]
    cells = [row * COLUMNS + column for row, column in POINTS if row + 1 < ROWS and column + 1 < COLUMNS]
    corners = [corner for at in cells for corner in ((at, at + 1, at + COLUMNS), (at + 1, at + COLUMNS + 1, at + COLUMNS))]
    return places, corners


def ply(big=None):
    """The faces before the vertices, so that a file cut short lacks some; big: None is text."""
    form = "ascii" if big is None else "binary_big_endian" if big else "binary_little_endian"
    order = ">" if big else "<"
    if big is None:
        places, corners = mesh(lambda place, z: "%g %g %g\n" % (*place, z))
        body = ("".join("3 %d %d %d\n" % corner for corner in corners) + "".join(places)).encode()
    else:
        places, corners = mesh(lambda place, z: struct.pack(order + "3f", *place, z))
        body = b"".join(struct.pack(order + "B3i", 3, *corner) for corner in corners) + b"".join(places)
    return (f"ply\nformat {form} 1.0\nelement face {len(corners)}\nproperty list uchar int vertex_indices\n"
            f"element vertex {len(places)}\nproperty float x\nproperty float y\nproperty float z\nend_header\n").encode() + body


def obj():
    """The faces before the vertices, as those of ply."""
    places, corners = mesh(lambda place, z: "v %g %g %g\n" % (*place, z))
    return ("o plate\n" + "".join("f %d %d %d\n" % tuple(i + 1 for i in corner) for corner in corners) + "".join(places)).encode()


FILES = {"ply/map.ply": lambda: ply(True), "ply/little.ply": lambda: ply(False), "ply/text.ply": ply, "obj/map.obj": obj,
         "metropro/map.dat": metropro, "vk4/map.vk4": vk4, "vk4/map.vk6": vk6, "opd/map.opd": opd,
         "opd/real.opd": lambda: opd(4), "al3d/map.al3d": al3d, "plu/map.plu": plu, "plux/map.plux": plux,
         "netcdf/map.nc": netcdf,
         "netcdf/profile.nc": lambda: netcdf((("x", 20, 10.0),)), "opdx/map.opdx": opdx,
         "opdx/profile.opdx": lambda: opdx(True), "zygo/map.asc": zygo, "surfer/text.grd": surfer_text,
         "surfer/six.grd": surfer_6, "surfer/seven.grd": surfer_7, "mat/map.mat": mat_map,
         "mat/big.mat": lambda: mat_map(">"), "mat/packed.mat": lambda: mat_map(packed=True), "mat/profile.mat": mat_profile}

if __name__ == "__main__":
    root = pathlib.Path(__file__).parents[1] / "tests/fuzz/corpus"
    made = {root / name: make() for name, make in FILES.items()}
    if "--check" in sys.argv:
        sys.exit("\n".join(f"{path} is another" for path, data in made.items()
                           if not path.exists() or path.read_bytes() != data) or 0)
    for path, data in made.items():
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(data)
