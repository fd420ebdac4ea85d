# SPDX-License-Identifier: BSD-3-Clause
"""Contacts and tabulated laws are those of C++, bit for bit."""

import concurrent.futures
import os
import pathlib
import pickle
import sys
import threading

import numpy as np
import pytest

import fstiff

FINE = {
    "rms_height": 0.832e-6,
    "peak_radius": 40e-6,
    "peak_density": 500e6,
    "max_peak_height": 5.3e-6,
    "r": 0.5,
    "theta": 1.0,
    "effective_modulus": 112.6e9,
}
COLUMNS = [
    "pressure_Pa",
    "separation_m",
    "stiffness_Pa_per_m",
    "stiffness_error_Pa_per_m",
    "loading_stiffness_Pa_per_m",
    "real_area_fraction",
    "contacts_per_m2",
]
CONTACTS = {
    "hertz": fstiff.Contact("hertz", **FINE),
    "fractal": fstiff.Contact("fractal", fractal_dimension=1.62, **FINE),
    "interacting": fstiff.Contact("hertz", interaction="effective_separation", interaction_length=1e-4, **FINE),
}


FINE_PEAKS = {"rms_height": 0.832e-6, "peak_radius": 40e-6, "peak_density": 500e6, "effective_modulus": 112.6e9}


def wanted(numbers, key):
    """The rows of C++ at the pressures, and at the separations that follow."""
    return [np.array([numbers[f"{key}/{of}{i}"] for i in range(len(numbers["pressures"]))]) for of in "pd"]


@pytest.mark.parametrize("key", CONTACTS)
def test_states_are_those_of_cpp_bit_for_bit(numbers, key):
    at_pressures, at_separations = wanted(numbers, key)
    points = CONTACTS[key].at_pressures(numbers["pressures"])
    assert list(points) == COLUMNS
    np.testing.assert_array_equal(np.array([points[name] for name in COLUMNS]).T, at_pressures)
    points = CONTACTS[key].at_separations(at_pressures[:, 1])
    np.testing.assert_array_equal(np.array([points[name] for name in COLUMNS]).T, at_separations)


def test_arrays_of_any_shape_and_kind(numbers):
    contact, p = CONTACTS["hertz"], numbers["pressures"][:6]
    flat = contact.at_pressures(p)
    assert contact.at_pressures(p.reshape(2, 3)).stiffness.shape == (2, 3)
    np.testing.assert_array_equal(contact.at_pressures(p.reshape(2, 3)).stiffness.ravel(), flat.stiffness)
    np.testing.assert_array_equal(contact.at_pressures(np.repeat(p, 2)[::2]).stiffness, flat.stiffness)
    np.testing.assert_array_equal(contact.at_pressures(p.tolist()).stiffness, flat.stiffness)
    np.testing.assert_array_equal(contact.at_pressures([1000000]).stiffness, contact.at_pressures([1e6]).stiffness)
    assert contact.at_pressures(1e6).stiffness.shape == ()
    assert contact.at_pressures([]).stiffness.shape == (0,)
    f32 = p.astype(np.float32)
    np.testing.assert_array_equal(contact.at_pressures(f32).stiffness, contact.at_pressures(f32.astype(float)).stiffness)


def test_only_what_is_asked_for_is_there():
    contact = CONTACTS["hertz"]
    assert contact.quantities == ["separation", "stiffness", "loading_stiffness", "real_area", "contacts"]
    assert list(contact.at_pressures(1e6, ["stiffness"])) == ["pressure_Pa", *COLUMNS[2:4]]
    with pytest.raises(ValueError, match='quantities = "stifness": of law hertz must be among "separation"'):
        contact.at_pressures(1e6, ["stifness"])


def test_results_outlive_what_they_were_made_of():
    points = fstiff.Contact("hertz", **FINE).at_pressures(np.full(100000, 1e6), ["stiffness"])
    column = points.stiffness
    first = column[0]
    del points
    column[1:] = 0  # the memory is that of the array
    assert column.flags.owndata is False and column.flags.writeable and column[0] == first and column[-1] == 0


def test_a_point_without_a_state_is_nan_with_its_reason():
    contact = fstiff.Contact("greenwood_williamson", **FINE)
    points = contact.at_separations([2e-6, 1.0])  # no peak is a metre high
    assert np.isfinite(points.stiffness[0]) and points.reasons.keys() <= {1}
    with pytest.raises(ValueError, match="pressure = -1: must be finite and greater than 0"):
        contact.at_pressures([1e6, -1])


