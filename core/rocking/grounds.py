"""Records as the kernels of many analyses take them."""

from dataclasses import dataclass

import numpy as np

from core.rocking.early_stop import lookahead_bounds


@dataclass(frozen=True)
class Grounds:
    """Records of one time step laid end to end, as a pass takes them; made once for all analyses of them.

    ground : [m/s2], a zero after each record; dt : [s]; first, last : index of the samples of each record,
    shape (records,); strongest : |u''| of each [m/s2]; ahead : of `lookahead_bounds`, shape (4, n).
    """

    ground: np.ndarray
    dt: float
    first: np.ndarray
    last: np.ndarray
    strongest: np.ndarray
    ahead: np.ndarray

    @classmethod
    def of(cls, records, dt: float) -> "Grounds":
        """records : ground accelerations [m/s2], each of shape (n,)."""
        end = np.cumsum([record.size + 1 for record in records])
        return cls(
            ground=np.concatenate([np.append(record, 0.0) for record in records]),
            dt=dt,
            first=end - np.array([record.size + 1 for record in records]),
            last=end - 2,
            strongest=np.array([np.abs(record).max() for record in records]),
            ahead=np.hstack([lookahead_bounds(np.append(record, 0.0), dt) for record in records]),
        )
