"""Summary, Input, Records, Results and Method sheets."""

import math
import platform

from openpyxl.styles import PatternFill

from core.case import Case
from core.code_check import TITLE
from core.report.cells import (
    ACCELERATION,
    BAD,
    GOOD,
    INK,
    QUIET,
    RATIO,
    WHOLE,
    Book,
    header,
    heighten,
    number,
    paragraph,
    rule,
    text,
    title,
)  # fmt: skip
from core.report.method_text import paragraphs
from core.restitution import MODELS
from core.results import StudyResult, WallResult
from core.units import CM, G
from core.version import NAME, VERSION, commit

SUMMARY_WALLS = 24
"""Walls listed on the Summary, which is one page; the rest are on Results and Check."""


def mechanism_word(book: Book, mechanism: str) -> str:
    return {
        "two_sided": book.say("two-sided", "su due lati"),
        "one_sided": book.say("one-sided", "su un lato"),
        "both": book.say("both", "entrambi"),
    }[mechanism]


def rule_word(book: Book, rule_name: str | None) -> str:
    return {
        None: "–",
        "mean": book.say("mean", "media"),
        "minimum": book.say("minimum", "minimo"),
        "too_few": book.say("minimum, too few", "minimo, troppo pochi"),
        "incomplete": book.say("incomplete", "incompleto"),
    }[rule_name]


def status_word(book: Book, status: str) -> str:
    return {
        "collapse_found": book.say("collapse found", "collasso trovato"),
        "no_collapse_found": book.say("no collapse found", "nessun collasso"),
        "impact_limit": book.say("impact limit", "limite di urti"),
    }[status]


def summary(book: Book, result: StudyResult) -> None:
    """One A4 page: title block, demand, one row a wall, warnings."""
    say, report, case = book.say, result.case.report, result.case
    widths = [20, 11, 7, 7, 7, 8, 20, 8, 8, 8, 9, 9, 9]
    sheet = book.sheet("Summary", "Sintesi", widths, landscape=True)
    sheet.page_setup.fitToHeight = 1
    last = len(widths)
    title(sheet, 1, case.title, 16)
    paragraph(sheet, 2, say(
        "Out-of-plane overturning of masonry walls: incremental dynamic analysis of the rocking block "
        "and the force reduction factor q (Coccia, Di Carlo, Imperatore 2016)",
        "Ribaltamento fuori piano di pareti in muratura: analisi dinamica incrementale del blocco "
        "oscillante e fattore di struttura q (Coccia, Di Carlo, Imperatore 2016)"), last, 150,
        color=QUIET)  # fmt: skip
    row = 3
    block = [
        (say("Client", "Committente"), report.client), (say("Site", "Luogo"), report.site),
        (say("Project", "Progetto"), report.project), (say("Author", "Autore"), report.author),
        (say("Revision", "Revisione"), report.revision), (say("Date", "Data"), report.date),
    ]  # fmt: skip
    started = result.started_utc[:16].replace("T", " ")
    block = [(label, value) for label, value in block if value]
    block.append((say("Program", "Programma"), f"{NAME} {VERSION}, {started} UTC"))
    for label, value in block:
        text(sheet, row, 1, label, color=QUIET)
        text(sheet, row, 2, value)
        row += 1
    row = _demand_line(book, sheet, result, row + 1, last)
    header(sheet, row, [
        say("Wall", "Parete"), say("Mechanism", "Meccanismo"), "H [m]", "t [m]", "α [°]",
        "a_RM [g]", say("Rule of the set", "Regola dell'insieme"), "q", say("q minimum", "q minimo"),
        say("q robust", "q robusto"), "q Eq. 15/16", say("Eq. 9\nq code", "Eq. 9\nq norma"),
        say("Eq. 9\nq histories", "Eq. 9\nq storie")])  # fmt: skip
    for wall in result.walls[:SUMMARY_WALLS]:
        row += 1
        _summary_row(book, sheet, row, wall)
        rule(sheet, row, 1, last)
    row += 2
    if len(result.walls) > SUMMARY_WALLS:
        row = paragraph(sheet, row, say(
            f"{len(result.walls) - SUMMARY_WALLS} more walls on the sheets Results and Check.",
            f"Altre {len(result.walls) - SUMMARY_WALLS} pareti nei fogli Risultati e Verifica."),
            last, 150)  # fmt: skip
    row = paragraph(sheet, row, say(
        f"Ratios are those of {TITLE}: a_RM / (S a_g / q), passed from 1.00. They compare a collapse q "
        "with a code value meant for the life-safety limit state: not a verdict on their own.",
        "I rapporti sono quelli della Eq. 9, senza e* e FC: a_RM / (S a_g / q), soddisfatta da 1.00. "
        "Confrontano un q di collasso con un valore di norma per lo stato limite di salvaguardia "
        "della vita: da soli non sono un giudizio."), last, 150, italic=True, color=QUIET)  # fmt: skip
    _warnings(book, sheet, result, row + 1, last)


