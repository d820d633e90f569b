"""Packages that are missing: asked for before the work, in a sentence that fits the installation."""

import re
import sys
import tomllib

import pytest

from core import packages
from core.errors import OutputError
from tests.conftest import ROOT


def refusal(extra: str, monkeypatch, language: str = "en") -> str:
    for module in packages.PACKAGES[extra]:
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(OutputError) as caught:
        packages.require(extra)
    return caught.value.text(language)


@pytest.mark.parametrize("extra", packages.PACKAGES)
def test_that_each_extra_names_its_packages_and_is_had_where_they_are(extra, monkeypatch):
    packages.require(extra)
    said = refusal(extra, monkeypatch)
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    asked = {re.match(r"[\w-]+", line)[0] for line in project["optional-dependencies"][extra]}
    assert asked == set(packages.PACKAGES[extra].values())
    assert all(name in said for name in asked)


def test_that_the_way_out_fits_the_installation(monkeypatch, tmp_path):
    """Who came by pipx has no run.py, who installed the program has no pip."""
    assert "start the program with python3 run.py" in refusal("study", monkeypatch)
    monkeypatch.setattr(packages, "__file__", str(tmp_path / "core" / "packages.py"))
    said = refusal("study", monkeypatch)
    assert said.endswith("the program (pipx inject ribalta-rocking matplotlib)")
    assert "run.py" not in said + refusal("study", monkeypatch, "it")
    monkeypatch.setattr(packages, "build", lambda: {"commit": "x"})
    assert refusal("accuracy", monkeypatch, "it").endswith("installare di nuovo il programma")


def test_that_no_other_sentence_sends_to_run_py():
    from core.text.catalogue import CATALOGUE

    sending = [code for texts in CATALOGUE.values() for code, words in texts.items() if "python3 run.py" in words[0]]
    assert sending == ["way_sources"]
