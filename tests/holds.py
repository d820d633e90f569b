"""What holds the walls of the tests, as [[wall.hold]] has it."""


def behind(evidence="drawing", kind="contact", **keys):
    """Contact along the wall, or another hold; evidence : kind of the document that shows it, "" of none."""
    shown = {"evidence": {"kind": evidence, "reference": "sheet 7"}} if evidence else {}
    return [{"kind": kind, **keys, **shown}]


def between(spacing=None, evidence="opening", **ends):
    """Cross walls, from so far apart on between which the wall spans; evidence "test" shows what its ends stand too."""
    return behind(evidence, "cross_walls", **({} if spacing is None else {"spacing_m": spacing}), **ends)


def at_top(height, strength=None, evidence="calculation", kind="ring_beam"):
    """What holds the top of a wall that bends [m], and how much it stands [kN/m]."""
    return behind(evidence, kind, h_m=height, **({} if strength is None else {"out_kn_m": strength}))
