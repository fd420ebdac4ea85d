# SPDX-License-Identifier: BSD-3-Clause
"""Slips of a caller: each is one ValueError or a warning, and no result is lost."""

import warnings

import fstiff
import numpy as np
import pytest

SCENE = {
    "surface": {"rms_height": "0.8 um", "rms_gradient": 0.1},
    "material": {"upper": "steel"},
    "contact": {"pressures": ["10 MPa"]},
}
LAW = fstiff.Contact("hybrid", rms_height=0.8e-6, rms_gradient=0.1, effective_modulus=112.6e9).tabulate(1e5, 1e8, "extrapolate")
HALF = "\udcff"  # half a surrogate pair
GREAT = 10**400
MISSING = "rms_height: is missing"


def contact(**changes):
    return fstiff.Contact(**{"law": "hybrid", "rms_height": 0.8e-6, "rms_gradient": 0.1, "effective_modulus": 112.6e9, **changes})


def answer(**changes):
    return fstiff.answer(**{"pressures": 1e6, "rms_height": 0.8e-6, "rms_gradient": 0.1, "samples": 0, **changes})


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda: fstiff.spot_conductance([1e12, -1.0], 40.0, 1e11), "stiffness = -1: must be 0 or greater"),
        (lambda: fstiff.spot_conductance(1e12, -40.0, 1e11), "conductivity = -40: must be 0 or greater"),
        (lambda: fstiff.measure([GREAT] + [1] * 50, spacing=1e-6), "heights: must be real numbers"),
        (lambda: answer(rms_height=GREAT), "rms_height: must be real numbers"),
        (lambda: answer(nominal_area=GREAT), "nominal_area = 1000"),
        (lambda: contact(rms_gradient=GREAT), "rms_gradient = 1000"),
        (lambda: LAW.stiffness([GREAT]), "pressure: must be real numbers"),
        (lambda: fstiff.run(f'name = "{HALF}"\n'), "scene: must be a text of Unicode"),
        (lambda: fstiff.run(SCENE | {"name": HALF}), "scene: name: must be a text of Unicode"),
        (lambda: fstiff.run(f"{HALF}.toml"), "scene: must be a text of Unicode"),
        (lambda: fstiff.measure(f"{HALF}.txt"), "surface: must be a text of Unicode"),
        (lambda: answer(upper=HALF), "upper: must be a text of Unicode"),
        (lambda: answer(process=HALF), "process: must be a text of Unicode"),
        (lambda: answer(quantities=[HALF]), "quantities: must be a text of Unicode"),
        (lambda: contact(law=HALF), "law: must be a text of Unicode"),
        (lambda: fstiff.Law.from_text(HALF), "text: must be a text of Unicode"),
        (lambda: LAW.stiffness(True), "pressure = True: must be a number"),
        (lambda: LAW.stiffness(np.array([True, False])), "pressure = array"),
        (lambda: LAW.stiffness([1e6, True]), "pressure = True: must be a number"),
        (lambda: answer(rms_height=True), "rms_height = True: must be a number"),
        (lambda: answer(samples=True), "samples = True: must be a number"),
        (lambda: contact(hardness=True), "hardness = True: must be a number"),
        (lambda: answer(upper=""), "upper: must be the name of a material or a dict, not an empty text"),
        (lambda: answer(lower=""), "lower: must be the name of a material or a dict, not an empty text"),
        (lambda: answer(upper={"name": 3}), "upper.name: must be a text, not of type int"),
        (lambda: answer(pressures=[]), "pressures: must have at least one"),
        (lambda: answer(pressures=np.zeros((2, 0))), "pressures: must have at least one"),
        (lambda: answer(samples=1e300), "samples = 1e\\+300: must be a whole number from 0 to 100000"),
        (lambda: answer(samples=40.5), "samples = 40.5: must be a whole number"),
        (lambda: answer(seed=-1), "seed = -1: must be 0 or greater"),
        (lambda: answer(seed=float("nan")), "seed = nan: must be a whole number"),
        (lambda: answer(quantities=3), "quantities = 3: must be a list of names"),
        (lambda: answer(quantities=[3]), "quantities: must be a text, not of type int"),
        (lambda: contact(law=3), "law: must be a text, not of type int"),
        (lambda: contact(interaction=None), "interaction: must be a text"),
        (lambda: contact().tabulate("x", 1e8), 'min_pressure = "x"'),
        (lambda: contact().tabulate([1, 2], 1e8), "min_pressure = \\[1, 2\\]: must be a number in SI units"),
        (lambda: contact().tabulate(1e5, 1e8, outside=3), "outside: must be a text"),
        (lambda: contact().at_pressures(1e6, [3]), "quantities: must be a text"),
        (lambda: contact().sensitivity(None), "pressure = None: must be a number in SI units"),
        (lambda: fstiff.Law.from_text(3), "text: must be a text"),
        (lambda: fstiff.Scene(SCENE).contact("hybrid", 2**70), "peaks = 1180591620717411303424: must be a whole number"),
        (lambda: fstiff.Scene(SCENE).contact(3), "law: must be a text"),
        (lambda: fstiff.sweep(SCENE, {"surface.rms_gradient": [0.1]}, threads=2**40), "threads = 1099511627776: must be a whole number"),
        (lambda: fstiff.peak_integral(lambda e, t: e, r=None, theta=1, eta=1), "r = None: must be a number"),
        (lambda: fstiff.identify(SCENE, {"pressure": [1e6], "stiffness": [1e13]}, [3]), "fit: must be a text"),
        (lambda: fstiff.truth(np.ones((8, 8)), [1e6], effective_modulus=None, spacing=1e-6), "effective_modulus = None: must be a number"),
    ],
)
def test_a_slip_is_one_value_error(call, sentence):
    with pytest.raises(ValueError, match=f"^{sentence}") as raised:
        call()
    assert "\n" not in str(raised.value) and "nanobind" not in str(raised.value)


