"""What the engineer sets aside: a mechanism that is not looked at, and the document that shows why it need not be."""

import math
from dataclasses import dataclass

from core.case.document import Document, is_named
from core.case.keys import choice_key, key, number_key
from core.errors import InputError
from core.text.sentence import sentence

OVERTURNING, VERTICAL_BENDING, HORIZONTAL_BENDING = "overturning", "vertical_bending", "horizontal_bending"
CORNER, LEAF, PART_ABOVE, DIRECTION = "corner", "leaf", "part_above", "direction"

ROWS = (OVERTURNING, VERTICAL_BENDING, HORIZONTAL_BENDING, CORNER, LEAF, PART_ABOVE, DIRECTION)
"""Mechanisms out of plane that a wall may have (Circolare 7/2019 C8.7.1.2.1.1): none is without a row."""

FOUND = OVERTURNING, VERTICAL_BENDING, HORIZONTAL_BENDING, PART_ABOVE
"""Mechanisms of which a document of what is there says nothing: that they need not be looked at is calculated or
tested."""

SHOWN_BY = "test", "calculation"
"""Kinds of documents that show of one of FOUND that it need not be looked at."""

NEAR = 0.01
"""Heights that differ by less are one [m]."""


@dataclass(frozen=True)
class SetAside:
    """[[wall.set_aside]]: a mechanism of the register that is not looked at, by a document.

    mechanism : one of ROWS
    from_m, to_m : heights above the base of the wall between which it is set aside, hinges at both included; all of the
        wall where they are left out
    """

    mechanism: str = choice_key(*ROWS)
    from_m: float | None = number_key(0.0, 60.0, unit="m")
    to_m: float | None = number_key(0.0, 60.0, unit="m")
    evidence: Document | None = key("section", of=Document, columns="set_aside{n}_evidence_")

    def covers(self, mechanism: str, low: float, high: float | None) -> bool:
        """Whether it sets aside a mechanism between two heights [m], high None of a wall without a height."""
        least, most = self.from_m or 0.0, math.inf if self.to_m is None else self.to_m
        return self.mechanism == mechanism and least <= low + NEAR and (low if high is None else high) <= most + NEAR


def check_set_aside(entry: SetAside, height: float | None, here) -> None:
    """Raise InputError for what is set aside without a document, or between heights that are none of the wall.

    height : of the wall [m]; here : its place
    """
    if entry.evidence is None:
        raise InputError("set_aside_evidence", place=here, key="evidence")
    if not is_named(entry.evidence.reference):
        raise InputError("set_aside_reference", place=here, key="reference")
    if entry.mechanism in FOUND and entry.evidence.kind not in SHOWN_BY:
        found = {"found": entry.evidence.kind, "mechanism": sentence("mechanism", entry.mechanism), "kinds": SHOWN_BY}
        raise InputError("set_aside_kind", place=here, key="kind", **found)
    most = math.inf if height is None else height + NEAR
    for name, found, least in (("from_m", entry.from_m, 0.0), ("to_m", entry.to_m, entry.from_m or 0.0)):
        if found is not None and not least <= found <= most:
            raise InputError("set_aside_heights", place=here, key=name, found=found, least=least, most=height or 60.0)
