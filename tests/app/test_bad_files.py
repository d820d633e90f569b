"""Every bad file as a person runs it: in a process of its own, the sentence alone on the terminal."""

import os
import subprocess
import sys

from tests.conftest import ROOT
from tests.core.ground.networks_made import REFUSED
from tests.core.ground.test_signatures import MADE

MORE = {
    "empty": b"",
    "blank": b"\n\n",
    "words": b"no numbers here\n",
    "zeros": b"acceleration in m/s2, dt = 0.01 s\n" + b"0.0\n" * 500,
    "tiny": b"acceleration in m/s2, dt = 0.01 s\n" + b"1e-300\n" * 500,
    "huge": b"acceleration in m/s2, dt = 0.01 s\n" + b"1e300\n-1e300\n" * 500,
    "nan": b"acceleration in m/s2, dt = 0.01 s\n" + b"nan\n" * 500,
    "sorted": b"acceleration in m/s2, dt = 0.01 s\n" + b"".join(b"%d\n" % k for k in range(500)),
    "no unit": b"".join(b"%d %d\n" % (k, (k * 7) % 5 - 2) for k in range(500)),
}


def test_that_bad_records_leave_their_sentences_alone_on_the_terminal(tmp_path):
    files = {**{name: content for name, (content, *_) in {**REFUSED, **MADE}.items()}, **MORE}
    paths = []
    for k, content in enumerate(files.values()):
        paths.append(tmp_path / f"r{k:02d}.dat")
        paths[-1].write_bytes(content)
    command = [sys.executable, "-P", "-W", "default", "-m", "app", "--inspect", *map(str, paths)]
    found = subprocess.run(command, env=dict(os.environ, PYTHONPATH=str(ROOT)), capture_output=True, text=True)
    assert found.returncode == 1
    said = found.stderr.splitlines()
    assert all(line.startswith(f"refused: {tmp_path}{os.sep}r") for line in said), found.stderr
    silent = [name for name, path in zip(files, paths, strict=True) if f"{path.name}" not in found.stderr]
    assert silent == ["LabVIEW, no unit"]  # shown with their unit asked for
