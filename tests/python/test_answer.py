# SPDX-License-Identifier: BSD-3-Clause
"""fstiff.answer() gives what fstiff.run() does of the same joint, to the last digit."""

import inspect
import re

import numpy as np
import pytest

import fstiff
from fstiff._units import si_unit

PRESSURES = np.array([1e6, 1e7, 1e8])
CONTACT = {"pressures": ["1 MPa", "10 MPa", "100 MPa"]}
KEYS = ("stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m", "law")


def assert_same(found, scene, **surface):
    """Every column that both have, and the causes, are equal."""
    answer = fstiff.run({**scene, "contact": {**CONTACT, **scene.get("contact", {})}}, **surface).answer
    for key in KEYS:
        np.testing.assert_array_equal(found[key], answer[key], err_msg=key)
    for key in set(found) & set(answer) - {"pressure_Pa"}:
        np.testing.assert_array_equal(found[key], answer[key], err_msg=key)
    for cause, shares in found.causes.items():
        np.testing.assert_array_equal(shares, answer.causes.get(cause, np.zeros(len(shares))), err_msg=cause)


def test_numbers():
    found = fstiff.answer(rms_height="0.8 um", rms_gradient=0.1, upper="steel", pressures=PRESSURES)
    assert_same(found, {"surface": {"rms_height": "0.8 um", "rms_gradient": 0.1}, "material": {"upper": "steel"}})
    assert found.stiffness.shape == (3,) and found.doubtful.shape == () and not found.doubtful
    assert (found.low < found.stiffness).all() and (found.stiffness < found.high).all()
    assert "plastic" in repr(found) and "MPa/µm" in repr(found)
    assert list(found.to_dataframe()["law"]) == ["plastic"] * 3 if pytest.importorskip("pandas") else True


def test_two_faces_and_metals_that_yield():
    found = fstiff.answer(
        mean_height=0.8e-6,
        process="ground",
        other={"rms_height": "0.2 um", "rms_gradient": 0.05, "process": "lapped"},
        upper={"name": "steel", "hardness": 2e9},
        lower={"youngs_modulus": 110e9, "poisson_ratio": 0.26, "hardness": 1.5e9},
        nominal_area=1e-4,
        pressures=PRESSURES,
    )
    assert_same(
        found,
        {
            "surface": {
                "upper": {"Ra": "0.8 um", "process": "ground"},
                "lower": {"rms_height": "0.2 um", "rms_gradient": 0.05, "process": "lapped"},
            },
            "material": {
                "upper": {"name": "steel", "hardness": "2 GPa"},
                "lower": {"youngs_modulus": "110 GPa", "poisson_ratio": 0.26, "hardness": "1.5 GPa"},
            },
            "contact": {"nominal_area": "1 cm^2"},
        },
    )
    assert (found["loading_stiffness_Pa_per_m"] <= found.stiffness).all()


