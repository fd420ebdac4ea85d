#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Contact pressure over a joint whose faces are not flat: the equations behind K of data/flanged_joint.toml, by numpy.

    pressure_of_form.py [--points 32] [--picture bolted_joint.svg]

    c(p) + u[p] + gap = delta,  mean p = force/area       c: closure of the roughness by a law of fstiff

u is the deflection of a half space under the cosines of a quarter of the faces, mirrored at its edges: 2/(E q) for each. Newton's
method steps in ln p. The last columns are those of `fstiff run`, which solves the same on a grid of its own. Units are SI.
"""

import argparse
from pathlib import Path

import fstiff
import numpy as np

SIDE, FLATNESS, FORCES, MODULUS = 50e-3, 10e-6, np.array([12e3, 25e3, 50e3]), 205e9 / (2 * (1 - 0.3**2))
SCENE = Path(__file__).resolve().parents[2] / "data/flanged_joint.toml"


def law_of_faces():
    """Loading law of the roughness alone."""
    face = {"Ra": "0.8 um", "process": "ground"}
    contact = {"pressures": [f"{p:.6g} Pa" for p in np.geomspace(1e3, 1e9, 61)], "nominal_area": "2500 mm^2", "flatness": "0 um"}
    scene = {"surface": {"upper": face, "lower": face}, "material": {"upper": "C45"}, "contact": contact}
    return fstiff.run(scene).answer.loading_law(0.5, outside="extrapolate")


def compliance(points):
    """Deflection [m/Pa] at the points of a quarter of the square under the pressure at each."""
    k = np.arange(points)
    cosines = np.sqrt(np.where(k, 2, 1) / points) * np.cos(np.pi * (k[:, None] + 0.5) * k / points)
    q = np.pi / (SIDE / 2) * np.hypot(k[:, None], k)
    q[0, 0] = np.inf  # the mean pressure moves the bodies as a whole
    modes = np.kron(cosines, cosines)
    return modes * (2 / (MODULUS * q.ravel())) @ modes.T


def pressures(law, gap, deflection, mean):
    """Pressure [Pa] at each point of the `gap` under the `mean` pressure, by Newton's method in ln p and delta."""
    log_p, delta = np.full(gap.size, np.log(mean)), None
    for _ in range(100):
        p = np.exp(log_p)
        separation = law.separation(p)
        rest = -separation + deflection @ p + gap
        delta = np.average(rest, weights=p) if delta is None else delta
        slopes = np.diag(p / law.tangent_at_separation(separation)[1]) + deflection * p
        step = np.linalg.solve(np.block([[slopes, -np.ones((gap.size, 1))], [p / p.size, 0]]), np.r_[delta - rest, mean - p.mean()])
        share = min(1.0, 1 / np.abs(step[:-1]).max())
        log_p, delta = log_p + share * step[:-1], delta + share * step[-1]
        if np.abs(step[:-1]).max() < 1e-8:
            return np.exp(log_p)
    raise RuntimeError(f"Newton's method does not converge at {mean} Pa")


def picture(name, x, gap, lines):
    """The gap before load, and the pressure under each force, along the middle of the joint."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"font.size": 10, "svg.hashsalt": "fstiff", "axes.spines.top": False, "axes.spines.right": False})
    figure, panels = plt.subplots(1, 2, figsize=(8.6, 3.4), layout="constrained")
    both = lambda values: np.r_[values[::-1], values]
    place = 1e3 * np.r_[-x[::-1], x]
    panels[0].plot(place, 1e6 * both(gap), color="#2f80d0")
    for (force, p), colour in zip(lines.items(), ("#2f80d0", "#d08020", "#d1453b")):
        panels[1].plot(place, 1e-6 * both(p), color=colour, label=f"{force / 1e3:.0f} kN")
        panels[1].axhline(1e-6 * force / SIDE**2, color=colour, lw=1, ls="--")
    panels[1].legend(frameon=False, title="dashed: force/area", alignment="left")
    for ax, title, label in zip(panels, ("Gap of the faces before load", "Contact pressure under the bolt"), ("gap [µm]", "p [MPa]")):
        ax.set_title(title, fontsize=10, fontweight="bold")
        ax.set(xlabel="place along the middle of the joint [mm]", ylabel=label, ylim=(0, None))
        ax.grid(color="#8a8a92", alpha=0.3, linewidth=0.6)
    panels[1].set_ylim(top=1.35 * panels[1].get_ylim()[1])
    figure.savefig(name, dpi=160, metadata={"Date": None} if name.endswith(".svg") else None)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--points", type=int, default=32, help="along half a side")
    parser.add_argument("--picture", help="file to draw, .png or .svg")
    options = parser.parse_args()
    x = (np.arange(options.points) + 0.5) * SIDE / 2 / options.points
    gap = FLATNESS * np.minimum(1, (2 * x[:, None] / SIDE) ** 2 + (2 * x / SIDE) ** 2)
    law, deflection, own, lines = law_of_faces(), compliance(options.points), fstiff.run(SCENE).answer, {}
    print("  force  greatest p   touching   fstiff run: greatest p   touching")
    for i, force in enumerate(FORCES):
        mean = force / SIDE**2
        p = pressures(law, gap.ravel(), deflection, mean)
        lines[force] = p.reshape(gap.shape)[0]
        numbers = force / 1e3, 1e-6 * p.max(), (p > 0.01 * mean).mean(), 1e-6 * own["greatest_local_pressure_Pa"][i], own["touching_share"][i]
        print("%4.0f kN  %6.1f MPa  %9.3f  %19.1f MPa  %9.3f" % numbers)
    if options.picture:
        picture(options.picture, x, gap[0], lines)


if __name__ == "__main__":
    main()
