"""Parts of the sentences of errors."""

PLACES = {
    "wall": ('wall "{name}"', 'parete "{name}"'),
    "record": ("record {n}", "accelerogramma {n}"),
    "grid": ("grid {n}", "griglia {n}"),
    "group": ('group "{name}"', 'gruppo "{name}"'),
    "row": ("row {n}", "riga {n}"),
    "cell": ("row {n}, {key}", "riga {n}, {key}"),
    "sheet": ('sheet "{name}"', 'foglio "{name}"'),
    "load": ("load {n}", "carico {n}"),
    "line": ("line {n}", "riga {n}"),
    "section": ("{name}", "{name}"),
}
"""Where an error is: code -> (English, Italian)."""

ACCEPTED = {
    "from": ("from {low:g} to {high:g}{unit}", "da {low:g} a {high:g}{unit}"),
    "above": ("above {low:g} to {high:g}{unit}", "sopra {low:g} fino a {high:g}{unit}"),
    "whole": ("a whole number from {low:g} to {high:g}{unit}", "un numero intero da {low:g} a {high:g}{unit}"),
    "channel_key": ("the name of a channel, or its number from 1", "il nome di un canale, o il suo numero da 1"),
    "channel": ('"{name}"', '"{name}"'),
    "more_channels": ("{n} more", "altri {n}"),
    "vertical_channel": ('"{name}" (vertical)', '"{name}" (verticale)'),
    "one_of": ("one of {names}", "uno fra {names}"),
    "law": (
        "one of {names}, or {{ elastic_limit = ..., plateau_end = ... }}",
        "uno fra {names}, oppure {{ elastic_limit = ..., plateau_end = ... }}",
    ),
    "list": ("a list in brackets, each {items}", "un elenco fra parentesi quadre, ciascuno {items}"),
    "tables": ("one or more tables [[{name}]]", "una o più tabelle [[{name}]]"),
    "section": ("a table [{of}.{name}]", "una tabella [{of}.{name}]"),
    "hinges": (
        '"{floors}", "{base}" for the one at the base alone, or heights above the base in m, [3.0, 6.0]',
        '"{floors}", "{base}" per la sola cerniera alla base, o quote dalla base in m, [3.0, 6.0]',
    ),
    "flag": ("true or false", "true o false"),
    "table": ("a table [demand.spectrum]", "una tabella [demand.spectrum]"),
    "periods": (
        "two periods [low, high] in s, rising, from {low:g} to {high:g}",
        "due periodi [minimo, massimo] in s, crescenti, da {low:g} a {high:g}",
    ),
    "path": ("the name of a file in quotes", "il nome di un file fra virgolette"),
    "text": (
        "text in quotes, up to {most} characters, without control characters",
        "testo fra virgolette, fino a {most} caratteri, senza caratteri di controllo",
    ),
    "merged_cells": ("merged cells {cells}", "celle unite {cells}"),
    "formula_cells": ("formulas {cells}", "formule {cells}"),
    "uncomputed_cells": (
        "formulas without values {cells} (Excel computes them when it saves the workbook)",
        "formule senza valore {cells} (Excel le calcola quando salva la cartella di lavoro)",
    ),
    "error_cells": ("errors {cells}", "errori {cells}"),
    "not_zero": ("other than 0", "diverso da 0"),
    "positive": ("above 0", "maggiore di 0"),
    "degrees": ("between 0 and 90 degrees", "fra 0 e 90 gradi"),
    "above_radius": ("above R^2 = {square:.4g} m2", "maggiore di R^2 = {square:.4g} m2"),
    "radians": ("0 to pi/2 rad", "da 0 a pi/2 rad"),
    "given": ("given", "dato"),
    "missing": ("missing", "mancante"),
    "none": ("none", "nessuno"),
    "empty": ("empty", "vuoto"),
    "without_line_end": ("without a line end", "senza fine riga"),
    "shorter_than_above": ("not as long as the numbers above it", "meno lungo dei numeri sopra"),
    "write_all_digits": ("write it with as many digits", "scriverlo con altrettante cifre"),
    "end_last_line": ("end the last line with a line break", "terminare l'ultima riga con un a capo"),
}
"""What is accepted instead, and other parts: code -> (English, Italian)."""
