#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of tests/fuzz/corpus: tiny files of every form that the readers know, good and bad.

    python3 tools/make_fuzz_corpus.py

Standard library only; the same bytes on every run. Inputs that fuzzing found (found-*) are left alone.
"""
import io
import math
import pathlib
import struct
import zipfile
import zlib

root = pathlib.Path(__file__).resolve().parent.parent / "tests" / "fuzz" / "corpus"


def put(reader, name, content):
    folder = root / reader
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


heights = [(7 * i) % 10 - 3 for i in range(20)]

# --- profiles ---
rows = lambda sep: "".join(f"{i / 2}{sep}{z / 10}\n" for i, z in enumerate(heights))
put("profile_text", "comma.csv", "x [um],z [nm]\n" + rows(","))
put("profile_text", "decimal-comma.csv", "x (um);z (nm)\n" + rows(";").replace(".", ","))
put("profile_text", "blanks.txt", "# x/um z/um\n" + rows("  "))
put("profile_text", "tab-missing.txt", "x [mm]\tz [um]\n" + rows("\t").replace("0.4\n", "\n"))
put("profile_text", "stated-spacing.txt", "Resolution,0.5 um/sample\nz [um]\n" + "".join(f"{z}\n" for z in heights))
put("profile_text", "cp1252-crcrlf.csv", ("x \xb5m,z \xb5m\r\r\n" + rows(",").replace("\n", "\r\r\n")).encode("cp1252"))
put("profile_text", "falling.txt", "x [um] z [um]\n" + "".join(f"{9 - i / 2} {z}\n" for i, z in enumerate(heights)))
put("profile_text", "huge.txt", "x [um],z [um]\n" + "".join(f"{i},{z}e308\n" for i, z in enumerate(heights)))
put("profile_text", "binary.txt", b"0 1\n\0\xff\n")
put("profile_text", "hole.txt", "x [um],z [um]\n" + "".join(f"{i + (i > 9)},{z}\n" for i, z in enumerate(heights)))
put("profile_text", "missing-words.txt", "#;x [\u00b5m];z [A]\n" + rows(";").replace("0.4\n", "NA\n").replace("0.1\n", "***\n"))
put("profile_text", "missing-number.txt", "x [um] z [um]\n" + rows(" ").replace("0.4\n", "-9999\n"))
put("profile_text", "utf-16.txt", ("x [\u00b5m]\tz [nm]\n" + rows("\t")).encode("utf-16"))
put("profile_text", "uneven.txt", "x [um],z [um]\n" + "".join(f"{i + i % 3 / 4},{z}.5D-01\n" for i, z in enumerate(heights)))

# --- maps as text ---
matrix = lambda sep: "".join(sep.join(str(heights[(5 * j + i) % 20] / 8) for i in range(5)) + "\n" for j in range(4))
gwyddion = "# Channel: z\n# Width: 10 \u00b5m\n# Height: 800 nm\n# Value units: nm\n"
triples = lambda sep: "".join(
    f"{i * 0.5}{sep}{j * 2}{sep}{heights[(5 * j + i) % 20]}\n" for j in range(4) for i in range(5))
put("map_text", "gwyddion.txt", gwyddion + matrix("\t"))
put("map_text", "gwyddion-three-columns.txt", gwyddion + "1 2 3\n4 5 7\n0 nan 1\n")
put("map_text", "esri.asc", "ncols 5\nnrows 4\ncellsize 2\nNODATA_value -9999\n" + matrix(" ").replace("0.5", "-9999"))
put("map_text", "no-data.xyz", triples(" ").replace(" 4\n", " No Data\n"))
put("map_text", "factor.txt",
    "h=4 w=5\npixel size=1e-007 m\ndata unit=rad\nheight conversion factor (-> m)=2.5e-008\n" + matrix(" "))
put("map_text", "wrong-count.txt", "h=9 w=5\npixel size=1e-007 m\ndata unit=m\n" + matrix(" "))
put("map_text", "missing.csv",
    "dx = 1 um\ndy: 2 um\nunit: nm\n" + matrix(",").replace("0.5", "").replace("-0.25", "BAD"))
put("map_text", "decimal-comma.csv", "dx=1 um\ndy=1 um\nunits=nm\n" + matrix(";").replace(".", ","))
put("map_text", "triples.csv", "x [um],y [um],z [nm]\n" + triples(","))
put("map_text", "triples-by-column.txt", "x [um] y [um] z [nm]\n" + "".join(
    f"{i} {j} {(i * j) % 7}\n" for i in range(4) for j in reversed(range(5)) if i + j != 3))
put("map_text", "scattered.txt", "".join(f"{math.sin(i):.6f} {math.cos(3 * i):.6f} {i}\n" for i in range(20)))
put("map_text", "twice.csv", "x [um],y [um],z [nm]\n" + triples(",") + "0.5,2,1\n")
put("map_text", "written.txt", "# Form: matrix\n# dx: 1e-6 m\n# dy: 1e-6 m\n# Value units: m\n" + matrix("\t"))
put("map_text", "keyence.csv", '"Measured date","2026-01-01 12:00:00"\n"XY Calibration","277.8","nm"\n"Horizontal","5"\n'
    '"Vertical","4"\n"Minimum value","-1"\n"Unit","um"\n"Reference data name",""\n\n"Height"\n' +
    matrix('","').replace("\n", '"\n"')[:-1].join(['"', ""]))
put("map_text", "spip.asc", "# File Format = ASCII\n# Created by SPIP\n# x-pixels = 5\n# y-pixels = 4\n# x-length = 2000\n"
    "# y-length = 1500\n# Bit2nm = 0.5\n# voidpixels =0\n# Start of Data:\n" + matrix("\t"))
put("map_text", "gwyddion-german.txt", "# Kanal: z\n# Breite: 10,5 \u00b5m\n# H\u00f6he: 800 nm\n# Einheiten: nm\n" +
    matrix("\t").replace(".", ","))
put("map_text", "gwyddion-czech-cp1250.txt", ("# Kan\u00e1l: z\n# \u0160\u00ed\u0159ka: 10,5 \u00b5m\n# V\u00fd\u0161ka: 800 nm\n"
    "# Jednotky hodnot: nm\n" + matrix("\t").replace(".", ",")).encode("cp1250"))
put("map_text", "gwyddion-japanese.txt", "# \u30c1\u30e3\u30cd\u30eb\uff1a z\n# \u5e45\uff1a 10 \u00b5m\n# \u9ad8\u3055\uff1a 800 nm\n"
    "# \u5024\u306e\u5358\u4f4d\uff1a nm\n" + matrix("\t"))
put("map_text", "far-apart.csv", "x [um],y [um],z [nm]\n0,0,1\n1,1,2\n1e300,1e300,3\n-1e308,1,1\n1e308,2,2\n")

# --- surface data files ---
fields = dict(ManufacID="fstiff", CreateDate="010120000000", ModDate="010120000000", NumPoints=5, NumProfiles=4,
              Xscale=1e-6, Yscale=2e-6, Zscale=1e-9, Zresolution=-1, Compression=0, DataType=7, CheckType=0)


def sdf_text(version="aISO-1.0", data=None, trailer="*\r\n", **changed):
    header = "".join(f"{key} = {value}\r\n" for key, value in {**fields, **changed}.items())
    return f"{version}\r\n{header}*\r\n{matrix(' ') if data is None else data}*\r\n{trailer}"


def sdf_binary(version=b"bISO-1.0", kind=7, points=5, profiles=4, data=None, x=1e-6, z=1e-9, trailer=b""):
    counts = "<II" if version.endswith(b"2.0") else "<HH"
    code = "BHIfbhid"[kind]
    if data is None:
        lift = 3 if kind < 3 else 0
        data = struct.pack(f"<20{code}", *[value + lift for value in heights])
    return (version + b"fstiff    " + b"010120000000" * 2 + struct.pack(counts, points, profiles) +
            struct.pack("<ddddBBB", x, 2e-6, z, -1, 0, kind, 0) + data + trailer)


put("sdf", "text-1.sdf", sdf_text())
put("sdf", "text-2-trailer.sdf", sdf_text("aISO-2.0", trailer="< Name > value < / Name >\n*"))
put("sdf", "text-bad.sdf", sdf_text(data="BAD 1 2 3 4\n" + "1 2 3 4 5\n" * 3))
put("sdf", "text-bcr.sdf", sdf_text("aBCR-1.0", DataType="INTEGER", Compression="NULL",
                                    data="32767 1 2 3 4 ; comment\n" + "1 2 3 4 5\n" * 3))
put("sdf", "text-profile.sdf", sdf_text(NumPoints=20, NumProfiles=1, Yscale=0))
put("sdf", "text-huge-count.sdf", sdf_text(NumPoints=4294967295, NumProfiles=4294967295))
put("sdf", "text-too-few.sdf", sdf_text(NumProfiles=5))
put("sdf", "text-inf.sdf", sdf_text(data="inf 1 2 3 4\n" + "1 2 3 4 1e999\n" * 3))
for kind in range(8):
    put("sdf", f"binary-type-{kind}.sdf", sdf_binary(kind=kind))
put("sdf", "binary-2-trailer.sdf", sdf_binary(b"bISO-2.0", trailer=b"trailer\0"))
put("sdf", "binary-bcr.sdf", sdf_binary(b"bBCR-1.0", 5))
put("sdf", "binary-huge-count.sdf", sdf_binary(b"bISO-2.0", points=0xFFFFFFFF, profiles=0xFFFFFFFF))
put("sdf", "binary-nan-scale.sdf", sdf_binary(x=math.nan))
put("sdf", "binary-overflow.sdf", sdf_binary(z=1e308))
put("sdf", "binary-missing.sdf", sdf_binary(
    data=struct.pack("<20d", math.nan, -1.7976931348623157e308, *range(18))))


# --- arrays of NumPy, simple fields of Gwyddion, files of Digital Surf ---
def npy(kind="<f8", shape="(4, 5)", order="False", data=None, version=1):
    text = f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}\n".encode()
    code = kind[0].replace("|", "<") + "20" + {"f4": "f", "f8": "d", "i1": "b", "i2": "h", "i4": "i", "i8": "q"}[kind[1:]]
    return (b"\x93NUMPY" + bytes([version, 0]) + struct.pack("<H" if version == 1 else "<I", len(text)) + text +
            (struct.pack(code, *heights) if data is None else data))


for kind in ("<f4", ">f4", "<f8", ">f8", "|i1", "<i2", ">i4", "<i8"):
    put("npy", f"map-{kind[1:]}-{'big' if kind[0] == '>' else 'little'}.npy", npy(kind))
put("npy", "fortran.npy", npy(order="True"))
put("npy", "profile.npy", npy(shape="(20,)"))
put("npy", "column-2.npy", npy("<i2", "(20, 1)", version=2))
put("npy", "huge-shape.npy", npy(shape="(4294967295, 4294967295)"))
put("npy", "three.npy", npy(shape="(2, 2, 5)"))
put("npy", "missing.npy", npy(data=struct.pack("<20d", math.nan, -9999, -9999, *range(17))))
put("npy", "infinite.npy", npy(data=struct.pack("<20d", math.inf, *range(19))))


def gsf(x="5", y="4", width="1e-5", unit="m", data=None):
    text = (f"Gwyddion Simple Field 1.0\nXRes = {x}\nYRes = {y}\nXReal = {width}\nYReal = 4e-6\nXYUnits = m\n"
            f"ZUnits = {unit}\nTitle = z\n").encode()
    return text + bytes(4 - len(text) % 4) + (struct.pack("<20f", *heights) if data is None else data)


put("gsf", "map.gsf", gsf())
put("gsf", "profile.gsf", gsf("20", "1", unit="nm"))
put("gsf", "huge-count.gsf", gsf("4294967295", "4294967295"))
put("gsf", "volt.gsf", gsf(unit="V"))
put("gsf", "no-width.gsf", gsf(width="nan"))
put("gsf", "missing.gsf", gsf(data=struct.pack("<20f", math.nan, *range(19))))


def sur(order="<", bits=16, x=5, y=4, comment=b"", marked=1, z=1e-3, units=(b"mm", b"\xb5m"), streams=None):
    text = lambda word: word.ljust(16)
    header = struct.pack(
        order + "12s4h30s30s5h8sh5i3f48s16s16s16s48s3f3h12s7hf10s2h128s3f34s", b"DSCOMPRESSED" if streams else b"DIGITAL SURF", 257 if order == ">" else 0,
        1, 1, 2, b"name", b"operator", 0, 0, 0, marked, 0, b"", bits, -1, 6, x, y, 20, 0.5, 0.5, z, b"", text(units[0]),
        text(units[0]), text(units[1]), b"", 1, 1, 1, 0, 0, 0, b"", *[0] * 7, 0, b"", len(comment), 0, b"", 0, 0, 0, b"")
    assert len(header) == 512
    data = struct.pack(f"{order}20{'h' if bits == 16 else 'i'}", *heights)
    return header + comment + (streams(data) if streams else data)


def packed_in(*sizes):
    """The data as zlib streams of so many bytes, behind their table."""
    def pack(data):
        parts = [data[sum(sizes[:i]):sum(sizes[:i + 1])] for i in range(len(sizes))]
        parts.append(data[sum(sizes):])
        streams = [zlib.compress(part, 9) for part in parts]
        table = b"".join(struct.pack("<2I", len(part), len(stream)) for part, stream in zip(parts, streams))
        return struct.pack("<I", len(parts)) + table + b"".join(streams)
    return pack


for bits in (16, 32):
    put("sur", f"little-{bits}.sur", sur(bits=bits))
    put("sur", f"big-{bits}.sur", sur(">", bits, marked=0))
put("sur", "comment.sur", sur(comment=b"comment"))
put("sur", "profile.pro", sur(x=20, y=1))
put("sur", "huge-count.sur", sur(x=2147483647, y=2147483647))
put("sur", "nan-step.sur", sur(z=math.nan))
put("sur", "volt.sur", sur(units=(b"mm", b"V")))
put("sur", "compressed-16.sur", sur(streams=packed_in()))
put("sur", "compressed-32-three-streams.sur", sur(bits=32, comment=b"comment", streams=packed_in(8, 20)))
put("sur", "compressed-bomb.sur", sur(x=30000, y=30000, streams=lambda data: struct.pack("<3I", 1, 1800000000, 60) + bytes(60)))
put("sur", "compressed-many-streams.sur", sur(streams=lambda data: b"\xff" * 40))
put("sur", "compressed-damaged.sur", sur(streams=lambda data: packed_in()(data)[:-4] + bytes(4)))


# --- files of Gwyddion ---
def gwy_object(name, *components):
    content = b"".join(components)
    return name.encode() + b"\0" + struct.pack("<I", len(content)) + content


def gwy_part(name, kind, value):
    body = {"b": lambda: bytes([value]), "i": lambda: struct.pack("<i", value), "d": lambda: struct.pack("<d", value),
            "q": lambda: struct.pack("<q", value), "s": lambda: value.encode() + b"\0", "o": lambda: value,
            "D": lambda: struct.pack(f"<I{len(value)}d", len(value), *value),
            "S": lambda: struct.pack("<I", len(value)) + b"".join(text.encode() + b"\0" for text in value),
            "O": lambda: struct.pack("<I", len(value)) + b"".join(value), "raw": lambda: value}[kind]()
    return name.encode() + b"\0" + (b"D" if kind == "raw" else kind.encode()) + body


def gwy_field(x=5, y=4, width=1e-5, unit="m", numbers=heights):
    si = lambda text: gwy_object("GwySIUnit", gwy_part("unitstr", "s", text))
    data = gwy_part("data", "raw", numbers) if isinstance(numbers, bytes) else gwy_part("data", "D", numbers)
    return gwy_object("GwyDataField", gwy_part("xres", "i", x), gwy_part("yres", "i", y), gwy_part("xreal", "d", width),
                      gwy_part("yreal", "d", 4e-6), gwy_part("si_unit_xy", "o", si("m")),
                      gwy_part("si_unit_z", "o", si(unit)), data)


def gwy(*components):
    return b"GWYP" + gwy_object("GwyContainer", *components)


gwy_data = lambda number=0, **changed: gwy_part(f"/{number}/data", "o", gwy_field(**changed))
gwy_mask = gwy_part("/0/mask", "o", gwy_field(unit="", numbers=[1, 0.0] * 10))
put("gwy", "map.gwy", gwy(gwy_part("/filename", "s", "a"), gwy_data(), gwy_part("/0/base/palette", "s", "Gray"),
                          gwy_part("/0/data/visible", "b", 1), gwy_part("/0/data/title", "s", "Height")))
put("gwy", "profile.gwy", gwy(gwy_data(x=20, y=1)))
put("gwy", "mask.gwy", gwy(gwy_mask, gwy_data()))
put("gwy", "two.gwy", gwy(gwy_data(unit="deg"), gwy_data(1), gwy_part("/1/data/title", "s", "Height"),
                          gwy_part("/texts", "S", ["a", "b"]), gwy_part("/list", "O", [gwy_object("GwyString")])))
put("gwy", "volt.gwy", gwy(gwy_data(unit="V")))
put("gwy", "huge-count.gwy", gwy(gwy_data(x=2147483647, y=2147483647, numbers=struct.pack("<I", 0xFFFFFFFF))))
put("gwy", "huge-texts.gwy", gwy(gwy_part("/texts", "S", []).replace(bytes(4), b"\xff" * 4), gwy_data()))
put("gwy", "no-width.gwy", gwy(gwy_data(width=math.nan)))
put("gwy", "missing.gwy", gwy(gwy_data(numbers=[math.nan, *range(19)])))
put("gwy", "infinite.gwy", gwy(gwy_data(numbers=[math.inf, *range(19)])))
put("gwy", "old.gwy", b"GWYO" + gwy_object("GwyContainer"))
put("gwy", "unknown-type.gwy", gwy(gwy_data(), b"x\0?"))


# --- profiles of ISO 5436-2 and their elder form ---
def smd(points=20, x="I", z="A", unit="um", scale="1.0e0", data=None, total=None, form="PRF"):
    data = "".join(f"{value / 10:.5f}\r\n" for value in heights) if data is None else data
    text = (f"ISO 5436-2:2012\0a.smd\0\r\n{form}\0 1 ISO5436\0\r\nCX\0 {x}\0 {points} mm\0 1.0e0 D\0 5.0e-4 \r\n"
            f"CZ\0 {z}\0 {points} {unit}\0 {scale} D\0\r\n\3\r\nDATE: 1-January-2026\0\r\nCOMMENT /* a */\0\r\n\3\r\n"
            f"{data}\3\r\n").encode()
    return text + (str(sum(text) % 65535 if total is None else total) + "\r\n\3\r\n\x1a").encode()


def prf(points="2.000000e+001", spacing="SPACING CX 5.000000e-004\r\n", scale="1.000000e-006", mapped="0.000000e+000"):
    return (f"1 2\r\nSG2004 0.000000e+000 PRF\r\nCX M {points} MM 1.000000e+000 D\r\nCZ M {points} UM {scale} L\r\nEOR\r\n"
            f"STYLUS_RADIUS 2.000000e-003 MM\r\n{spacing}MAP 1.000000e+000 CZ CZ 1.000000e+000 1.000000e+000\r\n"
            f"MAP 2.000000e+000 CZ CX 1.000000e+000 {mapped}\r\nCOMMENT a\r\nEOR\r\n" +
            "".join(f"{100000 * value}\r\n" for value in heights) + "EOR\r\nEOF\r\n")


put("smd", "profile.smd", smd())
put("smd", "blanks.smd", smd().replace(b"\0", b" "))
put("smd", "changed.smd", smd(total=1))
put("smd", "absolute-x.smd", smd(x="A"))
put("smd", "surface.smd", smd(form="SUR"))
put("smd", "volt.smd", smd(unit="V"))
put("smd", "huge-count.smd", smd(points=4294967295))
put("smd", "huge-scale.smd", smd(scale="1e308", unit="km"))
put("smd", "word.smd", smd(data="a\r\n" * 20))
put("smd", "missing.smd", smd(data="BAD\r\n" + "".join(f"{value}\r\n" for value in range(19))))
put("smd", "many-ends.smd", smd() + b"\3" * 200)
put("smd", "profile.prf", prf())
put("smd", "gauge.prf", prf(mapped="1.000000e-003"))
put("smd", "no-spacing.prf", prf(spacing=""))
put("smd", "zero-scale.prf", prf(scale="0"))


# --- X3P ---
def main_xml(kind="D", x=5, y=4, root="p:ISO5436_2", space=' xmlns:p="http://www.opengps.eu/2008/ISO5436_2"',
             feature="SUR", data="<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>", size=None):
    axis = lambda name, step: (f"<{name}><AxisType>I</AxisType><DataType>D</DataType><Increment>{step}</Increment>"
                               f"<Offset>0</Offset></{name}>")
    size = size or f"<MatrixDimension><SizeX>{x}</SizeX><SizeY>{y}</SizeY><SizeZ>1</SizeZ></MatrixDimension>"
    return (f'<?xml version="1.0"?><{root}{space}><Record1><FeatureType>{feature}</FeatureType><Axes>'
            f'{axis("CX", 1e-6)}{axis("CY", 2e-6)}<CZ><AxisType>A</AxisType><DataType>{kind}</DataType>'
            f"<Increment>1e-9</Increment><Offset/></CZ></Axes></Record1><Record3>{size}{data}</Record3></{root}>")


def packed(*members, method=zipfile.ZIP_DEFLATED):
    bytes_ = io.BytesIO()
    with zipfile.ZipFile(bytes_, "w", method) as archive:
        for name, content in members:
            archive.writestr(zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0)), content, compress_type=method)
    return bytes_.getvalue()


binary = lambda code: struct.pack(f"<20{code}", *heights)
masked = ("<DataLink><PointDataLink>bindata/data.bin</PointDataLink><ValidPointsLink>bindata/valid.bin"
          "</ValidPointsLink></DataLink>")
data_list = "<DataList>" + "".join(f"<Datum>{z}</Datum>" for z in heights[:-1]) + "<Datum/></DataList>"
for kind, code in zip("ILFD", "hifd"):
    put("x3p", f"type-{kind}.x3p", packed(("main.xml", main_xml(kind)), ("bindata/data.bin", binary(code))))
put("x3p", "folder-no-namespace.x3p", packed(
    ("a/main.xml", main_xml(root="ISO5436", space="")), ("a/bindata/data.bin", binary("d")), ("a/mask.png", b"png")))
put("x3p", "mask.x3p", packed(("main.xml", main_xml("I", data=masked)), ("bindata/data.bin", binary("h")),
                              ("bindata/valid.bin", b"\xfe\xff\x07")))
put("x3p", "list.x3p", packed(("main.xml", main_xml(data=data_list))))
put("x3p", "stored.x3p", packed(("main.xml", main_xml()), ("bindata/data.bin", binary("d")), method=zipfile.ZIP_STORED))
put("x3p", "path.x3p", packed(("main.xml", main_xml(data="<DataLink><PointDataLink>../../etc/passwd</PointDataLink>"
                                                    "</DataLink>")), ("../../etc/passwd", binary("d"))))
put("x3p", "bomb.x3p", packed(("main.xml", main_xml(x=2048, y=1024)), ("bindata/data.bin", bytes(2048 * 1024 * 8))))
put("x3p", "two-mains.x3p", packed(("a/main.xml", main_xml()), ("b/main.xml", main_xml())))
put("x3p", "truncated.x3p", packed(("main.xml", main_xml()), ("bindata/data.bin", binary("d")))[:-30])
# main.xml and heights alone: the fuzz target packs them
put("x3p", "bare-double.xml", main_xml().encode() + binary("d"))
put("x3p", "bare-mask.xml", main_xml("I", x=4, y=4, data=masked).encode() + binary("h")[:32])
put("x3p", "bare-list.xml", main_xml(data=data_list))
put("x3p", "bare-profile.xml", main_xml("L", feature="PRF", size="<ListDimension>20</ListDimension>").encode()
    + binary("i"))
put("x3p", "bare-huge.xml", main_xml(x=4294967295, y=4294967295).encode() + binary("d"))
