#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes tests/data/formats: small files of other programs, and formats_expected.csv: what yet other programs read in them.

    python3 -m venv venv && venv/bin/pip install numpy gwyfile surfalize SurfaceTopography
    venv/bin/python tools/make_format_files.py

The files of Gwyddion are written by gwyfile, those of Digital Surf by surfalize, those of NumPy by numpy.save; the text files
are put together here as the programs named in them write theirs. They are read back by SurfaceTopography, by surfalize where
the file is compressed, and by numpy.load; a text that neither reads is expected to hold what was put into it. Lengths in the
table are in m, the heights row by row from the top. Made with
gwyfile 0.3.0, surfalize 0.19.2, SurfaceTopography 1.27.1, NumPy 2.4.6; surfalize writes the time into its files.
"""
import pathlib

import gwyfile
import numpy as np
import surfalize
from gwyfile.objects import GwyContainer, GwyDataField
from SurfaceTopography.IO import open_topography

data = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data"
folder = data / "formats"
folder.mkdir(exist_ok=True)

rng = np.random.default_rng(20140314)
z = np.cumsum(np.cumsum(np.round(rng.standard_normal((6, 8)) * 40e-9, 12), 0), 1)  # m, rows from the top
trace = np.cumsum(np.round(rng.standard_normal(40), 3))  # um
dx, dy = 0.25e-6, 0.5e-6
expected = []


def expect(name, heights, step_x=dx, step_y=dy, reader=""):
    heights = np.atleast_2d(heights)
    expected.append((name, reader, float(step_x), float(step_y), heights.shape[0], heights.shape[1],
                     " ".join(repr(float(value)) for value in heights.ravel())))


def read_by_surface_topography(name, unit=1.0):
    """Heights in m, rows from the top, by SurfaceTopography; \\p unit is its unit in m."""
    topography = open_topography(str(folder / name)).topography()
    heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=float), np.nan).T * unit
    width, height = topography.physical_sizes
    expect(name, heights, width * unit / heights.shape[1], height * unit / heights.shape[0], "SurfaceTopography")


# --- Gwyddion ---
field = lambda values, unit: GwyDataField(values, xreal=8 * dx, yreal=6 * dy, si_unit_xy="m", si_unit_z=unit)
container = GwyContainer()
container["/0/data/title"], container["/0/data"] = "Phase", field(z * 1e9, "deg")
container["/1/data/title"], container["/1/data"] = "Height", field(z, "m")
container.tofile(str(folder / "two-channels.gwy"))
read_by_surface_topography("two-channels.gwy")  # knows channels in lengths only
mask = np.zeros_like(z)
mask[2, 3:6] = 1
container = GwyContainer()
container["/0/data/title"], container["/0/data"], container["/0/mask"] = "z", field(z, "m"), field(mask, "")
container.tofile(str(folder / "mask.gwy"))
read_by_surface_topography("mask.gwy")

# --- Digital Surf ---
surface = surfalize.Surface(z * 1e6, dx * 1e6, dy * 1e6)
surface.save(str(folder / "plain.sur"))
surface.save(str(folder / "compressed.sur"), compressed=True)
read_by_surface_topography("plain.sur", unit=1e-6)
again = surfalize.Surface.load(str(folder / "compressed.sur"))
offset = again.metadata["offset_z"] * 1e-6  # surfalize adds it, fstiff does not: a constant
expect("compressed.sur", again.data * 1e-6 - offset, again.step_x * 1e-6, again.step_y * 1e-6, "surfalize")

# --- NumPy ---
np.save(folder / "fortran.npy", np.asfortranarray((z * 1e9).astype(">f4")))
expect("fortran.npy", np.load(folder / "fortran.npy").astype(float) * 1e-9, reader="NumPy")

# --- text ---
def write(name, text, encoding="utf-8"):
    (folder / name).write_bytes(text.encode(encoding))


def rows(cell, between, unit=1e-6):
    return "".join(between.join(cell % (value / unit) for value in row) + "\n" for row in z)


def as_printed(cell, unit=1e-6):
    return np.array([[float(cell % (value / unit)) for value in row] for row in z]) * unit


keyence = ('"{date}","2026-01-01 12:00:00"\n"{model}","VK-X3000 Series"\n"{kind}","ImageDataCsv"\n"{pitch}","277.800","nm"\n'
           '"{across}","8"\n"{down}","6"\n"{low}","-1"\n"{unit}","\u00b5m"\n"{other}",""\n\n"{height}"\n' +
           rows('"%.4f"', ","))
write("keyence.csv", keyence.format(
    date="Measured date", model="Model", kind="Data type\n", pitch="XY Calibration", across="Horizontal", down="Vertical",
    low="Minimum value", unit="Unit", other="Reference data name", height="Height"), "utf-8-sig")
write("keyence-german.csv", keyence.format(
    date="Gemessenes Datum", model="Modell", kind="Dateityp", pitch="XY-Justierung", across="Horizont.", down="Vertikal",
    low="Mindestwert", unit="Einheit", other="Referenzdatenname", height="H\u00f6he"), "cp1252")
for name in ("keyence.csv", "keyence-german.csv"):
    expect(name, as_printed("%.4f"), 277.8e-9, 277.8e-9)

spip = "# File Format = ASCII\n# x-pixels = 8\n# y-pixels = 6\n# x-length = 2000\n# y-length = 3000\n{}# Start of Data:\n"
write("spip.asc", spip.format("# z-unit = nm\n# voidpixels =0\n") + rows("%.2f", "\t", 1e-9))
read_by_surface_topography("spip.asc", unit=1e-9)
write("spip-counts.asc", spip.format("# Bit2nm = 0.5\n") + rows("%.0f", "\t", 0.5e-9))
read_by_surface_topography("spip-counts.asc", unit=1e-9)

languages = {
    "czech": ("Kan\u00e1l", "\u0160\u00ed\u0159ka", "V\u00fd\u0161ka", "Jednotky hodnot", ":", "cp1250"),
    "german": ("Kanal", "Breite", "H\u00f6he", "Einheiten", ":", "cp1252"),
    "french": ("Canal", "Largeur", "Hauteur", "Unit\u00e9s", "\u00a0:", "utf-16"),
    "spanish": ("Canal", "Anchura", "Altura", "Unidades de valor", ":", "utf-8"),
    "italian": ("Canale", "Larghezza", "Altezza", "unit\u00e0 valore", ":", "cp1252"),
    "japanese": ("\u30c1\u30e3\u30cd\u30eb", "\u5e45", "\u9ad8\u3055", "\u5024\u306e\u5358\u4f4d", "\uff1a", "utf-8"),
    "korean": ("\ucc44\ub110", "\ud3ed", "\ub192\uc774", "\uac12 \ub2e8\uc704", ":", "utf-16"),
    "russian": ("\u041a\u0430\u043d\u0430\u043b", "\u0428\u0438\u0440\u0438\u043d\u0430", "\u0412\u044b\u0441\u043e\u0442\u0430",
                "\u0415\u0434\u0438\u043d\u0438\u0446\u044b \u0438\u0437\u043c\u0435\u0440\u0435\u043d\u0438\u044f", ":", "utf-8"),
}
for language, (channel, width, height, unit, colon, encoding) in languages.items():
    header = f"# {channel}{colon} z\n# {width}{colon} 2.0 \u00b5m\n# {height}{colon} 3.0 \u00b5m\n# {unit}{colon} m\n"
    text = header + rows("%.6e", "\t", 1)
    points = encoding in ("utf-8",)
    write(f"gwyddion-{language}.txt", text if points else text.replace(".", ","), encoding)
    if points:
        read_by_surface_topography(f"gwyddion-{language}.txt")
    else:
        expect(f"gwyddion-{language}.txt", as_printed("%.6e", 1))

# --- profiles in records: ISO 5436-2, and its elder form as the help of NPL's softgauges shows it ---
smd = (f"ISO 5436-2:2012\0trace.smd\0\r\nPRF\0 1 ISO5436\0\r\nCX\0 I\0 40 mm\0 1.0e0 D\0 2.50000e-004 \r\n"
       f"CZ\0 A\0 40 um\0 1.0e0 D\0\r\n\3\r\nDATE: 01-January-2026\0\r\nTIME: 12:00\0\r\nCREATED_BY a script\0\r\n"
       f"COMMENT /* none */\0\r\n\3\r\n" + "".join(f"{value:.5f}\r\n" for value in trace) + "\3\r\n")
write("trace.smd", smd + f"{sum(smd.encode()) % 65535}\r\n\3\r\n\x1a")
expect("trace.smd", np.array([float(f"{value:.5f}") for value in trace]) * 1e-6, 0.25e-6, 0.25e-6)
write("trace.prf", "1 2\r\nSG2004 0.000000e+000 PRF\r\nCX M 4.000000e+001 MM 1.000000e+000 D\r\n"
      "CZ M 4.000000e+001 UM 1.000000e-006 L\r\nEOR\r\nSTYLUS_RADIUS 2.000000e-003 MM\r\nSPACING CX 2.500000e-004\r\n"
      "MAP 1.000000e+000 CZ CZ 1.000000e+000 1.000000e+000\r\nMAP 2.000000e+000 CZ CX 1.000000e+000 0.000000e+000\r\n"
      "COMMENT a trace\r\nEOR\r\n" + "".join(f"{value * 1e6:.0f}\r\n" for value in trace) + "EOR\r\nEOF\r\n")
expect("trace.prf", np.array([float(f"{value * 1e6:.0f}") for value in trace]) * 1e-12, 0.25e-6, 0.25e-6)

with open(data / "formats_expected.csv", "w", encoding="utf-8") as table:
    table.write("file,reader,dx,dy,rows,columns,heights\n")
    for row in expected:
        table.write(",".join(repr(value) if isinstance(value, float) else str(value) for value in row) + "\n")
