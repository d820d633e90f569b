"""`variant_of` in a case file: a wall as the copy of another, of which only what differs is written."""

from core.case.values import quote_value
from core.case.variant_names import AS_IS, DESIGNED
from core.errors import InputError, place

KEY = "variant_of"
"""Key of a [[wall]] in the file alone: a Wall is whole."""

MAX_NAMES_SHOWN = 20
"""Names of walls repeated in a sentence."""

EMPTY_VALUES = ("", [])
"""Values that take a key of the named wall away."""

ALTERNATIVES = (
    ("thickness_m", "slenderness_deg", "height_over_thickness"),
    ("restitution", "velocity_ratio"),
    ("hinge_setback_m", "compressive_strength_mpa"),
)
"""Keys that give one thing: where the copy has one, the others of the named wall go."""


def expand_variants(table: dict) -> dict:
    """Replace each variant in the mapping of a case file by a whole wall; the wall it is of becomes "as it is", where
    it names no variant. Raises InputError."""
    walls = table.get("wall")
    if not isinstance(walls, (list, tuple)) or not any(isinstance(wall, dict) and KEY in wall for wall in walls):
        return table
    whole = [dict(wall) if isinstance(wall, dict) else wall for wall in walls]
    known = {wall["name"]: k for k, wall in reversed(list(enumerate(walls))) if _is_whole(wall)}
    variants = {name for wall in walls if isinstance(wall, dict) and KEY in wall for name in _names(wall)}
    for k, wall in enumerate(walls):
        if not isinstance(wall, dict) or KEY not in wall:
            continue
        name, here = wall[KEY], place("wall", name=k + 1)
        if not isinstance(name, str) or name not in known:
            if isinstance(name, str) and name in variants:
                raise InputError("variant_of_variant", place=(here,), key=KEY, named=quote_value(name))
            names = ", ".join(quote_value(one) for one in list(known)[::-1][:MAX_NAMES_SHOWN])
            raise InputError("variant_of_unknown", place=(here,), key=KEY, named=quote_value(name), known=names)
        whole[known[name]].setdefault("variant", AS_IS)
        whole[k] = _copy(walls[known[name]], wall)
    return {**table, "wall": whole}


def _is_whole(wall) -> bool:
    return isinstance(wall, dict) and KEY not in wall and isinstance(wall.get("name"), str)


def _names(wall: dict) -> list[str]:
    """Names by which a variant may refer to a wall: its name, where it has one, and its title."""
    own, original, variant = wall.get("name"), wall[KEY], wall.get("variant", DESIGNED)
    titled = isinstance(original, str) and isinstance(variant, str)
    return [*([own] if isinstance(own, str) else []), *([f"{original} ({variant})"] if titled else [])]


def _copy(original: dict, wall: dict) -> dict:
    """Copy the original wall with the keys of the variant in place of its own."""
    own = {key: value for key, value in wall.items() if key != KEY}
    if own.get("name", original["name"]) != original["name"]:
        here = place("wall", name=original["name"])
        raise InputError("variant_name", place=(here,), key="name", named=quote_value(own["name"]))
    gone = {key for key, value in own.items() if value in EMPTY_VALUES}
    for keys in ALTERNATIVES:
        if any(key in own and key not in gone for key in keys):
            gone |= {key for key in keys if key not in own}
    copy = {**original, "variant": DESIGNED, **own}
    return {key: value for key, value in copy.items() if key not in gone}


def contract_variants(walls: list[dict], stated) -> list[dict]:
    """Whole walls as the file writes them, which states a variant as such. stated : the walls of the file as it is"""
    if len(stated) != len(walls):
        return walls
    originals = {
        wall.get("name"): wall for wall, old in reversed(list(zip(walls, stated, strict=True))) if KEY not in old
    }
    written = list(walls)
    for k, old in enumerate(stated):
        original = originals.get(str(old[KEY])) if KEY in old else None
        if original is not None:
            own = {key: value for key, value in walls[k].items() if value != original.get(key)}
            if own.get("variant") == DESIGNED:
                del own["variant"]
            replaced = {key for keys in ALTERNATIVES if any(key in own for key in keys) for key in keys}
            gone = dict.fromkeys(original.keys() - walls[k].keys() - replaced, "")
            written[k] = {KEY: old[KEY], **own, **gone}
    return written
