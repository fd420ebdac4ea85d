#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Frequency and damping of a bolted beam against its amplitude, with the band that the roughness of its faces leaves.

    lap_joint.py [--contacts 101] [--amplitudes 13] [--picture backbone.png]

The lap of the beam has some hundred contacts, each with a law of fstiff:

    1. prestress by the loading law, without friction         K u + Q' A p(gap - Q u) = F
    2. the law of each contact after its own greatest load    p(d | p_max)
    3. modes with every contact stuck                         K + Q' A diag(k, ratio k) Q
    4. backbone of the first, x = x0 + xc cos wt + xs sin wt  M x'' - 2 zeta w M x' + K x + Q' f(Q x) = F, tip: b cos wt

Q x is the approach and the slip of each contact. Equation 4 is the extended periodic motion of Krack, Comput. Struct. 154
(2015) 34; zeta is the damping by friction alone. Units are SI.
"""

import argparse

import fstiff
import numpy as np
import scipy.sparse as sp
from beam import LAP, NU, Beam, E
from scipy.sparse.linalg import eigsh, spsolve

FORCE, FORM = 12e3, 50e-6  # of each bolt [N]; gap in the middle of the lap where its ends touch first [m]
FRICTION, RATIO, STEPS = 0.2, fstiff.tangential_ratio(E, NU, E, NU), 64  # steps of a cycle


def faces():
    """K of two rough faces together against the pressure, with its band."""
    steel = {"youngs_modulus": E, "poisson_ratio": NU, "hardness": 2.4e9}
    return fstiff.answer(rms_height=2e-6, rms_gradient=0.08, upper=steel, pressures=np.geomspace(1e3, 1e9, 61))


def prestress(beam, laws, gap, u):
    """Displacements under the bolts by Newton's method, from `u`; a step that does not lower the residual is halved."""
    step, size, normal = 0 * u, np.inf, beam.Q[::2]
    for _ in range(200):
        p, slope = laws.tangent_at_separation(gap - normal @ (u + step))
        residual = beam.K @ (u + step) + normal.T @ (beam.areas * p) - FORCE * beam.bolts
        if np.linalg.norm(residual) < size:
            u, size = u + step, np.linalg.norm(residual)
            if size < 1e-9 * FORCE:
                return u
            step = -spsolve((beam.K + normal.T @ sp.diags(beam.areas * slope) @ normal).tocsc(), residual)
        else:
            step = step / 2
    raise RuntimeError(f"the prestress does not converge: {size} N remain")


def modes(beam, stiffness, ratio=RATIO):
    """The three first bending modes with stuck contacts of a stiffness each [Pa/m]: frequencies [Hz], shapes."""
    springs = np.c_[stiffness, ratio * stiffness] * beam.areas[:, None]
    values, shapes = eigsh(beam.K + beam.Q.T @ sp.diags(springs.ravel()) @ beam.Q, 6, beam.M, sigma=0)
    return np.sqrt(values[3:]) / (2 * np.pi), shapes[:, 3:]  # without the three of the springs on which it is hung


