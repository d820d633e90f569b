"""Colours that tell series, verdicts and states apart, as colour-blind eyes see them; and what stands beside a colour.

Dichromats are simulated by Machado, Oliveira and Fernandes (2009), A Physiologically-based Model for Simulation of
Color Vision Deficiency, IEEE TVCG 15(6), table 1 at severity 1.0, applied to linear RGB; distances are those of CIELAB
(CIE 1976, D65), where 2.3 is just seen between large areas, and lines and chips are small.
"""

import itertools
import os

import numpy as np
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.look import theme
from core.lab.research.study_files import PALETTE
from core.report import cells
from core.report.note.document import COLORS
from tests.app.driving import run
from tests.conftest import ROOT

EYES = {
    "all cones": np.eye(3),
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
}
LEAST = 12.0
"""Distance of two colours that are drawn together."""

XYZ = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)
"""Linear sRGB to XYZ (IEC 61966-2-1)."""

NOTE = {name: color for name, color in COLORS.items() if name != "accent"}
BESIDE = {
    **{f"curves, {name}": one.curves for name, one in theme.THEMES.items()},
    **{f"verdicts, {name}": (one.good, one.amber, one.bad, one.quiet, one.ink) for name, one in theme.THEMES.items()},
    "figures of a study": PALETTE,
    "verdicts of the note": tuple(NOTE.values()),
    "lines of the note": tuple(COLORS[name] for name in ("accent", "bad", "amber", "ink")),
    "verdicts of the workbook": tuple(f"#{color}" for color in (cells.GOOD, cells.AMBER, cells.BAD, cells.INK)),
}


def seen(color: str, eyes: str) -> np.ndarray:
    """L*, a*, b* of a colour "#rrggbb"."""
    coded = np.array([int(color[k : k + 2], 16) / 255.0 for k in (1, 3, 5)])
    linear = np.where(coded <= 0.04045, coded / 12.92, ((coded + 0.055) / 1.055) ** 2.4)
    x = XYZ @ np.clip(np.asarray(EYES[eyes]) @ linear, 0.0, 1.0) / (XYZ @ np.ones(3))
    f = np.where(x > (6 / 29) ** 3, np.cbrt(x), x / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def test_that_the_simulation_confuses_what_these_eyes_confuse():
    """Red against green of the same luminance for protan and deutan eyes, blue against green for tritan ones."""

    def apart(one: str, other: str, eyes: str) -> float:
        return float(np.linalg.norm(seen(one, eyes) - seen(other, eyes)))

    assert apart("#8a5a00", "#b3421b", "deuteranopia") < 5.0 < 30.0 < apart("#8a5a00", "#b3421b", "all cones")
    assert apart("#2b5c8a", "#1b6e4b", "tritanopia") < 0.4 * apart("#2b5c8a", "#1b6e4b", "all cones")
    for eyes in EYES:  # rows of these matrices sum to one: grey stays grey
        assert abs(seen("#808080", eyes)[1:]).max() < 0.1


@pytest.mark.shows("window.themes")
@pytest.mark.parametrize("eyes", EYES)
@pytest.mark.parametrize("group", BESIDE)
def test_that_colours_drawn_together_are_told_apart(group, eyes):
    for one, other in itertools.combinations(BESIDE[group], 2):
        distance = float(np.linalg.norm(seen(one, eyes) - seen(other, eyes)))
        assert distance >= LEAST, f"{one} and {other}: {distance:.1f}"


def test_that_the_note_has_the_same_colours_in_both_its_forms():
    template = (ROOT / "resources" / "templates" / "note.typ").read_text(encoding="utf-8").lower()
    for name in ("good", "amber", "bad", "accent"):
        assert f'{name}: rgb("{COLORS[name].lower()}")' in template


@pytest.mark.shows("window.themes")
def test_that_no_verdict_is_told_by_a_colour_alone(opened, application):
    """In shades of grey each chip of the tree, each bar and each outcome in a table still says it."""
    run(application, opened)
    chips = [row for row in opened.tree.rows if row.tone in theme.VERDICT_MARKS and row.chip]
    assert any(row.kind == "wall" for row in chips)
    shown = {item.text(0) for item in opened.tree.items}
    for row in chips:
        assert f"{row.text} {theme.add_tone_mark(row.tone, row.chip)}" in shown and theme.VERDICT_MARKS[
            row.tone
        ] in str(shown)
    ladder = opened.pages["check"].content.ladder
    assert {rung.tone for rung in ladder.rungs} <= {*theme.VERDICT_MARKS, "quiet"}
    for rung in ladder.rungs:
        assert theme.VERDICT_MARKS.get(rung.tone, "") in ladder.toolTip().splitlines()[ladder.rungs.index(rung)]
    marks = {theme.add_tone_mark(tone, "0.8") for tone in theme.VERDICT_MARKS}
    assert len(marks) == 3 and theme.add_tone_mark("quiet", "0.8") == "0.8" and theme.add_tone_mark("amber", "!") == "!"
