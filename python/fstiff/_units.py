# SPDX-License-Identifier: BSD-3-Clause
"""Arguments in SI: quantities of pint, astropy or unyt, arrays whose attrs have units, and texts such as "10 MPa"."""

from __future__ import annotations

from typing import Any

from . import _core

#: The SI unit of arguments by their names, the last word of "upper.youngs_modulus"; other arguments are pure numbers.
UNITS = {
    name: unit
    for unit, names in {
        "m": "interaction_length separation slip spacing dx dy crop radius cutoff lambda_s lambda_c tip_radius resolution "
        "width window longest shortest",
        "Pa": "min_pressure max_pressure from until at",
        "Pa/m": "stiffness",
        "kg/(m^2 s)": "impedance",
        "W/(m K) or S/m": "conductivity",
    }.items()
    for name in names.split()
} | {name: unit for numbers in _core.numbers_of_joint().values() for name, (unit, _, _) in numbers.items() if unit}


def si_unit(name: str) -> str:
    """The SI unit of an argument, "" of a pure number."""
    return str(UNITS.get(name.rpartition(".")[2].rstrip("2"), ""))


def units_of(value: Any) -> Any:
    """The units that a quantity carries, of an array of xarray or pandas those of its attrs; None where there are none."""
    attrs = getattr(value, "attrs", None)
    if isinstance(attrs, dict):
        return attrs.get("units")
    return getattr(value, "units", getattr(value, "unit", None)) if hasattr(value, "to") or hasattr(value, "rescale") else None


def has_units(value: Any) -> bool:
    """Whether `value`, or what it holds, is a quantity."""
    if isinstance(value, (list, tuple)):
        return any(map(has_units, value))
    return units_of(held(value)) is not None


def held(value: Any) -> Any:
    """The quantity in an array of xarray or a series of pandas; else `value`."""
    inner = value.data if hasattr(value, "coords") else getattr(getattr(value, "array", None), "quantity", None)
    return value if units_of(inner) is None else inner


def in_si(value: Any, name: str, unit: str) -> Any:
    """Numbers in `unit`: of a quantity, a text, or a list of such; what has no unit stays as it is."""
    if isinstance(value, str):
        return _of_text(value, name, unit) if unit else value
    if isinstance(value, (list, tuple)):
        return value if all(type(one) in (int, float) for one in value) else [in_si(one, name, unit) for one in value]
    kind = getattr(getattr(value, "dtype", None), "kind", "")
    if isinstance(value, bool) or kind == "b":
        raise ValueError(f"{name} = {value!r:.40}: must be a number, not True or False")
    value = held(value)
    units = units_of(value)
    if units is None:
        return in_si(value.tolist(), name, unit) if kind in ("U", "O") and hasattr(value, "tolist") else value
    if isinstance(units, str):
        import numpy as np

        return np.asarray(value) * (_of_text(f"1 {units}", name, unit) if unit else _refuse(name, units, unit))
    for one in unit.split(" or "):
        to = one.replace("^", "**").replace(" ", "*")
        try:
            made = (value.to if hasattr(value, "to") else value.rescale)(to)
        except Exception:  # each package has errors of its own
            continue
        return made.magnitude if hasattr(made, "magnitude") else made.value
    return _refuse(name, units, unit)


def _of_text(text: str, name: str, unit: str) -> float:
    """The number of a text with its unit."""
    units = unit.split(" or ")
    for one in units[:-1]:
        try:
            return _core.parse_quantity(text, one, name)
        except ValueError:
            continue
    return _core.parse_quantity(text, units[-1], name)


def _refuse(name: str, units: Any, unit: str) -> float:
    raise ValueError(f"{name}: is in {units}; must be {f'in {unit}, or in a unit of the same kind' if unit else 'a pure number'}")


def as_text(value: Any, name: str) -> Any:
    """A quantity as a text with its SI unit, as a scene has it; an array or a list of them as a list; a pure number as a number."""
    if isinstance(value, (list, tuple)):
        return [as_text(one, name) if has_units(one) else one for one in value]
    for unit in ("", *dict.fromkeys(UNITS.values()), "K"):
        if " or " in unit:
            continue
        try:
            import numpy as np

            numbers = np.asarray(in_si(value, name, unit), dtype=np.float64).tolist()
        except ValueError:
            continue
        texts = [f"{one!r} {unit}" if unit else one for one in (numbers if isinstance(numbers, list) else [numbers])]
        return texts if isinstance(numbers, list) else texts[0]
    raise ValueError(f"{name}: is in {units_of(held(value))}; must be a quantity of a scene, such as a length or a pressure")