class Joint:
    """The beam after it was tightened and has swung once with the amplitude `swing` of its tip [m].

    tightened     the first modes with K of each contact at its own pressure [Hz]
    frequencies   the same after the swing
    laws, separation, pressure, stiffness   of each contact at rest after the swing
    greatest      p_max of each contact [Pa]
    """

    def __init__(self, beam, answer, quantile, form, swing):
        self.beam, normal = beam, beam.Q[::2]
        loading = answer.loading_law(quantile, outside="extrapolate")
        gap, least = loading.touch + form, 2 * loading.pressures[0]  # a contact below `least` is open
        u = prestress(beam, loading, gap, np.zeros(beam.K.shape[0]))
        p, _ = loading.tangent_at_separation(gap - normal @ u)
        self.tightened, shapes = modes(beam, np.where(p > least, loading.stiffness(np.maximum(p, least)), 0.0))
        # The first cycle presses a contact beyond its pressure at rest and flattens it; from then on it is reversible. The margins are
        # for the change of the mode and of the pressures: a cycle that exceeds p_max would flatten further.
        closer = 2.0 * swing * np.abs(normal @ shapes[:, 0] / shapes[beam.tip, 0])
        self.greatest = np.maximum(1.1 * loading.tangent_at_separation(gap - normal @ u - closer)[0], least)
        self.laws = answer.law_after(self.greatest, quantile, outside="extrapolate")
        self.separation = gap - normal @ prestress(beam, self.laws, gap, u)
        self.pressure, self.stiffness = self.laws.tangent_at_separation(self.separation)
        self.frequencies, self.shapes = modes(beam, self.stiffness)

    def contact_forces(self, motion, steps=STEPS):
        """Harmonics of pressure and traction of each contact, their derivatives by those of its approach and slip, and the path."""
        angle = 2 * np.pi * np.arange(2 * steps) / steps  # the second cycle is periodic
        cycles = np.c_[np.ones_like(angle), np.cos(angle), np.sin(angle)]
        basis = np.vstack([np.zeros(3), cycles])  # the path begins at the prestress, which no harmonic moves
        increments = np.diff(basis, axis=0, prepend=0)
        relative = (self.beam.Q @ motion).reshape(-1, 2, 3)
        separation = self.separation[:, None] - relative[:, 0] @ basis.T
        slip = np.stack([relative[:, 1] @ increments.T, np.zeros_like(separation)], axis=-1)
        directions = np.zeros((len(basis), 3, 2, 3))
        directions[:, 0, 0], directions[:, 1, 1] = basis, increments
        path = self.laws.path(separation, slip, friction=FRICTION, ratio=RATIO, area=self.beam.areas,
                              directions=directions.reshape(-1, 3, 6))  # fmt: skip
        mean = cycles[:steps].T * np.array([[1.0], [2.0], [2.0]]) / steps
        loads = np.stack([path.pressure, path.traction[..., 0]], axis=1)[..., -steps:]
        loads[:, 0] -= (self.beam.areas * self.pressure)[:, None]
        by_relative = np.einsum("ht,etkd->ekhd", mean, path.by_directions[:, -steps:, :2])
        return loads @ mean.T, by_relative.reshape(-1, 6, 6), path

    def residual(self, motion, omega, zeta):
        """Harmonics of the forces on the beam, and their derivatives by those of the motion, by omega and by zeta."""
        forces, forces_by, _ = self.contact_forces(motion)
        beam, blocks = self.beam, np.arange(self.beam.contacts + 1)
        turn = lambda elastic, damping: np.array([[0, 0, 0], [0, -elastic, -damping], [0, damping, -elastic]])
        by_motion = sp.kron(beam.K, sp.identity(3)) + sp.kron(beam.M, turn(omega**2, 2 * zeta * omega**2))
        residual = by_motion @ motion.ravel() + beam.relative.T @ forces.ravel()
        by_motion += beam.relative.T @ sp.bsr_matrix((forces_by, blocks[:-1], blocks)) @ beam.relative
        by_numbers = [(beam.M @ motion @ by.T).ravel() for by in (turn(2 * omega, 4 * zeta * omega), turn(0, 2 * omega**2))]
        return residual, by_motion, np.stack(by_numbers, axis=1)

    def backbone(self, amplitudes):
        """For amplitudes of the tip [m], a row each: frequency [Hz], damping ratio, acceleration of the tip [m/s^2], Newton's steps, p/p_max."""
        shape, tip, rows = self.shapes[:, :1], self.beam.tip, []
        before = [np.r_[(shape / shape[tip] * [0, 1, 0]).ravel(), 2 * np.pi * self.frequencies[0], 0.0]]
        tied = sp.csr_matrix((np.ones(2), ([0, 1], [3 * tip + 1, 3 * tip + 2])), (2, 3 * len(shape)))
        for b in amplitudes:
            # the motion over b, omega and zeta go on straight from amplitude to amplitude
            guess = 2 * before[-1] - before[-2] if len(before) > 1 else before[-1]
            motion, (omega, zeta) = b * guess[:-2].reshape(-1, 3), guess[-2:]
            steps = 0
            while True:
                residual, by_motion, by_numbers = self.residual(motion, omega, zeta)
                if np.linalg.norm(residual) < 1e-8 * omega**2 * np.linalg.norm(self.beam.M @ motion):
                    break
                if steps == 20:
                    raise RuntimeError(f"Newton's method does not converge at {b} m")
                steps += 1
                jacobian = sp.bmat([[by_motion, by_numbers], [tied, None]], format="csc")
                change = -spsolve(jacobian, np.r_[residual, tied @ motion.ravel() - [b, 0]])
                motion, omega, zeta = motion + change[:-2].reshape(-1, 3), omega + change[-2], zeta + change[-1]
            before.append(np.r_[motion.ravel() / b, omega, zeta])
            pressed = self.contact_forces(motion)[2].pressure.max(axis=1) / (self.beam.areas * self.greatest)
            rows.append((omega / (2 * np.pi), zeta, omega**2 * b, steps, pressed.max()))
        self.motion, self.omega, self.zeta = motion, omega, zeta
        return np.array(rows)


