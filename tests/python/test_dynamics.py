# SPDX-License-Identifier: BSD-3-Clause
"""The bolted beam of examples/dynamics on a coarse mesh, and the programs of docs/joint-dynamics.md."""

import importlib
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT
from test_package import check_document

pytest.importorskip("scipy.sparse")
AMPLITUDES = np.geomspace(1e-7, 2e-5, 7)  # of the tip [m], from slight slip to gross slip at the ends of the lap


@pytest.fixture(scope="module")
def example():
    sys.path.insert(0, str(ROOT / "examples" / "dynamics"))
    yield importlib.import_module("lap_joint")
    sys.path.pop(0)


@pytest.fixture(scope="module")
def joint(example):
    """A joint of 41 contacts whose faces are not flat."""
    beam = example.Beam(41)
    return example.Joint(beam, example.faces(), 0.5, example.FORM * (1 - (2 * beam.x / example.LAP) ** 2), AMPLITUDES[-1])


def test_stiff_contacts_make_a_beam_of_one_piece(example):
    """Against Euler's beam without a lap: shear and the notches at both ends of the lap take a tenth."""
    found, _ = example.modes(example.Beam(41), np.full(41, 1e16))
    euler = 4.730041**2 / (2 * np.pi * 0.720**2) * np.sqrt(example.E * 0.0254**2 / 12 / 8000)
    assert 0.9 < found[0] / euler < 1


def test_newton_takes_at_most_five_steps_an_amplitude(joint):
    frequency, damping, _, steps, pressed = joint.backbone(AMPLITUDES).T
    assert steps.max() <= 5 and pressed.max() <= 1
    assert np.all(np.diff(frequency) < 0) and np.all(np.diff(damping) > 0)


def test_a_slight_motion_has_the_first_mode_of_stuck_contacts(joint):
    frequency, damping = joint.backbone([1e-9])[0, :2]
    assert abs(frequency / joint.frequencies[0] - 1) < 1e-6 and 0 <= damping < 1e-6


@pytest.mark.parametrize("count", [1, 4, 7])
def test_the_jacobian_is_that_of_differences(joint, count):
    """At slight, partial and gross slip, all derivatives of the contacts and those of the whole by omega and zeta."""
    joint.backbone(AMPLITUDES[:count])
    motion, omega, zeta = joint.motion, joint.omega, joint.zeta
    change = motion * np.random.default_rng(1).uniform(0.5, 1.5, motion.shape) + 0.1 * np.roll(motion, 1, axis=1)
    relative = (joint.beam.Q @ change).reshape(-1, 6)
    forces = [joint.contact_forces(motion + step * change)[0] for step in (1e-6, -1e-6)]
    by = np.einsum("eij,ej->ei", joint.contact_forces(motion)[1], relative)
    assert np.linalg.norm((forces[0] - forces[1]).reshape(-1, 6) / 2e-6 - by) < 1e-7 * np.linalg.norm(by)
    _, _, by_numbers = joint.residual(motion, omega, zeta)
    for column, step in enumerate(((1e-3 * omega, 0.0), (0.0, 1e-3))):
        ends = [joint.residual(motion, omega + sign * step[0], zeta + sign * step[1])[0] for sign in (1, -1)]
        by = by_numbers[:, column]
        assert np.linalg.norm((ends[0] - ends[1]) / (2 * sum(step)) - by) < 1e-6 * np.linalg.norm(by)


def test_damping_is_the_energy_that_a_cycle_of_the_contacts_loses(joint):
    """2 pi zeta w^2 (xc'M xc + xs'M xs) against the sum of q ds + p dn over the steps of a finer cycle, within 0.5 %."""
    joint.backbone(AMPLITUDES)
    motion, fine = joint.motion, 2048
    path = joint.contact_forces(motion, fine)[2]
    angle = 2 * np.pi * np.arange(-1, fine) / fine
    relative = (joint.beam.Q @ motion).reshape(-1, 2, 3) @ np.stack([np.ones_like(angle), np.cos(angle), np.sin(angle)])
    forces = np.stack([path.pressure, path.traction[..., 0]], axis=1)[..., -fine - 1 :]
    lost = np.sum((forces[..., 1:] + forces[..., :-1]) / 2 * np.diff(relative))
    kinetic = sum(motion[:, i] @ (joint.beam.M @ motion[:, i]) for i in (1, 2))
    assert abs(lost / (2 * np.pi * joint.zeta * joint.omega**2 * kinetic) - 1) < 5e-3