def test_measured_surfaces(trace, rough_map):
    traces = [fstiff.measure(trace, spacing=0.5e-6), fstiff.measure(trace[: trace.size // 2], spacing=0.5e-6)]
    of_map = fstiff.measure(rough_map, spacing=(1e-6, 1.5e-6))
    for measured in (*traces, of_map):
        found = fstiff.answer(surface=measured, upper="steel", pressures=PRESSURES)
        assert_same(found, {"material": {"upper": "steel"}}, surface=measured)
    many = fstiff.answer(surface=traces, upper="steel", pressures=PRESSURES, samples=50)
    assert many.stiffness.shape == (2, 3) and many.doubtful.shape == (2,)
    for i, measured in enumerate(traces):
        one = fstiff.answer(surface=measured, upper="steel", pressures=PRESSURES, samples=50)
        np.testing.assert_array_equal(many.stiffness[i], one.stiffness)
        np.testing.assert_array_equal(many.high[i], one.high)


def test_arrays_are_many_joints():
    heights, gradients = np.array([[0.2e-6], [0.8e-6]]), np.array([0.05, 0.1, np.nan])
    many = fstiff.answer(rms_height=heights, rms_gradient=gradients, upper="steel", pressures=PRESSURES)
    assert many.stiffness.shape == many["law"].shape == (2, 3, 3)
    for i in range(2):
        for k in range(3):
            gradient = None if np.isnan(gradients[k]) else gradients[k]
            one = fstiff.answer(rms_height=heights[i, 0], rms_gradient=gradient, upper="steel", pressures=PRESSURES)
            for key in one:
                np.testing.assert_array_equal(many[key][i, k], one[key], err_msg=key)
    assert fstiff.answer(rms_height=1e-6, upper="steel", pressures=1e7).stiffness.shape == ()


def test_an_answer_without_its_approach():
    whole, found = (fstiff.answer(rms_height=[0.4e-6, 0.8e-6], pressures=PRESSURES, seating=seating) for seating in (1e3, None))
    assert np.isnan(found["approach_m"]).all() and (whole["approach_m"] > 0).all()
    for key in set(whole) - {"approach_m"}:
        np.testing.assert_array_equal(found[key], whole[key], err_msg=key)


def test_quantities():
    named = ["tangential_stiffness", "reflection", "shear_reflection", "loss_factor", "thermal_conductance"]
    found = fstiff.answer(
        rms_height=0.8e-6, rms_gradient=0.1, upper="steel", lower="aluminium", pressures=PRESSURES, quantities=named,
        frequency=5e6, film_stiffness=1e14, friction=0.2, amplitude=1e-8,
    )  # fmt: skip
    curves = fstiff.run({
        "surface": {"rms_height": "0.8 um", "rms_gradient": 0.1},
        "material": {"upper": "steel", "lower": "aluminium"},
        "contact": CONTACT,
        "ultrasound": {"frequency": "5 MHz", "film_stiffness": "1e14 Pa/m"},
        "friction": {"coefficient": 0.2, "amplitude": "10 nm"},
        "output": {"quantities": ["stiffness", *named]},
    })  # fmt: skip
    for key in found:
        if key in curves and key not in ("law", "pressure_Pa"):
            np.testing.assert_array_equal(found[key], curves[key], err_msg=key)
    for name in named:
        assert any(key.startswith(name) for key in set(found) & set(curves))


def test_points_without_a_stiffness_and_concerns():
    soft = {"name": "steel", "hardness": 50e6}
    found = fstiff.answer(rms_height=0.8e-6, rms_gradient=0.1, upper=soft, pressures=PRESSURES)
    assert np.isnan(found.stiffness[2]) and found["law"][2] == "" and found.doubtful
    reason = "1e+08 Pa is above the hardness (5e+07 Pa): the contact is closed"
    assert found.reasons[(2,)] == reason and "no_state" in found.concerns[0]
    assert f"warning: no state\nwarning: {reason}" in repr(found)
    none = fstiff.answer(rms_height=0.8e-6, rms_gradient=0.1, upper=soft, pressures=1e9)
    assert np.isnan(none.stiffness) and np.isnan(none.low) and none.pressure == 1e9 and "is above the hardness" in repr(none)
    assert "0 points" in repr(fstiff.answer(rms_height=[], pressures=[1e6]))


def test_what_print_and_plot_show():
    one = fstiff.answer(rms_height=0.8e-6, rms_gradient=0.1, pressures=1e7, nominal_area=1e-4)
    assert one["stiffness_N_per_m"] == 1e-4 * one.stiffness and one.joint_stiffness.low == 1e-4 * one.low
    assert "–".join(f"{float(f'{end * 1e-12:.2g}'):g}" for end in (one.low, one.high)) in repr(one) and "1 point>" in repr(one)
    many = fstiff.answer(rms_height=np.array([0.4e-6, 0.8e-6, 1.6e-6]), rms_gradient=0.1, pressures=PRESSURES)
    assert "joint" in repr(many) and "..." in repr(many)
    pytest.importorskip("matplotlib")
    axes = one.plot()
    assert axes.lines[0].get_marker() == "o" and len(axes.collections) == 1  # a band of one point
    np.testing.assert_allclose(axes.get_xlim(), (5, 20))


def test_heights_in_another_unit_are_warned_of_where_they_were_given():
    for name in ("rms_height", "mean_height"):
        with pytest.warns(UserWarning, match="above 1 mm") as caught:
            fstiff.answer(**{name: 1.6}, pressures=1e7, samples=0)
        assert caught[0].filename == __file__
    with pytest.warns(UserWarning, match="above 1 mm") as caught:
        fstiff.measure(np.random.default_rng(1).normal(size=400), spacing=1e-6)
    assert caught[0].filename == __file__


def test_each_number_of_the_library_is_a_keyword():
    fields = fstiff._core.numbers_of_joint()["face"]
    needs = {"skewness": {"kurtosis": 90}, "kurtosis": {"skewness": 0}, "r": {"theta": 0.7}, "theta": {"r": 0.5}}
    heights = [name for name, (_, _, main) in fields.items() if main in ("rms_height", "mean_height")]
    assert len({main for _, _, main in fields.values()}) == 18 and "Ra" in heights
    for name in ("worn", "whole"):
        assert np.isfinite(fstiff.answer(rms_height="1 um", pressures=1e7, samples=0, seating=None, **{name: True}).stiffness)
        del fields[name]
    for name, (unit, meaning, main) in fields.items():
        value = {"m": "1 um", "1/m^2": 1e9, "rad": "45 deg"}.get(unit, 1.6 if main in ("alpha", "fractal_dimension") else 0.2)
        face = {name: 5 if main == "kurtosis" else value, **needs.get(main, {})}
        base = {} if name in heights else {"rms_height": "1 um"}
        assert np.isfinite(fstiff.answer(**base, **face, pressures=1e7, samples=0, seating=None).stiffness), name
        assert name in inspect.signature(fstiff.answer).parameters and meaning in fstiff.answer.__doc__
        with pytest.raises(ValueError, match=f"^{main} = -9: must be"):
            fstiff.answer(**base, **{**face, name: -9}, pressures=1e7, samples=0)
        with pytest.raises(ValueError, match=f"^other.{main} = -9: must be"):
            fstiff.answer(rms_height="1 um", other={name: -9}, pressures=1e7, samples=0)
    with pytest.raises(ValueError, match="^height: is called rms_height"):
        fstiff.answer(height=1e-6, pressures=1e7)
    with pytest.raises(ValueError, match="^rms_hight: must be one of rms_height, Rq.*; did you mean rms_height?"):
        fstiff.answer(rms_hight=1e-6, pressures=1e7)


def test_each_number_of_a_load_has_its_unit():
    fields = fstiff._core.numbers_of_joint()["load"]
    assert set(fields) == {"pressures", "pressure", "separations", "force", "seating", "ball_radius"}
    for name, (unit, meaning, main) in fields.items():
        assert si_unit(name) == unit and meaning and (main == name or name == "pressure")
    of = dict(rms_height="0.8 um", samples=0)
    texts = fstiff.answer(**of, pressures=["1 MPa", "10 MPa"], seating="2 kPa")
    plain = fstiff.answer(**of, pressures=[1e6, 1e7], seating=2e3)
    np.testing.assert_array_equal(texts["approach_m"], plain["approach_m"])
    for name in ("pressures", "seating"):
        with pytest.raises(ValueError, match=f'^{name} = "1 kg": "kg" is not a unit of pressure'):
            fstiff.answer(**{**of, "pressures": 1e7, name: "1 kg"})


def test_processes_and_grades_by_other_words():
    of = dict(mean_height="0.8 um", pressures=PRESSURES, samples=0)
    ground = fstiff.answer(**of, process="ground").stiffness
    assert np.array_equal(fstiff.answer(**of, process="grinding").stiffness, ground)
    assert np.array_equal(fstiff.answer(**{**of, "mean_height": "N6"}, process="ground").stiffness, ground)
    unknown = fstiff.answer(**of).stiffness
    assert np.array_equal(fstiff.answer(**of, process="reamed").stiffness, unknown) and not np.array_equal(unknown, ground)
    with pytest.raises(ValueError, match='did you mean "stainless_steel"'):
        fstiff.answer(**of, upper="1.4305")
    assert np.array_equal(fstiff.answer(Ra="N6", process="ground", pressures=PRESSURES, samples=0).stiffness, ground)
    with pytest.raises(ValueError, match="height"):
        fstiff.answer(rms_height="N6", pressures=PRESSURES)


@pytest.mark.parametrize(
    "given, sentence",
    [
        ({"rms_height": -1e-6}, "^rms_height = -1e-06: must be finite and greater than 0"),
        ({"rms_height": 1e-6, "upper": "stele"}, r'^upper = "stele": is not a known material \(did you mean steel\?\); fstiff help materials'),
        ({"rms_height": 1e-6, "upper": {"poisson_ratio": 0.3}}, "^upper.youngs_modulus: is missing"),
        ({"rms_height": 1e-6, "lower": {"modulus": 1}}, "^lower.modulus: must be one of name"),
        ({"rms_height": [1e-6, 2e-6], "rms_gradient": [0.1, 0.2, 0.3]}, "shapes that do not go together"),
        ({"rms_height": [1e-6, -2e-6]}, "^surface 1: rms_height = -2e-06"),
        ({"rms_height": 1e-6, "other": {"rms": 1}}, "^other.rms: must be one of process"),
        ({"rms_height": 1e-6, "process": "forged"}, '^process = "forged": must be one of'),
        ({"rms_height": 1e-6, "quantities": ["reflection"]}, "^quantities: reflection needs frequency"),
        ({"rms_height": 1e-6, "quantities": ["colour"]}, '^quantities = "colour": must be one of force, '),
        ({"rms_height": 1e-6, "quantities": "reflection"}, "must be a list of names"),
        ({"surface": 3}, "^surface: must be what measure"),
        ({"surface": np.ones((64, 96))}, "^surface: must be what measure.. returned, not of type ndarray"),
        ({}, "rms_height|height"),
        ({"rms_height": 1e-6, "samples": 3}, "^samples = 3"),
        ({"rms_height": 1e-6, "nominal_area": "2 cm"}, '^nominal_area = "2 cm": "cm" is not a unit of area'),
        ({"rms_height": 1e-6, "upper": {"name": "steel", "hardness": "240 HV"}}, '^upper.hardness = "240 HV": "HV" is not a unit of pressure'),
        ({"rms_height": 1e-6, "upper": {"name": "steel", "hardness": [2e9]}}, "^upper.hardness = .2000000000.0.: must be a number in SI units"),
        ({"rms_height": 1e-6, "other": 1e-6}, "^other: must be a dict of numbers"),
        ({"rms_height": 1e-6, "process": ["turned"]}, "^process: must be one word"),
        ({"rms_height": 1e-6, "pressures": "30 um"}, '^pressures = "30 um": "um" is not a unit of pressure'),
        ({"rms_height": 1e-6, "pressures": [[1e6], [1e6, 2e6]]}, "^pressures: must be real numbers, its rows equally long"),
        ({"rms_height": 1e-6, "pressures": [1e6, -1]}, "^pressure = -1"),
    ],
)
def test_refusals(given, sentence):
    with pytest.raises(ValueError, match=sentence):
        fstiff.answer(**{"pressures": PRESSURES, **given})


def test_numbers_in_another_unit_and_refusals_name_what_is_wrong():
    with pytest.warns(UserWarning, match="pressure 10 Pa is below 1e-9 of the effective modulus, 115 Pa: a unit is likely wrong"):
        found = fstiff.answer(rms_height=0.8e-6, rms_gradient=0.1, pressures=10, samples=0)
    assert found.concerns == [["pressure_unit"]] and found.doubtful
    soft = {"youngs_modulus": 205, "poisson_ratio": 0.3}
    with pytest.warns(UserWarning, match="modulus 205 Pa is below 1 kPa"):
        found = fstiff.answer(rms_height=0.8e-6, rms_gradient=0.1, upper=soft, pressures=1e7, samples=0)
    assert "modulus_unit" in found.concerns[0]
    for given, sentence in [
        ({"lower": {"youngs_modulus": 0, "poisson_ratio": 0.3}}, "lower.youngs_modulus = 0: must be"),
        ({"upper": {"name": "steel", "hardness": -1}}, "upper.hardness = -1: must be"),
        ({"other": {"rms_height": -1}}, "other.rms_height = -1: must be"),
        ({"other": {"rms_gradient": 0.1}}, "other.rms_height: is missing"),
    ]:
        with pytest.raises(ValueError, match=sentence):
            fstiff.answer(**{"rms_height": 0.8e-6, "rms_gradient": 0.1, "pressures": 1e7, **given})


def test_the_law_of_an_answer():
    # truth: K and the ends of its band at pressures between those of the law, by answers of their own
    p, between = np.geomspace(1e6, 1e8, 21), np.geomspace(1.1e6, 9e7, 7)
    given = {"rms_height": 0.8e-6, "rms_gradient": 0.1, "upper": "steel"}
    found, there = fstiff.answer(pressures=p, **given), fstiff.answer(pressures=between, **given)
    for quantile, end in ((0.05, "low"), (0.5, "stiffness"), (0.95, "high")):
        law = found.law_at(quantile)
        assert isinstance(law, fstiff.Law) and law.stiffness_is_slope and law.pressures == (p[0], p[-1])
        np.testing.assert_allclose(law.stiffness(between), getattr(there, end), rtol=2e-3)
        np.testing.assert_allclose(law.tangent_at_separation(law.separation(p))[1], getattr(found, end), rtol=1e-3)
    law = found.law_at(0.05, "2 MPa", 5e7, outside="extrapolate")
    assert law.pressures == (2e6, 5e7) and law.outside == "extrapolate" and law.stiffness(1e8) > law.stiffness(5e7)
    same = fstiff.Law.from_text(fstiff.export({
        "surface": {"rms_height": "0.8 um", "rms_gradient": 0.1}, "material": {"upper": "steel"},
        "contact": {"pressures": ["1 MPa", "100 MPa"]},
    }, "law", law="answer"))  # fmt: skip
    np.testing.assert_allclose(same.stiffness(p), found.law_at().stiffness(p), rtol=1e-6)

    loading = found.loading_law(outside="extrapolate")
    np.testing.assert_allclose(loading.stiffness(between), there.stiffness, rtol=2e-3)
    slopes = loading.tangent_at_separation(loading.separation(between))[1]
    np.testing.assert_allclose(slopes, there.loading_stiffness, rtol=2e-2)
    carried = fstiff.answer(pressures=between, greatest_pressure=9.5e7, **given)
    after = found.law_after([3e7, 9.5e7], outside="extrapolate")
    np.testing.assert_allclose(after[1].stiffness(between), carried.stiffness, rtol=5e-3)
    np.testing.assert_allclose(after.separation([3e7, 9.5e7]), loading.separation(np.array([3e7, 9.5e7])), atol=1e-13)
    assert found.law_after(3e7, outside="extrapolate") == after[0]
    with pytest.raises(ValueError, match="greatest_pressure: must be greater than 0"):
        found.law_after(0)
    formed = {"flatness": 5e-6, "nominal_area": 1e-3, "samples": 0}
    of_joint, of_faces = (fstiff.answer(pressures=p, **given, **more) for more in (formed, {"samples": 0}))
    assert of_joint.stiffness[0] < 0.9 * of_faces.stiffness[0]
    np.testing.assert_allclose(of_joint.law_at().stiffness(between), of_faces.law_at().stiffness(between), rtol=1e-6)

    many = fstiff.answer(rms_height=[0.4e-6, 0.8e-6], rms_gradient=[0.1, np.nan], upper="steel", pressures=p, samples=0)
    one = fstiff.answer(rms_height=0.4e-6, rms_gradient=0.1, upper="steel", pressures=p, samples=0)
    assert many.law_at(joint=0).to_text() == one.law_at().to_text()
    soft = fstiff.answer(rms_height=0.8e-6, rms_gradient=0.1, upper={"name": "steel", "hardness": 50e6}, pressures=p)
    assert soft.law_at().pressures == (p[0], p[p < 50e6][-1])
    for call, words in (
        (lambda: found.law_at(0.1), "quantile = 0.1: must be 0.05, 0.5 or 0.95"),
        (lambda: found.law_at("x"), "quantile = 'x': must be a number"),
        (lambda: found.law_at(max_pressure=1e9), "max_pressure = "),
        (lambda: found.law_at(outside="exact"), "outside"),
        (lambda: found.law_at(outside="on"), 'outside = "on"'),
        (lambda: many.law_at(), "joint: must be the index of one of the joints, whose shape is"),
        (lambda: many.law_at(joint=2), "joint = 2: index 2 is out of bounds"),
        (lambda: fstiff.answer(pressures=1e7, **given).law_at(), "points with a stiffness = 1: must be at least 2"),
        (lambda: fstiff.answer(rms_height=0.8e-6, pressures=p[:2], upper={"name": "steel", "hardness": 1e5}).law_at(), "points with a stiffness = 0"),
    ):
        with pytest.raises(ValueError, match=re.escape(words)):
            call()
