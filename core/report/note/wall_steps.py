"""Steps of the note, of the demand and of a wall: what core/derivation describes, in the form of an Italian note, as
"α0 = t/H = 0.90/12.50 = 0.0720". Each names the cell of the sheet Check that has the same as a live formula.
"""

import ast
from dataclasses import replace

from core.derivation import site
from core.derivation import wall as of_wall
from core.derivation.geometry import geometry
from core.derivation.line import FULL, Columns, Line, Section
from core.report.derivation_text import DerivationText
from core.report.note.parts import Step
from core.report.note.words import Words
from core.study.results import StudyResult, WallResult

MAX_FORMULA = 150
"""Characters of a formula that a note holds: the closed form of SI, which decides nothing, has more."""


class Derivations:
    """The sections of a wall one after the other. prefix : what the names of its cells begin with"""

    def __init__(self, result: StudyResult, words: Words, prefix: str = ""):
        self.result, self.prefix = result, prefix
        self.phrases = DerivationText(result, words.language)
        self.demand = self.steps(site.demand_section(result), "")

    def steps(self, section: Section, prefix: str | None = None) -> list[Step]:
        """Steps of the lines, all of them: each number of the note follows from numbers of the note."""
        prefix = self.prefix if prefix is None else prefix
        self.phrases.enter(section)
        steps = []
        for line in section.lines:
            if not isinstance(line, Columns):
                of, note = line.shown_by or line.of, FULL if self._in_numbers(line) else line.note
                steps.append(self._step(replace(line, of=of, note=note), prefix))
        return steps

    def _in_numbers(self, line: Line) -> bool:
        """Whether each number of the formula of a line stands above it: those of loads and modes stand in tables."""
        of = line.shown_by or line.quantity
        if of is None or isinstance(of.tree, ast.Name):
            return False
        return all(name in self.phrases.shown for name in of.needs)

    def _step(self, line: Line, prefix: str) -> Step:
        name = prefix + line.of.name
        said = self.phrases.of(line, name, prefix + line.run_name)
        result, long = self.phrases.read(line.value), len(said.symbols) > MAX_FORMULA
        return Step(
            said.symbol,
            result,
            f".{line.of.digits}f",
            said.unit,
            said.clause,
            "" if long else said.symbols,
            [] if long else said.numbers,
            name,
            said.label,
            line.quantity,
            dict(self.phrases.symbols),
            dict(self.phrases.shown),
        )

    def wall(self, wall: WallResult) -> list[tuple[str, list[Step]]]:
        """(title, steps) of the sections of a wall that has a kinematic mechanism, or of its block alone."""
        sections = [geometry(wall)]
        if wall.assessment and wall.required_assessment.kinematic:
            sections += of_wall.checks_of(self.result, wall)
        return self._titled(sections)

    def deciding(self, wall: WallResult) -> list[tuple[str, list[Step]]]:
        """(title, steps) of what the check that decides about a wall follows from, and what the wall withstands."""
        governing = wall.required_assessment.verdict.governing or ""
        checks = of_wall.sections_by_check(self.result, wall)
        chosen = next((section for name, section in checks.items() if governing.startswith(name)), None)
        # histories are of the block: alpha_0, e*, a_0* are of the checks of the clauses
        chain = [] if governing == "dynamic" and not wall.wall.bends else [of_wall.chain(wall)]
        between = [] if chosen is None else [chosen]
        return self._titled([geometry(wall), *chain, *between, of_wall.risk(self.result, wall)])

    def _titled(self, sections: list[Section]) -> list[tuple[str, list[Step]]]:
        return [(section.title, self.steps(section)) for section in sections]
