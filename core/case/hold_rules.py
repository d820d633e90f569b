"""What is wrong with the holds of a wall, and how the keys that said the same before are written now."""

import json
from collections.abc import Mapping
from typing import Any

from core.case.asked import DEMAND, shown_by
from core.case.directions import LONGEST
from core.case.document import KINDS_THAT_SHOW, PRESENCE, STATED, STRENGTH, is_named
from core.case.held_stretches import find_held_stretches, refuse_uncounted_holds, stands_outward
from core.case.hold import HOLD_KINDS, TIE, Hold, hold_kind
from core.case.site import Building
from core.case.tie_rules import OF_AN_OLD_TIE, check_tie
from core.case.wall import Wall
from core.errors import InputError, place, section
from core.text.sentence import Key
from core.wall.bending import TOP_TOLERANCE
from core.wall.kinematics import kinematics

LEAST_ELONGATION = 0.001
"""Least elongation of a hold that yields [m]: what a wall at rest gives way before its thrust line has moved to where
the least reaction holds it, some tenths of a millimetre, is less."""

OF_ENDS = ("tie_kn_m", "tie_bar_length_m", "tie_elongation_m", "shoulder_length_m", "shoulder_thickness_m")
OF_ENDS += ("corner_wall", "corner_side")
"""Keys of what the ends of a wall push against, where it spans between two holds."""


def check_holds(wall: Wall) -> None:
    """Raise InputError for holds that are not complete, contradict each other or are not on the wall."""
    here = (place("wall", name=wall.title),)
    for n, hold in enumerate(wall.hold, start=1):
        _check_hold(wall, hold, (*here, place("hold", n=n)))
    bends = wall.kinematics.bends_up or any(stands_outward(hold) or hold.is_tie for hold in wall.hold)
    if wall.base_friction is not None and not bends:
        raise InputError("base_friction_unused", place=here, key="base_friction", out_kn_m=Key("out_kn_m"))
    spans = [n for n, hold in enumerate(wall.hold, start=1) if hold.spans]
    counted = wall.kinematics.bends_up or not any(stands_outward(hold) for hold in wall.hold)
    if not counted and not find_held_stretches(wall):
        n = next(n for n, hold in enumerate(wall.hold, start=1) if stands_outward(hold))
        refuse_uncounted_holds(wall, (*here, place("hold", n=n)))
    if len(spans) > 1:
        raise InputError("hold_two_spacings", place=(*here, place("hold", n=spans[1])), key="spacing_m", first=spans[0])
    sought = [n for n, hold in enumerate(wall.hold, start=1) if hold.design]
    if len(sought) > 1:
        raise InputError("two_sought", place=(*here, place("hold", n=sought[1])), key="design", first=sought[0])


def _check_hold(wall: Wall, hold: Hold, here) -> None:
    high = hold.has_height
    if high and hold.h_m is None:
        raise InputError("hold_needs", place=here, key="h_m", kind=hold.kind)
    others = ("from_m", "to_m") if high else ("h_m",)
    others += () if hold.is_local else OF_ENDS if hold.design else ("spacing_m", *OF_ENDS)
    others += () if hold.has_height or hold.is_local else ("out_kn_m",)
    if given := [key for key in others if getattr(hold, key) not in (None, "")]:
        raise InputError("hold_key", place=here, key=given[0], kind=hold.kind)
    of_ends = [key for key in (*OF_ENDS, "out_kn_m") if getattr(hold, key) not in (None, "")]
    if of_ends and hold.only_there:
        raise InputError("hold_needs_spacing", place=here, key=of_ends[0], needed=Key("spacing_m"))
    if hold.to_m is not None and hold.to_m <= (hold.from_m or 0.0):
        raise InputError("hold_reversed", place=here, key="to_m", found=hold.to_m, least=hold.from_m or 0.0)
    if hold.shows_strength and hold.evidence is not None and not is_named(hold.evidence.reference):
        raise InputError("document_reference", place=here, key="reference", kind=hold.evidence.kind)
    if hold.in_kn_m is not None and (hold.out_kn_m is None or not hold.has_height or hold.is_bar):
        raise InputError("hold_inward", place=here, key="in_kn_m", out_kn_m=Key("out_kn_m"))
    if hold.stiffness_kn_m2 is not None and (hold.out_kn_m is None or not hold.has_height or hold.is_bar):
        raise InputError("hold_inward", place=here, key="stiffness_kn_m2", out_kn_m=Key("out_kn_m"))
    _check_yield(hold, here)
    check_tie(wall, hold, here)
    _check_height(wall, hold, here)


