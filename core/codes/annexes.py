"""National annexes of EN 1998-1 as data: the elastic spectrum of a country is a file of resources/annexes."""

import functools
import tomllib
from pathlib import Path
from typing import Any

from core.codes.target_spectrum import CodeSpectrum
from core.errors import InputError
from core.units import G

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "annexes"

ANNEXES = ("EN1998-ES",)
"""Codes of the files of that folder, as a case names them."""


@functools.cache
def annex(code: str) -> dict[str, Any]:
    """What the file of an annex holds."""
    return tomllib.loads((FOLDER / f"{code}.toml").read_text(encoding="utf-8"))


def code_words(code: str) -> str:
    """A code of EN 1998 as it is named to people."""
    return str(annex(code)["name"]) if code in ANNEXES else "EN 1998"


def is_unseen(code: str | None) -> bool:
    """Whether a code is an annex whose table was not compared with print: its spectrum may be too low."""
    return code in ANNEXES and not annex(str(code))["seen_in_print"]


def annex_spectrum(code: str, ag: float, soil: str, vs30: float, contribution: float) -> CodeSpectrum:
    """The elastic spectrum of an annex (EN 1998-1 3.2.2.2).

    ag : on rock [m/s2]; vs30 : of the ground [m/s]; contribution : K of the far earthquakes [-]
    Raises InputError for a ground that it has not, or that is not of this velocity.
    """
    given = annex(code)
    grounds = given["soil"]
    if soil not in grounds:
        raise InputError("annex_ground", key="soil", found=soil, known=tuple(grounds), name=given["name"])
    ground, whole = grounds[soil], given["amplified"]
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
