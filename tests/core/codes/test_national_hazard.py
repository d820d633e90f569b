"""The hazard of a place: worked values, an implementation of its own in plain Python, islands, what is refused."""

import itertools
import math
import random
from functools import cache

import pytest

from core.codes.national_hazard import (
    ISLANDS,
    RETURN_PERIODS,
    grid,
    hazard_at,
    municipalities,
    municipality,
    reference_life,
    search_municipalities,
)
from core.errors import InputError


@cache
def places():
    """id of a node -> latitude, longitude."""
    known = grid()
    return {node: (float(known.nodes[k][0]), float(known.nodes[k][1])) for node, k in known.row_of.items()}


def plain(latitude, longitude, years):
    """The same from the words of Annex A, node by node, without arrays; None outside the grid."""
    known, where = grid(), places()

    def sees(a, b):
        return (b[0] - a[0]) * (longitude - a[1]) - (b[1] - a[1]) * (latitude - a[0])

    for node, (north, east) in where.items():
        if abs(north - latitude) > 0.2 or abs(east - longitude) > 0.2:
            continue
        ring = [node, node + 1, node + 223, node + 222]
        if not all(one in where for one in ring):
            continue
        signs = [sees(where[a], where[b]) for a, b in itertools.pairwise([*ring, node])]
        if min(signs) < 0.0 < max(signs):
            continue
        sums, weight = [0.0, 0.0, 0.0], 0.0
        for one in ring:
            lat, lon = map(math.radians, where[one])
            mine = math.radians(latitude), math.radians(longitude)
            cosine = math.sin(lat) * math.sin(mine[0]) + math.cos(lat) * math.cos(mine[0]) * math.cos(lon - mine[1])
            d = 6371.0088 * math.acos(min(1.0, cosine))
            table = known.values[known.row_of[one]]
            k = max(j for j in range(8) if RETURN_PERIODS[j] <= years)
            exponent = math.log(years / RETURN_PERIODS[k]) / math.log(RETURN_PERIODS[k + 1] / RETURN_PERIODS[k])
            for j in range(3):
                low, high = float(table[k][j]), float(table[k + 1][j])
                sums[j] += math.exp(math.log(low) + math.log(high / low) * exponent) / d
            weight += 1.0 / d
        return 0.1 * sums[0] / weight, sums[1] / weight, sums[2] / weight
    return None


@pytest.mark.shows("demand.place")
@pytest.mark.parametrize("count", [60, pytest.param(1000, marks=pytest.mark.long)])
def test_that_points_agree_with_an_implementation_in_plain_python(count):
    draw, compared = random.Random(53), 0
    nodes = grid().nodes
    while compared < count:
        node = nodes[draw.randrange(len(nodes))]
        point = (node[0] + draw.uniform(-0.08, 0.08), node[1] + draw.uniform(-0.1, 0.1))
        years = draw.uniform(30.0, 2475.0)
        expected = plain(*point, years)
        if expected is None:
            with pytest.raises(InputError):
                hazard_at(*point)
            continue
        assert tuple(hazard_at(*point).at(years)) == pytest.approx(expected, rel=1e-6)
        compared += 1


def test_that_a_node_has_its_own_values_and_an_edge_lies_between_its_ends():
    known = grid()
    row = known.row_of[26305]
    found = hazard_at(*known.nodes[row])
    assert 0.0 in found.distances
    for years, values in zip(RETURN_PERIODS, known.values[row], strict=True):
        assert tuple(found.at(years)) == pytest.approx((0.1 * values[0], values[1], values[2]), rel=1e-14)
    other = known.nodes[known.row_of[26306]]
    middle = hazard_at(*(0.5 * (known.nodes[row] + other)))
    assert {26305, 26306} <= set(middle.nodes)


def test_that_below_30_and_above_2475_years_the_ends_of_the_table_hold():
    found = hazard_at(42.3498, 13.3995)
    assert found.at(10.0) == found.at(30.0) and found.at(9000.0) == found.at(2475.0)
    # continuous through each return period of the table
    for years in RETURN_PERIODS[1:-1]:
        assert tuple(found.at(years * (1 - 1e-12))) == pytest.approx(tuple(found.at(years)), rel=1e-9)


PLACES = {
    "Sardegna": (39.2238, 9.1217),
    "Pantelleria": (36.8290, 11.9450),
    "Lampedusa": (35.5020, 12.6090),
    "Linosa": (35.8660, 12.8660),
    "Ponza": (40.8950, 12.9570),
    "Egadi": (37.9310, 12.3270),
    "Arcipelago Toscano": (42.8130, 10.3180),
    "Ventotene": (40.7960, 13.4310),
    "Ustica": (38.7090, 13.1910),
    "Tremiti": (42.1180, 15.5050),
    "Alicudi": (38.5400, 14.3500),
    "Filicudi": (38.5650, 14.5700),
    "Lipari": (38.4670, 14.9540),
    "Stromboli": (38.8060, 15.2380),
    "Panarea": (38.6370, 15.0760),
    "Salina": (38.5600, 14.8700),
    "Vulcano": (38.4050, 14.9620),
}