def test_a_number_that_was_not_given_is_named():
    for name in ("rms_height", "peak_radius", "peak_density"):
        with pytest.raises(ValueError, match=f"^{name}: missing; a contact needs rms_height, peak_radius and peak_density, or surface"):
            fstiff.Contact("hertz", **{key: value for key, value in FINE.items() if key != name})
    for name in ("r", "theta"):
        with pytest.raises(ValueError, match="^(r|theta): is missing; r and theta belong together$"):
            fstiff.Contact("hertz", **{key: value for key, value in FINE.items() if key != name})
    plastic = {**FINE, "yield_strength": 1e9}
    with pytest.raises(ValueError, match="^law jackson_green: needs poisson_ratio$"):
        fstiff.Contact("jackson_green", **plastic)
    zero, steel = (fstiff.Contact("jackson_green", poisson_ratio=nu, **plastic).at_pressures(1e7).stiffness for nu in (0, 0.3))
    assert zero > 0 and steel > 0 and zero != steel


def test_a_length_may_be_a_text_and_what_is_no_number_is_named():
    texts = {**FINE, "rms_height": "0.832 um", "peak_radius": "40 um", "max_peak_height": "5.3 um"}
    expected = CONTACTS["hertz"].at_pressures(1e6).stiffness
    assert fstiff.Contact("hertz", **texts).at_pressures(1e6).stiffness == pytest.approx(expected, rel=1e-14)
    for name, wrong, allowed in (
        ("rms_height", "0.8", "rms_height"),
        ("peak_radius", "40 Pa", "peak_radius"),
        ("rms_height", [1e-6, 2e-6], "rms_height = .*must be a length in m, or a text such as"),
        ("effective_modulus", "112.6 um", 'effective_modulus = "112.6 um": "um" is not a unit of pressure'),
        ("effective_modulus", None, "effective_modulus = None: must be a number in SI units"),
    ):
        with pytest.raises(ValueError, match=f"^{allowed}"):
            fstiff.Contact("hertz", **{**FINE, name: wrong})


def test_a_batch_calls_no_python_for_each_point():
    contact = CONTACTS["hertz"]
    law = contact.tabulate(1e5, 1e8)

    def calls(work):
        count = 0

        def hook(_frame, event, _argument):
            nonlocal count
            count += event in ("call", "c_call")

        sys.setprofile(hook)
        try:
            work()
        finally:
            sys.setprofile(None)
        return count

    few, many = np.linspace(1e6, 1e7, 10), np.linspace(1e6, 1e7, 5000)
    assert calls(lambda: contact.at_pressures(few)) == calls(lambda: contact.at_pressures(many)) > 0
    assert calls(lambda: law.stiffness(few)) == calls(lambda: law.stiffness(many)) > 0


def test_a_law_is_that_of_cpp_bit_for_bit(numbers):
    text = pathlib.Path(os.environ["FSTIFF_LAW"]).read_text()
    law = CONTACTS["hertz"].tabulate(1e5, 1e8, "extrapolate")
    assert law.to_text() == text
    for one in (law, fstiff.Law.from_text(text), pickle.loads(pickle.dumps(law))):
        assert one == law and one.outside == "extrapolate"
        for i in range(len(numbers["pressures"])):
            p, d, k, dk_dp, p_of_d, k_of_d, slope = numbers[f"law/{i}"].tolist()
            assert (one.separation(p), one.stiffness(p), one.stiffness_slope(p)) == (d, k, dk_dp)
            assert one.at_separation(d) == (p_of_d, k_of_d)
            assert one.tangent_at_separation(d) == (p_of_d, slope)
    assert law.pressures == (1e5, 1e8) and 0 < law.relative_error < 1e-7 and law.stiffness_is_slope


def test_a_law_on_an_array_is_the_scalar_law_within_rounding():
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    p = np.geomspace(1e5, 1e8, 1001)
    d = law.separation(p)
    bound = law.relative_error + 200 * np.finfo(float).eps  # docs of ContactLaw: a batch differs by rounding
    for many, one in (
        (law.stiffness(p), [law.stiffness(x) for x in p.tolist()]),
        (law.stiffness_slope(p), [law.stiffness_slope(x) for x in p.tolist()]),
        (law.at_separation(d)[1], [law.at_separation(x)[1] for x in d.tolist()]),
    ):
        np.testing.assert_allclose(many, one, rtol=bound, atol=0)
    np.testing.assert_allclose(law.stiffness(p), CONTACTS["hertz"].at_pressures(p).stiffness, rtol=1e-7, atol=0)


