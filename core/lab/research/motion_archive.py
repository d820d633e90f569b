"""The motions of tests within an archive of numpy: what a process of its own unpacks, which imports nothing else."""

import io

import numpy as np

NO_MOTION = "no_motion "
"""How the reason begins for which a test has none."""


def unpacked(content: bytes, names: tuple[str, ...]) -> list[np.ndarray]:
    """The motions of these tests within an archive. Raises ValueError, and what numpy raises of a damaged file."""
    with np.load(io.BytesIO(content), allow_pickle=False) as archive:
        motions = []
        for name in names:
            motion = archive[f"t{name}"] if f"t{name}" in archive else np.zeros(0)
            if motion.ndim != 1 or motion.size < 2 or motion.dtype.kind not in "fiu" or not np.isfinite(motion).all():
                raise ValueError(NO_MOTION + name)
            motions.append(np.asarray(motion, float))
        return motions
