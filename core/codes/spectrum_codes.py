"""The codes whose elastic spectrum a case may name. NTC 2018 is that of the country whose hazard, checks and words the
program has; EN 1998-1 and each national annex of it is a file of resources/annexes."""

import functools
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core.codes.target_spectrum import CodeSpectrum, ntc2018
from core.errors import InputError
from core.units import G

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "annexes"

NATIONAL = "NTC2018"
"""The code whose F_0 and T_C* the national hazard gives."""


@dataclass(frozen=True)
class Code:
    """A code, and its elastic spectrum.

    name : as people call it; keys : of [demand.spectrum] beside soil, all of which it needs
    make : (a_g on rock [m/s2], soil, values of the keys) -> the spectrum; raises InputError
    seen_in_print : its tables were compared with print; the spectrum of another may be too low
    """

    name: str
    keys: tuple[str, ...]
    make: Callable[..., CodeSpectrum]
    seen_in_print: bool = True


def codes_of(folder: Path) -> dict[str, Code]:
    """The codes by the name a case has for them. folder : of the files of EN 1998-1"""
    known = {NATIONAL: Code("NTC 2018", ("f0", "tc_star_s", "topography"), _of_ntc2018)}
    for path in sorted(folder.glob("*.toml"), key=lambda path: path.stem):
        try:
            if path.stem in known:
                raise ValueError("the name of another code")
            known[path.stem] = _code_of(tomllib.loads(path.read_text(encoding="utf-8")))
        except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
            raise RuntimeError(f"the annex {path} cannot be used: {error!r}") from error
    return known


def _code_of(given: dict[str, Any]) -> Code:
    """The code of a file. Raises LookupError, TypeError and ValueError where it is not of its form: a file that says of
    itself that it was compared with print must say so by true."""
    for key, kind in (("name", str), ("source", str), ("seen_in_print", bool), ("amplification", float)):
        if not isinstance(given[key], kind):
            raise TypeError(key)
    keys, make = FORMS["table" if "type" in given else "velocity"]
    rows = (
        [(row["s"], row["t_b"], row["t_c"], row["t_d"]) for rows in given["type"].values() for row in rows.values()]
        if "type" in given
        else [(1.0, given["t_b_over_t_c"] * row["t_c"], row["t_c"], given["t_d_s"]) for row in given["soil"].values()]
    )
    for factor, t_b, t_c, t_d in rows:
        if not (0.3 <= factor <= 5.0 and 0.0 < t_b < t_c < t_d):
            raise ValueError((factor, t_b, t_c, t_d))
    return Code(given["name"], keys, functools.partial(make, given), given["seen_in_print"])


def _of_ntc2018(ag: float, soil: str, f0: float, tc_star: float, topography: str) -> CodeSpectrum:
    return ntc2018(ag, f0, tc_star, soil, topography)


def _of_ground(table: dict[str, Any], soil: str, name: str) -> dict[str, Any]:
    """The row of a ground. Raises InputError for a ground that the table has not."""
    if soil not in table:
        raise InputError("annex_ground", key="soil", found=soil, known=tuple(table), name=name)
    return table[soil]


def of_table(given: dict[str, Any], ag: float, soil: str, kind: int) -> CodeSpectrum:
    """S, T_B, T_C, T_D by the type of the spectrum and the ground (EN 1998-1 3.2.2.2, Tables 3.2 and 3.3).

    given : of the file; ag : on rock [m/s2]; raises InputError for a type or a ground that it has not
    """
    name = f"{given['name']} type {kind}"
    row = _of_ground(given["type"].get(str(kind), {}), soil, name)
    return CodeSpectrum(f"{name}, {soil}", ag, row["s"], given["amplification"], row["t_b"], row["t_c"], row["t_d"])


def of_velocity(given: dict[str, Any], ag: float, soil: str, vs30: float, contribution: float) -> CodeSpectrum:
    """S and T_C by the velocity of the ground (Spain's annex).

    given : of the file; ag : on rock [m/s2]; vs30 : of the ground [m/s]; contribution : K of the far earthquakes [-]
    Raises InputError for a ground that it has not, or that is not of this velocity.
    """
    ground, whole = _of_ground(given["soil"], soil, given["name"]), given["amplified"]
    low, high = ground["vs30_m_s"]
    if not low <= vs30 <= high:
        raise InputError("annex_velocity", key="vs30_m_s", found=vs30, low=low, high=high, soil=soil)
    c = (given["ground"]["reference_m_s"] / vs30) ** given["ground"]["exponent"]
    weak = c if ground["weak"] == "C" else ground["weak"]
    beyond = ag / G - whole["from_g"]
    if beyond <= 0.0:
        factor = weak
    else:
        factor = 1.0 if ag / G > whole["to_g"] else weak + whole["slope"] * beyond * (1.0 - weak)
    t_c = ground["t_c"] * contribution * (c if ground["with_c"] else 1.0)
    t_b, t_d = given["t_b_over_t_c"] * t_c, given["t_d_s"]
    name = f"{given['name']}, {soil}, v_s,30 {vs30:.4g} m/s, K {contribution:.3g}"
    return CodeSpectrum(name, ag, factor, given["amplification"], t_b, t_c, t_d)


FORMS: dict[str, tuple[tuple[str, ...], Callable[..., CodeSpectrum]]] = {
    "table": (("type",), of_table),
    "velocity": (("vs30_m_s", "contribution_k"), of_velocity),
}
"""Form of the file of an annex -> the keys of a case that it needs, and how its spectrum is made."""

CODES = codes_of(FOLDER)


def takes(code: str, key: str) -> bool | None:
    """Whether a code needs a key of [demand.spectrum]; None of a key that every code has."""
    return key in CODES[code].keys if any(key in one.keys for one in CODES.values()) else None


def en1998(ag: float, kind: int, soil: str) -> CodeSpectrum:
    """EN 1998-1 3.2.2.2, recommended spectra of type 1 and 2, Tables 3.2 and 3.3. ag : on rock [m/s2]."""
    return CODES["EN1998"].make(ag, soil, kind)