def test_the_table_of_choices_is_that_of_the_example(example):
    """docs/joint-dynamics.md: the first mode by K at the local and at the mean pressure, by the loading slope and without K_t."""
    beam, loading = example.Beam(101), example.faces().loading_law(0.5, outside="extrapolate")
    columns = []
    for form in (0.0, example.FORM):
        gap = loading.touch + form * (1 - (2 * beam.x / example.LAP) ** 2)
        separation = gap - beam.Q[::2] @ example.prestress(beam, loading, gap, np.zeros(beam.K.shape[0]))
        p, slope = loading.tangent_at_separation(separation)
        K, mean = loading.stiffness(np.maximum(p, 2e3)), loading.stiffness(beam.areas @ p / beam.areas.sum())
        choices = ((K, example.RATIO), (np.full_like(K, mean), example.RATIO), (slope, example.RATIO), (K, 1e-9))
        # without K_t the halves slide on each other, one mode more without stiffness
        columns.append([f"{next(f for f in example.modes(beam, *choice)[0] if f > 100):.1f}" for choice in choices])
    text = (ROOT / "docs/joint-dynamics.md").read_text()
    for flat, form in zip(*columns):
        assert f" | {flat} | {form} |\n" in text


def test_the_example_prints_its_table_and_draws(tmp_path):
    pytest.importorskip("matplotlib")
    program = [sys.executable, ROOT / "examples/dynamics/lap_joint.py", "--picture", "backbone.svg"]
    done = subprocess.run(program, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == (ROOT / "examples/dynamics/lap_joint.txt").read_text()
    assert done.stdout in (ROOT / "docs/joint-dynamics.md").read_text()
    assert (tmp_path / "backbone.svg").stat().st_size > 10000


def test_the_document_shows_what_comes_out(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    check_document(ROOT / "docs" / "joint-dynamics.md", 2)


def test_tmdsimpy_has_the_same_motion(example, joint):
    """Its residual of extended periodic motion at the motion of the example, and the Jacobian of the force against differences."""
    system_of = pytest.importorskip("tmdsimpy.vibration_system").VibrationSystem
    Contacts = importlib.import_module("tmdsimpy_contacts").Contacts
    joint.backbone(AMPLITUDES)
    beam, motion, h = joint.beam, joint.motion, np.array([0, 1])
    Q = np.zeros((beam.contacts, 3, beam.K.shape[0]))  # x, y, approach
    Q[:, 2], Q[:, 0] = beam.Q[::2].toarray(), beam.Q[1::2].toarray()
    Q = Q.reshape(3 * beam.contacts, -1)
    force = Contacts(Q, Q.T * np.repeat(beam.areas, 3), joint.laws, joint.separation, example.FRICTION, example.RATIO)
    system = system_of(beam.M.toarray(), beam.K.toarray(), ab=[0, 0])
    system.add_nl_force(force)
    U, size = motion.T.ravel(), np.sqrt(sum(motion[:, i] @ (beam.M @ motion[:, i]) for i in (1, 2)))
    static = np.zeros(U.size)
    static[: len(motion)] = beam.Q[::2].T @ (beam.areas * joint.pressure)
    unknowns = np.r_[motion[:, 0], motion[:, 1] / size, motion[:, 2] / size, joint.omega, 2 * joint.zeta * joint.omega, np.log10(size)]
    residual = system.epmc_res(unknowns, static, h, Nt=example.STEPS)[0]
    assert np.linalg.norm(residual[:-2]) < 1e-8 * joint.omega**2 * np.linalg.norm(beam.M @ motion) and abs(residual[-2]) < 1e-9
    change = 1e-6 * U * np.random.default_rng(0).uniform(0.5, 1.5, U.size)
    ends = [force.aft(U + sign * change, joint.omega, h, example.STEPS, calc_grad=False)[0] for sign in (1, -1)]
    by = force.aft(U, joint.omega, h, example.STEPS)[1] @ change
    assert np.linalg.norm((ends[0] - ends[1]) / 2 - by) < 1e-6 * np.linalg.norm(by)
