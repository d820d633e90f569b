"""Types of masonry, Circolare 7/2019, Tables C8.5.I and C8.5.II."""

from typing import NamedTuple


class MasonryType(NamedTuple):
    """A row of both tables; each range is (least, greatest).

    strength : f [MPa]; modulus : E [MPa]; weight : w [kN/m3]
    most_factor : greatest product of the factors of Table C8.5.II on f
    """

    strength: tuple[float, float]
    modulus: tuple[float, float]
    weight: tuple[float, float]
    most_factor: float


TYPES = {
    "disordered_rubble": MasonryType((1.0, 2.0), (690.0, 1050.0), (19.0, 19.0), 3.5),
    "roughly_dressed_stone": MasonryType((2.0, 2.0), (1020.0, 1440.0), (20.0, 20.0), 3.0),
    "split_stone": MasonryType((2.6, 3.8), (1500.0, 1980.0), (21.0, 21.0), 2.4),
    "irregular_soft_stone": MasonryType((1.4, 2.2), (900.0, 1260.0), (13.0, 16.0), 2.0),
    "regular_soft_stone": MasonryType((2.0, 3.2), (1200.0, 1620.0), (13.0, 16.0), 1.8),
    "squared_stone": MasonryType((5.8, 8.2), (2400.0, 3300.0), (22.0, 22.0), 1.4),
    "solid_brick": MasonryType((2.6, 4.3), (1200.0, 1800.0), (18.0, 18.0), 1.8),
    "hollow_brick": MasonryType((5.0, 8.0), (3500.0, 5600.0), (15.0, 15.0), 1.3),
}
"""In the order of the table; hollow_brick is "mattoni semipieni con malta cementizia", holes to 40 %."""

MIN_STRENGTH = min(row.strength[0] for row in TYPES.values())
"""f [MPa] of the weakest masonry of the table."""

TABLE_MODULI = min(row.modulus[0] for row in TYPES.values()), max(row.modulus[1] for row in TYPES.values())
"""E [MPa] of the table."""


def least_strength(masonry: str | None) -> float:
    """Lowest f of a type, of the table where none is named [MPa]."""
    return TYPES[masonry].strength[0] if masonry else MIN_STRENGTH


def weights(masonry: str | None) -> tuple[float, float]:
    """Range of the unit weight of a type, of the table where none is named [kN/m3]."""
    rows = [TYPES[masonry]] if masonry else TYPES.values()
    return min(row.weight[0] for row in rows), max(row.weight[1] for row in rows)


def moduli(masonry: str | None) -> tuple[float, float]:
    """Range of E of a type, of the table where none is named [MPa]."""
    return TYPES[masonry].modulus if masonry else TABLE_MODULI
