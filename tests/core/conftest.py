"""Fixtures of the tests of core: a file, a folder of short records and the study of it."""

import numpy as np
import pytest

from core.study import run as study
from tests.core.study.cases import case


@pytest.fixture
def write(tmp_path):
    def make(content, name="motion.txt", encoding="utf-8"):
        path = tmp_path / name
        data = content if isinstance(content, bytes) else content.encode(encoding)
        path.write_bytes(data)
        return path

    return make


@pytest.fixture(scope="session")
def folder(tmp_path_factory, reference):
    """Three short records made from the reference motion."""
    place = tmp_path_factory.mktemp("records")
    ground = reference("standard")[0][:900]
    for k, factor in enumerate((0.9, 1.0, 1.1)):
        lines = [f"{value * factor:.9e}" for value in np.roll(ground, 30 * k)]
        (place / f"r{k}.txt").write_text("\n".join(lines))
    return place


@pytest.fixture(scope="session")
def result(folder):
    return study.run(case(), base_dir=folder)
