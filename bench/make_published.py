#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Judges the command by what others have measured or simulated (tests/data/published), into the tables of docs/published.md.

    bench/make_published.py --command build/release/bin/fstiff            writes the tables
    bench/make_published.py --command build/release/bin/fstiff --check    exit code 1 when they are not what the command gives
"""
import argparse
import csv
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tools"))
from generated import ROOT, Axis, Picture, between_markers, table, write_or_check

DOCUMENT, PICTURE, DATA = ROOT / "docs/published.md", ROOT / "docs/published.svg", ROOT / "tests/data/published"
BODIES = {"silicon": 'youngs_modulus = "160 GPa", poisson_ratio = 0.22, hardness = "11 GPa"',  # usual ones; others by name
          "beryllium_copper": 'youngs_modulus = "128 GPa", poisson_ratio = 0.3, hardness = "3.7 GPa"'}
MEDIA = {"silicone oil": 'conductivity = "0.14 W/(m K)"'}  # others by name
SQUARE, FLAT = 625, 'flatness = "0 um"\n'  # 25 mm square where the area is not stated [mm2]
INCONEL_HAYNES = ('[material]\nupper = { youngs_modulus = "200 GPa", poisson_ratio = 0.29, thermal_conductivity = "11.4 W/(m K)" }\n'
                  'lower = { youngs_modulus = "225 GPa", poisson_ratio = 0.3, thermal_conductivity = "9.4 W/(m K)" }\n')


def rows(name):
    with open(DATA / name, newline="") as file:
        return list(csv.DictReader(file))


def number(value):
    """Three digits, without a power of ten."""
    digits = max(0, 2 - math.floor(math.log10(abs(value)))) if value else 0
    return f"{float(f'{value:.3g}'):.{digits}f}"


def body(name, conductivity=""):
    return BODIES.get(name, f'name = "{name}"') + (f', thermal_conductivity = "{conductivity} W/(m K)"' if conductivity else "")


def scene_of(upper, lower, process, height, area, pressures, form=""):
    """Two faces of the same roughness; area [mm2], or "" for K of the faces, pressures [MPa]."""
    face, listed = f'{{ {height}, process = "{process}" }}', ", ".join(f'"{one:.6g} MPa"' for one in pressures)
    size = f'nominal_area = "{area} mm^2"\n{form}' if area else ""
    return (f"material = {{ upper = {{ {upper} }}, lower = {{ {lower} }} }}\n[surface]\nupper = {face}\nlower = {face}\n"
            f"[contact]\npressures = [{listed}]\n{size}")


def span(low, high):
    return f"{low:.2f}–{high:.2f}"


def met(of, wanted, low, high):
    """Where the falling function is as wanted, by halves of the logarithm."""
    for _ in range(14):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if of(middle) > wanted else (low, middle)
    return low


class Judge:
    def __init__(self, command):
        self.command = command

    def run(self, scene):
        """Answer and rows of the laws of a scene."""
        found = subprocess.run([self.command, "run", "-", "--format", "json"], input=scene, capture_output=True, text=True)
        if not found.stdout:
            raise RuntimeError(found.stderr)
        document = json.loads(found.stdout)
        return document["answer"], document["rows"]

    # Simulations: Gaussian, periodic, C(q) ~ q^(-2-2H); stiffness as K sigma/p, gaps in sigma.
    def gfmd_at(self, stars):
        """The answer and the laws by name at each p*; E = 1 GPa."""
        pressures = ", ".join(f'"{float(star) * 0.276597:.8g} GPa"' for star in stars)
        surface = 'rms_height = "6 um"\nrms_gradient = 0.276597\nalpha = 139.79\nhurst = 0.8\nskewness = 0\nkurtosis = 3\n'
        scene = (f'[surface]\n{surface}[material.upper]\nyoungs_modulus = "2 GPa"\npoisson_ratio = 0\nhardness = "infinite"\n[contact]\n'
                 f'laws = ["hybrid", "persson", "hertz"]\npressures = [{pressures}]\n'
                 '[output]\nquantities = ["stiffness", "separation", "real_area"]\n')
        answer, laws = self.run(scene)
        return answer, {name: [row for row in laws if row["law"] == name] for name in ("hybrid", "persson", "hertz")}

    def gfmd_stiffness(self):
        truth = [row for row in rows("gfmd.csv") if row["chord_p_star"]]
        answer, laws = self.gfmd_at([row["chord_p_star"] for row in truth])
        reduced = lambda row, key="stiffness_Pa_per_m": row[key] * 6e-6 / row["pressure_Pa"]
        for i, row in enumerate(truth):
            K = float(row["chord_K_rms_height_over_p"])
            low, high = (reduced(answer[i], f"stiffness_{end}_Pa_per_m") / K for end in ("p05", "p95"))
            yield [float(row["chord_p_star"]), K, *(reduced(laws[name][i]) / K for name in laws), low, high]

    def gfmd_gaps(self):
        truth = rows("gfmd.csv")
        _, laws = self.gfmd_at([row["p_star"] for row in truth])
        for i, row in enumerate(truth):
            gaps = [laws[name][i]["separation_m"] / 6e-6 for name in ("hybrid", "persson")]
            areas = [laws[name][i]["real_area_fraction"] for name in ("hybrid", "persson")]
            yield [float(row["p_star"]), float(row["mean_gap_over_rms_height"]), *gaps, float(row["area_fraction"]), *areas]

    # Conductance: spots with their band and the gap beside them.
    def conductance(self, scene):
        answer, _ = self.run(scene)
        return [(row["thermal_conductance_gap_W_per_m2K"], *(row[f"thermal_conductance{end}_W_per_m2K"] for end in ("", "_p05", "_p95")))
                for row in answer]

    def joint(self, upper, lower, process, height, pressure, gap, form=""):
        return self.conductance(scene_of(upper, lower, process, f'rms_height = "{height:.6g} um"', SQUARE, [pressure], form) + f"[gap]\n{gap}\n")[0]

    def joints(self, form=""):
        for row in rows("joints.csv"):
            ends = lambda key, unit: [float(row[f"{key}_{end}_{unit}"]) for end in ("from", "to")]
            height, pressure = (math.sqrt(math.prod(ends(*of))) for of in (("roughness", "um"), ("pressure", "MPa")))
            of_row, h = (body(row["upper"]), body(row["lower"]), row["process"]), float(row["h_W_per_m2K"])
            gap, value, low, high = self.joint(*of_row, height, pressure, f'medium = "{row["medium"]}"', form)
            yield row, height, pressure, h, gap, [(gap + one) / h for one in (value, low, high)]

    def compared(self, row, form=""):
        """Value and band over what was measured, at each pressure of a row of measured_joints.csv."""
        pressures, measured = ([float(one) for one in row[key].split()] for key in ("pressures_MPa", "measured"))
        upper, lower = (body(row[side], row[f"conductivity_{side}_W_per_mK"]) for side in ("upper", "lower"))
        scene = scene_of(upper, lower, row["process"], f'{row["kind_of_height"]} = "{row["height_um"]} um"', row["area_mm2"], pressures, form)
        if row["quantity"] == "conductance":
            found = [[gap + one for one in spots] for gap, *spots in self.conductance(f'{scene}[gap]\nmedium = "{row["medium"]}"\n')]
        else:
            found = []
            for at in self.run(scene)[0]:
                K = [at[f"stiffness{end}_Pa_per_m"] / 1e12 for end in ("", "_p05", "_p95")]
                loading = at.get("loading_stiffness_Pa_per_m", at["stiffness_Pa_per_m"]) if row["quantity"] == "loading" else at["stiffness_Pa_per_m"]
                found.append([one * loading / at["stiffness_Pa_per_m"] for one in K])  # the band is that of K
        return [(p, [one / m for one in all_three]) for p, all_three, m in zip(pressures, found, measured, strict=True)]

    def by_group(self, form=""):
        """Group, joint and (p, value and band over the measured) of its points, of every measured joint."""
        for row in rows("measured_joints.csv"):
            yield row["group"], row["joint"], self.compared(row, form)
        handbook = {}
        for row, _, pressure, *_, ratios in self.joints(form):
            handbook.setdefault((joint_of(row), row["roughness_from_um"]), []).append((pressure, ratios))
        for (joint, _), points in handbook.items():
            yield "handbook", joint, points

    def filled(self, medium, height):
        """h of the gap between aluminium faces at 1 atm, and h of the spots with its band."""
        filling = MEDIA.get(medium, f'medium = "{medium}"')
        return self.joint('name = "aluminium"', 'name = "aluminium"', "unknown", height, 0.101325, filling)

    def media(self):
        """h of each medium, and what it has more than air over that of the gap which makes it so for helium."""
        measured = {row["medium"]: float(row["h_W_per_m2K"]) for row in rows("media.csv")}
        more = lambda medium, height: self.filled(medium, height)[0] - self.filled("air", height)[0]
        height = met(lambda one: more("helium", one), measured["helium"] - measured["air"], 0.5, 20)
        for medium, h in measured.items():
            gap, value, low, high = self.filled(medium, 10)
            told = "" if medium == "air" else f"{(h - measured['air']) / more(medium, height):.2f}"
            yield medium, h, gap, [(gap + one) / h for one in (value, low, high)], told
        self.width = 0.598 / self.filled("water", height)[0]

    def in_air(self, finish):
        """Rms height that makes the answer meet h of the first row [um], and the rows with what it then says."""
        mine = [row for row in rows("inconel_haynes.csv") if row["finish"] == finish]
        pressures = ", ".join(f'"{row["pressure_kPa"]} kPa"' for row in mine)
        contact = f'[contact]\npressures = [{pressures}]\n[gap]\nmedium = "air"\n'
        at = lambda height: self.conductance(f'{INCONEL_HAYNES}[surface]\nrms_height = "{height:.6g} um"\n{contact}')
        height = met(lambda one: sum(at(one)[0][:2]), float(mine[0]["h_median_W_per_m2K"]), 0.1, 20)
        return height, list(zip(mine, at(height)))

    # Rock: sigma of two faces that do not mate, from chords of the loading curve with errors of 5 %.
    def identified(self, curve):
        scene = ('surface = { rms_height = "100 um", rms_gradient = 0.3, alpha = 20 }\ncontact.pressures = ["1 MPa"]\n'
                 'material.upper = { youngs_modulus = "11 GPa", poisson_ratio = 0.33, hardness = "infinite" }\n')
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("pressure [MPa],stiffness [MPa/um],error [MPa/um]\n")
            for (p0, d0), (p1, d1) in zip(curve, curve[1:]):
                K = (p1 - p0) / (d1 - d0) / 1000
                file.write(f"{math.sqrt(p0 * p1):.6g},{K:.6g},{0.05 * K:.6g}\n")
            file.flush()
            found = subprocess.run([self.command, "identify", "-", "--measured", file.name, "--fit", "sigma", "--format", "json"],
                                   input=scene, capture_output=True, text=True)
        fit = json.loads(found.stdout)["fits"][0]
        return f'{fit["parameters"][0]["value"] * 1e6:.0f}', f'{fit["chi_squared"] / fit["degrees_of_freedom"]:.0f}'

    # Metals that flow: K of unloading over K of loading, and over the elastic laws.
    def flowing(self, body, height, gradient, pressure, laws=""):
        slope = f"rms_gradient = {gradient}\n" if gradient else ""
        return self.run(f'material.upper = {body}\n[surface]\nrms_height = "{height} um"\n{slope}process = "ground"\n[contact]\n'
                        f'pressures = ["{pressure} MPa"]\n{laws}')


def tables_of_simulation(judge):
    stiffness = [[f"{p:.2g}", f"{K:.2f}", *(f"{one:.2f}" for one in laws), span(low, high), "yes" if low <= 1 <= high else "no"]
                 for p, K, *laws, low, high in judge.gfmd_stiffness()]
    gaps = [[f"{p:.2g}", *(f"{one:.3f}" for one in gap), *(f"{one:.3f}" for one in area)]
            for p, *both in judge.gfmd_gaps() for gap, area in [(both[:3], both[3:])]]
    return "\n".join(table(["p*", "K σ/p", "hybrid", "persson", "hertz", "answer, 90 % band", "covers"], stiffness) +
                     table(["p*", "gap/σ", "hybrid", "persson", "real area", "hybrid", "persson"], gaps)).rstrip()


def inside(points):
    return sum(low <= 1 <= high for _, (_, low, high) in points)


def summary(joints):
    """Joints, points and points covered; coverage as the mean over joints; medians over points of the width and of the value."""
    points = [one for joint in joints for one in joint]
    return [f"{len(joints)}", f"{inside(points)} of {len(points)}", f"{statistics.mean(inside(one) / len(one) for one in joints):.2f}",
            number(statistics.median(high / low for _, (_, low, high) in points)), f"{statistics.median(ratios[0] for _, ratios in points):.2f}"]


def tables_of_groups(judge):
    found, flat = list(judge.by_group()), list(judge.by_group(FLAT))
    air, above = "aluminium in air", lambda joint: [one for one in joint if one[0] >= 10]
    of = lambda joints, group: [points for name, _, points in joints if name == group]
    lines = []
    for group in dict.fromkeys(name for name, *_ in found):
        lines.append([group, *summary(of(found, group)), *summary(of(flat, group))[1:4]])
    first = next(iter(found))[0]
    high, high_flat = ([above(one) for one in of(joints, first) if above(one)] for joints in (found, flat))
    lines.insert(1, ["of these from 10 MPa on", *summary(high), *summary(high_flat)[1:4]])
    but_air = lambda joints: [points for name, _, points in joints if name != air]
    lines += [[f"**all but {air}**", *summary(but_air(found)), *summary(but_air(flat))[1:4]],
              ["**all**", *summary([points for *_, points in found]), *summary([points for *_, points in flat])[1:4]]]
    to = lambda values: "–".join(dict.fromkeys(f"{float(f'{one:.2g}'):g}" for one in (min(values), max(values))))
    each = []
    for row, (_, joint, points), (*_, other) in zip(rows("measured_joints.csv"), found, flat):  # the handbook has its own table
        what = f'h, {row["medium"]}' if row["medium"] else f'K of {row["quantity"]}'
        each.append([joint, what, to([p for p, _ in points]), to([ratios[0] for _, ratios in points]),
                     to([high / low for _, (_, low, high) in points]), f"{inside(points)} of {len(points)}", f"{inside(other)} of {len(other)}",
                     row["assumed"]])
    head = ["joints", "covers", "coverage, mean over joints", "width, median", "answer ÷ measured, median"]
    of_flat = ["flat: covers", "flat: coverage", "flat: width"]
    return "\n".join(table(["group", *head, *of_flat], lines) +
                     table(["joint", "measured", "p [MPa]", "answer ÷ measured", "width", "covers", "flat: covers", "assumed"], each)).rstrip()


def tables_of_joints(judge):
    lines, covered = [], 0
    for row, height, pressure, h, gap, (value, low, high) in judge.joints():
        covers = low <= 1 <= high
        covered += covers
        lines.append([joint_of(row), number(height), number(pressure), number(h), number(gap), f"{value:.2f}", span(low, high),
                      "yes" if covers else "no"])
    flat = sum(low <= 1 <= high for *_, (_, low, high) in judge.joints(FLAT))
    head = ["joint", "roughness [µm]", "p [MPa]", "h measured", "h of the gap, computed", "answer ÷ measured", "90 % band", "covers"]
    fluids = [[medium, number(h), number(gap), f"{value:.2f}", span(low, high), "yes" if low <= 1 <= high else "no", told]
              for medium, h, gap, (value, low, high), told in judge.media()]
    return "\n".join(table(head, lines) + [f"The band covers {covered} of {len(lines)}; of flat faces it would cover {flat}.", ""] +
                     table(["between aluminium faces", *head[3:], "more than air, over that of the gap of helium"], fluids) +
                     [f"The difference between helium and air is that of a gap of {judge.width * 1e6:.0f} µm."]).rstrip()


def tables_in_air(judge):
    lines, growth = [], []
    for finish in ("smooth", "med", "rough"):
        height, found = judge.in_air(finish)
        measured = [float(row["h_median_W_per_m2K"]) for row, _ in found]
        sums = [gap + spots for _, (gap, spots, *_) in found]
        for i in (0, 2, 4, 6, 9):
            row, (gap, spots, low, high) = found[i]
            lines.append([f"{finish}, σ {height:.1f} µm", number(float(row["pressure_kPa"])), number(measured[i]), number(gap),
                          f"{number(spots)} ({number(low)}–{number(high)})", f"{sums[i] / measured[i]:.2f}"])
        share = [found[-1][1][k] - found[6][1][k] for k in (0, 1)]
        growth.append([finish, f"{measured[-1] / measured[0]:.2f}", f"{sums[-1] / sums[0]:.2f}", f"{measured[-1] - measured[6]:.0f}",
                       *(f"{one:.0f}" for one in share)])
    return "\n".join(table(["finish", "p [kPa]", "h measured", "h of the gap", "h of the contacts", "sum/measured"], lines) +
                     table(["finish", "h last/first, measured", "the same, computed", "growth of h from 115 to 226 kPa, measured", "of the gap",
                            "of the contacts"], growth)).rstrip()


def branch_of(specimen, branch):
    """Pressures [MPa] and closures [mm] of a fracture, by rising pressure."""
    return sorted((float(row["pressure_MPa"]), float(row["closure_mm"])) for row in rows("rock_fractures.csv")
                  if (row["specimen"], row["branch"]) == (specimen, branch))


def slope_at(curve, pressure):
    """dp/d(closure) across the row nearest to the pressure [MPa/mm]."""
    here = min(range(1, len(curve) - 1), key=lambda i: abs(curve[i][0] - pressure))
    return (curve[here + 1][0] - curve[here - 1][0]) / (curve[here + 1][1] - curve[here - 1][1])


def tables_of_rock(judge):
    lines, fits = [], []
    for specimen in ("vd1", "vd2", "vd3"):
        loading, unloading = branch_of(specimen, "loading"), branch_of(specimen, "unloading")
        for pressure in (loading[4][0], loading[7][0], loading[10][0]):  # 2, 5 and 8 MPa
            K, back = slope_at(loading, pressure), slope_at(unloading, pressure)
            lines.append([specimen, f"{pressure:.1f}", f"{K:.0f}", f"{back:.0f}", f"{back / K:.2f}", f"{1000 * pressure / K:.0f}"])
        grows = math.log(slope_at(loading, loading[10][0]) / slope_at(loading, loading[4][0])) / math.log(loading[10][0] / loading[4][0])
        fits.append([specimen, f"p^{grows:.2f}", *judge.identified(loading)])
    return "\n".join(table(["fracture", "p [MPa]", "K loading [MPa/mm]", "K unloading", "unloading/loading", "p/K loading [µm]"], lines) +
                     table(["fracture", "K grows as", "σ of hybrid [µm]", "chi²/dof"], fits)).rstrip()


def tables_of_metals(judge):
    wave, over_gw = (float(next(row["value"] for row in rows("ratios.csv") if row["quantity"].startswith(start)))
                     for start in ("K by ultrasound over", "over K of Greenwood"))
    titanium = '{ name = "titanium", hardness = "3.4 GPa" }'
    ratios = []
    for gradient in (0.05, 0.1, 0.2, 0.3, 0.5):
        row = judge.flowing(titanium, 0.5, gradient, 70)[0][0]
        ratio = row["stiffness_Pa_per_m"] / row["loading_stiffness_Pa_per_m"] if "loading_stiffness_Pa_per_m" in row else 1
        ratios.append([f"{gradient:g}", row["law"], f"{ratio:.2f}", f"{ratio / wave:.2f}"])
    steel, laws = '{ name = "steel", hardness = "7 GPa" }', 'laws = ["hertz", "greenwood_williamson"]\n'
    lines = []
    for height in (0.1, 0.2, 0.25, 0.4):
        row = judge.flowing(steel, height, None, 400)[0][0]
        K = [row[f"stiffness_{end}Pa_per_m"] for end in ("", "p05_", "p95_")]
        elastic = {one["law"]: one["stiffness_Pa_per_m"] for one in judge.flowing(steel, height, None, 400, laws)[1]}
        lines.append([f"{height:g}", row["law"], f"{K[0] / 1e15:.2f} ({K[1] / 1e15:.2f}–{K[2] / 1e15:.2f})", f'{K[0] / elastic["hertz"]:.2f}',
                      f'{K[0] / elastic["greenwood_williamson"]:.2f}', f'{K[0] / elastic["greenwood_williamson"] / over_gw:.2f}'])
    return "\n".join(table(["rms gradient", "law", "unloading/loading", "over the measured 3"], ratios) +
                     table(["σ [µm]", "law", "K answer, band [GPa/µm]", "K/hertz", "K/greenwood_williamson", "the same over 2.2"], lines)).rstrip()


def table_of_beam():
    """The modes of a bolted beam by K of each law, of a finite-element model outside of this repository."""
    of = {}
    for row in rows("brake_reuss_beam.csv"):
        of.setdefault(row["law"], {})[row["faces"]] = [row[key] for key in ("load mean of K [MPa/um]", *(f"{n} mode [Hz]" for n in ("first", "second", "third")))]
    missing = ["–"] * 4
    lines = [[law, *faces.get("flat", missing), *faces.get("form", missing)] for law, faces in of.items()]
    modes = ["first [Hz]", "second", "third"]
    return "\n".join(table(["K of each element by", "flat: K [MPa/µm]", *modes, "with form: K", *modes], lines)).rstrip()


def joint_of(row):
    return f'{row["upper"]} on {row["lower"]}, {row["process"]}, {row["medium"]}'.replace("_", " ")


def picture(judge):
    """The laws and the band over the simulated stiffness, and the answer over each measured conductance."""
    laws = {"hybrid": ("#1d1d1f", "#ececf1", "circle"), "persson": ("#c25700", "#ffb074", "square"),
            "hertz": ("#b3261e", "#ff8a80", "triangle")}
    out = Picture(900, 890, "Computed over simulated stiffness, and over measured conductance", list(laws.values()))
    one = {value: str(value) for value in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)}
    simulated = list(judge.gfmd_stiffness())
    out.text(80, 28, "Stiffness of a Gaussian surface: law over simulation", 'class="title"')
    place = out.frame(80, 48, 780, 260, Axis("p* = p/(E g), pressure over modulus times rms gradient", 0.0009, 0.75,
                                             {p: str(p) for p in (0.001, 0.01, 0.03, 0.1, 0.3, 0.6)}),
                      Axis("K over K of the simulation", 0.05, 2.5, {value: text for value, text in one.items() if value < 5}), strong=1)
    out.polygon("band m0", [place(row[0], row[-1]) for row in simulated] + [place(row[0], row[-2]) for row in simulated[::-1]])
    for i, law in enumerate(laws):
        out.curve(i, [place(row[0], row[2 + i]) for row in simulated])
        out.sample(i, 100, 210 + 26 * i, law)
    out.rectangle("band m0", 190, 201, 26, 18)
    out.text(224, 214, "answer, 90 % band")

    joints = list(judge.joints())
    out.text(80, 396, "Conductance of metal joints: answer over measurement, with its 90 % band", 'class="title"')
    across = Axis("h over measured h", 0.05, 200, one)
    place = out.frame(420, 416, 440, 20 * len(joints), across, Axis("", len(joints), 0, {}, logarithmic=False), strong=1)
    for i, (row, _, pressure, *_, (value, low, high)) in enumerate(joints):
        middle, look = i + 0.5, 0 if low <= 1 <= high else 1
        if not across.low < low < high < across.high:
            raise ValueError(f"{joint_of(row)}: the band, {span(low, high)}, must be inside the axis of {PICTURE.name}")
        out.text(412, place(1, middle)[1] + 4, f"{joint_of(row)}, {number(pressure)} MPa", 'text-anchor="end" class="small"')
        out.curve(look, [place(low, middle), place(high, middle)], markers=False)
        out.markers(look, [place(value, middle)])
    for look, x, text in ((0, 80, "the band contains the measurement"), (1, 400, "the band does not contain it")):
        out.sample(look, x, 416 + 20 * len(joints) + 84, text)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--command", default=ROOT / "build/release/bin/fstiff")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    judge = Judge(options.command)
    text = between_markers(DOCUMENT, simulation=tables_of_simulation(judge), groups=tables_of_groups(judge), joints=tables_of_joints(judge), air=tables_in_air(judge),
                           rock=tables_of_rock(judge), metals=tables_of_metals(judge), beam=table_of_beam())
    return write_or_check({DOCUMENT: text, PICTURE: picture(judge)}, "../bench/make_published.py", options.check, 0.11)


if __name__ == "__main__":
    sys.exit(main())
