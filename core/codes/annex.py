"""A file of resources/annexes: the elastic spectrum of EN 1998-1 or of a national annex of it. Each value has a range
beyond which it is a slip of who typed it: it makes the spectrum too low, and a wall verified that falls."""

import hashlib
import itertools
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core.codes.target_spectrum import CodeSpectrum
from core.errors import InputError
from core.regular_file import read_regular
from core.units import G

MAX_BYTES = 100_000

RANGES = {
    "amplification": (2.5, 3.0),
    "s": (0.9, 3.0),
    "t_b": (0.02, 0.6),
    "t_c": (0.15, 2.0),
    "t_d": (1.2, 8.0),
    "t_d_s": (1.2, 8.0),
    "t_b_over_t_c": (0.1, 0.5),
    "reference_m_s": (600.0, 1100.0),
    "exponent": (0.2, 0.8),
    "from_g": (0.01, 1.0),
    "to_g": (0.01, 1.0),
    "slope": (1.0, 100.0),
    "weak": (0.8, 3.0),
    "from_m_s": (50.0, 3000.0),
    "to_m_s": (50.0, 3000.0),
}
"""What the numbers of printed annexes lie within, with room [-, s, g, m/s]. 2.5 is of EN 1998-1 itself (3.2 to
3.5), to which it leaves no choice."""

GROUNDS = ("A", "B", "C", "D", "E")


@dataclass(frozen=True)
class Annex:
    """What a file says.

    given : of the file; keys : of [demand.spectrum] beside soil, all of which it needs
    make : (given, a_g on rock [m/s2], soil, values of the keys) -> the spectrum; digest : SHA-256 of the file
    """

    given: dict[str, Any]
    keys: tuple[str, ...]
    make: Callable[..., CodeSpectrum]
    digest: str


def read_annex(path: Path) -> Annex:
    """An annex of a file. Raises InputError where the file cannot be read, or a value cannot be one of an annex."""
    try:
        content = read_regular(path, MAX_BYTES)
        given = tomllib.loads(content.decode("utf-8-sig"))
    except (OSError, ValueError, RecursionError) as error:
        raise InputError("annex_unreadable", place=(_place(path),), reason=str(error)) from None
    form = form_of(given)
    try:
        form.check(given)
    except InputError as error:
        raise error.at(_place(path)) from None
    return Annex(given, form.keys, form.spectrum, hashlib.sha256(content).hexdigest())


def _place(path: Path) -> str:
    return f"resources/annexes/{path.name}"


def _only(table: object, wanted: tuple[str, ...], here: str) -> dict[str, Any]:
    """A table with these keys and no other."""
    if not isinstance(table, dict) or set(table) != set(wanted):
        found = tuple(table) if isinstance(table, dict) else (str(table),)
        raise InputError("annex_keys", place=(here,) if here else (), found=found or ("–",), known=wanted)
    return table


def _some(table: object, known: tuple[str, ...], here: str) -> dict[str, Any]:
    """A table with some of these keys."""
    if not isinstance(table, dict) or not table or not set(table) <= set(known):
        found = tuple(table) if isinstance(table, dict) else (str(table),)
        raise InputError("annex_keys", place=(here,), found=found, known=known)
    return table


def _number(table: dict[str, Any], key: str, here: str = "") -> float:
    value, (low, high) = table[key], RANGES[key]
    if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
        raise InputError("annex_value", place=(here,) if here else (), key=key, found=value, low=low, high=high)
    return float(value)


def _at_least(table: dict[str, Any], key: str, least: float, here: str) -> None:
    if table[key] < least:
        raise InputError("annex_value", place=(here,), key=key, found=table[key], low=least, high=RANGES[key][1])


def _at_most(table: dict[str, Any], key: str, most: float, here: str) -> None:
    if table[key] > most:
        raise InputError("annex_value", place=(here,), key=key, found=table[key], low=RANGES[key][0], high=most)


def _rising(here: str, key: str, *values: float) -> None:
    if not all(one < other for one, other in itertools.pairwise(values)):
        raise InputError("annex_order", place=(here,), key=key, found=values)


HEAD = ("name", "seen_in_print", "source", "amplification")


def _check_head(given: dict[str, Any], more: tuple[str, ...]) -> None:
    _only(given, (*HEAD, *more), "")
    for key in ("name", "source"):
        if not isinstance(given[key], str) or not given[key].strip():
            raise InputError("annex_text", key=key, found=given[key])
    if not isinstance(given["seen_in_print"], bool):
        raise InputError("annex_flag", key="seen_in_print", found=given["seen_in_print"])
    _number(given, "amplification")


