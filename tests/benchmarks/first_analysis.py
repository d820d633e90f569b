"""The first analysis of a case, in a process of its own: speed.py measures from its start to its end."""

import sys
from pathlib import Path

from core.case.reader import read_case
from core.rocking.history import integrate_history
from core.setting.plan import make_plan, read_inputs

if __name__ == "__main__":
    path = Path(sys.argv[1])
    case = read_case(path)
    entry = make_plan(case, read_inputs(case, path.parent)).entries[0]
    motion = entry.felt[0]
    assert integrate_history(motion.acceleration, motion.time_step, 3.0, entry.model).rotation.any(), "a wall at rest"