def picture(name, lines):
    """Frequency and damping over the acceleration of the tip: a line by K, and a band over the laws of 5, 50 and 95 %."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"font.size": 10, "svg.hashsalt": "fstiff", "axes.spines.top": False, "axes.spines.right": False})
    figure, panels = plt.subplots(1, 2, figsize=(8.6, 3.6), layout="constrained")
    titles, labels = ("First mode", "Damping by friction"), ("frequency [Hz]", "damping ratio [%]")
    for ax, column, unit, title, label in zip(panels, (0, 1), (1, 100), titles, labels):
        for (faces, rows), colour in zip(lines.items(), ("#2f80d0", "#d1453b")):
            x = rows[0.5][:, 2]
            ends = [np.interp(x, row[:, 2], row[:, column] * unit) for row in rows.values()]
            ax.fill_between(x, np.min(ends, axis=0), np.max(ends, axis=0), color=colour, alpha=0.2, linewidth=0)
            ax.plot(x, rows[0.5][:, column] * unit, color=colour, linewidth=1.8, label=faces)
        ax.set(xscale="log", yscale=("linear", "log")[column], xlabel="acceleration of the tip [m/s²]", ylabel=label)
        ax.set_title(title, fontsize=10, fontweight="bold")
        ax.grid(color="#8a8a92", alpha=0.3, linewidth=0.6)
    panels[1].legend(frameon=False, title="line: K, band: 5 to 95 %", alignment="left")
    figure.savefig(name, dpi=160, metadata={"Date": None} if name.endswith(".svg") else None)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--contacts", type=int, default=101)
    parser.add_argument("--amplitudes", type=int, default=13)
    parser.add_argument("--picture", help="file to draw, .png or .svg")
    options = parser.parse_args()
    beam, answer, lines, most = Beam(options.contacts), faces(), {}, []
    amplitudes = np.geomspace(1e-7, 2e-5, options.amplitudes)  # of the tip [m]
    print("                 three modes, tightened   first: swung once    at 20 µm  damping")
    for name, form in (("flat faces", 0.0), ("form of 50 µm", FORM)):
        for quantile in (0.05, 0.5, 0.95):
            joint = Joint(beam, answer, quantile, form * (1 - (2 * beam.x / LAP) ** 2), amplitudes[-1])
            rows = lines.setdefault(name, {})[quantile] = joint.backbone(amplitudes)
            most.append(rows[:, 3:].max(axis=0))
            numbers = (*joint.tightened, joint.frequencies[0], rows[-1, 0], 100 * rows[-1, 1])
            print("%-13s %2.0f %%  %5.1f %5.1f %6.1f Hz %15.1f Hz  %7.1f Hz  %5.2f %%" % (name, 100 * quantile, *numbers))
    print("at most %.0f steps of Newton's method an amplitude; p at most %.2f p_max" % tuple(np.max(most, axis=0)))
    if options.picture:
        picture(options.picture, lines)


if __name__ == "__main__":
    main()
