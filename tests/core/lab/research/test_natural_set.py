"""The named set of natural records: found by content, and what its file says of it."""

import hashlib
from itertools import combinations

import numpy as np
import pytest

from core.errors import InputError
from core.ground import records
from core.lab.research import natural_set, parametric
from core.lab.research.natural_set import find, read_set
from tests.conftest import ROOT
from tests.core.lab.research.test_parametric import run, table

NAMED = ROOT / "resources" / "studies" / "natural.toml"

AT2 = "PEER\nEVENT, STATION, {name}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 200, DT= .01000 SEC\n"


def record(seed):
    """A record of the form of PEER."""
    values = np.random.default_rng(seed).normal(0.0, 0.1, 200).cumsum() * 0.05
    return (AT2.format(name=seed) + "\n".join(f"{value:.7E}" for value in values)).encode()


def named(contents):
    """A set of records of these contents."""
    tables = [
        f'[[record]]\nevent = "E{k}"\nstation = "S"\ncomponent = "N"\nfile = "r{k}.AT2"\n'
        f'file_sha256 = "{hashlib.sha256(content).hexdigest()}"\n'
        for k, content in enumerate(contents)
    ]
    return "\n".join(tables)


@pytest.mark.shows("paper.natural")
def test_that_records_are_found_by_their_content_and_the_others_are_named(tmp_path):
    contents, folder = [record(seed) for seed in range(4)], tmp_path / "records"
    (folder / "below").mkdir(parents=True)
    (tmp_path / "set.toml").write_text(named(contents))
    (folder / "another name.txt").write_bytes(contents[2])
    (folder / "below" / "r0.AT2").write_bytes(contents[0])
    (folder / "r1.AT2").write_bytes(contents[1] + b" ")  # of this name, and changed
    (folder / "stranger.AT2").write_bytes(record(9))
    found, missing = find(read_set(tmp_path / "set.toml"), folder)
    assert [(one.event, motion.name) for one, motion in found] == [("E0", "E0, S, N"), ("E2", "E2, S, N")]
    assert [one.file for one in missing] == ["r1.AT2", "r3.AT2"]
    content = table(motions="records") | {"natural": str(tmp_path / "set.toml")}
    result = run(content, records_from=folder)
    assert [entry.event for entry in result.motions if entry.seed is None] == ["E0", "E2"]
    assert result.missing == ("E1, S, N", "E3, S, N")
    (folder / "another name.txt").unlink()
    (folder / "below" / "r0.AT2").unlink()
    with pytest.raises(InputError, match=r"none of the records that .*set.toml names by their content \(4\)"):
        run(content, records_from=folder)


def test_that_the_set_of_the_paper_says_of_each_record_what_it_is():
    known = read_set(NAMED)
    hashes = [one.file_sha256 for one in (*known.record, *known.left_out)]
    assert len(set(hashes)) == len(hashes) and all(len(one) == 64 for one in hashes)
    assert len(known.record) == 35 and len({one.event for one in known.record}) == 21
    stations = [(one.event, one.station) for one in known.record]
    assert len(set(stations)) == len(stations)
    assert all(one.reason for one in known.left_out)


@pytest.mark.shows("paper.natural")
def test_that_the_set_of_the_paper_holds_what_its_file_promises(shelf):
    known = read_set(NAMED)
    found, missing = find(known, shelf)
    assert missing == []
    motions = [motion for _, motion in found]
    for motion in motions:
        codes = {warning.code for warning in motion.warnings}
        assert motion.pga >= 0.02 * 9.80665 and not codes & {"vertical", "unprocessed", "in_structure"}, motion.name
    step = 0.02
    sampled = []
    for motion in motions:
        times = np.arange(0.0, motion.time_step * (motion.acceleration.size - 1), step)
        values = np.interp(times, np.arange(motion.acceleration.size) * motion.time_step, motion.acceleration)
        sampled.append(values / np.linalg.norm(values))
    size = 1 << (2 * max(one.size for one in sampled)).bit_length()
    spectra = [np.fft.rfft(one, size) for one in sampled]
    alike = [np.abs(np.fft.irfft(a * np.conj(b), size)).max() for a, b in combinations(spectra, 2)]
    assert max(alike) < 0.85
    listed = {one.file_sha256 for one in (*known.record, *known.left_out)}
    for path in sorted(shelf.rglob("*")):  # each record the program reads is in one of the lists
        if path.is_file() and hashlib.sha256(path.read_bytes()).hexdigest() not in listed:
            with pytest.raises(InputError):
                records.read(path)


def test_that_a_list_of_records_is_taken_as_it_is(tmp_path):
    (tmp_path / "a.AT2").write_bytes(record(1))
    (tmp_path / "list.toml").write_text(f'[[record]]\nfile = "{tmp_path / "a.AT2"}"\n')
    study = parametric.Study(natural=str(NAMED))
    assert len(parametric.natural_motions(study, tmp_path, tmp_path / "list.toml").motions) == 1
    assert natural_set.find(read_set(NAMED), tmp_path)[0] == []
