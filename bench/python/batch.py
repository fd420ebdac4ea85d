# SPDX-License-Identifier: BSD-3-Clause
"""A batch of 10^6 pressures through the Python package against the same batch in C++.

    python bench/python/batch.py [--compiler CXX] [--eigen FOLDER]

needs the package installed in the Python that runs it. Both sides are compared bit for bit before a time is shown: the least CPU
time of 30 runs of a tabulated law, and of 3 runs of 10^4 pressures through the contact itself.
"""

import argparse
import pathlib
import subprocess
import tempfile
import time

import numpy as np

import fstiff

ROOT = pathlib.Path(__file__).resolve().parents[2]


def least_time(repetitions, call):
    least = float("inf")
    for _ in range(repetitions):
        begin = time.process_time()
        result = call()
        least = min(least, time.process_time() - begin)
    return least, result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--eigen", default="/usr/include/eigen3")
    options = parser.parse_args()
    contact = fstiff.Contact(
        "hertz", rms_height=0.832e-6, peak_radius=40e-6, peak_density=500e6, r=0.5, theta=1.0, effective_modulus=112.6e9
    )
    law = contact.tabulate(1e5, 1e8)
    pressures = np.random.default_rng(1).permutation(np.geomspace(1e5, 1e8, 1_000_000))
    few = pressures[: pressures.size // 100]
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "law.txt").write_text(law.to_text())
        pressures.tofile(work / "pressures")
        subprocess.run(
            [options.compiler, "-std=c++20", "-O3", "-DNDEBUG", f"-I{ROOT / 'include'}", f"-I{options.eigen}",
             ROOT / "bench" / "python" / "batch.cpp", "-o", work / "batch"], check=True,
        )  # fmt: skip
        times, ours = [], []
        for _ in range(3):  # in turns, so that both meet the same other load
            printed = subprocess.run(
                [work / "batch", work / "law.txt", work / "pressures", work / "out"], check=True, capture_output=True, text=True
            ).stdout
            times.append([float(one) for one in printed.split()])
            law_time, of_law = least_time(30, lambda: law.stiffness(pressures))
            contact_time, points = least_time(3, lambda: contact.at_pressures(few, ["stiffness", "separation"]))
            ours.append([law_time, contact_time])
        theirs = np.fromfile(work / "out")
    assert (of_law == theirs[: of_law.size]).all() and (points.stiffness == theirs[of_law.size :]).all(), "results differ"
    for name, size, cpp, python in zip(("law", "contact"), (pressures.size, few.size), np.min(times, 0), np.min(ours, 0)):
        print(f"{name}: {size} pressures, C++ {cpp / size * 1e9:.2f} ns, NumPy {python / size * 1e9:.2f} ns each: {python / cpp:.2f} times")


if __name__ == "__main__":
    main()
