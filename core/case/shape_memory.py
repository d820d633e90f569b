"""What is known of a shape that was judged before: in the window each key typed judges the whole case again."""

import copy
from dataclasses import replace
from functools import lru_cache
from typing import Any

from core.case.shape_rules import check_shape
from core.case.wall import Wall
from core.errors import InputError, place

WITHOUT_SHAPE: dict[str, Any] = {
    "name": "",
    "variant": None,
    "floor": "",
    "notes": "",
    "base_z_m": None,
    "hinge_heights": None,
    "unloaded_confirmed": False,
    "evidence": (),
    "restitution": None,
    "velocity_ratio": None,
    "law": "auto",
}
"""Keys of a wall that no rule of its shape reads."""


def check_known_shape(wall: Wall) -> None:
    """`check_shape`, once for equal shapes. Raises InputError."""
    if not wall.has_shape:
        return
    try:
        refusal = _found(replace(wall, hold=wall.ties, **WITHOUT_SHAPE))
    except TypeError:  # a value that is no key of a memory
        check_shape(wall)
        return
    if refusal is not None:
        error = copy.copy(refusal)
        error.place = (place("wall", name=wall.title), *refusal.place[1:])
        raise error


@lru_cache(maxsize=256)
def _found(wall: Wall) -> InputError | None:
    try:
        check_shape(wall)
    except InputError as error:
        return error.with_traceback(None)
    return None
