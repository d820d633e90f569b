"""Every text a person reads is in the catalogue, once, in both languages, and nowhere else."""

import ast
import json
import re
from dataclasses import fields
from string import Formatter

import pytest

from core.case import wall_columns
from core.case.asked import DEMAND, WALL, evidence_keys
from core.case.document import PRESENCE, STATED, STRENGTH
from core.case.loads import Load
from core.case.rules import parse_case
from core.case.schema import Case, sections
from core.codes.assumption import DECLARED, DEFAULT, GIVEN, LEFT_OUT
from core.codes.kinematic import CHECKS
from core.codes.outcomes import OUTCOMES
from core.errors import InputError, place, section
from core.ground.records.signatures import BEGINNINGS
from core.lab.solved.cases import SUBJECTS, cases_of
from core.packages import PACKAGES
from core.text.catalogue import CATALOGUE, FOLDER, GROUPS, Catalogue, in_its_place
from core.text.sentence import FormNames, Key, Quantity, capital, localized, sentence
from tests.conftest import ROOT
from tests.trees import nodes_of

SOURCES = [
    path for top in ("core", "app") for path in sorted((ROOT / top).rglob("*.py")) if path.parent.name != "text"
] + [ROOT / "run.py", ROOT / "packaging" / "platforms.py"]

SPOKEN = {
    "tr": "window",
    "terminal": "terminal",
    "tell": "terminal",
    "say": "report",
    "notice": "notice",
    "_reason": "reason",
    "phrase": "terminal",
    "worded": "solved",
}
"""Functions that take a code of a group."""

WORDS = re.compile(r"[A-Za-z]{2,} [a-z]{2,} [a-z]{2,}")
"""Three words in a row: a sentence of English or Italian, whatever else a literal holds."""

OF_NO_SENTENCE = {
    "app/terminal/command_line.py": "what argparse says, and the texts of the terminal for it",
    "core/case/asked.py": "why no clause asks about an input, for who reads the table",
    "core/case/wall_columns.py": "heads of columns, in both languages",
    "core/case/case_files.py": "errors of what no program wrote",
    "core/case/variant_names.py": "the values of a key",
    **dict.fromkeys(
        [
            "core/report/columns.py",
            *(f"core/report/stated/{one}.py" for one in ("checks", "records", "study", "verdicts", "walls")),
        ],
        "what each key of the results is: its page and its schema are in English, as the keys are",
    ),
    "core/capacity/regression.py": "errors of whoever fits a law",
    "core/lab/research/pack.py": "an archive to deposit is in English",
    "core/lab/research/page.py": "a page of the documents is in English",
    "core/lab/research/study_files.py": "what the columns of its CSV are",
    "core/study/check_script.py": "a script is in English, as programs are",
    "core/derivation/faces.py": "errors of whoever describes a quantity",
    "core/derivation/quantity.py": "errors of whoever describes a quantity",
    **dict.fromkeys(["core/lab/solved/bodies.py", "core/lab/solved/floors.py"], "formulas"),
    **dict.fromkeys(
        [f"core/lab/solved/{name}.py" for name in ("experiments", "published", "published_rocking")], "citations"
    ),
    "core/variation/evaluate.py": "how the first line of a bundled motion begins",
    "core/ground/records/california.py": "patterns of heads of files",
    "core/ground/records/geonet.py": "patterns of heads of files",
    "core/ground/records/wordings.py": "words of heads of files",
    "core/wall/restitution.py": "sources of the models",
    "app/terminal/system_libraries.py": "commands of systems",
    "packaging/platforms.py": "names of systems, for the documents",
    "run.py": "what a file of the environment holds",
}
"""Files with literals of three words that nobody reads, and what they are."""


LOAD_KINDS = next(entry for entry in fields(Load) if entry.name == "kind").metadata["names"]
ENTRIES = {cls.__name__.lower(): {entry.name: entry for entry in fields(cls)} for cls in (*sections().values(), Case)}
"""Section -> key -> its description."""

PARTS = (".caption", ".tip", ".help", ".column")
"""What the catalogue says of a key besides its word and its choices."""


def calls(source):
    """(name of the function, call) of every call."""
    for node in nodes_of(source):
        if isinstance(node, ast.Call):
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            yield name, node


def docstrings(source):
    """Expressions that are no value of anything: docstrings, and those below a constant."""
    return {
        id(node.value)
        for node in nodes_of(source)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    }


def placeholders(text):
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}


def test_that_every_file_of_translations_is_a_group():
    assert sorted(FOLDER.iterdir()) == sorted(FOLDER / f"{group}.json" for group in GROUPS)


@pytest.mark.parametrize("group", GROUPS)
def test_that_a_file_of_translations_is_written_in_one_way(group):
    """Each code once, English before Italian, two spaces a level: a change is a line, whoever makes it."""
    text = (FOLDER / f"{group}.json").read_text(encoding="utf-8")
    texts = json.loads(text)
    assert text == json.dumps(texts, indent=2, ensure_ascii=False) + "\n"
    assert all(isinstance(entry, str) or list(entry) == ["en", "it"] for entry in texts.values())


