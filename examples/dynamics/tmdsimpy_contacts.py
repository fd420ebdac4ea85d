# SPDX-License-Identifier: BSD-3-Clause
"""Laws of fstiff as one force of tmdsimpy (https://github.com/tmd-lab/tmdsimpy): all quadrature points of an interface at once."""

import numpy as np
from tmdsimpy.nlforces.nonlinear_force import HystereticForce
from tmdsimpy.utils import harmonic


class Contacts(HystereticForce):
    """`laws` is loading_law() during the prestress, then law_after() of each point: Q has x, y and the approach of each in turn.

    T sums up pressures, so that it has the areas; `separation` is that without displacement.
    """

    def __init__(self, Q, T, laws, separation, friction, ratio):
        super().__init__(Q, T)
        self.laws, self.separation, self.friction, self.ratio = laws, separation, friction, ratio
        self.stuck, self.start = 1.0, np.zeros(len(Q))

    def init_history(self):
        self.start = np.zeros(len(self.Q))

    def set_prestress_mu(self):
        self.stuck = 0.0

    def reset_real_mu(self):
        self.stuck = 1.0

    def set_aft_initialize(self, X):
        self.start = self.Q @ X

    def force(self, X, update_hist=False):
        """The static force: springs that stick along the faces, and no friction during the prestress."""
        u = (self.Q @ X).reshape(-1, 3)
        p, slope = self.laws.tangent_at_separation(self.separation - u[:, 2])
        springs = slope[:, None] * [self.stuck * self.ratio, self.stuck * self.ratio, 1]
        f = springs * (u - self.start.reshape(-1, 3))
        f[:, 2] = p
        if update_hist:
            self.start = u.ravel()
        return self.T @ f.ravel(), self.T @ (springs.reshape(-1, 1) * self.Q)

    def aft(self, U, w, h, Nt=128, tol=1e-7, calc_grad=True):
        count = harmonic.Nhc(h)
        cycle = harmonic.time_series_deriv(Nt, h, np.eye(count), 0)
        basis = np.vstack([np.zeros(count), cycle, cycle])  # from rest; the second cycle is periodic
        u = (self.Q @ U.reshape(count, -1).T).reshape(-1, 3, count) @ basis.T
        u[:, :, 0] = self.start.reshape(-1, 3)
        by = np.zeros((len(basis), 3, 3, count))  # (approach, slip) of each step by the harmonics of x, y and the approach
        by[:, 0, 2], by[:, 1, 0] = basis, np.diff(basis, axis=0, prepend=0)
        by[:, 2, 1] = by[:, 1, 0]
        slip = np.moveaxis(np.diff(u[:, :2], axis=2, prepend=u[:, :2, :1]), 1, 2)
        path = self.laws.path(self.separation[:, None] - u[:, 2], slip, friction=self.friction, ratio=self.ratio,
                              directions=by.reshape(len(basis), 3, -1))  # fmt: skip
        spectrum = lambda a: harmonic.get_fourier_coeff(h, np.moveaxis(a[:, -Nt:], 1, 0).reshape(Nt, -1))
        F = spectrum(np.concatenate([path.traction, path.pressure[..., None]], axis=2)) @ self.T.T
        if not calc_grad:
            return (F.ravel(),)
        J = spectrum(path.by_directions[:, :, [1, 2, 0]]).reshape(count, -1, 3, 3, count)
        Q = self.Q.reshape(-1, 3, self.Q.shape[1])
        blocks = [[self.T @ np.einsum("exy,eyn->exn", J[a, ..., b], Q).reshape(self.Q.shape) for b in range(count)] for a in range(count)]
        return F.ravel(), np.block(blocks), np.zeros(U.size)