def test_a_law_refuses_what_is_outside_unless_it_goes_on():
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    with pytest.raises(ValueError, match="pressure = .*: must be between 1e"):
        law.stiffness([1e6, 2e8])
    with pytest.raises(ValueError, match='outside = "on": must be one of refuse, clamp, exact, extrapolate'):
        CONTACTS["hertz"].tabulate(1e5, 1e8, "on")
    exact = fstiff.Contact("hertz", **FINE).tabulate(1e6, 1e7, "exact")  # its contact has no other name
    assert exact.stiffness(1e8) == pytest.approx(CONTACTS["hertz"].at_pressures(1e8).stiffness, rel=1e-12)
    with pytest.raises(ValueError):
        fstiff.Law.from_text("no law")


@pytest.mark.parametrize("law", ["hybrid", "persson", "summits", "plastic"])
def test_every_law_of_a_map_has_a_table(rough_map, law):
    surface = fstiff.measure(rough_map, spacing="1 um")
    contact = fstiff.Contact(law, surface=surface, effective_modulus=112.6e9, hardness=6e9)
    table = contact.tabulate(3e6, 3e7)
    assert table.relative_error <= 1e-3
    p = np.exp(np.random.default_rng(5).uniform(np.log(3e6), np.log(3e7), 40))
    points = contact.at_pressures(p, ["separation", "stiffness"])
    np.testing.assert_allclose(table.stiffness(p), points.stiffness, rtol=1e-3)
    inside = np.clip(points.separation, *table.separations)
    pressure, slope = table.tangent_at_separation(inside)
    np.testing.assert_allclose(pressure, p, rtol=1e-3)
    assert np.all(slope > 0)
    d = np.linspace(*table.separations, 1000)[1:-1]
    assert np.all(np.diff(table.at_separation(d)[0]) < 0)
    assert fstiff.Law.from_text(table.to_text()) == table


def test_pickled_contacts_give_the_same(trace):
    for contact in CONTACTS.values():
        again = pickle.loads(pickle.dumps(contact))
        assert again.at_pressures(3e6).stiffness == contact.at_pressures(3e6).stiffness and repr(again) == repr(contact)


def test_threads_share_a_contact(numbers):
    contact, p = CONTACTS["fractal"], np.repeat(numbers["pressures"], 20)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: contact.at_pressures(p).stiffness, range(4)))
    for one in found:
        np.testing.assert_array_equal(one, contact.at_pressures(p).stiffness)


def test_other_threads_run_during_an_evaluation():
    """The GIL is free: a thread counts while the points are computed, by the order of events and not by the clock."""
    contact, started, done = CONTACTS["fractal"], threading.Event(), threading.Event()
    seen = []

    def watch():
        started.set()
        while not done.is_set():
            seen.append(None)
            done.wait(1e-4)

    thread = threading.Thread(target=watch)
    thread.start()
    started.wait()
    before = len(seen)
    switch = sys.getswitchinterval()
    sys.setswitchinterval(1000)  # no switch but where the GIL is given away
    try:
        contact.at_pressures(np.geomspace(1e5, 1e8, 3000))
        during = len(seen) - before
    finally:
        sys.setswitchinterval(switch)
        done.set()
        thread.join()
    assert during > 1


def test_effective_modulus_and_laws():
    assert fstiff.effective_modulus(205e9, 0.3, 205e9, 0.3) == pytest.approx(205e9 / (2 * (1 - 0.3**2)), rel=1e-15)
    assert {"hertz", "hybrid", "boundary_elements"} <= set(fstiff.law_names())


def test_hybrid_takes_skewness_and_kurtosis():
    def stiffness(**shape):
        contact = fstiff.Contact("hybrid", rms_gradient=0.05, **FINE, **shape)
        return contact.at_pressures([1e6, 1e8], ["stiffness"])["stiffness_Pa_per_m"]

    gaussian = stiffness()
    assert (stiffness(skewness=0, kurtosis=3) == gaussian).all()
    assert (stiffness(skewness=-1, kurtosis=4.5) > 1.5 * gaussian).all()
    assert (stiffness(skewness=1, kurtosis=4.5) < 0.9 * gaussian).all()
    with pytest.raises(ValueError, match="kurtosis: is missing"):
        stiffness(skewness=1)
    with pytest.raises(ValueError, match="kurtosis = 1.5"):
        stiffness(skewness=1, kurtosis=1.5)


def test_a_plot_and_a_data_frame():
    pytest.importorskip("matplotlib")
    pandas = pytest.importorskip("pandas")
    points = CONTACTS["hertz"].at_pressures([1e6, 1e7])
    frame = points.to_dataframe()
    assert isinstance(frame, pandas.DataFrame) and frame["stiffness_Pa_per_m"].tolist() == points.stiffness.tolist()
    ax = points.plot()
    np.testing.assert_allclose(ax.get_lines()[0].get_xdata(), [1, 10])
    assert "hertz" in repr(points) and "K/A0 [" in repr(points) and ax.get_xlabel() == "p [MPa]"


