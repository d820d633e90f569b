"""Small record files of each dialect, written for the tests."""

import numpy as np

MOTION = np.round(np.sin(np.arange(40) * 0.7) * np.exp(-0.05 * np.arange(40)), 5)


def column(separator="\n", shape="{:.5f}"):
    return separator.join(shape.format(value) for value in MOTION)


def two(separator=" ", shape="{:.5f}", end="\n", decimal=".", every=0.01, places=2):
    rows = [f"{every * k:.{places}f}{separator}{shape.format(a)}" for k, a in enumerate(MOTION)]
    return end.join(rows).replace(".", decimal) + end


def thousandths(drop=None, double=None, jump=None):
    """Times printed to the millisecond at 1 kHz: the print is as coarse as the step."""
    rows = [f"{0.001 * k + (0.001 if jump and k > jump else 0):.3f} {a:.5f}" for k, a in enumerate(MOTION)]
    if drop:
        del rows[drop]
    if double:
        rows.insert(double, rows[double])
    return "\n".join(rows)


def peer(declared=40, values=None, unit="ACCELERATION TIME HISTORY IN UNITS OF G", step=".01000"):
    body = [f"{value:14.7E}" for value in (MOTION if values is None else values)]
    rows = ["".join(body[k : k + 5]) for k in range(0, len(body), 5)]
    head = ["PEER STRONG MOTION DATABASE RECORD", "EVENT, STATION", unit, f"NPTS= {declared}, DT= {step} SEC"]
    return "\n".join(head + rows) + "\n"


def esm(units="cm/s^2", peak=None, duration=None):
    """A DYNA file of MOTION in this unit."""
    rows = {
        "SAMPLING_INTERVAL_S": "0.01",
        "NDATA": "40",
        "UNITS": units,
        "DATA_TYPE": "ACCELERATION",
        "PGA_CM/S^2": peak,
        "DURATION_S": duration,
    }
    head = [f"{key}: {value}" for key, value in rows.items() if value is not None]
    return "\n".join([*head, *(f"{value:.6f}" for value in MOTION)]) + "\n"
