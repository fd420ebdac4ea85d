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


def sur(order="<", bits=16, x=5, y=4, comment=b"", marked=1, z=1e-3, units=(b"mm", b"\xb5m")):
    text = lambda word: word.ljust(16)
    header = struct.pack(
        order + "12s4h30s30s5h8sh5i3f48s16s16s16s48s3f3h12s7hf10s2h128s3f34s", b"DIGITAL SURF", 257 if order == ">" else 0,
        1, 1, 2, b"name", b"operator", 0, 0, 0, marked, 0, b"", bits, -1, 6, x, y, 20, 0.5, 0.5, z, b"", text(units[0]),
        text(units[0]), text(units[1]), b"", 1, 1, 1, 0, 0, 0, b"", *[0] * 7, 0, b"", len(comment), 0, b"", 0, 0, 0, b"")
    assert len(header) == 512
    return header + comment + struct.pack(f"{order}20{'h' if bits == 16 else 'i'}", *heights)


for bits in (16, 32):
    put("sur", f"little-{bits}.sur", sur(bits=bits))
    put("sur", f"big-{bits}.sur", sur(">", bits, marked=0))
put("sur", "comment.sur", sur(comment=b"comment"))
put("sur", "profile.pro", sur(x=20, y=1))
put("sur", "huge-count.sur", sur(x=2147483647, y=2147483647))
put("sur", "nan-step.sur", sur(z=math.nan))
put("sur", "volt.sur", sur(units=(b"mm", b"V")))


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
