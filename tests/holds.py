"""What holds the walls of the tests, as [[wall.hold]] has it."""


def behind(evidence="drawing", kind="contact", **keys):
    """Contact along the wall, or another hold; evidence : kind of the document that shows it, "" of none."""
    shown = {"evidence": {"kind": evidence, "reference": "sheet 7"}} if evidence else {}
    return [{"kind": kind, **keys, **shown}]


BOUND = {"hold": [{"kind": "cross_walls", "evidence": {"kind": "drawing"}}]}
"""What binds a wall that rocks to both sides, which is then not free to vibrate."""


def between(spacing=None, evidence="opening", **ends):
    """Cross walls, from so far apart on between which the wall spans; evidence "test" shows what its ends stand too."""
    return behind(evidence, "cross_walls", **({} if spacing is None else {"spacing_m": spacing}), **ends)


def at_top(height, strength=None, evidence="calculation", kind="ring_beam"):
    """What holds the top of a wall that bends [m], and how much it stands [kN/m]."""
    return behind(evidence, kind, h_m=height, **({} if strength is None else {"out_kn_m": strength}))


def carries(*given, **keys):
    """Keys of a wall that carries these loads, and that these ties hold beside the holds of `keys`: what is of kind
    "tie" is one of its holds. A wall without loads says that it has none."""
    loads, ties = [one for one in given if one["kind"] != "tie"], [one for one in given if one["kind"] == "tie"]
    holds = [*keys.pop("hold", ()), *ties]
    stated = {"load": loads} if loads else {"unloaded_confirmed": True}
    return keys | stated | ({"hold": holds} if holds else {})


def sought(height, **bar):
    """A tie to be designed at this height [m]; bar : bar_length_m, elongation_m, spacing_m."""
    return {"kind": "tie", "h_m": height, "design": True, **bar}


def aside(mechanism, **heights):
    """A mechanism that is set aside by a calculation; heights : from_m, to_m."""
    return {"mechanism": mechanism, **heights, "evidence": {"kind": "calculation", "reference": "sheet 9"}}


def shown(**references):
    """evidence of a wall or of the demand: a study for each of these keys."""
    return [{"of": key, "kind": "study", "reference": words} for key, words in references.items()]
