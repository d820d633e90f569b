"""Artificial motions: filtered noise under an envelope, for trials and the bundled example."""

import numpy as np

from core.units import G

GROUND_FREQUENCY = 2.5
GROUND_DAMPING = 0.6
"""Kanai-Tajimi filter of a firm soil: centre frequency [Hz] and damping [-]."""

LOW_CUT = 0.15
"""Corner of the high-pass that keeps velocity and displacement bounded [Hz]."""


def filtered_noise(seed: int, pga: float, duration: float = 25.0, time_step: float = 0.01):
    """A seeded accelerogram [m/s2], shape (n,): Kanai-Tajimi noise, 2 s rise, 10 s strong part, decay.

    pga [m/s2]; duration, time_step [s]. Bit-reproducible for a seed; ends at rest and at zero
    displacement.
    """
    n = round(duration / time_step) + 1
    times = np.arange(n) * time_step
    noise = np.random.Generator(np.random.PCG64(seed)).standard_normal(n)
    frequency = np.fft.rfftfreq(n, time_step)
    x = frequency / GROUND_FREQUENCY
    filter_ = (1.0 + 2j * GROUND_DAMPING * x) / (1.0 - x * x + 2j * GROUND_DAMPING * x)
    high_pass = (frequency / (frequency - 1j * LOW_CUT)) ** 2
    stationary = np.fft.irfft(np.fft.rfft(noise) * filter_ * high_pass, n)
    rise, strong = 2.0, 12.0
    envelope = np.minimum(times / rise, 1.0) ** 2
    envelope[times > strong] = np.exp(-0.35 * (times[times > strong] - strong))
    envelope *= np.clip((duration - times) / 1.0, 0.0, 1.0)
    motion = stationary * envelope
    # zero end velocity and displacement by a parabola under the same envelope
    shape = np.vstack([envelope * times**k for k in range(2)])
    weights = (1.0, duration - times)
    goals = np.array([[np.trapezoid(s * w, times) for s in shape] for w in weights])
    ends = [np.trapezoid(motion * w, times) for w in weights]
    motion = motion - np.linalg.solve(goals, ends) @ shape
    return np.round(motion * (pga / np.abs(motion).max()), 6)


def write_example_records(folder, count: int = 7) -> None:
    """The bundled records of resources/: two columns [s], [g] with a header that says what they are."""
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
