"""Sentences of errors the user can mend: place, what was found, what is accepted, what to do."""

SENTENCES = {
    "no_case_file": ("there is no such case file", "questo file di caso non esiste"),
    "would_overwrite": (
        "the results would overwrite {path}: rename it or give --output",
        "i risultati coprirebbero {path}: rinominarlo o dare un'altra cartella",
    ),
    "workbook_not_made": (
        "the workbook cannot be made ({reason}): free some space in {folder}, or name another folder in the "
        "variable TMPDIR",
        "la cartella di lavoro non si può produrre ({reason}): liberare spazio in {folder}, o indicare "
        "un'altra cartella nella variabile TMPDIR",
    ),
    "autosave_unreadable": (
        "this autosaved case cannot be read: {reason}",
        "questo caso salvato da solo non si può leggere: {reason}",
    ),
    "folder_not_writable": (
        "the output folder cannot be written ({reason}): name another with --output",
        "la cartella non si può scrivere ({reason}): nominarne un'altra",
    ),
    "file_not_writable": (
        "cannot be written ({reason}): close it if it is open elsewhere, free some space, or take another "
        "folder; what was there is untouched",
        "non si può scrivere ({reason}): chiuderlo se è aperto altrove, liberare spazio o scegliere un'altra "
        "cartella; ciò che c'era è intatto",
    ),
    "two_decimal_marks": (
        "{text!r} has both a point and a comma: write it with one decimal mark and no thousands mark",
        "{text!r} ha punto e virgola insieme: scriverlo con un solo segno decimale e senza separatore delle "
        "migliaia",
    ),
    "not_a_number": ("{text!r} is not a number", "{text!r} non è un numero"),
    "number_too_large": ("{text!r} is too large a number", "{text!r} è un numero troppo grande"),
    "case_not_a_file": (
        "this is not a file and cannot be read: name a case (.toml)",
        "non è un file e non si può leggere: nominare un caso (.toml)",
    ),
    "case_too_large": (
        "{mb:.0f} MB is no case file (up to 2 MB)",
        "{mb:.0f} MB non sono un file di caso (fino a 2 MB)",
    ),
    "unreadable": ("cannot be read: {reason}", "non si può leggere: {reason}"),
    "toml_dotted": (
        "not TOML: a key of more than {parts} parts",
        "non è TOML: una chiave di oltre {parts} parti",
    ),
    "case_not_utf8": (
        "not UTF-8 text: a case file is TOML, see the examples",
        "non è testo UTF-8: un caso è TOML, vedere gli esempi",
    ),
    "not_toml": (
        "not TOML: {reason}; see the examples in resources/cases",
        "non è TOML: {reason}; vedere gli esempi in resources/cases",
    ),
    "strength_gives_setback": (
        "{compressive_strength_mpa} gives the setback of the hinge: it takes {unit_weight_kn_m3} and no "
        "{hinge_setback_m}",
        "{compressive_strength_mpa} dà l'arretramento della cerniera: vuole {unit_weight_kn_m3} e nessun "
        "{hinge_setback_m}",
    ),
    "setback_too_large": (
        "{key}: the hinge setback {setback:.3f} m is not accepted: up to {most:.3f} m, {share:.0f} % of the "
        "thickness",
        "{key}: l'arretramento della cerniera di {setback:.3f} m non è ammesso: fino a {most:.3f} m, il "
        "{share:.0f} % dello spessore",
    ),
    "restitution_one_sided": (
        "restitution {model} is for one_sided walls; for mechanism {asked} take housner, "
        "{sorrentino_experimental}, {costa_upper} or user, or write two walls",
        "la restituzione {model} è per pareti one_sided; per il meccanismo {asked} prendere housner, "
        "{sorrentino_experimental}, {costa_upper} o user, oppure scrivere due pareti",
    ),
    "velocity_ratio_user": (
        '{velocity_ratio} goes with restitution "user" (or with none), and restitution user needs it',
        '{velocity_ratio} va con la restituzione "user" (o con nessuna), e la restituzione user ne ha bisogno',
    ),
    "general_no_setback": (
        "a general block takes no {hinge_setback_m} and no {compressive_strength_mpa}: give {radius_m}, "
        "{slenderness_deg} and {inertia_over_mass_m2} about the hinge itself",
        "un blocco qualsiasi non vuole {hinge_setback_m} né {compressive_strength_mpa}: dare {radius_m}, "
        "{slenderness_deg} e {inertia_over_mass_m2} rispetto alla cerniera stessa",
    ),
    "general_keys": (
        "a general block takes {radius_m}, {slenderness_deg} and {inertia_over_mass_m2} and nothing else; a "
        "rectangular one takes {height_m}",
        "un blocco qualsiasi vuole {radius_m}, {slenderness_deg} e {inertia_over_mass_m2} e nient'altro; uno "
        "rettangolare vuole {height_m}",
    ),
    "general_needs": (
        "a general block needs {radius_m} and {inertia_over_mass_m2}",
        "un blocco qualsiasi vuole {radius_m} e {inertia_over_mass_m2}",
    ),
    "table_rows": (
        "a table of walls has a row of heads (Parete; H; t; Meccanismo), a row of units (; m; cm;) and a row "
        "for each wall",
        "una tabella di pareti ha una riga di intestazioni (Parete; H; t; Meccanismo), una di unità (; m; "
        "cm;) e una per parete",
    ),
    "table_too_large": (
        "more than {rows} rows or {columns} columns",
        "più di {rows} righe o {columns} colonne",
    ),
    "table_not_a_file": (
        "this is not a file: name a table of walls",
        "questo non è un file: nominare una tabella di pareti",
    ),
    "table_too_many_mb": (
        "{mb:.0f} MB is no table of walls (up to 20 MB)",
        "{mb:.0f} MB non è una tabella di pareti (fino a 20 MB)",
    ),
    "no_table": ("there is no such table of walls", "questa tabella di pareti non esiste"),
    "table_no_text": (
        "this is no text: save the table as .xlsx or as CSV UTF-8",
        "questo non è testo: salvare la tabella come .xlsx o CSV UTF-8",
    ),
    "not_a_table": ("not a table: {reason}", "non è una tabella: {reason}"),
    "sheets_hidden": (
        "every sheet is hidden: show the one with the walls",
        "tutti i fogli sono nascosti: mostrare quello con le pareti",
    ),
    "not_a_workbook": (
        "not a workbook Excel could have saved ({reason})",
        "non è una cartella che Excel avrebbe salvato ({reason})",
    ),
    "value_beyond_columns": (
        "there is a value beyond the last column",
        "c'è un valore oltre l'ultima colonna",
    ),
    "unknown_column": (
        "the column {column!r} is not known: Parete, Piano, z, H, t, L, peso specifico, u, meccanismo, "
        "vincolo, note, or a key of [[wall]] ({known})",
        "la colonna {column!r} non è nota: Parete, Piano, z, H, t, L, peso specifico, u, meccanismo, vincolo, "
        "note, o una chiave di [[wall]] ({known})",
    ),
    "column_twice": (
        "the column {column!r} stands there twice",
        "la colonna {column!r} c'è due volte",
    ),
    "unknown_unit": (
        "the unit {unit!r} of the column {column} is not accepted: one of {known} in the row below the heads",
        "l'unità {unit!r} della colonna {column} non è ammessa: una fra {known} nella riga sotto le "
        "intestazioni",
    ),
    "not_yes_or_no": (
        "{text!r} is not accepted: sì, yes, x or no",
        "{text!r} non è ammesso: sì, yes, x oppure no",
    ),
    "table_kind": ("a table of walls is .xlsx or .csv", "una tabella di pareti è .xlsx o .csv"),
    "table_unpacked": (
        "unpacked it is larger than 20 MB: no table of walls",
        "decompressa supera 20 MB: non è una tabella di pareti",
    ),
    "merged_cells": (
        "cells are merged: a table of walls has one cell for each value",
        "ci sono celle unite: una tabella di pareti ha una cella per ogni valore",
    ),
    "too_many_rows": ("more than {rows} rows", "più di {rows} righe"),
    "two_units_of_column": (
        "the column {column!r} names {named}, the row of units below it {unit}: correct one of them",
        "la colonna {column!r} indica {named}, la riga delle unità sotto {unit}: correggere uno dei due",
    ),
    "formula_cell": (
        "{cell} is a formula: paste it as a value",
        "{cell} è una formula: incollarla come valore",
    ),
    "spectrum_ends": (
        "{name} ends at {end:.2f} s, before {period_name} = {period:.2f} s (C8.7.1.2.1.8): give the spectrum "
        "up to there",
        "{name} finisce a {end:.2f} s, prima di {period_name} = {period:.2f} s (C8.7.1.2.1.8): dare lo "
        "spettro fino a quel periodo",
    ),
    "return_period_short": (
        "{return_period_years} = {stated:g} is below the {shortest:.0f} years of {state} for V_R = {life:g} "
        "years (NTC 2018 3.2.0): the motion of another limit state? Give {nominal_life_years} and "
        "{use_class_factor} if it is right",
        "{return_period_years} = {stated:g} è sotto i {shortest:.0f} anni dello {state} per V_R = {life:g} "
        "anni (NTC 2018 3.2.0): il moto di un altro stato limite? Dare {nominal_life_years} e "
        "{use_class_factor} se è giusto",
    ),
    "return_period_contradicts": (
        "{return_period_years} = {stated:g} contradicts {nominal_life_years} and {use_class_factor}, which "
        "give {own:.0f} years at {state} (NTC 2018 3.2.0): correct one of them",
        "{return_period_years} = {stated:g} contraddice {nominal_life_years} e {use_class_factor}, che danno "
        "{own:.0f} anni allo {state} (NTC 2018 3.2.0): correggere uno dei dati",
    ),
    "return_period_of_other": (
        "{return_period_years} = {stated:g} is that of {weaker} for V_R = {life:g} years, not of {state}, "
        "which has {own:.0f} (NTC 2018 3.2.0): give the motion of {state}, or {nominal_life_years} and "
        "{use_class_factor} if it is right",
        "{return_period_years} = {stated:g} è quello dello {weaker} per V_R = {life:g} anni, non dello "
        "{state}, che ha {own:.0f} (NTC 2018 3.2.0): dare il moto dello {state}, oppure {nominal_life_years} "
        "e {use_class_factor} se è giusto",
    ),
    "period_range_beyond": (
        "{period_range_s} goes to {high:.2f} s, but {name} ends at {end:.2f} s: shorten it or give the "
        "spectrum up to there",
        "{period_range_s} arriva a {high:.2f} s, ma {name} finisce a {end:.2f} s: accorciarlo o dare lo "
        "spettro fino a quel periodo",
    ),
    "t_c_above_t_d": (
        "{tc_star_s} = {stated:g} s on soil {soil} gives T_C = {t_c:.2f} s, not below T_D = {t_d:.2f} s: "
        "check {tc_star_s} and {ag_g}",
        "{tc_star_s} = {stated:g} s su suolo {soil} dà T_C = {t_c:.2f} s, non inferiore a T_D = {t_d:.2f} s: "
        "controllare {tc_star_s} e {ag_g}",
    ),
    "spectrum_too_short": (
        "{rows} rows are too few for a spectrum: at least 5",
        "{rows} righe sono poche per uno spettro: almeno 5",
    ),
    "spectrum_values": (
        "periods from 0 s and ordinates above 0 g to 20 g are accepted",
        "sono ammessi periodi da 0 s e ordinate sopra 0 g fino a 20 g",
    ),
    "spectrum_range": (
        "covers {low:g} to {high:g} s: the range 0.1 to 2.5 s of the Housner intensity must be inside",
        "copre da {low:g} a {high:g} s: l'intervallo da 0.1 a 2.5 s dell'intensità di Housner deve starci "
        "dentro",
    ),
    "spectrum_start": (
        "it starts at {start:.3f} g, but a_g S of the demand is {pga:.3f} g: give {ag_g} and {soil_factor} of "
        "the same site",
        "comincia da {start:.3f} g, ma a_g S della domanda è {pga:.3f} g: dare {ag_g} e {soil_factor} dello "
        "stesso sito",
    ),
    "spectrum_largest": (
        "its largest ordinate, {largest:.3f} g, is {ratio:.2f} times a_g S of the demand (1.2 to 6 is "
        "accepted): is the file in g, and of the same site?",
        "la sua ordinata massima, {largest:.3f} g, è {ratio:.2f} volte a_g S della domanda (ammesso da 1.2 a "
        "6): il file è in g e dello stesso sito?",
    ),
    "spectrum_not_rising": (
        "the periods must rise, found {period:g} s",
        "i periodi devono crescere, trovato {period:g} s",
    ),
    "time_step": (
        "time step {step:g} s is not accepted: {low:g} to {high:g} s",
        "passo di {step:g} s non ammesso: da {low:g} a {high:g} s",
    ),
    "too_few_samples": (
        "{n} samples are too few for a record: at least 10",
        "{n} campioni sono pochi per un accelerogramma: almeno 10",
    ),
    "sample_not_a_number": ("sample {n} is not a number", "il campione {n} non è un numero"),
    "all_zero": (
        "all samples are zero: this record moves nothing",
        "tutti i campioni sono zero: questo accelerogramma non muove nulla",
    ),
    "empty_file": ("the file is empty", "il file è vuoto"),
    "too_many_numbers": (
        "more than {n} numbers are no accelerogram",
        "più di {n} numeri non sono un accelerogramma",
    ),
    "last_line_cut": (
        "samples of the last line are missing and it has no line end: the file is cut",
        "mancano campioni nell'ultima riga, che non ha fine riga: il file è troncato",
    ),
    "unit_not_accepted": (
        "unit = {given!r} is not accepted: {known}",
        "unità = {given!r} non ammessa: {known}",
    ),
    "peak_too_large": (
        "the peak would be {pga:.3g} g, beyond any earthquake (20 g): velocity, a count of samples on top, or "
        "another unit?",
        "il picco sarebbe {pga:.3g} g, oltre ogni terremoto (20 g): velocità, un conto di campioni in testa, "
        "o un'altra unità?",
    ),
    "skip_lines_of_plain_text": (
        "{skip_lines} is for plain text; this file is {format}: leave it out",
        "{skip_lines} è per testo semplice; questo file è {format}: toglierlo",
    ),
    "column_of_plain_text": (
        "column is for plain text; this file is {format}: leave it out",
        "column è per testo semplice; questo file è {format}: toglierlo",
    ),
    "contradicts_file": (
        "the file states {named} {stated}, the case gives {given}: remove {named}",
        "il file dice {named} {stated}, il caso {given}: togliere {named}",
    ),
    "record_not_a_file": (
        "this is not a file: name an accelerogram",
        "questo non è un file: nominare un accelerogramma",
    ),
    "record_too_large": (
        "{mb:.0f} MB is no accelerogram (up to {most} MB)",
        "{mb:.0f} MB non sono un accelerogramma (fino a {most} MB)",
    ),
    "no_record": ("there is no such file", "questo file non esiste"),
    "format_not_read": (
        "{format} files are not read yet: convert to two columns, time and acceleration",
        "i file {format} non si leggono ancora: convertire in due colonne, tempo e accelerazione",
    ),
    "bad_pattern": (
        "file = {pattern!r} is not accepted as a pattern: {reason}",
        "file = {pattern!r} non è ammesso come modello: {reason}",
    ),
    "unit_g_tenth": (
        "the unit is g/10: convert the file to g",
        "l'unità è g/10: convertire il file in g",
    ),
    "two_units": (
        "the header speaks of two units, {one} in {first} and {other} in {second}: leave the one of the "
        "samples",
        "l'intestazione parla di due unità, {one} in {first} e {other} in {second}: lasciare quella dei "
        "campioni",
    ),
    "token_too_large": ("{text} is too large for a number", "{text} è troppo grande per un numero"),
    "sample_nan": (
        "sample {n} is NaN: a gap in the record",
        "il campione {n} è NaN: un buco nell'accelerogramma",
    ),
    "count_differs": (
        "{n} samples, but the header declares {declared}",
        "{n} campioni, ma l'intestazione ne dichiara {declared}",
    ),
    "other_quantity": (
        "the header speaks of {quantity}: this is not an accelerogram; take the acceleration file",
        "l'intestazione parla di {quantity}: non è un accelerogramma; prendere il file di accelerazione",
    ),
    "binary_file": (
        "this is a binary file; SAC and miniSEED need instrument metadata: convert it to text with ObsPy "
        "(stream.write) or download the processed ASCII file",
        "è un file binario; SAC e miniSEED vogliono i dati dello strumento: convertirlo in testo con ObsPy "
        "(stream.write) o scaricare il file ASCII elaborato",
    ),
    "fewer_than_declared": (
        "{n} samples, but the header declares {declared}: the file is cut",
        "{n} campioni, ma l'intestazione ne dichiara {declared}: il file è troncato",
    ),
    "not_numbers": ("{text} is not numbers", "{text} non sono numeri"),
    "esm_data_type": (
        "DATA_TYPE is {kind}: take the ACCELERATION file (.ACC.ASC)",
        "DATA_TYPE è {kind}: prendere il file ACCELERATION (.ACC.ASC)",
    ),
    "esm_peak": (
        "UNITS {unit} gives a peak of {read:.4g} cm/s2, PGA_CM/S^2 states {stated:.4g}: one of them is wrong",
        "UNITS {unit} dà un picco di {read:.4g} cm/s2, PGA_CM/S^2 dichiara {stated:.4g}: uno dei due è "
        "sbagliato",
    ),
    "esm_duration": (
        "DURATION_S is {duration:g} s, but {n} samples of SAMPLING_INTERVAL_S = {step:g} s are {covered:g} s: "
        "one of them is wrong",
        "DURATION_S è {duration:g} s, ma {n} campioni con SAMPLING_INTERVAL_S = {step:g} s sono {covered:g} "
        "s: uno dei due è sbagliato",
    ),
    "sigma_no_acceleration": (
        "no line `Acceleration time series`: velocity, displacement or a spectrum?",
        "nessuna riga `Acceleration time series`: velocità, spostamento o uno spettro?",
    ),
    "unit_not_acceleration": (
        "unit {unit} is not an acceleration: g, m/s2, cm/s2 or mm/s2",
        "l'unità {unit} non è un'accelerazione: g, m/s2, cm/s2 o mm/s2",
    ),
    "not_a_count": (
        "{label} is {text}, not a count of samples",
        "{label} è {text}, non un numero di campioni",
    ),
    "not_a_time_step": (
        "{label} is {text}, not a time step in seconds",
        "{label} è {text}, non un passo in secondi",
    ),
    "peer_quantity": (
        "this file holds {quantity}: take the acceleration file (.AT2)",
        "questo file contiene {quantity}: prendere il file di accelerazione (.AT2)",
    ),
    "second_header": (
        "a second header stands among the samples: two records in one file",
        "fra i campioni c'è una seconda intestazione: due accelerogrammi in un file",
    ),
    "uneven_times": (
        "the time goes from {start:g} to {end:g} s, elsewhere by {usual:g} s: times must be sorted and even, "
        "without gaps",
        "il tempo va da {start:g} a {end:g} s, altrove di {usual:g} s: i tempi devono essere ordinati e "
        "uniformi, senza buchi",
    ),
    "no_numbers": ("no numbers in this file", "nessun numero in questo file"),
    "two_time_steps": (
        "the header states a time step of {stated:g} s, the time column {column_step:g} s",
        "l'intestazione dà un passo di {stated:g} s, la colonna dei tempi {column_step:g} s",
    ),
    "column_out_of_range": (
        "column = {given} is not accepted: 2 to {most} (column 1 is time)",
        "colonna = {given} non ammessa: da 2 a {most} (la colonna 1 è il tempo)",
    ),
    "which_column": (
        "{n} columns: say which holds the acceleration with column = 2 to {most} (column 1 is time); values "
        "wrapped over a line must stand one a line",
        "{n} colonne: dire quale è l'accelerazione con column = da 2 a {most} (la colonna 1 è il tempo); "
        "valori su più colonne vanno messi uno per riga",
    ),
    "no_time_column": (
        "column 1 does not grow: it is no time column; one column is read with {time_step_s}, and a decimal "
        "comma needs ; or a tab between columns",
        "la colonna 1 non cresce: non è il tempo; una colonna sola si legge con {time_step_s}, e la virgola "
        "decimale vuole ; o tabulazione fra le colonne",
    ),
    "gap": (
        "{text} is not numbers: a gap in the record?",
        "{text} non sono numeri: un buco nell'accelerogramma?",
    ),
    "columns_differ": (
        "{n} columns, {above} above it; text lines on top can be passed over with {skip_lines}",
        "{n} colonne, {above} in quella sopra; le righe di testo in testa si saltano con {skip_lines}",
    ),
    "one_column": (
        "column {given} asked for, but there is one column",
        "chiesta la colonna {given}, ma ce n'è una sola",
    ),
    "time_as_acceleration": (
        "this column grows evenly: it is a time column, not an acceleration",
        "questa colonna cresce uniformemente: è il tempo, non un'accelerazione",
    ),
    "count_on_top": (
        "the first value {first:g} looks like a count of samples: pass over the lines on top with {skip_lines}",
        "il primo valore {first:g} sembra un conto di campioni: saltare le righe in testa con {skip_lines}",
    ),
    "no_spectrum_file": ("there is no such spectrum file", "questo file di spettro non esiste"),
    "spectrum_too_large": (
        "larger than 1 MB: no spectrum of two columns",
        "più di 1 MB: non è uno spettro di due colonne",
    ),
    "spectrum_units": (
        "the head names {unit}: periods are read in s and S_e in g, convert them",
        "l'intestazione nomina {unit}: i periodi si leggono in s e S_e in g, convertirli",
    ),
    "spectrum_line": (
        "two numbers expected, period in s and S_e in g, found {text!r}",
        "due numeri attesi, periodo in s e S_e in g, trovato {text!r}",
    ),
    "batch_just_ended": (
        "another batch has just ended here: start again",
        "un altro calcolo è appena finito qui: riavviare",
    ),
    "not_a_journal": (
        "this file is no journal of Ribalta and stays as it is: rename it, or give another --output",
        "questo file non è un registro di Ribalta e resta com'è: rinominarlo, o indicare un altro --output",
    ),
    "journal_not_writable": (
        "the journal cannot be written: {reason}",
        "il giornale non si può scrivere: {reason}",
    ),
    "batch_running": (
        "another batch is writing these results: wait for it, or give another --output",
        "un altro calcolo sta scrivendo questi risultati: attenderlo, o indicare un altro --output",
    ),
    "restitution_not_accepted": (
        "restitution {model!r} with {velocity_ratio} {ratio!r} is not accepted: one of {known}; "
        "{velocity_ratio} within 0 and 1",
        "la restituzione {model!r} con {velocity_ratio} {ratio!r} non è ammessa: una fra {known}; "
        "{velocity_ratio} fra 0 e 1",
    ),
    "eq4_negative": (
        "Eq. 4 gives a negative velocity ratio ({ratio:.3g}) for slenderness {alpha:.2f} deg: the block is "
        "too stocky to rock; give {velocity_ratio} instead",
        "l'Eq. 4 dà un rapporto di velocità negativo ({ratio:.3g}) per una snellezza di {alpha:.2f} gradi: il "
        "blocco è troppo tozzo per oscillare; dare {velocity_ratio}",
    ),
    "eq7_above_one": (
        "Eq. 7 gives a velocity ratio of {ratio:.3g} at vanishing speed, above 1: it was fitted on "
        "rectangular walls; take {one_sided_theoretical} or give {velocity_ratio}",
        "l'Eq. 7 dà un rapporto di velocità di {ratio:.3g} a velocità nulla, oltre 1: è tarata su pareti "
        "rettangolari; prendere {one_sided_theoretical} o dare {velocity_ratio}",
    ),
    "not_accepted": (
        "{key} = {value} is not accepted: {accepted}",
        "{key} = {value} non è ammesso: {accepted}",
    ),
    "missing": (
        "{key} is missing: it is required ({accepted})",
        "manca {key}: è richiesto ({accepted})",
    ),
    "base_missing": (
        "{key} is missing: with a demand the height of the hinge above the ground is required, 0 m for a wall "
        "on the ground",
        "manca {key}: con una domanda è richiesta la quota della cerniera dal suolo, 0 m per una parete al "
        "suolo",
    ),
    "ends_not_accepted": (
        "{elastic_limit} = {first}, {plateau_end} = {last} are not accepted: {least:g} <= elastic_limit <= "
        "plateau_end < 1",
        "{elastic_limit} = {first}, {plateau_end} = {last} non sono ammessi: {least:g} <= elastic_limit <= "
        "plateau_end < 1",
    ),
    "window_below_step": (
        "{robust_window} = {window} is narrower than one step of {q_step} = {step}: widen the window or take "
        "a finer step",
        "{robust_window} = {window} è più stretta di un passo {q_step} = {step}: allargare la finestra o "
        "prendere un passo più fine",
    ),
    "generate_needs_spectrum": (
        "{section_generate} makes motions compatible with the spectrum of the demand: give "
        "{section_demand_spectrum} or {spectrum_file}",
        "{section_generate} genera moti compatibili con lo spettro della domanda: dare "
        "{section_demand_spectrum} o {spectrum_file}",
    ),
    "no_wall": (
        "no [[wall]]: a case needs at least one wall",
        "nessuna [[wall]]: un caso vuole almeno una parete",
    ),
    "two_spectra": (
        "give {spectrum} or {spectrum_file}, not both",
        "dare {spectrum} o {spectrum_file}, non entrambi",
    ),
    "soil_factor_follows": (
        "{soil_factor} follows from {section_demand_spectrum}: leave it out",
        "{soil_factor} segue da {section_demand_spectrum}: toglierlo",
    ),
    "intensity_follows": (
        "{housner_intensity_cm} follows from the spectrum: leave one of them out",
        "{housner_intensity_cm} segue dallo spettro: togliere uno dei due",
    ),
    "code_needs": ("code {code} needs {key}", "la norma {code} vuole {key}"),
    "code_does_not_take": ("code {code} does not take {key}", "la norma {code} non vuole {key}"),
    "written_once_for_each": (
        "{key} must be written [[{key}]], once for each",
        "{key} si scrive [[{key}]], una volta per ciascuno",
    ),
    "not_a_table_of_keys": (
        "{name} must be a table of keys, not {value}",
        "{name} deve essere una tabella di chiavi, non {value}",
    ),
    "same_name": (
        'two walls have the same name "{name}": names must differ',
        'due pareti hanno lo stesso nome "{name}": i nomi devono essere diversi',
    ),
    "linearised_is_rigid": (
        'method linearised is for the rigid law; wall "{name}" is trilinear: take method auto',
        'il metodo linearised è per la legge rigida; la parete "{name}" è trilineare: prendere il metodo auto',
    ),
    "low_confidence_factor": (
        "{confidence_factor} = {stated:g} is for walls whose compressive strength is in alpha (Circolare "
        'C8.7.1.2.1): give {hinge_setback_m} above 0 for wall "{name}", or 1.35',
        "{confidence_factor} = {stated:g} è per pareti con la resistenza a compressione in alpha (Circolare "
        'C8.7.1.2.1): dare {hinge_setback_m} maggiore di 0 per la parete "{name}", oppure 1.35',
    ),
    "not_built": (
        "{key} is not built yet in this version: leave it out",
        "{key} non c'è ancora in questa versione: toglierlo",
    ),
    "unknown_key": (
        "unknown key {value}; known: {known}",
        "chiave sconosciuta {value}; note: {known}",
    ),
    "unknown_key_near": (
        "unknown key {value}; did you mean {near}?",
        "chiave sconosciuta {value}; si intendeva {near}?",
    ),
    "one_geometry": (
        "give {height_m} and exactly one of {shapes} (found: {height_m} {height}; {found})",
        "dare {height_m} e uno solo fra {shapes} (trovati: {height_m} {height}; {found})",
    ),
    "no_unit": (
        "the file does not state its unit of acceleration: give {key} (g, m/s2, cm/s2 or mm/s2)",
        "il file non dice l'unità dell'accelerazione: dare {key} (g, m/s2, cm/s2 o mm/s2)",
    ),
    "no_time_step_s": (
        "the file does not state its time step: give {key} (in seconds)",
        "il file non dice il passo temporale: dare {key} (in secondi)",
    ),
    "no_match": (
        "file = {pattern!r}: no file matches",
        "file = {pattern!r}: nessun file corrisponde",
    ),
    "no_match_in": (
        "file = {pattern!r}: no file matches in {folder}",
        "file = {pattern!r}: nessun file corrisponde in {folder}",
    ),
    "last_number_cut": (
        "the last number, {last}, is {why}: the file looks cut there; copy it anew, or {mend} if it is whole",
        "l'ultimo numero, {last}, è {why}: il file sembra troncato in quel punto; copiarlo di nuovo, o {mend} "
        "se è intero",
    ),
    "record_twice": (
        "{file} is in the case twice (the same samples as {twin}): leave one out",
        "{file} è due volte nel caso (gli stessi campioni di {twin}): toglierne uno",
    ),
    "window_needs_qt": (
        "the window needs PySide6 and pyqtgraph, and on Linux libgl1, libegl1 and libxkbcommon0 ({reason}); "
        "start it with python3 run.py, or run a case with --batch",
        "la finestra vuole PySide6 e pyqtgraph, e in Linux libgl1, libegl1 e libxkbcommon0 ({reason}); "
        "avviarla con python3 run.py, o calcolare un caso con --batch",
    ),
    "picture_not_made": ("The picture cannot be made.", "Non è possibile creare l'immagine."),
}
"""Code -> (English, Italian). A placeholder without a value is a key of the case."""

PLACES = {
    "wall": ('wall "{name}"', 'parete "{name}"'),
    "record": ("record {n}", "accelerogramma {n}"),
    "row": ("row {n}", "riga {n}"),
    "cell": ("row {n}, {key}", "riga {n}, {key}"),
    "line": ("line {n}", "riga {n}"),
    "section": ("{name}", "{name}"),
}
"""Where an error is."""

ACCEPTED = {
    "from": ("from {low:g} to {high:g}{unit}", "da {low:g} a {high:g}{unit}"),
    "above": ("above {low:g} to {high:g}{unit}", "sopra {low:g} fino a {high:g}{unit}"),
    "whole": (
        "a whole number from {low:g} to {high:g}{unit}",
        "un numero intero da {low:g} a {high:g}{unit}",
    ),
    "one_of": ("one of {names}", "uno fra {names}"),
    "law": (
        "one of {names}, or {{ elastic_limit = ..., plateau_end = ... }}",
        "uno fra {names}, oppure {{ elastic_limit = ..., plateau_end = ... }}",
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
    "end_last_line": (
        "end the last line with a line break",
        "terminare l'ultima riga con un a capo",
    ),
}
"""What is accepted instead, and other parts of these sentences."""