@pytest.mark.parametrize(
    "change, sentence",
    [
        ({"rms_height": -1}, "rms_height = -1: must be"),
        ({"peak_density": float("nan")}, "peak_density = nan: must be"),
        ({"effective_modulus": 0}, "effective_modulus = 0: must be finite and greater than 0"),
        ({"r": 2}, "r = 2: must be"),
        ({"poisson_ratio": 0.7}, "poisson_ratio = 0.7: must be greater than -1 and at most 0.5"),
        ({"interaction": "some"}, 'interaction = "some": must be one of none'),
    ],
)
def test_bad_numbers_raise_value_errors(change, sentence):
    with pytest.raises(ValueError) as caught:
        fstiff.Contact("hertz", **{**FINE, **change})
    assert sentence in str(caught.value)


def test_bad_laws_and_arrays_raise_value_errors():
    with pytest.raises(ValueError, match='law = "herz": must be one of "fractal"'):
        fstiff.Contact("herz", **FINE)
    with pytest.raises(ValueError, match="needs a measured map"):
        fstiff.Contact("boundary_elements", **FINE)
    with pytest.raises(ValueError, match="needs fractal_dimension"):
        fstiff.Contact("fractal", **FINE)
    for bad, sentence in ((["a"], ' = "a": does not begin with a finite number'), ([1j], ": must be real"), ([None], ": must be real")):
        with pytest.raises(ValueError, match=f"pressures{sentence}"):
            CONTACTS["hertz"].at_pressures(bad)
    with pytest.raises(ValueError, match="pressure = nan"):
        CONTACTS["hertz"].at_pressures(np.nan)


@pytest.mark.parametrize("method", ["stiffness", "separation", "stiffness_slope"])
def test_results_go_into_an_array_of_the_caller(method):
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    p = np.geomspace(1e5, 1e8, 1000).reshape(10, 100)
    evaluate, out = getattr(law, method), np.empty_like(p)
    assert evaluate(p, out=out) is out
    np.testing.assert_array_equal(out, evaluate(p))
    np.testing.assert_array_equal(evaluate(out_and_in := p.copy(), out=out_and_in), out)


@pytest.mark.parametrize("method", ["at_separation", "tangent_at_separation"])
def test_both_results_go_into_arrays_of_the_caller(method):
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    d = np.linspace(*law.separations, 1000)
    evaluate, out = getattr(law, method), (np.empty_like(d), np.empty_like(d))
    assert all(made is given for made, given in zip(evaluate(d, out=out), out))
    np.testing.assert_array_equal(out, evaluate(d))
    where_d_was = d.copy()
    np.testing.assert_array_equal(evaluate(where_d_was, out=(where_d_was, out[0])), evaluate(d))


def test_an_array_that_results_cannot_go_into_is_refused():
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    p = np.geomspace(1e5, 1e8, 8)
    read_only = np.empty(8)
    read_only.flags.writeable = False
    for out in (np.empty(7), np.empty(8, np.float32), np.empty(16)[::2], read_only, [0.0] * 8):
        with pytest.raises(ValueError, match="^out: must be a writeable C-contiguous array of float64 with the shape"):
            law.stiffness(p, out=out)
    with pytest.raises(ValueError, match="^out: must be 2 arrays"):
        law.at_separation(p, out=(np.empty(8),))


def test_every_column_of_points_is_an_attribute():
    points = CONTACTS["hertz"].at_pressures([1e6, 1e7])
    for name, key in (
        ("stiffness_error", "stiffness_error_Pa_per_m"),
        ("loading_stiffness", "loading_stiffness_Pa_per_m"),
        ("contact_density", "contacts_per_m2"),
    ):
        assert np.array_equal(getattr(points, name), points[key]) and name in dir(points)
    assert points.stiffness.low is None  # a contact has no band
    with pytest.raises(AttributeError, match="loss_factor: is not a column here"):
        _ = points.loss_factor


def test_a_notebook_shows_a_table():
    html = CONTACTS["hertz"].at_pressures([1e6, 1e7])._repr_html_()
    assert html.startswith("<p>&lt;fstiff.Points of hertz: 2 points&gt;</p><table><tr><th>p [MPa]</th>")
    assert html.count("<tr>") == 3 and html.endswith("</td></tr></table>")