def _check_yield(hold: Hold, here) -> None:
    """Rules of a hold that yields and is no tie."""
    if hold.elongation_m is None or hold.is_bar:
        return
    if hold.out_kn_m is None or not hold.has_height:
        raise InputError("hold_yields", place=here, key="elongation_m", out_kn_m=Key("out_kn_m"))
    if hold.elongation_m < LEAST_ELONGATION:
        values = {"found": hold.elongation_m, "least": LEAST_ELONGATION}
        raise InputError("hold_yields_less", place=here, key="elongation_m", **values)


def _check_height(wall: Wall, hold: Hold, here) -> None:
    """Rules of a hold beside the height of its wall."""
    if (height := wall.height_m) is None:
        return
    for key in ("h_m", "from_m", "to_m"):
        if (at := getattr(hold, key)) is not None and at > height * (1.0 + TOP_TOLERANCE):
            raise InputError("hold_outside", place=here, key=key, found=at, most=height)
    below = hold.has_height and hold.h_m is not None and hold.h_m < height * (1.0 - TOP_TOLERANCE)
    if below and wall.kinematics.bends_up:
        raise InputError("hold_below_top", place=here, key="h_m", found=hold.h_m, height=height)


def check_holds_of_building(wall: Wall, building: Building | None) -> None:
    """Raise InputError for a floor above the building that is to hold the wall; a roof may rise above its height."""
    if building is None or wall.base_z_m is None:
        return
    most = building.height_m - wall.base_z_m
    for n, hold in enumerate(wall.hold, start=1):
        floor = hold_kind(hold.kind).of_building and not hold_kind(hold.kind).may_rise
        if floor and hold.h_m is not None and hold.h_m > most * (1.0 + TOP_TOLERANCE):
            here = (place("wall", name=wall.title), place("hold", n=n))
            raise InputError("hold_above_building", place=here, key="h_m", found=hold.h_m, most=most)


OF_A_SOUGHT_TIE = ("tie_height_m", "tie_bar_length_m", "tie_elongation_m", "tie_spacing_m")
"""Keys of a wall that said of a tie to be designed what a hold says."""

OLD_KEYS = ("back_restraint", "restraint_evidence", "restraint_note", "restraint_kn_m", "arch", *OF_A_SOUGHT_TIE)
"""Keys of a wall that [[wall.hold]] takes the place of."""

OLD_KINDS = {"tied_floors": "floor", "other": "contact"}
"""Restraint of older cases -> kind of hold, where it has another name."""


def refuse_old_keys(table: Mapping[str, Any], here) -> None:
    """Raise InputError for a key that [[wall.hold]] takes the place of, with the new writing of what it says.

    table : keys of a wall; here : its place
    """
    refuse_old_reasons(table, (here, section("[wall.justification]")))
    if "free_element" in table:
        bound = 'hold = [{ kind = "cross_walls", evidence = { kind = "drawing" } }]'
        raise InputError("old_free", place=(here,), key="free_element", written=bound, mechanism=Key("mechanism"))
    if "all_directions" in table:
        raise InputError("directions_by_themselves", place=(here,), key="all_directions", most=LONGEST)
    if old := next((key for key in OLD_KEYS if key in table), None):
        raise InputError("old_key", place=(here,), key=old, written=rewritten(table))
    loads = table.get("load")
    for n, load in enumerate(loads if isinstance(loads, list | tuple) else [], start=1):
        if isinstance(load, Mapping) and hold_kind(str(load.get("kind"))).is_bar:
            raise InputError("old_tie", place=(here, place("load", n=n)), key="kind", written=rewritten(table))


OF_TIES = ("elongation_m", "slack_mm", "prestress", "anchorage_kn")
"""Reasons of a wall that the evidence of its ties takes the place of."""


