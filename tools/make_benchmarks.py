#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Turns the JSON of the benchmark program into documents.

    build/native/bin/fstiff_bench --benchmark_repetitions=5 --benchmark_out=native.json --benchmark_out_format=json
    build/portable/bin/fstiff_bench --benchmark_filter=fstiff --benchmark_out=portable.json --benchmark_out_format=json
    tools/make_benchmarks.py native.json --portable portable.json
    tools/make_benchmarks.py            writes the documents again from bench/results.json
    tools/make_benchmarks.py --check    exit code 1 when they are not what bench/results.json gives

The least processor time of the repetitions of each row goes to bench/results.json, with its errors and the machine's name. From
it are written the tables between <!-- benchmarks --> and <!-- /benchmarks --> in docs/benchmarks.md, and
docs/benchmarks.svg. A row whose verification failed is shown as such, without a time.
"""
import argparse
import csv
import datetime
import json
import math
import re
import sys

from generated import ROOT, Axis, Picture, between_markers, powers, table, write_or_check

RESULTS = ROOT / "bench" / "results.json"
COUNTERS = ("rel_err_max", "rel_err_median", "evaluations", "values", "wrong", "beyond_estimate", "ns_median_problem")
UNIT = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}

METHODS = {  # in the order of the tables: what the documents call it; in the picture: colour on light, colour on dark, marker
    "fstiff": ("fstiff, one dimension", ("#b3261e", "#ff8a80", "circle")),
    "fstiff-tensor": ("fstiff, two dimensions", ("#c2571a", "#ffb27a", "square")),
    "fstiff-paper": ("fstiff, the paper's 50 x 50 points", None),
    "gauss_legendre-fitted": ("Gauss-Legendre by hand, nodes for each problem", ("#0b5d3b", "#7be0ae", "cross")),
    "gauss_legendre-tuned": ("Gauss-Legendre by hand, nodes for the grid", ("#1b7f54", "#5ccf97", "triangle")),
    "gauss_legendre-eigen": ("Gauss-Legendre on a box, Eigen arrays", ("#5b7f1b", "#bcdc6e", "diamond")),
    "gauss_legendre-scalar": ("Gauss-Legendre on a box, scalar", ("#7a6a00", "#e0cf5a", "diamond")),
    "gsl-1d": ("GSL qag, one dimension, U(a,b,x)", ("#0b57a4", "#7db8ff", "circle")),
    "gsl-nested_qag": ("GSL qag in qag", ("#2f6fd0", "#a9cbff", "square")),
    "gsl-nested_cquad": ("GSL cquad in cquad", ("#3d3fa8", "#b3b5ff", "triangle")),
    "cubature": ("cubature (pcubature)", ("#7a2f9e", "#dba4f5", "circle")),
    "boost-exp_sinh": ("Boost exp_sinh in exp_sinh", ("#9c2470", "#f59acb", "square")),
}


def rows_of(data):
    """The row of least processor time for each name."""
    rows = {}
    for raw in data["benchmarks"]:
        if raw.get("run_type") == "aggregate":
            continue
        name = raw.get("run_name", raw["name"])
        if raw.get("error_occurred"):
            said = dict(re.findall(r"(\w+)=(\S+)", raw["error_message"]))
            rows[name] = {key: float(said[key]) for key in COUNTERS if key in said}
            continue
        row = {"ns": raw["cpu_time"] * UNIT[raw["time_unit"]]} | {key: raw[key] for key in COUNTERS if key in raw}
        if name not in rows or row["ns"] < rows[name]["ns"]:
            rows[name] = row
    rounded = lambda value: float(f"{value:.4g}") if math.isfinite(value) else "inf"
    return {name: {key: rounded(value) for key, value in row.items()} for name, row in rows.items()}


def processor():
    info = dict(re.findall(r"^(model name|cpu family|model|flags)\s*: (.*)$", open("/proc/cpuinfo").read().split("\n\n")[0], re.M))
    vectors = next((name for flag, name in (("avx512f", "AVX-512"), ("avx2", "AVX2")) if flag in info.get("flags", "").split()), "SSE2")
    return f"{info.get('model name', 'unknown processor')} (family {info.get('cpu family', '?')}, model {info.get('model', '?')}, {vectors})"


def measure(native, portable):
    data = json.load(open(native))
    context = data["context"]
    out = {"machine": f"{processor()}, {context['mhz_per_cpu']} MHz, one core", "compiler": context["compiler"], "flags": context["flags"],
           "date": datetime.date.today().isoformat(), "rows": rows_of(data)}
    if portable:
        other = json.load(open(portable))
        out["portable"] = {"flags": other["context"]["flags"], "ns": {name: row["ns"] for name, row in rows_of(other).items() if "ns" in row}}
    elif RESULTS.exists():
        out["portable"] = json.loads(RESULTS.read_text()).get("portable")
    RESULTS.write_text(json.dumps(out, indent=1) + "\n")


def show_time(ns):
    for limit, scale, unit in ((1e3, 1, "ns"), (1e6, 1e3, "µs"), (1e9, 1e6, "ms")):
        if ns < limit * 0.9995:
            return f"{ns / scale:.3g} {unit}"
    return f"{ns / 1e9:.3g} s"


show_error = lambda value: "no digit" if not math.isfinite(float(value)) else f"{float(value):.0e}"
ratio = lambda value: f"{value:.2f}" if value < 10 else f"{value:.0f}"


def cells(row):
    time = show_time(row["ns"]) if "ns" in row else "not timed"
    return [time, show_error(row["rel_err_max"]), show_error(row["rel_err_median"]), f"{float(row['evaluations']):.4g}"]


class Report:
    def __init__(self, results):
        self.results, self.rows = results, results["rows"]

    def ns(self, name):
        return self.rows.get(name, {}).get("ns")

    def integrals(self, what, grid):
        """(method, setting, row), by METHODS and then by falling tolerance."""
        found = []
        for name, row in self.rows.items():
            parts = name.split("/")
            if parts[0] == "integrals" and parts[2:4] == [what, grid]:
                found.append((parts[1], parts[4], row))
        return sorted(found, key=lambda at: list(METHODS).index(at[0]))

    def summary(self):
        """(what, figure, whether it is within its bound) of the figures that the tables do not show as a row."""
        ns, row = self.ns, lambda name: self.rows.get(name, {})
        four, hard = (row(f"integrals/fstiff/four/{grid}/1e-12") for grid in ("plain", "hard"))
        out = []

        def at_most(text, value, limit, show):
            out.append((text, "not measured" if value is None else show(value), value is None or value <= limit))

        def faster(text, peer, least):
            other = ns(f"integrals/{peer}/four/plain/1e-12")
            times = other / four["ns"] if other and "ns" in four else None
            out.append((text, times and f"{ratio(times)} times ({show_time(four['ns'])} against {show_time(other)})" or "peer not found", not times or times >= least))

        total = lambda key, rows: sum(row[key] for row in rows if key in row) if any(key in row for row in rows) else None
        count, starting = (lambda n: f"{n:.0f}"), (lambda prefix: [row for name, row in self.rows.items() if name.startswith(prefix)])
        kink, portable = starting("kernel/elastic_plastic/"), (self.results.get("portable") or {}).get("ns", {})
        slower = {text: portable[name] / ns(name) for name, text in (("integrals/fstiff/four/plain/1e-12", "four integrals"), ("kernel/gradual_yield/1e-12", "kernel"),
                                                                     ("law/stiffness_of_pressure/scalar", "tabulated law")) if name in portable and ns(name)}
        at_most("four integrals, plain grid: largest relative error, 1e-12 asked for", four.get("rel_err_max"), 1e-12, show_error)
        at_most("four integrals, hard grid: largest relative error, 1e-12 asked for", hard.get("rel_err_max"), 1e-12, show_error)
        at_most("hard grid: median over the problems, per value", hard["ns_median_problem"] / 4 if "ns_median_problem" in hard else None, 1000, show_time)
        faster("faster than GSL in one dimension", "gsl-1d", 150)
        faster("faster than GSL cquad in cquad", "gsl-nested_cquad", 5000)
        at_most("values beyond their error estimate, both grids", total("beyond_estimate", starting("integrals/fstiff/")), 0, count)
        at_most("the same of the kernel, law with a kink", total("beyond_estimate", kink), 0, lambda n: f"{n:.0f} of {total('values', kink):.0f}" if n else "0")
        at_most("heap allocations of an evaluation (bench/baseline.csv)", self.allocations(), 0, count)
        at_most("time with plain -O2, over -O3 -march=native", max(slower.values(), default=None), 4,
                lambda _: ", ".join(f"{text} {ratio(times)}" for text, times in slower.items()))
        for name, limit in (("law/stiffness_of_pressure/scalar", 8), ("law/pressure_and_stiffness_of_gap/scalar", 8), ("law/compile", 50e3),
                            ("kernel/gradual_yield/1e-12", 2e3), ("contact/at_pressure/all", 2e3)):
            if (ns(name) or 0) > limit:
                out.append((name, show_time(ns(name)), False))
        return out

    @staticmethod
    def allocations():
        return sum(int(row["allocations"]) for row in csv.DictReader((ROOT / "bench" / "baseline.csv").open()) if row["row"] != "law/compile")

    def source(self):
        r = self.results
        portable = f"; plain: {r['portable']['flags']}" if r.get("portable") else ""
        return f"({r['machine']}; {r['compiler']} {r['flags']}{portable}; {r['date']}; least of the repetitions)"

    def document(self):
        summary = self.summary()
        if slow := [f"{what}: {figure}" for what, figure, within in summary if not within]:
            raise SystemExit("beyond its bound: " + "; ".join(slow))
        lines = ["## In short", "", *table(["", "figure"], [[what, figure] for what, figure, _ in summary])]
        head = ["time", "largest relative error", "median", "evaluations"]
        one = {(method, setting): row for method, setting, row in self.integrals("stiffness", "plain")}
        for title, grid in (("Four integrals, plain grid", "plain"), ("Four integrals, hard grid", "hard")):
            base, hard = self.ns(f"integrals/fstiff/four/{grid}/1e-12"), grid == "hard"
            body = []
            for method, setting, row in self.integrals("four", grid):
                wrong = f"{row['wrong']:.0f} of {row['values']:.0f}" if hard and setting == "1e-12" else ""
                alone = one.get((method, setting), {})
                body.append([METHODS[method][0], setting, *cells(row), ratio(row["ns"] / base) if "ns" in row and base else ""]
                            + ([wrong] if hard else [show_time(alone["ns"]) if "ns" in alone else "", show_error(alone["rel_err_max"]) if alone else ""]))
            body += [] if hard else [[METHODS[method][0], setting, "", "", "", "", "", show_time(row["ns"]), show_error(row["rel_err_max"])]
                                     for (method, setting), row in one.items() if not self.rows.get(f"integrals/{method}/four/plain/{setting}")]
            others = ["values off by more than 1e-6"] if hard else ["one integral (stiffness): time", "largest relative error"]
            lines += [f"## {title}", "", *table(["method", "asked for", *head, "time over fstiff at 1e-12"] + others, body)]

        def rows(prefix, before="", kernel=False):
            for name, row in self.rows.items():
                if name.startswith(prefix + "/"):
                    beyond = f"{row.get('beyond_estimate', math.nan):.0f} of {row['values']:.0f}" if kernel else ""
                    yield [before + name.split("/", 1)[1].replace("/", ", ").replace("_", " "), *cells(row)] + [beyond] * kernel

        lines += ["## Kernel in two dimensions, laws of a user", "", *table(["row", *head, "values beyond their error estimate"], list(rows("kernel", kernel=True)))]
        others = (("law", "tabulated law, 1e5 to 1e8 Pa: "), ("law_of_map", "law of a map, with kinks: "), ("contact", "contact: "), ("profile", "profile: "), ("topography", "map: "), ("io", "file: "))
        lines += ["## Tabulated laws, contacts, profiles and maps", "", *table(["row", *head], [row for prefix, before in others for row in rows(prefix, before)])]
        return "\n".join(lines + [self.source()])


# ---------------------------------------------------------------- picture

def picture(report):
    curves = {method: [] for method, (_, look) in METHODS.items() if look}
    for method, _, row in report.integrals("four", "plain"):
        if method in curves and "ns" in row:
            curves[method].append((float(row["rel_err_max"]), row["ns"]))
    curves = {method: sorted(points, reverse=True) for method, points in curves.items() if points}
    errors, times = zip(*(point for points in curves.values() for point in points))
    ends = lambda values: (math.floor(math.log10(min(values))), math.ceil(math.log10(max(values))))
    (best, worst), (fastest, slowest) = ends(errors), ends(times)
    out = Picture(1040, 572, "Time of four contact integrals against the largest relative error, for fstiff and other methods", [METHODS[m][1] for m in curves])
    out.text(80, 28, "Four contact integrals, cold, plain grid: time against error", 'class="title"')
    place = out.frame(80, 56, 560, 440,
                      Axis("largest relative error on the grid (right: more digits)", 10.0**worst, 10.0**best, powers(best, worst, 2)),
                      Axis("time for four integrals (down: faster)", 10.0**fastest, 10.0**slowest,
                           {time: show_time(time) for time in powers(fastest, slowest)}))
    for i, points in enumerate(curves.values()):
        out.curve(i, [place(*point) for point in points])
    slow_first = sorted(enumerate(curves), key=lambda at: -min(ns for _, ns in curves[at[1]]))
    for line, (i, method) in enumerate(slow_first):
        out.sample(i, 664, 70 + 27 * line, METHODS[method][0])
    results = report.results
    out.text(80, 562, f"{results['machine']}; {results['compiler']} {results['flags']}", 'class="small"')
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("json", nargs="?", help="of the program built for this processor; without it bench/results.json serves")
    parser.add_argument("--portable", help="JSON of the program built with plain -O2")
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args()
    if options.json:
        measure(options.json, options.portable)
    report = Report(json.loads(RESULTS.read_text()))
    wanted = {ROOT / "docs" / "benchmarks.svg": picture(report)}
    document = ROOT / "docs" / "benchmarks.md"
    wanted[document] = between_markers(document, benchmarks=report.document())
    return write_or_check(wanted, "make_benchmarks.py", options.check)


if __name__ == "__main__":
    sys.exit(main())
