# SPDX-License-Identifier: BSD-3-Clause
"""Quantities with units give the numbers of plain SI, or are refused; none loses its unit."""

import warnings

import fstiff
import numpy as np
import pytest

BODIES = {"effective_modulus": 112.6e9}


class Pint:
    """Quantities of pint: quantity(0.8, "um")."""

    def __init__(self):
        self.registry = pytest.importorskip("pint").UnitRegistry()

    def __call__(self, value, unit):
        return self.registry.Quantity(value, unit)


class Astropy:
    def __init__(self):
        self.units = pytest.importorskip("astropy.units")

    def __call__(self, value, unit):
        return self.units.Quantity(value, unit)


@pytest.fixture(params=[Pint, Astropy])
def quantity(request):
    return request.param()


@pytest.fixture(autouse=True)
def no_warning():
    """pint warns where it drops a unit."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


@pytest.fixture(scope="module")
def law():
    return fstiff.Contact("hybrid", rms_height=0.8e-6, rms_gradient=0.1, **BODIES).tabulate(1e5, 1e8)


def of(**changes):
    given = {"pressures": [1e6, 10e6], "rms_height": 0.8e-6, "rms_gradient": 0.1, "samples": 0, **changes}
    return fstiff.answer(**given)


def test_the_answer_of_quantities_is_that_of_si(quantity):
    expected = of(upper={"youngs_modulus": 205e9, "poisson_ratio": 0.3, "hardness": 2e9}, nominal_area=1e-4, seating=2e3)
    steel = {"youngs_modulus": quantity(205, "GPa"), "poisson_ratio": 0.3, "hardness": quantity(2000, "MPa")}
    found = of(
        pressures=quantity([1, 10], "MPa"), rms_height=quantity(0.8, "um"), upper=steel, nominal_area=quantity(1, "cm^2"), seating=quantity(2, "kPa")
    )
    np.testing.assert_allclose(found.stiffness, expected.stiffness, rtol=1e-12)
    np.testing.assert_allclose(found.joint_stiffness, expected.joint_stiffness, rtol=1e-12)


def test_arrays_and_lists_of_quantities_are_tables_in_si(quantity):
    expected = of(rms_height=[0.8e-6, 1e-6], rms_gradient=[0.1, 0.2]).stiffness
    for heights in (quantity(np.array([0.8, 1.0]), "um"), [quantity(0.8, "um"), quantity(1000, "nm")], [quantity(0.8, "um"), 1e-6]):
        np.testing.assert_allclose(of(rms_height=heights, rms_gradient=[0.1, quantity(20, "percent")]).stiffness, expected, rtol=1e-12)


def test_texts_with_a_unit_are_pressures_and_any_other_quantity():
    expected = of()
    for pressures in (["1 MPa", "10 MPa"], [1e6, "10 N/mm^2"], np.array(["1 MPa", "10 MPa"]), ("1000 kPa", "0.01 GPa")):
        np.testing.assert_allclose(of(pressures=pressures).stiffness, expected.stiffness, rtol=1e-12)
    assert of(pressures="10 MPa").stiffness == expected.stiffness[1]
    contact = fstiff.Contact("hybrid", rms_height="0.8 um", rms_gradient=0.1, effective_modulus="112.6 GPa")
    assert contact.at_pressures("10 MPa").stiffness == pytest.approx(contact.at_pressures(10e6).stiffness, rel=1e-14)
    assert fstiff.effective_modulus("205 GPa", 0.3, "205 GPa", 0.3) == pytest.approx(205e9 / 0.91 / 2, rel=1e-14)
    with pytest.raises(ValueError, match='pressures = "10 um": .*MPa'):
        of(pressures=["1 MPa", "10 um"])
    with pytest.raises(ValueError, match='pressures = "10": '):
        of(pressures="10")
    with pytest.raises(ValueError, match="rms_gradient: must be real numbers, not text"):
        of(rms_gradient="0.1")


def test_a_law_takes_quantities(quantity, law):
    assert law.stiffness(quantity(10, "MPa")) == pytest.approx(law.stiffness(10e6), rel=1e-14)
    assert law.stiffness("10 MPa") == law.stiffness(10e6)
    d = law.separation(np.array([1e6, 1e7]))
    np.testing.assert_allclose(law.tangent_at_separation(quantity(d * 1e6, "um")), law.tangent_at_separation(d), rtol=1e-9)
    of_quantities = fstiff.Contact(
        "hybrid", rms_height=quantity(0.8, "um"), rms_gradient=0.1, effective_modulus=quantity(112.6, "GPa")
    ).tabulate(quantity(0.1, "MPa"), "100 MPa")
    assert of_quantities.stiffness(1e7) == pytest.approx(law.stiffness(1e7), rel=1e-12)
    slipped = law.first_slip(quantity(d * 1e9, "nm"), quantity(1, "nm"), friction=0.2, ratio=0.8)
    np.testing.assert_allclose(slipped, law.first_slip(d, 1e-9, friction=0.2, ratio=0.8), rtol=1e-6)
    k = quantity([50, 60], "MPa/um")
    of_heat = fstiff.spot_conductance(k, quantity(40, "W/(m K)"), quantity(112.6, "GPa"))
    np.testing.assert_allclose(of_heat, fstiff.spot_conductance([50e12, 60e12], 40.0, 112.6e9), rtol=1e-12)


def test_heights_and_their_spacing_may_have_units(quantity, trace, rough_map):
    expected = fstiff.measure(trace, spacing=1e-6)
    found = fstiff.measure(quantity(trace * 1e6, "um"), spacing=quantity(1, "um"), lambda_s=quantity(2.5, "um"))
    assert found.rms_height.value == pytest.approx(fstiff.measure(trace, spacing=1e-6, lambda_s=2.5e-6).rms_height.value, rel=1e-9)
    assert fstiff.Surface(quantity(trace * 1e9, "nm"), "1 um").heights == pytest.approx(trace, rel=1e-12)
    of_map = fstiff.measure(quantity(rough_map * 1e6, "um"), spacing=(quantity(1, "um"), quantity(1.5, "um")))
    assert of_map.rms_height.value == pytest.approx(fstiff.measure(rough_map, spacing=(1e-6, 1.5e-6)).rms_height.value, rel=1e-9)
    several = fstiff.measure([quantity(trace * 1e6, "um"), trace], spacing=1e-6)
    assert several.rms_height.value == pytest.approx(expected.rms_height.value, rel=1e-9)


def test_a_scene_and_a_sweep_take_quantities(quantity):
    def scene(height, pressures):
        return {"surface": {"rms_height": height, "rms_gradient": 0.1}, "material": {"upper": "steel"}, "contact": {"pressures": pressures}}

    expected = fstiff.run(scene("0.8 um", ["1 MPa", "10 MPa"]))
    found = fstiff.run(scene(quantity(0.8, "um"), quantity([1, 10], "MPa")))
    np.testing.assert_allclose(found["stiffness_Pa_per_m"], expected["stiffness_Pa_per_m"], rtol=1e-12)
    pytest.importorskip("pandas")
    plain = fstiff.sweep(scene("1 um", ["10 MPa"]), {"surface.rms_height": [0.5e-6, 0.8e-6]})
    for heights in (quantity([0.5, 0.8], "um"), [quantity(0.5, "um"), quantity(800, "nm")]):
        swept = fstiff.sweep(scene("1 um", ["10 MPa"]), {"surface.rms_height": heights})
        np.testing.assert_allclose(swept["stiffness_Pa_per_m"], plain["stiffness_Pa_per_m"], rtol=1e-9)


def test_ultrasound_and_curves_take_quantities(quantity):
    expected = fstiff.ultrasound(stiffness=1e14, frequency=5e6, density=7850, velocity=5900)
    found = fstiff.ultrasound(
        stiffness=quantity(100, "MPa/um"), frequency=quantity(5, "MHz"), density=quantity(7.85, "g/cm^3"), velocity=quantity(5.9, "km/s")
    )
    assert found["reflection"] == pytest.approx(expected["reflection"], rel=1e-12)


@pytest.mark.parametrize(
    "call",
    [
        lambda q: of(rms_height=q(0.8, "MPa")),
        lambda q: of(rms_height=[0.8e-6, q(0.8, "MPa")]),
        lambda q: of(rms_gradient=q(0.1, "um")),
        lambda q: of(pressures=q([1, 10], "N")),
        lambda q: of(upper={"youngs_modulus": q(205, "m"), "poisson_ratio": 0.3}),
        lambda q: of(samples=q(100, "m")),
        lambda q: fstiff.measure(q(np.ones(60), "Pa"), spacing=1e-6),
        lambda q: fstiff.measure(np.ones(60), spacing=q(1, "Pa")),
        lambda q: fstiff.Contact("hybrid", rms_height=q(1, "kg"), rms_gradient=0.1, **BODIES),
        lambda q: fstiff.effective_modulus(q(205, "um"), 0.3, 205e9, 0.3),
        lambda q: fstiff.peak_integral(lambda e, t: e, r=q(0.5, "m"), theta=1.0, eta=1.0),
    ],
)
def test_a_quantity_of_another_kind_is_refused(quantity, call):
    with pytest.raises(ValueError, match=r"^[\w. \[\]]+: is in .*; must be (in |a pure number)"):
        call(quantity)


def test_labelled_arrays_with_units_are_in_si(quantity, trace):
    xarray, pandas = pytest.importorskip("xarray"), pytest.importorskip("pandas")
    expected = of(rms_height=[0.8e-6, 1e-6]).stiffness
    series = pandas.Series([0.8, 1.0])
    series.attrs["units"] = "um"
    for heights in (xarray.DataArray([0.8, 1.0], attrs={"units": "um"}), xarray.DataArray([0.8e-6, 1e-6]), series):
        np.testing.assert_allclose(of(rms_height=heights).stiffness, expected, rtol=1e-12)
    if isinstance(quantity, Pint):  # which xarray can hold
        np.testing.assert_allclose(of(rms_height=xarray.DataArray(quantity([0.8, 1.0], "um"))).stiffness, expected, rtol=1e-12)
        profile = xarray.DataArray(quantity(trace * 1e6, "um"), coords={"x": ("x", np.arange(trace.size) * 1.0, {"units": "um"})}, dims="x")
        assert fstiff.measure(profile).rms_height.value == pytest.approx(fstiff.measure(trace, spacing=1e-6).rms_height.value, rel=1e-9)
    with pytest.raises(ValueError, match="height"):
        of(rms_height=xarray.DataArray([0.8, 1.0], attrs={"units": "MPa"}))