@pytest.mark.parametrize("name", PLACES)
def test_that_each_group_of_islands_has_its_row_of_table_2(name):
    found = hazard_at(*PLACES[name])
    if name == "Vulcano" and not found.island:
        pytest.skip("nodes of the grid surround it")
    group = next(island for island in ISLANDS if name in island.name)
    assert found.island == group.name and not found.nodes
    assert tuple(found.at(475.0)) == pytest.approx((0.1 * group.ag[6], group.f0[6], group.tc[6]), rel=1e-14)


@pytest.mark.shows("demand.place")
@pytest.mark.parametrize("point", [(48.85, 2.35), (41.0, 11.0), (43.0, 15.0), (0.0, 0.0), (90.0, 0.0)])
def test_that_abroad_and_the_sea_are_refused_with_the_nearest_node(point):
    with pytest.raises(InputError) as refused:
        hazard_at(*point)
    assert refused.value.code == "outside_the_grid"
    assert str(refused.value.values["node"]) in refused.value.text("en") and "km" in refused.value.text("it")


def test_that_a_municipality_is_found_without_accents_and_asked_for_its_province_where_two_share_a_name():
    assert municipality("l’aquila").province == "AQ" and municipality("L AQUILA") == municipality("L'Aquila")
    assert len(municipalities()) == 7546
    with pytest.raises(InputError) as two:
        municipality("Castro")
    assert two.value.code == "municipality_of_two" and "BG" in two.value.text("en")
    assert municipality("Castro", "BG").province_name == municipality("Castro", "Bergamo").province_name
    for wrong, code in ((("Castro", "RM"), "municipality_elsewhere"), (("Nowhere", ""), "municipality_unknown")):
        with pytest.raises(InputError) as refused:
            municipality(*wrong)
        assert refused.value.code == code
    assert search_municipalities("aquil")[0].name.startswith("Aquil") and any(
        one.name == "L'Aquila" for one in search_municipalities("aquila")
    )


def test_that_every_municipality_has_a_hazard():
    draw = random.Random(1)
    for one in draw.sample(municipalities(), 300):
        assert 0.02 < hazard_at(one.latitude, one.longitude).at(475.0).ag_g < 0.3, one


def test_that_the_reference_life_is_that_of_the_code():
    assert reference_life(50.0, "III") == 75.0 and reference_life(40.0, "I") == 35.0


def test_that_a_name_without_its_apostrophe_is_the_same_municipality():
    assert municipality("Laquila").name == "L'Aquila" == search_municipalities("laquil", 3)[0].name


OPEN_SEA = (
    *((41.6, 8.8), (38.6, 8.8), (40.0, 7.8), (40.2, 10.2)),  # round Sardinia
    *((42.10, 10.95), (42.55, 10.85), (42.30, 10.70)),  # round Giglio
    *((43.70, 9.8), (42.6, 9.65), (42.15, 10.1)),  # round Capraia and Montecristo
    *((36.6, 12.0), (37.2, 12.0), (36.8, 11.5), (36.8, 12.5)),  # round Pantelleria
    *((35.2, 12.6), (35.7, 12.5), (36.2, 12.9), (35.5, 13.2)),  # round Lampedusa and Linosa
    *((41.05, 12.75), (40.6, 12.9), (40.6, 13.4), (40.9, 13.3)),  # round Ponza and Ventotene
    *((38.4, 13.2), (39.0, 13.2), (42.5, 15.6), (42.2, 16.2)),  # round Ustica and Tremiti
    *((38.8, 14.4), (38.55, 14.0), (39.2, 14.9), (39.0, 15.2), (38.8, 15.6), (38.7, 14.8)),  # round the Aeolian Islands
)
"""Latitude and longitude."""


@pytest.mark.parametrize("point", OPEN_SEA)
def test_that_the_hazard_of_an_island_ends_with_its_waters(point):
    with pytest.raises(InputError) as refused:
        hazard_at(*point)
    assert refused.value.code == "outside_the_grid"


def test_that_names_are_folded_once_and_what_is_typed_at_each_key(monkeypatch):
    from core.codes import national_hazard

    search_municipalities("a")
    seen = []
    fold = national_hazard.normalise_name
    monkeypatch.setattr(national_hazard, "normalise_name", lambda name: seen.append(name) or fold(name))
    for typed in ("L'", "L'A", "LAquila", "aquila"):
        assert "L'Aquila" in [one.name for one in search_municipalities(typed, 2000)]
    assert seen == ["L'", "L'A", "LAquila", "aquila"]
