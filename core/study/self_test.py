"""Does machine code that was compiled on another machine give the numbers it was compiled for?"""

import math

import numpy as np

from core.capacity.ida import Search, incremental_dynamic_analysis, multiplier_of, threshold_of
from core.ground.ground_motion import GroundMotion
from core.rocking.history import history
from core.rocking.methods import METHODS
from core.version import build
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model


def numbers() -> list[str]:
    """Doubles, as hexadecimal text: the Housner intensity of a motion; q, SLV and a history of a wall 3 m high,
    rigid and free to rock to both sides, then trilinear beside a transverse wall. The motion is made of whole numbers,
    so that it is the same everywhere."""
    count = np.arange(400)
    samples = ((count * count * 7 + count * 13) % 101 - 50.0) * (count % 40 < 23) / 16.0
    motion = GroundMotion("whole numbers", samples, 0.01)
    block = Block.rectangle(3.0, 0.13)
    found = [motion.housner_intensity]
    for one_sided, law in ((False, "rigid"), (True, "doherty")):
        model = rocking_model(block, one_sided, restitution(block, "housner"), LAWS[law])
        ground, pga, method = motion.acceleration, motion.pga, METHODS["taylor"]
        run = incremental_dynamic_analysis(ground, 0.01, pga, 1, model, method, Search(q_limit=20.0))
        found += [value if value is not None else math.nan for value in (run.q, run.q_slv)]
        scale = float(multiplier_of(1.2, pga, threshold_of(model)))
        found += list(history(ground, 0.01, scale, model, method).rotation[::40])
    return [float(value).hex() for value in found]


def numbers_are_right() -> bool:
    """Whether they are those of the machine this program was built on."""
    return numbers() == build().get("self_test")