@pytest.mark.parametrize("content", [None, "", "[]", '{"a": 1}', '{"a": {"en": "A"}}', '{"a": "A",}', b"\xff"])
def test_that_a_missing_or_damaged_file_of_translations_stops_the_program(tmp_path, content):
    """No error of the input: what refuses a file or a case does not take it for one."""
    if content is not None:
        (tmp_path / "word.json").write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(RuntimeError, match=r"word\.json"):
        Catalogue(tmp_path)["word"]
    with pytest.raises(KeyError):
        Catalogue(tmp_path)["no such group"]


def test_that_a_group_is_read_when_it_is_first_asked_for(tmp_path):
    (tmp_path / "word.json").write_text('{"stable": {"en": ["st", "able"], "it": "stabile"}}', encoding="utf-8")
    (tmp_path / "window.json").write_text('{"Check": "Verifica"}', encoding="utf-8")
    texts = Catalogue(tmp_path)
    assert texts["word"] == {"stable": ("stable", "stabile")}
    assert texts["window"] == {"Check": ("Check", "Verifica")}
    assert texts["word"] is texts["word"]
    assert set(texts.known) == {"word", "window"}


@pytest.mark.parametrize("group", CATALOGUE)
def test_that_both_languages_name_the_same_values(group):
    for code, (english, italian) in CATALOGUE[group].items():
        assert (english and italian) or code == "nothing", (group, code)
        assert placeholders(english) == placeholders(italian), (group, code)


@pytest.mark.shows("window.language")
def test_that_a_sentence_in_italian_is_not_the_english_one():
    for group, texts in CATALOGUE.items():
        for code, (english, italian) in texts.items():
            if WORDS.search(english):
                assert english != italian, (group, code)


def test_that_every_code_that_is_used_exists_and_every_error_is_used():
    used = set()
    for path in SOURCES:
        for name, call in calls(path):
            first = call.args[0] if call.args else None
            if name in ("InputError", "RecordError", "OutputError") and isinstance(first, ast.Constant):
                assert first.value in CATALOGUE["error"], (path.name, first.value)
                used.add(first.value)
            elif name in SPOKEN and isinstance(first, ast.Constant) and isinstance(first.value, str):
                assert first.value in CATALOGUE[SPOKEN[name]], (path.name, first.value)
            elif name in ("sentence", "localized") and all(isinstance(a, ast.Constant) for a in call.args[:2]):
                group, code = (a.value for a in call.args[:2])
                assert code in CATALOGUE[group], (path.name, code)
    chosen = {"no_unit", "no_time_step_s", "code_needs", "code_does_not_take", "not_accepted"}
    chosen |= {code for _, _, code in BEGINNINGS}
    assert set(CATALOGUE["error"]) - used <= chosen


def test_that_every_text_of_the_catalogue_is_used():
    """By a literal of the program, or by one of its codes: checks, verdicts, statuses, kinds."""
    literals = {
        node.value
        for path in SOURCES
        for node in nodes_of(path)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }
    sides = {f"{word}_{side}" for word in ("confidence", "dynamic") for side in ("demand", "capacity")}
    sides |= {"choice_rigid", "choice_floors", "choice_base"}
    sides |= {f"{one.key}_why" for one in cases_of(SUBJECTS)}
    sides |= {
        f"choice_{name}"
        for keys in ENTRIES.values()
        for entry in keys.values()
        for name in entry.metadata.get("names", ())
    }
    sides |= {f"section_{entry.name}" for entry in fields(Case)}
    sides |= {f"work_{extra}" for extra in PACKAGES}
    sides |= {key for keys in ENTRIES.values() for key in keys}
    sides |= {f"by_{label}" for label in (*CHECKS, "linear_sld")}
    sides |= {f"client_{code}" for code in OUTCOMES} | {
        f"evidence_{name}" for name in (*PRESENCE, *STRENGTH, *STATED, "unstated")
    }
    sides |= {f"source_{name}" for name in (GIVEN, DEFAULT, LEFT_OUT, DECLARED)}
    sides |= {f"part_{part}" for part in ("steel", "thread", "anchorage")}
    for group in set(CATALOGUE) - {"error", "key"}:
        unused = {code for code in CATALOGUE[group] if code not in literals | sides}
        assert unused == set(), group


@pytest.mark.shows("window.language")
def test_that_no_sentence_stands_outside_the_catalogue():
    found = []
    for path in SOURCES:
        name = path.relative_to(ROOT).as_posix()
        known = docstrings(path)
        for function, call in calls(path):
            if function in (*SPOKEN, "sheet"):
                known |= {id(node) for a in call.args for node in ast.walk(a)}
        for node in nodes_of(path):
            text = node.value if isinstance(node, ast.Constant) else None
            described = name.startswith("core/derivation/") and text in CATALOGUE["report"]
            in_catalogue = text in CATALOGUE["terminal"] or described
            if isinstance(text, str) and not in_catalogue and id(node) not in known and WORDS.search(text):
                found.append((name, text[:60]))
    assert [(name, text) for name, text in found if name not in OF_NO_SENTENCE] == []
    assert {name for name, _ in found} == set(OF_NO_SENTENCE)