def test_sensitivities_are_differences_of_the_contact():
    by = CONTACTS["hertz"].sensitivity(1e7)
    assert {"pressure", "rms_height", "peak_radius", "peak_density", "r", "theta", "effective_modulus"} <= set(by)
    h = 1e-4 * FINE["rms_height"]
    up, down = (fstiff.Contact("hertz", **{**FINE, "rms_height": FINE["rms_height"] + s * h}) for s in (1, -1))
    slope = (up.at_pressures(1e7).stiffness - down.at_pressures(1e7).stiffness) / (2 * h)
    assert by["rms_height"] == pytest.approx(float(slope), rel=1e-6)
    with pytest.raises(ValueError, match="^sensitivity.*plain numbers"):
        fstiff.Scene().contact().sensitivity(1e7)


def test_sigma_and_gradient_are_enough_for_the_laws_of_a_spectrum():
    modulus = 210e9 / (2 * (1 - 0.3**2))
    curves = fstiff.run(
        {
            "material": {"upper": {"name": "steel", "hardness": "2 GPa"}},
            "surface": {"rms_height": "0.8 um", "rms_gradient": 0.1},
            "contact": {"pressures": ["0.5 MPa", "2 MPa", "30 MPa"], "laws": ["hybrid", "persson", "plastic"]},
            "output": {"quantities": ["stiffness"]},
            "uncertainty": {"samples": 0},
        }
    )
    of_surface = {"rms_height": "0.8 um", "rms_gradient": 0.1, "effective_modulus": modulus}
    for law, hardness in (("hybrid", None), ("persson", None), ("plastic", 2e9)):
        of_law = curves["law"] == law
        contact = fstiff.Contact(law, hardness=hardness, **of_surface)
        found = contact.at_pressures(curves["pressure_Pa"][of_law], ["stiffness"]).stiffness
        np.testing.assert_allclose(found, curves["stiffness_Pa_per_m"][of_law], rtol=1e-14)
        assert pickle.loads(pickle.dumps(contact)).at_pressures(1e6) == contact.at_pressures(1e6)
        slopes = contact.sensitivity(1e6)
        assert slopes["rms_height"] < 0 and {"rms_gradient", "effective_modulus", "pressure"} <= set(slopes)
    gaussian, skewed = (
        fstiff.Contact("hybrid", skewness=skewness, kurtosis=kurtosis, **of_surface).at_pressures(2e6).stiffness
        for skewness, kurtosis in ((0, 3), (-1, 4.5))
    )
    assert skewed > 1.3 * gaussian
    del of_surface["rms_height"], of_surface["rms_gradient"]
    for law, numbers in (("hertz", {"rms_gradient": 0.1, "r": 0.5, "theta": 1}), ("hybrid", {})):
        with pytest.raises(ValueError, match="peak_radius: missing; a contact needs"):
            fstiff.Contact(law, rms_height=0.8e-6, **numbers, **of_surface)
    with pytest.raises(ValueError, match="rms_gradient = -0.1"):
        fstiff.Contact("hybrid", rms_height=0.8e-6, rms_gradient=-0.1, **of_surface)


def test_a_slip_of_the_unit_is_refused_or_warned_of():
    contact = fstiff.Contact("hertz", **FINE)
    with pytest.raises(ValueError, match="pressures: must not be masked"):
        contact.at_pressures(np.ma.array([1e6, 2e6], mask=[False, True]))
    unmasked = np.ma.array([1e6, 2e6], mask=[False, False])
    assert contact.at_pressures(unmasked) == contact.at_pressures([1e6, 2e6])
    with pytest.raises(ValueError, match='youngs_modulus = "210 N": "N" is not a unit of pressure'):
        fstiff.effective_modulus("210 N", 0.3, "210 GPa", 0.3)
    with pytest.warns(UserWarning, match="effective_modulus of 112.6 Pa: below 1 kPa"):
        fstiff.Contact("hertz", **{**FINE, "effective_modulus": 112.6})
    law = contact.tabulate(1e5, 1e8, "extrapolate")
    for nan in (np.nan, -np.nan):
        with pytest.raises(ValueError, match="^pressure = nan: must be a number$"):
            law.stiffness(nan)
        with pytest.raises(ValueError, match="^separation = nan: must be a number$"):
            law.at_separation([1e-6, nan])


