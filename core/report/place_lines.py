"""The place of a case: where it is, and its values at the four limit states. Note and workbook show it."""

from core.case.place import Site
from core.codes.limits import EXCEEDANCE
from core.text.sentence import format_number, localized

SOURCE = "D.M. 14/01/2008, Annexes A and B (NTC 2018 3.2)"


def place_of(site: Site, language: str) -> list[tuple[str, str]]:
    """Lines (what, value)."""

    def number(value: float, form: str) -> str:
        return format_number(value, form, language)

    def say(text: str) -> str:
        return localized("report", text, language)

    hazard = site.hazard
    where = f"{site.municipality} ({site.province})" if site.province else site.municipality
    nodes = ", ".join(
        f"{node} ({number(km, '.2f')} km)" for node, km in zip(hazard.nodes, hazard.distances, strict=True)
    )
    lines = [
        (say("Place"), where),
        (say("Coordinates"), f"{number(hazard.latitude, '.5f')} N, {number(hazard.longitude, '.5f')} E"),
        (say("Nodes of the grid"), nodes or hazard.island),
        ("V_R", f"{number(site.reference_life, 'g')} {say('years')}, {say('class')} {site.use_class}"),
        (say("Source"), say(SOURCE)),
    ]
    return [line for line in lines if line[1]]


def states_of(site: Site) -> list[tuple[str, float, float, float, float]]:
    """(limit state, T_R [years], a_g [g], F_0, T_C* [s]) of each."""
    return [(state, years := site.return_period(state), *site.hazard.at(years)) for state in EXCEEDANCE]
