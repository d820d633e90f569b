"""Sentences of errors of files that are read: accelerograms and tables of walls."""

FILE_ERRORS = {
    "spectra_file": (
        "this file holds response spectra: take the accelerogram (volume 1 or 2)",
        "questo file contiene spettri di risposta: usare l'accelerogramma (volume 1 o 2)",
    ),
    "vertical_component": (
        "a vertical component, left out of a study of horizontal motions",
        "componente verticale, esclusa da uno studio di moti orizzontali",
    ),
    "unreadable": ("cannot be read: {reason}", "non si può leggere: {reason}"),
    "table_rows": (
        "a table of walls has a row of heads (Parete; H; t; Meccanismo), a row of units (; m; cm;) unless the "
        "heads name them, as H (m), and a row for each wall",
        "una tabella di pareti ha una riga di intestazioni (Parete; H; t; Meccanismo), una di unità (; m; "
        "cm;) salvo che le intestazioni le indichino, come H (m), e una per parete",
    ),
    "table_too_large": ("more than {rows} rows or {columns} columns", "più di {rows} righe o {columns} colonne"),
    "table_not_a_file": (
        "this is not a file: name a table of walls",
        "questo non è un file: indicare una tabella di pareti",
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
        "every sheet is hidden: show the one that is to be read",
        "tutti i fogli sono nascosti: mostrare quello da leggere",
    ),
    "not_a_workbook": (
        "not a workbook Excel could have saved ({reason}): save it again as .xlsx",
        "non è una cartella di lavoro che Excel avrebbe salvato ({reason}): salvarla di nuovo come .xlsx",
    ),
    "workbook_unpacked": (
        "unpacked it is larger than {mb:.0f} MB: copy the cells that are to be read into a new workbook",
        "decompressa supera {mb:.0f} MB: copiare le celle da leggere in una nuova cartella di lavoro",
    ),
    "workbook_too_large": (
        "it holds more parts, cells, texts or formats than can be read: copy the cells that are to be read into a new "
        "workbook, as values",
        "contiene più parti, celle, testi o formati di quanti se ne leggano: copiare le celle da leggere in una nuova "
        "cartella di lavoro, come valori",
    ),
    "sheet_too_large": (
        "there are values beyond row {rows} or column {columns}, or more than {cells} of them: copy what is to be read "
        "into a sheet of its own, or save it as .csv",
        "ci sono valori oltre la riga {rows} o la colonna {columns}, o più di {cells}: copiare ciò che va letto in un "
        "foglio a parte, o salvarlo come .csv",
    ),
    "cells_without_value": (
        "{cells}: each cell that is read holds a value of its own; unmerge, correct, or paste as values",
        "{cells}: ogni cella che si legge contiene un valore proprio; separare, correggere o incollare come valori",
    ),
    "value_beyond_columns": ("there is a value beyond the last column", "c'è un valore oltre l'ultima colonna"),
    "unknown_column": (
        "the column {column!r} is not known: Parete, Piano, z, H, t, L, peso specifico, u, meccanismo, "
        "vincolo, note, or a key of [[wall]] ({known})",
        "la colonna {column!r} non è nota: Parete, Piano, z, H, t, L, peso specifico, u, meccanismo, vincolo, "
        "note, o una chiave di [[wall]] ({known})",
    ),
    "column_twice": ("the column {column!r} stands there twice", "la colonna {column!r} c'è due volte"),
    "unknown_unit": (
        "the unit {unit!r} of the column {column} is not accepted: one of {known} in the row below "
        "the heads, or in brackets in the head",
        "l'unità {unit!r} della colonna {column} non è ammessa: una fra {known} nella riga sotto le "
        "intestazioni, o fra parentesi nell'intestazione",
    ),
    "table_word": ("{text!r} is not accepted: one of {known}", "{text!r} non è ammesso: una fra {known}"),
    "not_yes_or_no": ("{text!r} is not accepted: sì, yes, x or no", "{text!r} non è ammesso: sì, yes, x oppure no"),
    "table_kind": ("a table of walls is .xlsx or .csv", "una tabella di pareti è .xlsx o .csv"),
    "two_units_of_column": (
        "the column {column!r} names {named}, the row of units below it {unit}: correct one of them",
        "la colonna {column!r} indica {named}, la riga delle unità sotto {unit}: correggere uno dei due",
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
    "too_many_numbers": ("more than {n} numbers are no accelerogram", "più di {n} numeri non sono un accelerogramma"),
    "last_line_cut": (
        "samples of the last line are missing and it has no line end: the file is cut",
        "mancano campioni nell'ultima riga, che non ha fine riga: il file è troncato",
    ),
    "unit_not_accepted": ("{unit} = {given!r} is not accepted: {known}", "{unit} = {given!r} non ammessa: {known}"),
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
        "questo non è un file: indicare un accelerogramma",
    ),
    "record_too_large": (
        "{mb:.0f} MB is no accelerogram (up to {most} MB)",
        "{mb:.0f} MB non sono un accelerogramma (fino a {most} MB)",
    ),
    "no_record": ("there is no such file", "questo file non esiste"),
    "bad_pattern": (
        "file = {pattern!r} is not accepted as a pattern: {reason}",
        "file = {pattern!r} non è ammesso come modello: {reason}",
    ),
    "two_units": (
        "the header speaks of two units, {one} in {first} and {other} in {second}: leave the one of the samples",
        "l'intestazione parla di due unità, {one} in {first} e {other} in {second}: lasciare quella dei campioni",
    ),
    "token_too_large": ("{text} is too large for a number", "{text} è troppo grande per un numero"),
    "sample_nan": ("sample {n} is NaN: a gap in the record", "il campione {n} è NaN: un buco nell'accelerogramma"),
    "count_differs": (
        "{n} samples, but the header declares {declared}",
        "{n} campioni, ma l'intestazione ne dichiara {declared}",
    ),
    "other_quantity": (
        "the header speaks of {quantity}: this is not an accelerogram, its line is {line}; take the acceleration file",
        "l'intestazione parla di {quantity}: non è un accelerogramma, la riga è {line}; usare il file di accelerazione",
    ),
    "binary_file": (
        "this is a binary file; SAC and miniSEED need instrument metadata: convert it to text with ObsPy "
        "(stream.write) or download the processed ASCII file",
        "è un file binario; SAC e miniSEED richiedono i dati dello strumento: convertirlo in testo con ObsPy "
        "(stream.write) o scaricare il file ASCII elaborato",
    ),
    "fewer_than_declared": (
        "{n} samples, but the header declares {declared}: the file is cut",
        "{n} campioni, ma l'intestazione ne dichiara {declared}: il file è troncato",
    ),
    "not_numbers": ("{text} is not numbers", "{text} non sono numeri"),
    "esm_data_type": (
        "DATA_TYPE is {kind}: take the ACCELERATION file (.ACC.ASC)",
        "DATA_TYPE è {kind}: usare il file ACCELERATION (.ACC.ASC)",
    ),
    "esm_peak": (
        "UNITS {unit} gives a peak of {read:.4g} cm/s2, PGA_CM/S^2 states {stated:.4g}: one of them is wrong",
        "UNITS {unit} dà un picco di {read:.4g} cm/s2, PGA_CM/S^2 dichiara {stated:.4g}: uno dei due è sbagliato",
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
    "unit_not_read": (
        "the file is in {unit}: convert it to g, m/s2, cm/s2 or mm/s2; its line is {line}",
        "il file è in {unit}: convertirlo in g, m/s2, cm/s2 o mm/s2; la sua riga è {line}",
    ),
    "factor_stated": (
        "the head states a factor of {factor:g} in {line}: give {scale} = {factor:g} if the samples have still to "
        "be multiplied by it, or take the line out if they have been",
        "l'intestazione indica un fattore {factor:g} in {line}: dare {scale} = {factor:g} se i campioni vanno "
        "ancora moltiplicati, o togliere la riga se lo sono già",
    ),
    "two_factors_stated": (
        "the head states two factors, in {first} and in {second}: leave the one that the samples have still to be "
        "multiplied by",
        "l'intestazione indica due fattori, in {first} e in {second}: lasciare quello per cui i campioni vanno ancora "
        "moltiplicati",
    ),
    "two_steps_stated": (
        "the head states a time step of {one:g} s in {first} and of {other:g} s in {second}: leave the one of the "
        "samples",
        "l'intestazione dà un passo di {one:g} s in {first} e di {other:g} s in {second}: lasciare quello dei campioni",
    ),
    "count_stated": (
        "{n} samples, but the header declares {declared} in {line}: download the file again, or correct the line",
        "{n} campioni, ma l'intestazione ne dichiara {declared} in {line}: scaricare di nuovo il file, o correggere "
        "la riga",
    ),
    "contradicts_line": (
        "the file states {named} {stated}, the case gives {given}: remove {named}, or correct the line {line}",
        "il file dice {named} {stated}, il caso {given}: togliere {named}, o correggere la riga {line}",
    ),
    "blank_among_samples": (
        "a blank line among the samples: leave one record in the file, without blank lines in it",
        "una riga vuota fra i campioni: lasciare un solo accelerogramma nel file, senza righe vuote",
    ),
    "text_among_samples": (
        "{text} stands among the samples: leave one record in the file, with text above it only",
        "{text} si trova fra i campioni: lasciare un solo accelerogramma nel file, con il testo solo sopra",
    ),
    "head_too_long": (
        "more than {n} lines of text above the samples: leave those of the record",
        "più di {n} righe di testo sopra i campioni: lasciare quelle dell'accelerogramma",
    ),
    "marks_of_gaps": (
        "{n} samples are {mark:g}, the first of them sample {sample}, all others within {others:.4g}: a mark of "
        "missing samples? Download the file again, or take a record without gaps",
        "{n} campioni valgono {mark:g}, il primo è il campione {sample}, gli altri sono entro {others:.4g}: un "
        "segno di campioni mancanti? Scaricare di nuovo il file, o usare un accelerogramma senza buchi",
    ),
    "line_twice": (
        "the line {text} stands there twice: download the file again, or take one out",
        "la riga {text} c'è due volte: scaricare di nuovo il file, o toglierne una",
    ),
    "pairs_in_line": (
        "a line holds several pairs of time and acceleration: write one pair a line",
        "una riga contiene più coppie di tempo e accelerazione: scrivere una coppia per riga",
    ),
    "not_a_count": ("{label} is {text}, not a count of samples", "{label} è {text}, non un numero di campioni"),
    "not_a_time_step": ("{label} is {text}, not a time step in seconds", "{label} è {text}, non un passo in secondi"),
    "peer_quantity": (
        "this file holds {quantity}: take the acceleration file (.AT2)",
        "questo file contiene {quantity}: usare il file di accelerazione (.AT2)",
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
        "the header states a time step of {stated:g} s, {line}, the samples are {column_step:g} s apart: correct "
        "the line or the times",
        "l'intestazione dà un passo di {stated:g} s, {line}, i campioni distano {column_step:g} s: correggere la "
        "riga o i tempi",
    ),
    "column_out_of_range": (
        "{column} = {given} is not accepted: 2 to {most} (column 1 is time)",
        "{column} = {given} non ammessa: da 2 a {most} (la colonna 1 è il tempo)",
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
        "decimale richiede ; o tabulazione fra le colonne",
    ),
    "gap": ("{text} is not numbers: a gap in the record?", "{text} non sono numeri: un buco nell'accelerogramma?"),
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
    "base_missing": (
        "{key} is missing: with a demand the height of the hinge above the ground is required, 0 m for a wall "
        "on the ground",
        "manca {key}: con una domanda è richiesta la quota della cerniera dal suolo, 0 m per una parete al suolo",
    ),
    "no_unit": (
        "the file does not state its unit of acceleration: give {key} (g, m/s2, cm/s2 or mm/s2)",
        "il file non dice l'unità dell'accelerazione: indicare {key} (g, m/s2, cm/s2 o mm/s2)",
    ),
    "no_time_step_s": (
        "the file does not state its time step: give {key} (in seconds)",
        "il file non dice il passo temporale: indicare {key} (in secondi)",
    ),
    "no_match": ("file = {pattern!r}: no file matches", "file = {pattern!r}: nessun file corrisponde"),
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
    "case_too_large": (
        "{mb:.0f} MB is no case file (up to 2 MB)",
        "{mb:.0f} MB non sono un file di caso (fino a 2 MB)",
    ),
    "toml_dotted": ("not TOML: a key of more than {parts} parts", "non è TOML: una chiave di oltre {parts} parti"),
    "case_not_utf8": (
        "not UTF-8 text: a case file is TOML, see the examples",
        "non è testo UTF-8: un caso è TOML, vedere gli esempi",
    ),
    "not_toml": (
        "not TOML: {reason}; see the examples in resources/cases",
        "non è TOML: {reason}; vedere gli esempi in resources/cases",
    ),
    "toml_comma": (
        "line {line}: {found} has a comma: numbers of a case file have a decimal point",
        "riga {line}: {found} ha la virgola: i numeri di un file di caso hanno il punto decimale",
    ),
}
"""Code -> (English, Italian)."""
