"""A folder of records to choose from."""

import shutil
from pathlib import Path

from core.case.rules import parse_case
from core.ground.artificial import filtered_noise
from core.units import G

NTC = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
EN = {"code": "EN1998", "soil": "B", "type": 1}
WALL = {"name": "w", "height_m": 4.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "one_sided"}


def case(folder="recs", demand=None, **keys):
    select = {"folder": folder, "count": 3, **keys}
    return parse_case({"wall": [WALL], "select": select, "demand": demand or {"ag_g": 0.2, "spectrum": NTC}})


def write_esm(path: Path, seed: int, station: str, event: str, stream="HNE", magnitude="6.1", times=1.0) -> None:
    """An ESM file of a seeded motion in cm/s2. times : what its samples are multiplied by"""
    samples = times * 100.0 * filtered_noise(seed, (0.15 + 0.02 * (seed % 7)) * G, 20.0)
    head = {
        "EVENT_ID": event,
        "EVENT_NAME": "",
        "MAGNITUDE_W": magnitude,
        "EPICENTRAL_DISTANCE_KM": f"{10 + seed}",
        "NETWORK": "IT",
        "STATION_CODE": station,
        "SITE_CLASSIFICATION_EC8": "B*" if seed % 2 else "",
        "STREAM": stream,
        "SAMPLING_INTERVAL_S": "0.01",
        "NDATA": str(samples.size),
        "UNITS": "cm/s^2",
        "DATA_TYPE": "ACCELERATION",
        "PROCESSING": "manual",
    }
    lines = [f"{key}: {value}" for key, value in head.items()] + [f"{value:.6f}" for value in samples]
    path.write_text("\n".join(lines) + "\n")


def write_folder(base: Path) -> None:
    """Ten stations of five events, two components each, one vertical, one file that is none, one copy."""
    (base / "recs").mkdir()
    for k in range(10):
        for n, stream in enumerate(("HNE", "HNN")):
            write_esm(base / "recs" / f"IT.S{k}..{stream}.ASC", 2 * k + n + 1, f"S{k}", f"EV-{k // 2}", stream)
    write_esm(base / "recs" / "IT.S0..HNZ.ASC", 50, "S0", "EV-0", "HNZ")
    (base / "recs" / "readme.md").write_text("Downloaded on a day.\n")
    shutil.copy(base / "recs" / "IT.S3..HNE.ASC", base / "recs" / "copy of S3.ASC")