def _demand_line(book: Book, sheet, result: StudyResult, row: int, last: int) -> int:
    demand, say = result.demand, book.say
    if demand is None:
        line = say("No demand given: no check.", "Nessuna domanda assegnata: nessuna verifica.")
    else:
        line = (
            f"{say('Demand', 'Domanda')} {demand.limit_state}: a_g {demand.ag / G:.3f} g, "
            f"S {demand.soil_factor:.2f}, S a_g {demand.pga / G:.3f} g"
        )
        if demand.intensity:
            source = {
                "given": say("given", "assegnata"),
                "records_scaled": say("from the records", "dai record"),
            }[demand.intensity_source]
            line += f", SI {demand.intensity / CM:.1f} cm ({source})"
    return paragraph(sheet, row, line, last, 150, bold=True)


def _summary_row(book: Book, sheet, row: int, wall: WallResult) -> None:
    text(sheet, row, 1, wall.name, wrap=True)
    heighten(sheet, row, (wall.name, 20))
    text(sheet, row, 2, mechanism_word(book, wall.mechanism))
    number(sheet, row, 3, wall.height, RATIO)
    number(sheet, row, 4, wall.thickness, RATIO)
    number(sheet, row, 5, math.degrees(wall.block.slenderness), RATIO)
    number(sheet, row, 6, wall.block.threshold_acceleration / G, ACCELERATION)
    text(sheet, row, 7, rule_word(book, wall.set_rule), align="center")
    number(sheet, row, 8, wall.q_set, RATIO, bold=True)
    number(sheet, row, 9, wall.q_min, RATIO)
    number(sheet, row, 10, wall.q_robust_set, RATIO)
    number(sheet, row, 11, wall.closed_form_q, RATIO)
    checks = dict(zip((12, 13), (wall.code_check[0], wall.code_check[2]), strict=True)) if (
        wall.code_check) else {12: None, 13: None}  # fmt: skip
    for column, check in checks.items():
        color = INK if check is None else GOOD if check.passed else BAD
        number(sheet, row, column, check.ratio if check else None, RATIO, color=color,
               bold=check is not None)  # fmt: skip


def _warnings(book: Book, sheet, result: StudyResult, row: int, last: int, most: int = 14) -> None:
    """Each warning once, with the walls or records it belongs to."""
    owners: dict[str, list[str]] = {}
    for owner in (*result.walls, *result.motions):
        for warning in owner.warnings:
            name = owner.name
            if isinstance(owner, WallResult):
                name += f" ({mechanism_word(book, owner.mechanism)})"
            owners.setdefault(warning.text(book.language), []).append(name)
    text(sheet, row, 1, book.say("Warnings", "Avvertenze"), bold=True)
    row += 1
    if not owners:
        text(sheet, row, 1, book.say("none", "nessuna"))
    for line, names in list(owners.items())[:most]:
        who = ", ".join(names[:4]) + (f" +{len(names) - 4}" if len(names) > 4 else "")
        row = paragraph(sheet, row, f"• {line}  [{who}]", last, 140)
    if len(owners) > most:
        paragraph(sheet, row, book.say(
            f"{len(owners) - most} more on the sheets Records and Check.",
            f"Altre {len(owners) - most} nei fogli Accelerogrammi e Verifica."), last, 140)  # fmt: skip


def inputs(book: Book, result: StudyResult) -> None:
    """Echo of the case; what the user did not write is marked as default."""
    say, case = book.say, result.case
    sheet = book.sheet("Input", "Dati", [26, 30, 44, 16])
    title(sheet, 1, say("Input as read", "Dati letti"))
    text(sheet, 2, 1, f"SHA-256 {case.sha256}", color=QUIET, size=8)
    header(
        sheet,
        4,
        [say("Section", "Sezione"), say("Key", "Chiave"), say("Value", "Valore"), ""],
        1,
        18,
    )
    row = 5
    given = case.given
    text(sheet, row, 2, "title")
    text(sheet, row, 3, case.title, wrap=True)
    heighten(sheet, row, (case.title, 44))
    row += 1
    for section, index, place, values in _sections(case):
        for key, value in values.items():
            if value is None or value == "":
                continue
            text(sheet, row, 1, place)
            text(sheet, row, 2, key)
            if isinstance(value, dict):
                value = ", ".join(f"{name} = {end:g}" for name, end in value.items())
            if isinstance(value, (int, float)):
                number(sheet, row, 3, value, "General", align="left")
            else:
                text(sheet, row, 3, value, wrap=True)
                heighten(sheet, row, (str(value), 44))
            if (section, index, key) not in given:
                text(sheet, row, 4, say("default", "predefinito"), color=QUIET, italic=True)
            rule(sheet, row, 1, 4)
            row += 1
    sheet.freeze_panes = "A5"
    sheet.print_title_rows = "4:4"


