# SPDX-License-Identifier: BSD-3-Clause
"""A beam of two halves that lap and are bolted: Timoshenko elements, and the relative motions of the faces of the lap. SI units."""

import numpy as np
import scipy.sparse as sp

LENGTH, LAP, SIDE = 0.720, 0.120, 0.0254  # of the beam, of the lap, of the square section [m]
E, NU, DENSITY = 193e9, 0.29, 8000.0
BOLTS, CONE = (-0.03, 0.0, 0.03), 0.014  # places, and radius of the pressure of a head at the faces [m]
HUNG = 200.0  # soft springs at both ends of the beam [N/m]


def element(length, height, offset):
    """Stiffness and mass of a beam whose axis is `offset` above the plane to which the displacements (u, w, w') of its nodes belong."""
    L, area, inertia = length, SIDE * height, SIDE * height**3 / 12
    shear = 12 * E * inertia / (5 / 6 * E / (2 + 2 * NU) * area * L**2)
    stiffness, mass, axis = np.zeros((6, 6)), np.zeros((6, 6)), np.eye(6)
    bending, drawing = np.ix_([1, 2, 4, 5], [1, 2, 4, 5]), np.ix_([0, 3], [0, 3])
    near, far = (4 + shear) * L**2, (2 - shear) * L**2
    stiffness[bending] = E * inertia / ((1 + shear) * L**3) * np.array(
        [[12, 6 * L, -12, 6 * L], [6 * L, near, -6 * L, far], [-12, -6 * L, 12, -6 * L], [6 * L, far, -6 * L, near]])  # fmt: skip
    stiffness[drawing] = E * area / L * np.array([[1, -1], [-1, 1]])
    mass[bending] = DENSITY * area * L / 420 * np.array(
        [[156, 22 * L, 54, -13 * L], [22 * L, 4 * L**2, 13 * L, -3 * L**2],
         [54, 13 * L, 156, -22 * L], [-13 * L, -3 * L**2, -22 * L, 4 * L**2]])  # fmt: skip
    mass[drawing] = DENSITY * area * L / 6 * np.array([[2, 1], [1, 2]])
    axis[0, 2] = axis[3, 5] = -offset
    return axis.T @ stiffness @ axis, axis.T @ mass @ axis


class Beam:
    """Stiffness K and mass M, and of each contact of the lap the place x and the area.

    Q         approach and slip of each contact, in turn, by the displacements; both faces are in the plane of those
    relative  the same of the three harmonics of each displacement
    bolts     forces for 1 N in each bolt
    tip       the displacement w of the right end
    """

    def __init__(self, contacts):
        outer, self.x = np.linspace(LAP / 2, LENGTH / 2, 25), np.linspace(-LAP / 2, LAP / 2, contacts)
        left, below, above, right = np.split(np.arange(48 + 2 * contacts), np.cumsum([24, contacts, contacts]))
        chains = ((np.r_[left, below[0]], -outer[::-1], SIDE, 0.0), (below, self.x, SIDE / 2, -SIDE / 4),
                  (above, self.x, SIDE / 2, SIDE / 4), (np.r_[above[-1], right], outer, SIDE, 0.0))  # fmt: skip
        count = 3 * (48 + 2 * contacts)
        stiffness, mass = np.zeros((count, count)), np.zeros((count, count))
        for nodes, x, height, offset in chains:
            for i, j, length in zip(nodes, nodes[1:], np.diff(x)):
                places = np.r_[3 * i : 3 * i + 3, 3 * j : 3 * j + 3]
                for whole, part in zip((stiffness, mass), element(length, height, offset)):
                    whole[np.ix_(places, places)] += part
        ends = [0, 1, count - 3, count - 2]
        stiffness[ends, ends] += HUNG
        self.K, self.M, self.tip, self.contacts = sp.csc_matrix(stiffness), sp.csc_matrix(mass), count - 2, contacts
        width = np.full(contacts, LAP / (contacts - 1))
        width[[0, -1]] /= 2
        self.areas = SIDE * width
        motions = np.zeros((contacts, 2, count))
        each = np.arange(contacts)
        motions[each, 0, 3 * below + 1], motions[each, 0, 3 * above + 1] = 1, -1
        motions[each, 1, 3 * above], motions[each, 1, 3 * below] = 1, -1
        self.Q = sp.csr_matrix(motions.reshape(2 * contacts, count))
        self.relative = sp.kron(self.Q, sp.identity(3)).tocsr()
        spread = sum(np.maximum(1 - ((self.x - place) / CONE) ** 2, 0) for place in BOLTS) * self.areas
        self.bolts = self.Q[::2].T @ spread * (len(BOLTS) / spread.sum())
