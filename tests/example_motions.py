"""Motions for tests that need files of records: filtered noise."""

from core.ground.artificial import filtered_noise
from core.units import G


def write_example_records(folder, count: int = 7) -> None:
    """The motions of tests/motions: two columns [s], [g] with a header that says what they are."""
    folder.mkdir(parents=True, exist_ok=True)
    for seed in range(1, count + 1):
        pga = (0.15 + 0.02 * seed) * G
        motion = filtered_noise(seed, pga) / G
        lines = [
            f"# Ribalta example motion, seed {seed}: filtered noise, not a real record, not compatible",
            "# Time (s)  Acceleration (g)",
        ]
        lines += [f"{0.01 * k:.2f} {value:.7f}" for k, value in enumerate(motion)]
        (folder / f"noise_{seed}.txt").write_text("\n".join(lines) + "\n", encoding="ascii")