def test_that_an_error_is_data_with_a_sentence_in_each_language():
    wall = {"name": "none", "height_m": 70, "thickness_m": 0.3, "mechanism": "two_sided"}
    with pytest.raises(InputError) as caught:
        parse_case({"wall": [wall]})
    error = caught.value
    assert (error.code, error.key, error.wall) == ("not_accepted", "height_m", "none")
    assert str(error) == 'wall "none": height_m = 70 is not accepted: from 0.1 to 60 m'
    assert error.text("it") == 'parete "none": height_m = 70 non è ammesso: da 0.1 a 60 m'


def test_that_the_window_says_its_own_names_and_units():
    form = FormNames(
        {"thickness_m": "Thickness t", "[demand]": "Demand", "q_step": "Step"}, {"thickness_m": (100.0, "cm")}
    )
    accepted = sentence("accepted", "from", low=0.005, high=20.0, unit=" m")
    error = InputError(
        "not_accepted",
        place=(place("wall", name="thickness_m"),),
        key="thickness_m",
        value="83.0",
        found=83.0,
        accepted=accepted,
    )
    assert error.text("en", form) == ('wall "thickness_m": Thickness t = 8300 cm is not accepted: from 0.5 to 2000 cm')
    assert error.accepted_text("it", form) == "da 0,5 a 2000 cm"
    assert InputError("two_spectra", place=(section("[demand]"),)).text("en", form).startswith("Demand: ")
    quantity = Quantity("thickness_m", 0.3)
    assert sentence("place", "row", n=quantity).text("en", form) == "row 30 cm"
    assert sentence("place", "row", n=(Key("q_step"), Key("b"))).text("en", form) == "row Step, b"


def test_that_a_place_is_said_once_from_the_outside_in():
    error = InputError("no_wall", section=Key("[[wall]]")).at(place("row", n=3)).at("a.toml").at("a.toml")
    assert str(error) == "a.toml: row 3: no [[wall]]: a case needs at least one wall"


def test_that_a_value_nobody_gave_is_an_error_of_the_program():
    with pytest.raises(KeyError):
        localized("window", "{path} already exists. Overwrite it?", "it")
    with pytest.raises(KeyError):
        sentence("window", "no such words")


def test_that_no_text_says_safe():
    for code in ("verdict", "reason", "added"):
        for english, italian in CATALOGUE[code].values():
            assert "safe" not in english.lower() and "sicura" not in italian.lower()


def test_that_every_key_of_a_case_has_a_word():
    for name, keys in ENTRIES.items():
        assert name == "case" or set(keys) <= set(CATALOGUE["key"]), name


def test_that_the_catalogue_says_nothing_of_a_key_that_is_none():
    """Of a key, its caption, tip, help, column, or one of its choices; the ends of a law are keys in a key, and what a
    document shows has its word."""
    shown = {f"{key}{end}" for key in (*evidence_keys(WALL), *evidence_keys(DEMAND)) for end in ("", ".help")}
    for code in set(CATALOGUE["key"]) - {"elastic_limit", "plateau_end", "evidence.columns"} - shown:
        name, _, choice = code.partition("=")
        part, _, key = name.removesuffix(next((end for end in PARTS if name.endswith(end)), "")).rpartition(".")
        of_name = [keys[key] for section, keys in ENTRIES.items() if part in ("", section) and key in keys]
        assert of_name, code
        assert not choice or any(choice in entry.metadata.get("names", ()) for entry in of_name), code


def test_that_a_field_has_a_caption_of_its_own_only_where_it_is_not_its_word():
    known = CATALOGUE["key"]
    for code, captions in known.items():
        if code.endswith(".caption") and code.count(".") == 1:
            assert captions != tuple(map(capital, known[code.removesuffix(".caption")])), code


def test_that_every_kind_of_load_has_its_words():
    for kind in LOAD_KINDS:
        assert f"choice_{kind}" in CATALOGUE["word"], kind
        assert kind in wall_columns.LOAD_KINDS.values()
        for words, said in zip(CATALOGUE["word"][f"choice_{kind}"], CATALOGUE["key"]["load.kind.help"], strict=True):
            assert words in said, kind


@pytest.mark.parametrize(
    ("text", "stands"),
    [
        ("ζ {zeta:.2f} per {wall}", True),
        ("ζ {zeta:.0f} per {wall}", False),
        ("ζ {zeta} per {wall}", False),
        ("ζ {zeta:.2f}", False),
        ("ζ {zeta:.2f} per {wall!r}", False),
        ("ζ {zeta:.2f} per {wall} {more}", False),
        ("ζ {zeta:.2f} per {wall", False),
        (0.69, False),
    ],
)
def test_that_a_translation_with_other_placeholders_or_formats_is_english(text, stands):
    """0.69 without its decimals would be read as 1."""
    english = "ζ {zeta:.2f} of {wall}"
    assert in_its_place(text, english) == (text if stands else english)
    assert all(
        in_its_place(italian, plain) == italian for group in CATALOGUE for plain, italian in CATALOGUE[group].values()
    )
