"""paper.md is its template with the results of the two studies in it, and says nothing else."""

import json
import re

import pytest

from core.lab.research import page
from core.lab.research.page import KEPT, PAGE, TEMPLATE, Results, cells, kept, rendered, table_text


@pytest.mark.shows("paper.of_results")
def test_that_the_page_is_of_the_results_that_are_kept():
    assert PAGE.read_text(encoding="utf-8") == page.page()


def test_that_every_cell_the_template_asks_for_has_a_value():
    found = [Results(json.loads(kept(name).read_text(encoding="utf-8"))) for name in ("paper", "law")]
    template, values = TEMPLATE.read_text(encoding="utf-8"), cells(*found)
    asked = set(re.findall(r"\{\{(\w+)\}\}", template))
    assert asked <= set(values) and "{{" not in page.page()
    assert len(asked) > 60
    with pytest.raises(KeyError):
        rendered("{{nothing}}", values)


def test_that_a_changed_result_changes_the_page(monkeypatch, tmp_path):
    contents = {name: json.loads(kept(name).read_text(encoding="utf-8")) for name in ("paper", "law")}
    contents["law"]["fits"]["two_sided rigid q"]["set_of_records"][0] = 0.123
    contents["paper"]["claims"][0]["held"] = 7
    monkeypatch.setattr(page, "STUDIES", tmp_path)
    monkeypatch.setattr(page, "PAGE", tmp_path / "paper.md")
    for name, content in contents.items():
        (tmp_path / f"{name}.json").write_text(json.dumps(content | {"motions": []}))
    page.main([str(tmp_path / f"{name}.json") for name in ("paper", "law")])
    text = (tmp_path / "paper.md").read_text(encoding="utf-8")
    assert "12 % inside" in text and "| 7 of " in text and "12 % inside" not in PAGE.read_text(encoding="utf-8")
    assert set(json.loads((tmp_path / "law.results.json").read_text())) == {*KEPT, "natural"}


def test_that_a_table_is_markdown():
    assert table_text(["a", "b"], [[1, 0.12345], [None, "c"]]) == "| a | b |\n| --- | --- |\n| 1 | 0.123 |\n| – | c |"