def test_a_path_of_friction_is_the_first_slip_then_the_cycle_of_masing():
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    with_friction = {"friction": 0.3, "ratio": 0.8}
    d, s, angle = float(law.separation(1e7)), 2e-8, np.array([0.6, 0.8])
    there = law.path(d, np.full((20, 1), s / 20) * angle, **with_friction)
    q, slope = law.first_slip(d, np.linspace(s / 20, s, 20), **with_friction)
    assert there.pressure == pytest.approx(1e7, rel=1e-6) and there.pressure.shape == (20,)
    assert there.traction == pytest.approx(q[:, None] * angle, rel=1e-9)
    assert there.tangent[-1, 1:, 1:] @ angle == pytest.approx(slope[-1] * angle, rel=1e-9)

    cycle = np.concatenate([np.full(400, -s / 200), np.full(400, s / 200)])  # one step before its first, along it
    slips = cycle[:, None] * angle
    back = law.path(d, slips, before=there.after, **with_friction)
    traction = np.concatenate([there.traction[-1:], back.traction]) @ angle
    lost = np.sum((traction[1:] + traction[:-1]) / 2 * cycle)
    assert lost == pytest.approx(float(law.cycle(d, s, **with_friction)[0]), rel=1e-3)
    assert back.traction[-1] == pytest.approx(there.traction[-1], rel=1e-9)  # the loop is closed
    assert there.energy == pytest.approx(back.energy, rel=1e-9) and 0 < there.energy < q[-1] * s

    state = pickle.loads(pickle.dumps(there.after))
    for i in range(5):  # one at a time is the same path
        one = law.path(d, slips[i], before=state, **with_friction)
        assert np.array_equal(one.traction, back.traction[i]) and one.traction.shape == (2,)
        state = one.after
    with pytest.raises(ValueError, match="slip: must have two numbers for each step"):
        law.path(d, 1e-8, **with_friction)
    with pytest.raises(ValueError, match="slip = nan: must be finite"):
        law.path(d, (np.nan, 0), **with_friction)


def test_paths_of_many_contacts_are_those_of_each():
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    other = CONTACTS["hertz"].tabulate(1e5, 2e8)
    laws = fstiff.Laws([law, other, law])
    t = np.linspace(0, 4 * np.pi, 24)
    opening = 2e-8 * np.sin(t) * np.array([[1], [2], [3]])
    slip = np.diff(np.stack([2e-8 * np.cos(t), 1e-8 * np.sin(2 * t)], -1), axis=0, prepend=0.0)
    mu, preload, area = [0.1, 0.2, 0.3], [5e6, 1e7, 2e7], [1e-4, 2e-4, 3e-4]
    found = laws.path(opening, slip, friction=mu, ratio=0.8, preload=preload, area=area, threads=2)
    assert found.pressure.shape == (3, 24) and found.tangent.shape == (3, 24, 3, 3) and len(found.after) == 3
    np.testing.assert_array_equal(laws.separation(preload), [one.separation(p) for one, p in zip(laws, preload)])
    for c, one in enumerate(laws):
        alone = one.path(one.separation(preload[c]) + opening[c], slip, friction=mu[c], ratio=0.8)
        for name in ("pressure", "traction", "tangent"):
            np.testing.assert_allclose(getattr(found, name)[c], area[c] * getattr(alone, name), rtol=1e-12)
        assert found.energy[c] == pytest.approx(area[c] * alone.energy, rel=1e-12)
    half = laws.path(opening[:, :12], slip[:12], friction=mu, ratio=0.8, preload=preload)
    rest = laws.path(opening[:, 12:], slip[12:], friction=mu, ratio=0.8, preload=preload, before=half.after)
    whole = laws.path(opening, slip, friction=mu, ratio=0.8, preload=preload)
    np.testing.assert_array_equal(np.concatenate([half.traction, rest.traction], axis=1), whole.traction)
    same = law.path(np.full((3, 24), law.separation(1e7)), slip, friction=0.2, ratio=0.8)  # one law
    np.testing.assert_array_equal(same.traction[0], same.traction[2])
    d = laws.separation(preload)
    for call in ("cycle", "first_slip"):
        both = getattr(laws, call)(d, 1e-8, friction=mu, ratio=0.8)
        for c, one in enumerate(laws):
            assert [x[c] for x in both] == pytest.approx([float(x) for x in getattr(one, call)(d[c], 1e-8, friction=mu[c], ratio=0.8)])
    p, slope = laws.tangent_at_separation(d)
    np.testing.assert_allclose(p, preload, rtol=1e-6)
    np.testing.assert_allclose(slope, laws.stiffness(preload), rtol=1e-6)
    no_friction = laws.path(opening, slip, friction=0, ratio=0.8, preload=preload)
    assert not no_friction.traction.any() and np.array_equal(no_friction.pressure, whole.pressure)
    for wrong, sentence in [
        ({"separation": opening[:2]}, "separation: must be of 3 contacts, one for each law, not of the shape"),
        ({"slip": np.zeros((5, 2))}, r"slip: its shape \(5, 2\) does not go with the shape"),
        ({"friction": [0.1, 0.2]}, "friction: must be one number or 3, one for each contact"),
        ({"friction": -0.1}, "friction = -0.1: must be"),
        ({"slip": np.full((24, 2), np.nan)}, "slip = nan: must be finite"),
        ({"directions": np.zeros((24, 2, 4))}, r"directions: must be of the shape \(24, 3, 'numbers'\)"),
        ({"directions": np.full((24, 3, 1), np.inf)}, "motion_by = inf: must be finite"),
        ({"before": half.after[:2]}, "before: must be of 3 contacts"),
        ({"preload": 1e12}, r"pressure = 1e\+12: must be between"),
    ]:
        with pytest.raises(ValueError, match=sentence):
            laws.path(**{"separation": opening, "slip": slip, "friction": mu, "ratio": 0.8, "preload": preload, **wrong})
    with pytest.raises(ValueError, match="laws: must be laws, at least one"):
        fstiff.Laws([])
    with pytest.raises(ValueError, match="separation: must have 3 rows, one for each law"):
        laws.energy([1e-6, 2e-6])


