"""What stands behind a wall is one of a list; what an older text denies or leaves open is refused."""

import pytest

from core.case.back_restraint import RESTRAINTS
from core.case.rules import parse_case
from core.case.writer import table_of
from core.errors import InputError

WALL = {"name": "w", "height_m": 5.0, "thickness_m": 0.8, "mechanism": "one_sided", "base_z_m": 0.0}


def wall_of(**keys):
    return parse_case({"wall": [WALL | keys]}).wall[0]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("cross walls", "cross_walls"),
        ("Muri trasversali in mattoni", "cross_walls"),
        ("solai in latero-cemento", "tied_floors"),
        ("contrafforti in pietra", "buttress"),
        ("cordolo sommitale", "ring_beam"),
        ("abutting building of equal height", "other"),
    ],
)
def test_that_a_text_of_an_older_case_is_one_of_the_list_with_the_text_as_its_note(text, found):
    wall = wall_of(back_restraint=text)
    assert (wall.back_restraint, wall.restraint_note) == (found, text)
    again = parse_case(table_of(parse_case({"wall": [WALL | {"back_restraint": text}]}))).wall[0]
    assert again == wall


DENIED = ["non c'è", "assente", "da definire", "not tied", "boh", "xxx", "none", "senza vincolo", "nessuno", "TBD", "?"]
DENIED += [
    "mancano i muri trasversali",
    "cross walls missing",
    "solai non collegati",
    "to be verified",
    "unknown floors",
]


@pytest.mark.shows("verdict.empty_reason")
@pytest.mark.parametrize("text", DENIED)
def test_that_a_text_that_denies_a_restraint_or_leaves_it_open_is_refused(text):
    with pytest.raises(InputError) as refused:
        wall_of(back_restraint=text)
    assert all(name in refused.value.text("en") for name in RESTRAINTS)


@pytest.mark.parametrize("note", ["", "xx", "aaa", "boh", "da definire"])
def test_that_another_restraint_is_named_in_its_note(note):
    with pytest.raises(InputError, match="restraint_note"):
        wall_of(back_restraint="other", restraint_note=note)
    assert wall_of(back_restraint="other", restraint_note="neighbouring house").back_restraint == "other"


@pytest.mark.parametrize("reason", ["boh", "xxx", "da definire", "to be defined", "vedi sopra", "asdf", "aaaa"])
def test_that_a_reason_that_says_nothing_is_refused(reason):
    with pytest.raises(InputError) as refused:
        wall_of(velocity_ratio=0.9, justification={"velocity_ratio": reason})
    assert refused.value.code == "reason_says_nothing"


def test_that_nothing_written_is_no_restraint():
    assert wall_of().back_restraint is None is wall_of(back_restraint=" ").back_restraint