def _of_ground(table: dict[str, Any], soil: str, name: str) -> dict[str, Any]:
    """The row of a ground. Raises InputError for a ground that the table has not."""
    if soil not in table:
        raise InputError("annex_ground", key="soil", found=soil, known=tuple(table), name=name)
    return table[soil]


class _Table:
    """S, T_B, T_C, T_D by the type of the spectrum and the ground (EN 1998-1 3.2.2.2, Tables 3.2 and 3.3)."""

    keys = ("type",)

    @staticmethod
    def check(given: dict[str, Any]) -> None:
        _check_head(given, ("type",))
        for kind, grounds in _some(given["type"], ("1", "2"), "type").items():
            for ground, row in _some(grounds, GROUNDS, f"type.{kind}").items():
                here = f"type.{kind}.{ground}"
                _only(row, ("s", "t_b", "t_c", "t_d"), here)
                _, *periods = (_number(row, key, here) for key in ("s", "t_b", "t_c", "t_d"))
                _rising(here, "t_b, t_c, t_d", *periods)
                _at_most(row, "t_b", 0.5 * row["t_c"], here)
            for ground, row in grounds.items():  # softer ground amplifies, and its plateau is longer
                for key in ("s", "t_c"):
                    _at_least(row, key, grounds.get("A", row)[key], f"type.{kind}.{ground}")

    @staticmethod
    def spectrum(given: dict[str, Any], ag: float, soil: str, kind: int) -> CodeSpectrum:
        """Make the spectrum of a type. Raises InputError for a type or a ground that the annex has not."""
        name = f"{given['name']} type {kind}"
        row = _of_ground(given["type"].get(str(kind), {}), soil, name)
        return CodeSpectrum(f"{name}, {soil}", ag, row["s"], given["amplification"], row["t_b"], row["t_c"], row["t_d"])


class _Velocity:
    """S and T_C by the velocity of the ground (Spain's annex)."""

    keys = ("vs30_m_s", "contribution_k")

    @staticmethod
    def check(given: dict[str, Any]) -> None:
        _check_head(given, ("t_b_over_t_c", "t_d_s", "ground", "amplified", "soil"))
        for key in ("t_b_over_t_c", "t_d_s"):
            _number(given, key)
        for key in _only(given["ground"], ("reference_m_s", "exponent"), "ground"):
            _number(given["ground"], key, "ground")
        _only(given["amplified"], ("from_g", "to_g", "slope"), "amplified")
        low, high, slope = (_number(given["amplified"], key, "amplified") for key in ("from_g", "to_g", "slope"))
        _rising("amplified", "from_g, to_g", low, high)
        if abs(slope * (high - low) - 1.0) > 0.02:  # S comes to 1 where it stays 1
            raise InputError("annex_slope", place=("amplified",), key="slope", found=slope, meant=1.0 / (high - low))
        for ground, row in _some(given["soil"], GROUNDS, "soil").items():
            here = f"soil.{ground}"
            _only(row, ("vs30_m_s", "weak", "t_c", "with_c"), here)
            _number(row, "t_c", here)
            if row["weak"] != "C":
                _number(row, "weak", here)
            if not isinstance(row["with_c"], bool):
                raise InputError("annex_flag", place=(here,), key="with_c", found=row["with_c"])
            ends = row["vs30_m_s"]
            if not isinstance(ends, list) or len(ends) != 2:
                raise InputError("annex_keys", place=(here, "vs30_m_s"), found=(str(ends),), known=("from", "to"))
            speeds = dict(zip(("from_m_s", "to_m_s"), ends, strict=True))
            _rising(here, "vs30_m_s", *(_number(speeds, key, here) for key in speeds))

    @staticmethod
    def spectrum(given: dict[str, Any], ag: float, soil: str, vs30: float, contribution: float) -> CodeSpectrum:
        """Make the spectrum of a ground of this velocity [m/s]. contribution : K of the far earthquakes [-]

        Raises InputError for a ground that the annex has not, or that is not of this velocity.
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


def form_of(given: dict[str, Any]) -> type[_Table] | type[_Velocity]:
    """The form of a file: that of EN 1998-1 but for one that says its grounds by their velocity."""
    return _Velocity if "soil" in given or "ground" in given else _Table