def test_derivatives_of_a_whole_motion():
    law = CONTACTS["hertz"].tabulate(1e5, 1e8, outside="extrapolate")
    d = float(law.separation(1e7))
    s = 3 * 0.3 / 0.8 * 1e7 / law.stiffness(1e7)  # gross slip
    t = np.arange(128) * 4 * np.pi / 128
    shapes = np.stack([np.cos(t), np.sin(t)], -1)

    def motion(amplitudes):
        slips = np.diff(shapes @ amplitudes, prepend=0.0)
        return law.path(d, np.stack([slips, 0.1 * slips], -1), friction=0.3, ratio=0.8, directions=directions)

    directions = np.zeros((128, 3, 2))
    directions[:, 1] = np.diff(shapes, axis=0, prepend=0.0)
    directions[:, 2] = 0.1 * directions[:, 1]
    at = np.array([0.3 * s, s])
    found = motion(at)
    assert found.by_directions.shape == (128, 3, 2)
    for k in range(2):
        h = 1e-6 * s * np.eye(2)[k]
        difference = (motion(at + h).traction - motion(at - h).traction) / (2e-6 * s)
        exact = found.by_directions[:, 1:, k]
        assert np.abs(exact - difference).max() < 1e-6 * np.abs(found.by_directions).max()
    # the sine of the traction by that of the slip: the tangent of each step alone is far off
    exact = found.by_directions[64:, 1, 1] @ shapes[64:, 1]
    alone = found.tangent[64:, 1, 1] @ shapes[64:, 1] ** 2
    assert abs(alone / exact - 1) > 0.2


def test_greenwood_williamson_takes_heights_of_peaks():
    gaussian = fstiff.Contact("greenwood_williamson", **FINE_PEAKS)
    p = np.array([1e5, 1e6, 1e7])
    K = gaussian.at_pressures(p).stiffness
    same = fstiff.Contact("greenwood_williamson", peak_skewness=0, peak_kurtosis=3, **FINE_PEAKS)
    np.testing.assert_allclose(same.at_pressures(p).stiffness, K, rtol=3e-3)
    outliers = fstiff.Contact("greenwood_williamson", peak_skewness=0.5, peak_kurtosis=6, **FINE_PEAKS)
    assert (outliers.at_pressures(p).stiffness[:2] < 0.9 * K[:2]).all()
    heights = FINE_PEAKS["rms_height"] * np.random.default_rng(3).normal(size=4000)
    measured = fstiff.Contact("greenwood_williamson", peak_heights=heights, **FINE_PEAKS)
    np.testing.assert_allclose(measured.at_pressures(p[2:]).stiffness, K[2:], rtol=0.05)
    again = pickle.loads(pickle.dumps(measured))
    np.testing.assert_array_equal(again.at_pressures(p).stiffness, measured.at_pressures(p).stiffness)
    assert fstiff.Contact("plastic", hardness=2e9, **FINE_PEAKS).at_pressures(1e7).stiffness > 0  # without r and theta
    for law, wrong, sentence in [
        ("hertz", {"peak_heights": heights, "r": 0.5, "theta": 1.0}, "peak_heights: are for greenwood_williamson, not for hertz"),
        ("greenwood_williamson", {"peak_skewness": 1}, "peak_kurtosis: missing"),
        ("greenwood_williamson", {"peak_heights": heights, "peak_skewness": 0, "peak_kurtosis": 3}, "must not be given with peak_skewness"),
        ("greenwood_williamson", {"peak_heights": [1e-6]}, "peak_heights = 1: must be 2 heights at least"),
        ("greenwood_williamson", {"peak_heights": [1e-6, np.nan]}, "peak_heights = nan: must be finite"),
        ("greenwood_williamson", {"peak_heights": 1e-6}, "peak_heights: must be an array of one axis"),
        ("greenwood_williamson", {"peak_skewness": 0, "peak_kurtosis": 1e4}, "kurtosis"),
    ]:
        with pytest.raises(ValueError, match=sentence):
            fstiff.Contact(law, **FINE_PEAKS, **wrong)


