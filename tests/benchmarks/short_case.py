"""A case of one wall under one record of a few seconds."""

from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]

CASE = """title = "Small"
[[wall]]
name = "w"
height_m = 3.0
thickness_m = 0.3
base_z_m = 0.0
mechanism = "two_sided"
[[record]]
file = "motion.txt"
unit = "g"
time_step_s = 0.01
kind = "artificial"
[analysis]
q_step = 0.05
[demand]
ag_g = 0.1
soil_factor = 1.2
"""


def short_case(folder: Path) -> Path:
    """A case of one wall under one record of 6 s, written in this folder as small.toml."""
    data = np.loadtxt(ROOT / "resources/reference/standard_record.csv", delimiter=",", skiprows=1)
    lines = [f"{value / 9.80665:.8f}" for value in data[:600, 1]]
    (folder / "motion.txt").write_text("\n".join([*lines, ""]))
    path = folder / "small.toml"
    path.write_text(CASE)
    return path
