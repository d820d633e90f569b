"""Fixtures of the tests of core."""

import pytest


@pytest.fixture
def write(tmp_path):
    def make(content, name="motion.txt", encoding="utf-8"):
        path = tmp_path / name
        data = content if isinstance(content, bytes) else content.encode(encoding)
        path.write_bytes(data)
        return path

    return make
