"""Every visible string of the window has its Italian."""

import ast
import re
import xml.etree.ElementTree as ET

from app.sentences import catalogue, translated
from core.case.rules import parse_case
from core.errors import InputError
from tests.conftest import ROOT

APP = sorted((ROOT / "app").rglob("*.py"))


def visible_strings():
    """(file, string) of every tr("...") in the program."""
    for path in APP:
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "tr":
                (argument,) = node.args
                if isinstance(argument, ast.Constant):
                    yield path.name, argument.value


def test_that_no_visible_string_lacks_a_translation():
    tree = ET.parse(ROOT / "resources" / "translations" / "ribalta_it.ts")
    done = {
        m.find("source").text
        for m in tree.iter("message")
        if m.find("translation").text and m.find("translation").get("type") != "unfinished"
    }
    found = list(visible_strings())
    assert len(found) > 150
    assert [entry for entry in found if entry[1] not in done] == []


CORE = sorted((ROOT / "core").rglob("*.py"))


def sentences_of_the_core():
    """(file, sentence) of every input check, with «k» where it names something."""

    def words(node) -> list[str]:
        if isinstance(node, ast.Constant):
            return [node.value]
        if isinstance(node, ast.IfExp):
            return words(node.body) + words(node.orelse)
        if isinstance(node, ast.JoinedStr):
            return [
                "".join(
                    v.value if isinstance(v, ast.Constant) else f"«{k}»"
                    for k, v in enumerate(node.values)
                )
            ]
        return []

    for path in CORE:
        for node in ast.walk(ast.parse(path.read_text())):
            name = getattr(getattr(node, "func", None), "id", "")
            if name in ("InputError", "RecordError", "OutputError") and node.args:
                yield from ((path.name, sentence) for sentence in words(node.args[0]))
            elif name == "require":
                yield from ((path.name, sentence) for sentence in words(node.args[3]))


def test_that_no_sentence_of_an_input_check_lacks_its_italian():
    found = set(sentences_of_the_core())
    assert len(found) > 90
    same = {"«0»: «2»", "0 < D1 < 1", "D1 <= D2 < 1"}
    for file, sentence in found:
        if sentence in same:
            continue
        # a hint or a place that ends some sentences has an entry of its own
        ends = (sentence, re.sub("«[0-9]»$", "; did you mean «9»?", sentence), sentence[:-3])
        italian = [translated(end, "it") for end in ends if translated(end, "it") != end]
        assert italian, (file, sentence)
        english = [
            part for part in re.split("«[0-9]»", sentence) if re.search("[a-z]{3} [a-z]{2}", part)
        ]
        assert all(part.strip() not in italian[0] for part in english), (file, italian[0])


def test_that_a_translation_names_as_much_as_the_sentence():
    for _, english, italian in catalogue("it"):
        assert english.count("{}") == italian.count("{}"), english


def test_that_a_sentence_is_said_with_what_it_names_in_it():
    wall = {"name": "none", "height_m": 70, "thickness_m": 0.3, "mechanism": "two_sided"}
    try:
        parse_case({"wall": [wall]})
    except InputError as error:
        sentence = str(error)
    assert translated(sentence, "en") == sentence
    italian = translated(sentence, "it")
    assert "non è ammesso: da 0.1 a 60 m" in italian and "none" in italian
    assert translated("words of no check", "it") == "words of no check"


def test_that_the_place_before_what_is_missing_is_italian_too():
    rule = "mechanism is missing: it is required (one of one_sided, two_sided, both)"
    end = "manca mechanism: è richiesto (uno fra one_sided, two_sided, both)"
    assert translated(f'wall "A1": {rule}', "it") == f'parete "A1": {end}'
    assert translated(f'row 3: wall "A1": {rule}', "it") == f'riga 3: parete "A1": {end}'
