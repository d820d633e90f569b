"""Archives of tar, packed or not: each member as the file itself, and hostile ones refused in a sentence."""

import gzip
import io
import tarfile

import numpy as np
import pytest

from core.errors import RecordError
from core.ground.records import channels, read
from core.ground.records.container import MAX_TAR, tar_as_zip
from core.ground.records.grammar import Options

TEXT = "t (s)\tacc (g)\n" + "".join(f"{0.01 * k:.2f}\t{0.1 * np.sin(k / 5.0):.6f}\n" for k in range(400))


def packed(path, members, mode="w"):
    """An archive of tar. members : name -> content, None a folder"""
    with tarfile.open(path, mode) as tar:
        for name, content in members.items():
            entry = tarfile.TarInfo(name)
            if content is None:
                entry.type = tarfile.DIRTYPE
            else:
                entry.size = len(content)
            tar.addfile(entry, io.BytesIO(content or b""))
    return path


@pytest.mark.parametrize(("ending", "mode"), [("tar", "w"), ("tar.gz", "w:gz")])
def test_that_a_member_of_a_tar_is_read_as_the_file_itself(tmp_path, ending, mode):
    plain = tmp_path / "one.txt"
    plain.write_text(TEXT)
    other = TEXT.replace("0.1", "0.2").encode()
    path = packed(tmp_path / f"both.{ending}", {"d": None, "d/a.txt": TEXT.encode(), "d/b.txt": other}, mode)
    assert channels(path, Options("g")) == ("d/a.txt", "d/b.txt")
    with pytest.raises(RecordError, match="d/a.txt"):
        read(path, Options("g"))
    found, alone = read(path, Options("g", channel="d/a.txt")), read(plain, Options("g"))
    assert (found.acceleration == alone.acceleration).all() and found.time_step == alone.time_step
    assert found.format == "tar, plain text" and found.file_sha256 != alone.file_sha256
    one = packed(tmp_path / f"one.{ending}", {"a.txt": TEXT.encode()}, mode)
    assert (read(one, Options("g")).acceleration == alone.acceleration).all() and channels(one, Options("g")) == ()


def test_that_what_is_no_tar_or_a_damaged_one_is_refused_in_a_sentence(tmp_path):
    whole = packed(tmp_path / "whole.tar", {"a.txt": TEXT.encode()}).read_bytes()
    path = tmp_path / "x.tar"
    for content in (whole[:600], whole[:257] + b"ustar" + b"\xff" * 400, gzip.compress(whole)[:300]):
        path.write_bytes(content)
        with pytest.raises(RecordError) as refused:
            read(path, Options("g"))
        assert "\n" not in str(refused.value)
    path.write_bytes(gzip.compress(TEXT.encode()))
    with pytest.raises(RecordError, match="gzip"):
        read(path, Options("g"))
    assert tar_as_zip(b"") is None and tar_as_zip(TEXT.encode()) is None


def test_that_a_tar_of_nothing_but_zeros_is_not_unpacked_to_its_end(tmp_path):
    path = tmp_path / "bomb.tar.gz"
    with gzip.open(path, "wb", compresslevel=9) as stream:
        head = tarfile.TarInfo("a.txt")
        head.size = 2 * MAX_TAR
        stream.write(head.tobuf(tarfile.USTAR_FORMAT))
        for _ in range(2 * MAX_TAR // 10_000_000):
            stream.write(b"\0" * 10_000_000)
    with pytest.raises(RecordError, match="MB"):
        read(path, Options("g"))