def refuse_old_reasons(table: Mapping[str, Any], here) -> None:
    """Raise InputError for the reasons in words that documents take the place of, with the new writing of the line.

    table : keys of a wall, or of the demand; here : its place
    """
    if "investigations" in table:
        words = _toml_value(str(table["investigations"]))
        written = f'evidence = [{{ of = "confidence_factor", kind = "test", reference = {words} }}]'
        kinds = KINDS_THAT_SHOW[shown_by(DEMAND, "confidence_factor")]
        raise InputError("old_reason", place=here, key="investigations", written=written, kinds=kinds)
    reasons = table.get("justification")
    if reasons is None:
        return
    (name, words) = next(iter(reasons.items()), ("", "")) if isinstance(reasons, Mapping) else ("", reasons)
    shown = f'{{ kind = "...", reference = {_toml_value(str(words))} }}'
    if name == "hinge_heights":
        written = f'set_aside = [{{ mechanism = "overturning", evidence = {shown} }}]'
    elif name in OF_TIES:
        written = f"evidence = {shown}"
    else:
        written = f'evidence = [{{ of = "{name}", {shown[2:]}]'
    kinds = (*PRESENCE, *STRENGTH, *STATED)
    raise InputError("old_reason", place=here, key="justification", written=written, kinds=kinds)


def rewritten(table: Mapping[str, Any]) -> str:
    """What the older keys of a wall say, as the line of a case file that says it now."""
    loads = table.get("load")
    loads = [load for load in loads if isinstance(load, Mapping)] if isinstance(loads, list | tuple) else []
    given = table.get("hold")
    holds = [
        _hold_in_words(hold) for hold in (given if isinstance(given, list | tuple) else []) if isinstance(hold, Mapping)
    ]
    holds += [_tie_in_words(load) for load in loads if hold_kind(str(load.get("kind"))).is_bar]
    if any(key in table for key in OF_A_SOUGHT_TIE):
        keys = [f"{key.removeprefix('tie_')} = {table[key]}" for key in OF_A_SOUGHT_TIE[1:] if key in table]
        holds.append(
            ", ".join([f'kind = "{TIE}"', f"h_m = {table.get(OF_A_SOUGHT_TIE[0], '...')}", *keys, "design = true"])
        )
    if any(key in table for key in OLD_KEYS if key not in OF_A_SOUGHT_TIE):
        holds.insert(0, _restraint_in_words(table))
    return f"hold = [{', '.join(f'{{ {hold} }}' for hold in holds)}]"


def _hold_in_words(hold: Mapping[str, Any]) -> str:
    """A hold as it is, in one line."""
    return ", ".join(f"{key} = {_toml_value(value)}" for key, value in hold.items())


def _tie_in_words(load: Mapping[str, Any]) -> str:
    """A tie that was among the loads, as a hold."""
    share, length = load.get("elongation"), load.get("bar_length_m")
    names = {"kind": "kind", "h_m": "h_m", "kn_m": "out_kn_m"} | {key: key for key in OF_AN_OLD_TIE}
    keys = [f"{new} = {_toml_value(load[old])}" for old, new in names.items() if old in load]
    if isinstance(share, float | int) and isinstance(length, float | int):
        keys.append(f"elongation_m = {share * length:.6g}")
    return ", ".join(keys)


def _restraint_in_words(table: Mapping[str, Any]) -> str:
    """What the older keys of a restraint say, as a hold."""
    ends = dict(table["arch"]) if isinstance(table.get("arch"), Mapping) else {}
    restraint = str(table.get("back_restraint") or "")
    kind = OLD_KINDS.get(restraint, restraint if restraint in HOLD_KINDS else "contact")
    kind = kind if not ends or hold_kind(kind).is_local else "cross_walls"
    keys = [f'kind = "{kind}"']
    if hold_kind(kind).has_height:
        at = table.get("height_m") if kinematics(str(table.get("mechanism"))).bends_up else None
        keys.append(f"h_m = {'...' if at is None else at}")
    if table.get("restraint_kn_m") is not None:
        keys.append(f"out_kn_m = {table['restraint_kn_m']}")
    keys += [f"{key} = {_toml_value(value)}" for key, value in ends.items()]
    evidence, note = table.get("restraint_evidence"), table.get("restraint_note")
    if evidence not in (None, "", "none"):
        words = f", note = {_toml_value(note)}" if note else ""
        if evidence in STRENGTH:
            words = f", reference = {_toml_value(note or '...')}"
        keys.append(f"evidence = {{ kind = {_toml_value(evidence)}{words} }}")
    elif note:
        keys.append(f"name = {_toml_value(note)}")
    return ", ".join(keys)


def _toml_value(value: Any) -> str:
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{key} = {_toml_value(inner)}' for key, inner in value.items())} }}"
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else str(value)