def test_the_law_after_a_load():
    plastic = fstiff.Contact("plastic", rms_height=0.8e-6, rms_gradient=0.1, effective_modulus=115e9, hardness=2e9)
    loading = plastic.tabulate(1e5, 1e8, outside="extrapolate")
    law = plastic.law_after("20 MPa", 1e5, 1e8, outside="extrapolate")
    assert law.stiffness_is_slope and law.separation(2e7) == pytest.approx(loading.separation(2e7), abs=1e-13)
    assert law.stiffness(1.9999e7) == pytest.approx(loading.stiffness(2e7), rel=1e-3)
    assert law.separation(1e7) < loading.separation(1e7)
    with pytest.raises(ValueError, match="must be elastic"):
        loading.cycle(loading.separation(1e7), 1e-9, friction=0.2, ratio=0.8)
    lost, factor = law.cycle(law.separation(1e7), 1e-8, friction=0.2, ratio=0.8)
    assert lost > 0 and 0 < factor < 4 / np.pi
    many = plastic.law_after([1e7, 2e7], 1e5, 1e8, outside="extrapolate")
    assert isinstance(many, fstiff.Laws) and many[1] == law and len(many) == 2
    elastic = CONTACTS["hertz"]
    assert elastic.law_after(1e7, 1e5, 1e8) == elastic.tabulate(1e5, 1e8)
    for call, sentence in [
        (lambda: plastic.law_after(2e8, 1e5, 1e8), r"greatest_pressure = 2e\+08: must be above"),
        (lambda: plastic.law_after(np.nan, 1e5, 1e8), "greatest_pressure = nan: must be"),
        (lambda: plastic.law_after([[1e7]], 1e5, 1e8), "greatest_pressure: must be one pressure or an array of one axis"),
        (lambda: plastic.law_after(1e7, 1e5, 1e8, outside="exact"), "outside = exact: must be another policy"),
        (lambda: CONTACTS["fractal"].law_after(1e7, 1e5, 1e8), "it has no unloading"),
    ]:
        with pytest.raises(ValueError, match=sentence):
            call()


def test_energy_friction_and_heat_of_a_law():
    integral = lambda y, x: float(np.sum((y[1:] + y[:-1]) / 2 * np.diff(x)))
    law = CONTACTS["hertz"].tabulate(1e5, 1e8)
    d = law.separation(np.array([1e6, 1e7]))
    assert law.touch > d[0] > d[1]
    fine = np.linspace(d[1], d[0], 20001)
    work = integral(law.at_separation(fine)[0], fine)
    assert law.energy(d[1]) - law.energy(d[0]) == pytest.approx(work, rel=1e-6)  # the work of p
    ratio = fstiff.tangential_ratio(205e9, 0.3, 205e9, 0.3)
    assert ratio == pytest.approx(2 * (1 - 0.3) / (2 - 0.3), rel=1e-14)
    p, k = law.at_separation(d)
    traction, stiffness = law.first_slip(d, [0.0, 1.0], friction=0.3, ratio=ratio)
    assert stiffness[0] == pytest.approx(ratio * k[0], rel=1e-6)  # nothing slips
    assert traction[1] == pytest.approx(0.3 * p[1], rel=1e-9)  # all of it does
    s = np.linspace(0, 2e-8, 2001)
    lost, factor = law.cycle(d[1], s[-1], friction=0.3, ratio=ratio)
    q = law.first_slip(d[1], s, friction=0.3, ratio=ratio)[0]
    masing = 8 * integral(q, s) - 4 * q[-1] * s[-1]  # twice the area of the first curve above its chord, four times
    assert float(lost) == pytest.approx(masing, rel=1e-4) and 0 < factor < 4 / np.pi
    assert fstiff.spot_conductance(k, 50.0, 112.6e9) == pytest.approx(50.0 * k / 112.6e9, rel=1e-14)
    with pytest.raises(ValueError, match="friction = -0.1: must be"):
        law.first_slip(d, 0.0, friction=-0.1, ratio=ratio)
