"""A display server without a screen, for the tests and benchmarks of the window."""

import contextlib
import os
import shutil
import subprocess
import sys


@contextlib.contextmanager
def display(**variables):
    """The environment of a process that shows the window on an Xvfb of its own, else what is missing, a str."""
    server = shutil.which("Xvfb")
    if server is None:
        yield "no Xvfb on this machine"
        return
    read, write = os.pipe()
    with subprocess.Popen(
        [server, "-displayfd", str(write), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
        pass_fds=[write],
        stderr=subprocess.DEVNULL,
    ) as process:
        os.close(write)
        try:
            with os.fdopen(read) as answer:
                number = answer.readline().strip()
            found = {**os.environ, **variables, "DISPLAY": f":{number}", "QT_QPA_PLATFORM": "xcb"}
            probe = "from PySide6.QtWidgets import QApplication; QApplication([])"
            start = [sys.executable, "-P", "-c", probe]
            if not number:
                yield "Xvfb does not start here"
            elif subprocess.run(start, env=found, capture_output=True).returncode:
                yield "Qt finds no xcb libraries here"
            else:
                yield found
        finally:
            process.terminate()
