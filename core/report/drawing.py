"""matplotlib drawing alike everywhere, whatever a matplotlibrc of the user or the folder says."""

import contextlib
from collections.abc import Iterator


@contextlib.contextmanager
def style(settings: dict) -> Iterator[None]:
    """matplotlib's own defaults and these settings of it, for what is drawn and saved within."""
    import matplotlib as mpl

    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(settings)
        yield
