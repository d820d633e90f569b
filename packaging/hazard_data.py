"""Makes resources/hazard/italy.npz of the national grid and the municipalities.

    python packaging/hazard_data.py FOLDER    # grid.csv.xz and places.csv, see resources/docs/place.md for where from

Numbers are whole: degrees and values in millionths, which hold every digit of the tables.
"""

import csv
import lzma
import sys
from pathlib import Path

import numpy as np

TARGET = Path(__file__).resolve().parents[1] / "resources" / "hazard" / "italy.npz"
MILLION = 1_000_000


def whole(text: str) -> int:
    """A decimal number in millionths, exact."""
    value = round(float(text) * MILLION)
    if not abs(value / MILLION - float(text)) < 1e-12:
        raise SystemExit(f"{text} in the tables has more than six decimals: italy.npz holds millionths")
    return value


def main(folder: Path) -> None:
    """Write the file."""
    with lzma.open(folder / "grid.csv.xz", "rt", newline="") as table:
        rows = list(csv.reader(table))[1:]
    with open(folder / "places.csv", encoding="utf-8", newline="") as stream:
        places = list(csv.DictReader(stream))
    words = "\n".join(f"{p['municipality']}\t{p['province']}\t{p['province_name']}" for p in places)
    TARGET.parent.mkdir(exist_ok=True)
    np.savez(
        TARGET,
        ids=np.array([int(row[0]) for row in rows], np.int32),
        nodes=np.array([[whole(row[2]), whole(row[1])] for row in rows], np.int32),
        values=np.array([[whole(cell) for cell in row[3:]] for row in rows], np.int32).reshape(len(rows), 9, 3),
        names=np.frombuffer(words.encode(), np.uint8),
        seats=np.array([[whole(p["latitude"]), whole(p["longitude"])] for p in places], np.int32),
    )
    print(f"{TARGET.name}: {len(rows)} nodes, {len(places)} municipalities, {TARGET.stat().st_size} bytes")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
