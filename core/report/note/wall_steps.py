"""Steps of the note, of the demand and of a wall: what core/derivation describes, in the form of an Italian note, as
"α0 = t/H = 0.90/12.50 = 0.0720". Each names the cell of the sheet Check that has the same as a live formula.
"""

import ast
from dataclasses import replace

from core.derivation import site
from core.derivation import wall as of_wall
from core.derivation.checks import tr_c_longer
from core.derivation.geometry import geometry
from core.derivation.line import FULL, Columns, Line, Section
from core.report.derivation_text import DerivationText
from core.report.note.parts import Step
from core.report.words import Words
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
        """(title, steps) of what the check that decides about a wall follows from, and what the wall withstands: with
        every section that a line of these needs."""
        governing = wall.required_assessment.verdict.governing or ""
        checks = of_wall.sections_by_check(self.result, wall)
        deciding = {name for name in checks if governing.startswith(name)}
        # histories are of the block: alpha_0, e*, a_0* are of the checks of the clauses
        chain = governing != "dynamic" or wall.wall.bends
        sections = [(geometry(wall), True), (of_wall.chain(wall), chain)]
        sections += [(section, name in deciding) for name, section in checks.items()]
        withstands = of_wall.risk(self.result, wall)
        lines = [line for line in withstands.lines if isinstance(line, Columns) or line.of is not tr_c_longer]
        return self._titled(_with_needed([*sections, (replace(withstands, lines=lines), True)]))

    def _titled(self, sections: list[Section]) -> list[tuple[str, list[Step]]]:
        return [(section.title, self.steps(section)) for section in sections]


def _with_needed(sections: list[tuple[Section, bool]]) -> list[Section]:
    """The sections that are wanted, with those that give what their lines need."""
    lines = [[line for line in section.lines if not isinstance(line, Columns)] for section, _ in sections]
    names = [{line.of.name for line in of_section} for of_section in lines]
    needs = [
        {name for line in of_section for of in (line.quantity, line.shown_by) if of for name in of.needs}
        for of_section in lines
    ]
    chosen = {k for k, (_, wanted) in enumerate(sections) if wanted}
    while True:
        missing = set().union(*(needs[k] for k in chosen)) - set().union(*(names[k] for k in chosen))
        more = {k for k, given in enumerate(names) if given & missing} - chosen
        if not more:
            return [sections[k][0] for k in sorted(chosen)]
        chosen |= more
