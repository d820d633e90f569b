"""Order and tone of the verdicts, for workbook, note and window."""

import functools
import math

from core.study.results import StudyResult, WallResult
from core.text.keys import KEYS, SECTIONS
from core.text.sentence import FormNames, word

TONES = {"verified": "good", "not_activated": "good", "verified_refined": "amber", "indicative": "amber",
         "undetermined": "amber", "at_limit": "bad", "q2_unsafe": "bad", "not_verified": "bad"}  # fmt: skip


@functools.cache
def names_in(language: str) -> FormNames:
    """What the report calls the keys of a case."""
    captions = {code.removeprefix("key_"): word(code, language) for code in KEYS}
    for code in SECTIONS:
        captions[f"[{code.removeprefix('section_')}]"] = word(code, language).lower()
    return FormNames(captions)


def by_zeta(walls) -> list[WallResult]:
    """Walls without a zeta first, then the lowest."""

    def key(wall: WallResult) -> float:
        zeta = wall.assessment.verdict.zeta_e if wall.assessment else None
        return -math.inf if zeta is None else zeta

    return sorted(walls, key=key)


def tone_of(result: StudyResult, wall: WallResult) -> str:
    """good, amber or bad; good only where nothing is left to read; "" without a verdict."""
    if wall.assessment is None:
        return ""
    tone = TONES[wall.assessment.verdict.code]
    return "amber" if tone == "good" and result.left_to_read(wall) else tone