def _sections(case: Case):
    content = case.as_dict()
    for section in ("report", "wall", "record", "analysis", "demand"):
        items = content[section]
        if isinstance(items, dict):
            yield section, 0, f"[{section}]", items
        else:
            for index, item in enumerate(items or ()):
                yield section, index, f"[[{section}]] {index + 1}", item


def records(book: Book, result: StudyResult) -> None:
    """The ground motions as read, with their intensity measures and hashes."""
    say = book.say
    widths = [24, 34, 12, 9, 9, 8, 9, 9, 9, 9, 9, 9, 20]
    sheet = book.sheet("Records", "Accelerogrammi", widths, landscape=True)
    title(sheet, 1, say("Ground motions", "Accelerogrammi"))
    header(sheet, 3, [
        say("Record", "Accelerogramma"), "File", say("Format", "Formato"), "Δt [s]",
        say("Samples", "Campioni"), say("Unit", "Unità"), "PGA [g]", "PGV [cm/s]", "PGD [cm]",
        "Arias [m/s]", "D5-95 [s]", "SI [cm]", "SHA-256"], 1, 32)  # fmt: skip
    row = 4
    for motion in result.motions:
        text(sheet, row, 1, motion.name, wrap=True)
        text(sheet, row, 2, motion.file, wrap=True)
        heighten(sheet, row, (motion.name, 24), (motion.file, 34))
        text(sheet, row, 3, motion.format)
        for column, value, shape in (
            (4, motion.time_step, "0.00000"), (5, motion.acceleration.size, WHOLE),
            (7, motion.pga / G, ACCELERATION), (8, motion.pgv / CM, RATIO),
            (9, motion.pgd / CM, RATIO), (10, motion.arias, ACCELERATION),
            (11, motion.duration_5_95, RATIO), (12, motion.housner_intensity / CM, RATIO),
        ):  # fmt: skip
            number(sheet, row, column, value, shape)
        text(sheet, row, 6, motion.unit, align="center")
        text(sheet, row, 13, motion.file_sha256[:16], size=8, color=QUIET)
        rule(sheet, row, 1, len(widths))
        row += 1
    row += 1
    row = paragraph(sheet, row, say(
        "SI: integral of the 5 % pseudo-velocity from 0.1 to 2.5 s (Eq. 11), not divided by 2.4. PGV and "
        "PGD without baseline step: no meaning for uncorrected records. Nothing trimmed or resampled. "
        "SHA-256: first 16 digits of the file's hash; the whole one is in the JSON.",
        "SI: integrale della pseudo-velocità al 5 % da 0.1 a 2.5 s (Eq. 11), non diviso per 2.4. PGV e "
        "PGD senza correzione della linea di base: senza significato per record non corretti. Nessun "
        "taglio o ricampionamento. SHA-256: prime 16 cifre; per intero nel JSON."), len(widths), 150,
        color=QUIET)  # fmt: skip
    for motion in result.motions:
        for warning in motion.warnings:
            line = f"• {motion.name}: {warning.text(book.language)}"
            row = paragraph(sheet, row, line, len(widths), 150)
    sheet.freeze_panes = "A4"
    sheet.print_title_rows = "3:3"


