"""The codes whose elastic spectrum a case may name. NTC 2018 is that of the country whose hazard, checks and words the
program has; EN 1998-1 and each national annex of it is a file of resources/annexes."""

import functools
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from core.codes import annex
from core.codes.target_spectrum import CodeSpectrum, ntc2018
from core.errors import InputError

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "annexes"

NATIONAL, EUROPEAN = "NTC2018", "EN1998"
"""The code whose F_0 and T_C* the national hazard gives, and the one whose recommended values stand beside an annex."""


COMPARED_WITH_PRINT = {EUROPEAN: "12b163efa7428b46d96872f43f48341ac815e7982d3d016ffa8c6292fb3750ac"}
"""Code -> SHA-256 of its file as it was compared with the printed page: what a file says of itself shows nothing."""


@dataclass(frozen=True)
class SpectrumCode:
    """A code, and its elastic spectrum.

    name : as people call it; keys : of [demand.spectrum] beside soil, all of which it needs
    make : (a_g on rock [m/s2], soil, values of the keys) -> the spectrum; raises InputError
    seen_in_print : its tables were compared with print; the spectrum of another may be too low
    digest : SHA-256 of its file, "" of the code of the program
    fault : of its file, raised for every case that names the code
    """

    name: str
    keys: tuple[str, ...]
    make: Callable[..., CodeSpectrum]
    seen_in_print: bool = True
    digest: str = ""
    fault: InputError | None = None


def load_spectrum_codes(folder: Path) -> dict[str, SpectrumCode]:
    """The codes by the name a case has for them. folder : of the files of EN 1998-1; one with a fault is a code that a
    case cannot take, so that no other case is hindered by it"""
    known = {NATIONAL: SpectrumCode("NTC 2018", ("f0", "tc_star_s", "topography"), _of_ntc2018)}
    for path in sorted(folder.glob("*.toml"), key=lambda path: path.stem):
        try:
            if path.stem in known:
                raise InputError("annex_name", place=(f"resources/annexes/{path.name}",), name=path.stem)
            made = annex.read_annex(path)
            seen = COMPARED_WITH_PRINT.get(path.stem) == made.digest
            spectrum = functools.partial(made.make, made.given)
            known[path.stem] = SpectrumCode(made.given["name"], made.keys, spectrum, seen, made.digest)
        except InputError as fault:
            known[path.stem] = SpectrumCode(path.stem, (), _never, False, fault=fault)
    return known


def _never(*_) -> CodeSpectrum:
    """Make no spectrum: a code with a fault is refused before."""
    raise AssertionError


def _of_ntc2018(ag: float, soil: str, f0: float, tc_star: float, topography: str) -> CodeSpectrum:
    return ntc2018(ag, f0, tc_star, soil, topography)


CODES = load_spectrum_codes(FOLDER)


def requires_key(code: str, key: str) -> bool | None:
    """Whether a code needs a key of [demand.spectrum]; None of a key that every code has."""
    return key in CODES[code].keys if any(key in one.keys for one in CODES.values()) else None


def refuse_faulty(code: str) -> None:
    """Raise InputError for a code whose file has a fault."""
    if (fault := CODES[code].fault) is not None:
        raise InputError(fault.code, place=fault.place, key=fault.key, **fault.values)


def en1998(ag: float, kind: int, soil: str) -> CodeSpectrum:
    """EN 1998-1 3.2.2.2, recommended spectra of type 1 and 2, Tables 3.2 and 3.3. ag : on rock [m/s2]."""
    return CODES[EUROPEAN].make(ag, soil, kind)