@pytest.mark.parametrize("method", ["at_separation", "tangent_at_separation"])
def test_two_results_in_one_array_are_refused(method):
    d, out = LAW.separation(np.array([1e6, 1e7])), np.zeros(3)
    for arrays in ((out[:2], out[:2]), (out[:2], out[1:])):
        with pytest.raises(ValueError, match="^out: must be arrays that share no memory, one for each result"):
            getattr(LAW, method)(d, out=arrays)
    both = np.zeros((2, 2))
    np.testing.assert_array_equal(getattr(LAW, method)(d, out=tuple(both)), getattr(LAW, method)(d))


def test_k_without_a_state_has_no_conductance():
    assert np.isnan(fstiff.spot_conductance([np.nan, 1e12], 40.0, 1e11)).tolist() == [True, False]


def test_a_gap_in_a_table_is_a_row_without_k():
    heights = [0.8e-6, np.nan, 1e-6]
    found = fstiff.answer(pressures=[1e6, 1e7], rms_height=heights, rms_gradient=0.1, samples=0)
    full = fstiff.answer(pressures=[1e6, 1e7], rms_height=[0.8e-6, 1e-6], rms_gradient=0.1, samples=0)
    np.testing.assert_array_equal(found.stiffness[[0, 2]], full.stiffness)
    assert np.isnan(found.stiffness[1]).all() and np.isnan(found.low[1]).all() and list(found["law"][1]) == ["", ""]
    assert set(found.reasons) == {(1, 0), (1, 1)} and all(MISSING in reason for reason in found.reasons.values())
    assert found.doubtful.tolist() == [False, True, False] and found.concerns[1] == []
    np.testing.assert_array_equal(found["pressure_Pa"][1], [1e6, 1e7])
    assert MISSING in repr(found)
    only = fstiff.answer(pressures=1e6, rms_height=[np.nan], rms_gradient=0.1)
    assert np.isnan(only.stiffness).all() and MISSING in only.reasons[(0,)]
    assert np.isfinite(fstiff.answer(pressures=1e6, rms_height=1e-6, rms_gradient=[0.1, np.nan], samples=0).stiffness).all()  # has a prior


def test_a_wrong_number_in_a_table_and_one_joint_without_its_height_are_refused():
    with pytest.raises(ValueError, match="^surface 1: rms_height = -1e-06: must be"):
        fstiff.answer(pressures=1e6, rms_height=[1e-6, -1e-6, np.nan], rms_gradient=0.1)
    with pytest.raises(ValueError, match=f"^{MISSING}"):
        fstiff.answer(pressures=1e6, rms_height=np.nan, rms_gradient=0.1)


def test_a_sweep_of_metres_warns_as_an_answer_does():
    pytest.importorskip("pandas")
    with pytest.warns(UserWarning, match="rms height of 2 m: above 1 mm; lengths are numbers in m"):
        fstiff.sweep(SCENE, {"surface.rms_height": [1.0, 2.0]})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fstiff.sweep(SCENE, {"surface.rms_height": [1e-6, 2e-6]})


def test_a_report_of_one_pressure_draws_without_a_warning():
    pytest.importorskip("matplotlib")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert "<svg" in fstiff.report(SCENE)
        fstiff.answer(pressures=1e7, rms_height=0.8e-6, rms_gradient=0.1).plot()
