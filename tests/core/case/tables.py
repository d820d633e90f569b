"""Tables of a case, as a file would hold them."""

WALL = {"name": "w", "height_m": 7.0, "thickness_m": 0.83, "base_z_m": 0.0, "mechanism": "two_sided"}


def case(wall=(), **rest):
    return {"wall": [{**WALL, **dict(wall)}], **rest}


def without(*keys, **more):
    return {"wall": [{k: v for k, v in {**WALL, **more}.items() if k not in keys}]}