def results(book: Book, result: StudyResult) -> None:
    """One row for each wall, record and sign."""
    say = book.say
    widths = [20, 11, 24, 7, 16, 8, 8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9]
    sheet = book.sheet("Results", "Risultati", widths, landscape=True)
    step = 100 * result.search.q_step
    title(sheet, 1, say(
        f"Incremental dynamic analysis: grid step {step:g} %, method {result.method.name} "
        f"(order {result.method.order})",
        f"Analisi dinamica incrementale: passo {step:g} %, metodo {result.method.name} "
        f"(ordine {result.method.order})"))  # fmt: skip
    header(sheet, 3, [
        say("Wall", "Parete"), say("Mechanism", "Meccanismo"), say("Record", "Accelerogramma"),
        say("Sign", "Segno"), say("Status", "Esito"), "q", say("bracket low", "da"),
        say("bracket high", "a"), "q SLV", "q SLC", say("q robust", "q robusto"),
        say("Scale C", "Scala C"), "q_eff", say("last survival", "ultima sopravv."),
        say("survived share", "quota sopravv."), say("windows", "finestre"),
        say("analyses", "analisi"), say("unknown points", "punti ignoti"),
        say("Eq. 7 clamped", "Eq. 7 limitata")], 1, 44)  # fmt: skip
    row = 3
    for wall in result.walls:
        for run in wall.runs:
            row += 1
            ida = run.ida
            text(sheet, row, 1, wall.name, wrap=True)
            text(sheet, row, 2, mechanism_word(book, wall.mechanism))
            text(sheet, row, 3, run.record, wrap=True)
            heighten(sheet, row, (wall.name, 20), (run.record, 24))
            text(sheet, row, 4, "+" if run.polarity > 0 else "−", align="center")
            text(sheet, row, 5, status_word(book, ida.status), color=INK if ida.q else BAD)
            low, high = ida.bracket or (None, None)
            for column, value, shape in (
                (6, ida.q, RATIO), (7, low, "0.0000"), (8, high, "0.0000"), (9, ida.q_slv, RATIO),
                (10, ida.q_slc, RATIO), (11, ida.q_robust, RATIO), (12, run.scale, ACCELERATION),
                (13, run.q_eff, RATIO), (14, ida.q_last_survival, RATIO),
                (15, ida.survived_fraction, RATIO), (16, len(ida.survival_windows), WHOLE),
                (17, ida.analyses, WHOLE), (18, ida.impact_limited, WHOLE), (19, ida.clamped, WHOLE),
            ):  # fmt: skip
                number(sheet, row, column, value, shape, bold=column == 6 and value is not None)
            rule(sheet, row, 1, len(widths))
    if row > 3:
        sheet.auto_filter.ref = f"A3:S{row}"
    sheet.freeze_panes = "D4"
    sheet.print_title_rows = "3:3"
    paragraph(sheet, row + 2, say(
        f"q, q SLV, q SLC: first collapse, first peak at 0.40 and 0.60 alpha on the grid, bisected to "
        f"1e-4. Survival, share and windows are of the map and depend on the grid step ({step:g} %).",
        f"q, q SLV, q SLC: primo collasso e prima rotazione pari a 0.40 e 0.60 alpha sulla griglia, "
        f"bisezione a 1e-4. Sopravvivenza, quota e finestre dipendono dal passo ({step:g} %)."),
        len(widths), 170, color=QUIET)  # fmt: skip


def method(book: Book, result: StudyResult) -> None:
    """Equations, versions, hashes, range of use, misprints, what is left out."""
    say = book.say
    sheet = book.sheet("Method", "Metodo", [30, 75])
    title(sheet, 1, say("Method, range of use, provenance", "Metodo, campo d'impiego, provenienza"))
    row = 3
    settings = result.search
    facts = [
        (say("Program", "Programma"), f"{NAME} {VERSION} {commit()[:12]}"),
        ("Python", f"{platform.python_version()}, {platform.system()} {platform.machine()}"),
        (say("Case SHA-256", "SHA-256 del caso"), result.case.sha256),
        (say("Method", "Metodo"), f"{result.method.name}, {say('order', 'ordine')} {result.method.order}"),
        (say("Search", "Ricerca"), f"q_step {settings.q_step:g}, q_limit {settings.q_limit:g}, map_span "
         f"{settings.map_span:g}, robust_window {settings.robust_window:g}"),
        (say("Sign of the records", "Segno dei record"), {
            "both": say("both", "entrambi"), "as_recorded": say("as recorded", "come registrato"),
            "reversed": say("reversed", "invertito")}[result.case.analysis.polarity]),
    ]  # fmt: skip
    for wall in result.walls:
        ratio = f"{wall.restitution.model} ({MODELS[wall.restitution.model]})"
        label = f"{wall.name}, {mechanism_word(book, wall.mechanism)}"
        law = say("rigid", "rigida")
        if not wall.law.is_rigid:
            ends = f"D1 {wall.law.elastic_limit:g}, D2 {wall.law.plateau_end:g}"
            law = f"{say('trilinear', 'trilineare')} {ends}"
        facts.append((label, f"{ratio}, e = {wall.restitution.ratio_at_rest:.4f}; {law}"))
    if len(facts) > 46:
        facts = facts[:46] + [("…", say("see Input and the JSON", "vedi Dati e il JSON"))]
    for label, value in facts:
        text(sheet, row, 1, label, bold=True, wrap=True)
        text(sheet, row, 2, value, wrap=True)
        longest = max(len(label) / 30, len(value) / 78)
        sheet.row_dimensions[row].height = 14 * math.ceil(longest)
        rule(sheet, row, 1, 2)
        row += 1
    row += 1
    for label, body in paragraphs(book.language):
        text(sheet, row, 1, label, bold=True, wrap=True)
        text(sheet, row, 2, body, wrap=True)
        lines = max(math.ceil(len(body) / 80), math.ceil(len(label) / 28))
        sheet.row_dimensions[row].height = 13.8 * lines + 4
        sheet.cell(row, 1).fill = PatternFill("solid", fgColor="F2F5F8")
        rule(sheet, row, 1, 2)
        row += 1
