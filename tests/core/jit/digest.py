"""Histories and scans of a process of its own, as one digest."""

import os
import subprocess
import sys

from tests.conftest import ROOT

SCRIPT = """
import sys, hashlib, math, numpy as np
from core.jit import cache
from core.ground.response_spectrum import housner_intensity
from core.rocking.history import history, scan
from core.rocking.methods import METHODS
from core.wall.rocking_model import RockingModel
ground = np.loadtxt(sys.argv[1], delimiter=",", skiprows=1)[:240, 1].copy()
digest = hashlib.sha256()
a = math.radians(6.8)
for one, ratio, drop, d1, d2 in ((0, .97, 0, 0, 0), (1, .45, 0, 0, 0), (1, .5, 9., 0, 0),
                                 (0, .97, 0, .02, .28), (1, .45, 0, .06, .28)):
    model = RockingModel(a, 2.0866, float(one), ratio, float(drop), d1 * a, d2 * a)
    for method in METHODS.values():
        for scale in (1.0, 2.7):
            found = history(ground, 0.01, scale, model, method)
            digest.update(found.rotation.tobytes() + found.velocity.tobytes())
            digest.update(found.impact_time.tobytes() + repr((found.outcome, float(found.peak))).encode())
    for name in sys.argv[2:]:
        outcomes, peaks = np.zeros(80, np.int64), np.zeros(80)
        clamped = scan(METHODS[name], ground, 0.01, np.linspace(0.5, 6.0, 80), model, outcomes, peaks)
        digest.update(outcomes.tobytes() + peaks.tobytes() + clamped.tobytes())
digest.update(repr(housner_intensity(ground[:300], 0.01)).encode())
print(digest.hexdigest(), cache.folder())
"""


def run(*scanned, before="", **variables):
    """(digest of histories by all methods and of scans by these, the cache's folder) of a process. before : lines it
    begins with"""
    known = ROOT / "resources" / "reference" / "standard_record.csv"
    found = subprocess.run(
        [sys.executable, "-P", "-c", before + SCRIPT, known, *scanned],
        capture_output=True,
        text=True,
        check=True,
        env=dict(os.environ, PYTHONPATH=str(ROOT), **variables),
    )
    digest, folder = found.stdout.split()
    return digest, folder
