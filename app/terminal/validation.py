"""`--validate --data DIR`: the model against tests on a shake table, in words and as validation.json."""

import json
from pathlib import Path

from app.look.language import terminal
from app.terminal.batch import say
from core import atomic_write
from core.errors import InputError
from core.research.shake_table import AGREE, Found, Score, as_json, compared, read_tests

SEED = 1
"""Seed that draws the halves of the events."""

NAME = "validation.json"


def run(data: Path, output: Path | None) -> int:
    """Compare, say what was found, and write it into a folder where one is named. Raises InputError."""
    if output is not None and (output / NAME).resolve() in {file.resolve() for file in data.iterdir()}:
        raise InputError("would_overwrite", path=output / NAME)
    tests = read_tests(data)
    found = compared(tests, SEED)
    for line in lines(found, len(tests.left_out)):
        say(line)
    if output is not None:
        atomic_write.check_folder(output)
        content = json.dumps(as_json(tests, found, SEED), indent=1, allow_nan=False, ensure_ascii=False) + "\n"
        atomic_write.write({output / NAME: content.encode()})
        say(str(output / NAME))
    return 0


def _words() -> dict[str, str]:
    return {
        "measured": terminal("body as measured"),
        "slenderness": terminal("slenderness fitted"),
        "setback": terminal("setback of the hinges fitted"),
        "restitution": terminal("restitution fitted"),
        "pgv": terminal("threshold of PGV fitted"),
        "distinct_elements": terminal("distinct elements, stiffness chosen"),
    }


def _score(one: Score, name: str) -> str:
    text = terminal(
        "  {name}: right {right:.1f} % ({low:.1f} to {high:.1f}), missed {missed:.0f} %, false {false:.0f} %",
        name=name,
        right=100.0 * one.right,
        low=100.0 * one.interval[0],
        high=100.0 * one.interval[1],
        missed=100.0 * one.missed,
        false=100.0 * one.false,
    )
    if not one.fitted:
        return text
    return text + terminal("; fitted {values}", values=", ".join(str(value) for value in one.fitted))


def lines(found: list[Found], left_out: int) -> list[str]:
    """What was found, in words."""
    words, said = _words(), []
    for one in found:
        said.append(terminal("body {name}: {n} tests", name=one.body.name, n=one.tests))
        said += [_score(score, words[score.method]) for score in one.scores]
        if one.tried:
            said.append(_score(one.tried, terminal("setback of the first body")))
        share, low, high = (100.0 * value for value in one.setback)
        text = "  setback by all its tests: {share:.1f} % of the width ({low:.1f} to {high:.1f})"
        said.append(terminal(text, share=share, low=low, high=high))
        tests, overturned = one.below_rule
        text = "  computed peak 0.1 to 0.4 of the collapse rotation: {n} tests, {overturned} overturned"
        said.append(terminal(text, n=tests, overturned=overturned))
    if left_out:
        text = "left out: {n} tests whose measured PGA is not within {share:.0f} % of the stated one"
        said.append(terminal(text, n=left_out, share=100.0 * AGREE))
    return said
