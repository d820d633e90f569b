"""Sentences of errors the user can mend: place, what was found, what is accepted, what to do."""

CASE_ERRORS = {
    "no_case_file": ("there is no such case file", "questo file di caso non esiste"),
    "would_overwrite": (
        "the results would overwrite {path}: rename it or give --output",
        "i risultati coprirebbero {path}: rinominarlo o indicare un'altra cartella con --output",
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
    "case_reads_otherwise": (
        "what would be written reads back as another case: nothing is written",
        "ciò che verrebbe scritto si rilegge come un altro caso: non è stato scritto nulla",
    ),
    "folder_not_writable": (
        "the output folder cannot be written ({reason}): name another with --output",
        "la cartella dei risultati non è scrivibile ({reason}): indicarne un'altra con --output",
    ),
    "files_mixed": (
        "cannot be written ({reason}), and what is new already could not be put back: {new}. Each file is whole, but "
        "they are not of one run: write them again once the folder takes files",
        "non si può scrivere ({reason}), e ciò che è già nuovo non si è potuto ripristinare: {new}. Ogni file è "
        "intero, ma non sono di uno stesso calcolo: scriverli di nuovo quando la cartella accetta file",
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
        "non è un file e non si può leggere: indicare un caso (.toml)",
    ),
    "number_in_quotes": (
        "{key} = {value}: write the number without quotes and with a decimal point, {key} = {plain}",
        "{key} = {value}: scrivere il numero senza virgolette e con il punto decimale, {key} = {plain}",
    ),
    "strength_gives_setback": (
        "{compressive_strength_mpa} gives the setback of the hinge: it takes {unit_weight_kn_m3} and no "
        "{hinge_setback_m}",
        "{compressive_strength_mpa} dà l'arretramento della cerniera: richiede {unit_weight_kn_m3} e nessun "
        "{hinge_setback_m}",
    ),
    "setback_too_large": (
        "{key}: the hinge setback {setback:.3f} m is not accepted: up to {most:.3f} m, {share:.0f} % of the "
        "thickness",
        "{key}: l'arretramento della cerniera di {setback:.3f} m non è ammesso: fino a {most:.3f} m, il "
        "{share:.0f} % dello spessore",
    ),
    "restitution_one_sided": (
        "restitution {model} is for {one_sided} walls: for mechanism {asked} leave it out, which takes {housner} "
        "for both sides, or write two walls",
        "la restituzione {model} è per pareti {one_sided}: per il meccanismo {asked} toglierla, e vale {housner} su "
        "due lati, oppure scrivere due pareti",
    ),
    "velocity_ratio_user": (
        '{velocity_ratio} goes with restitution "user" (or with none), and restitution user needs it',
        '{velocity_ratio} va con la restituzione "user" (o con nessuna), e la restituzione user ne ha bisogno',
    ),
    "general_no_setback": (
        "a general block takes no {hinge_setback_m} and no {compressive_strength_mpa}: give {radius_m}, "
        "{slenderness_deg} and {inertia_over_mass_m2} about the hinge itself",
        "un blocco qualsiasi non ammette {hinge_setback_m} né {compressive_strength_mpa}: indicare {radius_m}, "
        "{slenderness_deg} e {inertia_over_mass_m2} rispetto alla cerniera stessa",
    ),
    "general_keys": (
        "a general block takes {radius_m}, {slenderness_deg} and {inertia_over_mass_m2} and nothing else; a "
        "rectangular one takes {height_m}",
        "un blocco qualsiasi richiede {radius_m}, {slenderness_deg} e {inertia_over_mass_m2} e nient'altro; uno "
        "rettangolare richiede {height_m}",
    ),
    "general_needs": (
        "a general block needs {radius_m} and {inertia_over_mass_m2}",
        "un blocco qualsiasi richiede {radius_m} e {inertia_over_mass_m2}",
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
        "il registro non si può scrivere: {reason}",
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
        "Eq. 4 gives a negative velocity ratio ({ratio:.3g}) for slenderness {alpha:.2f} deg: the block is too "
        "stocky to rock, and no rule says what it withstands; check its sizes. A {velocity_ratio} given in its "
        "place must come from tests of such a block",
        "l'Eq. 4 dà un coefficiente di restituzione negativo ({ratio:.3g}) per una snellezza di {alpha:.2f} gradi: "
        "il blocco è troppo tozzo per oscillare, e nessuna regola dice che cosa sopporta; controllarne le misure. "
        "Un {velocity_ratio} dato al suo posto deve venire da prove su un tale blocco",
    ),
    "eq7_above_one": (
        "Eq. 7 gives a velocity ratio of {ratio:.3g} at vanishing speed, above 1: it was fitted on rectangular "
        "walls; give {velocity_ratio} 1, the limit without loss ({one_sided_theoretical} loses more than Eq. 7 "
        "found)",
        "l'Eq. 7 dà un coefficiente di restituzione di {ratio:.3g} a velocità nulla, oltre 1: è tarata su pareti "
        "rettangolari; indicare {velocity_ratio} 1, il limite senza perdite ({one_sided_theoretical} dissipa più di "
        "quanto trovato con l'Eq. 7)",
    ),
    "not_accepted": (
        "{key} = {value} is not accepted: {accepted}",
        "{key} = {value} non è ammesso: {accepted}",
    ),
    "missing": (
        "{key} is missing: it is required ({accepted})",
        "manca {key}: è richiesto ({accepted})",
    ),
    "ends_not_accepted": (
        "{elastic_limit} = {first}, {plateau_end} = {last} are not accepted: {least:g} <= {elastic_limit} <= "
        "{plateau_end} < 1",
        "{elastic_limit} = {first}, {plateau_end} = {last} non sono ammessi: {least:g} <= {elastic_limit} <= "
        "{plateau_end} < 1",
    ),
    "window_below_step": (
        "{robust_window} = {window} is narrower than one step of {q_step} = {step}: widen the window or take "
        "a finer step",
        "{robust_window} = {window} è più stretta di un passo {q_step} = {step}: allargare la finestra o "
        "usare un passo più fine",
    ),
    "hinges_need_building": (
        "hinges at the floors need the building: give {section_building} with {storeys}, or the heights of the hinges",
        "le cerniere ai piani richiedono l'edificio: indicare {section_building} con {storeys}, o le quote "
        "delle cerniere",
    ),
    "hinges_need_rectangle": (
        "hinges above the base need a wall by its {height_m}: give it; a wall without it is checked at its base "
        "alone",
        "cerniere sopra la base richiedono una parete data con {height_m}: indicarla; senza, la parete è verificata "
        "solo alla base",
    ),
    "hinge_above_wall": (
        "a hinge at {hinge:g} m leaves no wall above it: give heights above its base of at most {most:g} m",
        "una cerniera a {hinge:g} m non lascia parete sopra di sé: indicare quote dalla base di al più {most:g} m",
    ),
    "base_above_building": (
        "the base of the wall is {base:g} m above the ground, the building is {height:g} m high: correct the one "
        "that is wrong; the building reaches up to what carries the wall",
        "la base della parete è a {base:g} m dal suolo, l'edificio è alto {height:g} m: correggere il dato errato; "
        "l'edificio arriva fino a ciò che porta la parete",
    ),
    "modes_at_one_height": (
        "the participation of modes is that at one height, and walls stand at {low:g} m and {high:g} m: give "
        "{period_s}, or a case for each height",
        "la partecipazione dei modi vale a una sola quota, e vi sono pareti a {low:g} m e {high:g} m: indicare "
        "{period_s}, oppure un caso per ogni quota",
    ),
    "modes_or_period": (
        "modes state their period and damping: leave out {period_s} and {damping}, or the modes",
        "i modi dichiarano periodo e smorzamento: togliere {period_s} e {damping}, oppure i modi",
    ),
    "no_wall": (
        "no [[wall]]: a case needs at least one wall",
        "nessuna [[wall]]: un caso richiede almeno una parete",
    ),
    "written_once_for_each": (
        "{key} must be written [[{key}]], once for each",
        "{key} si scrive [[{key}]], una volta per ciascuno",
    ),
    "not_a_table_of_keys": (
        "{name} must be a table of keys, not {value}",
        "{name} deve essere una tabella di chiavi, non {value}",
    ),
    "same_name": (
        'two walls have the same name "{wall}": names must differ',
        'due pareti hanno lo stesso nome "{wall}": i nomi devono essere diversi',
    ),
    "study_without": (
        "{key} is missing: see the examples in resources/studies",
        "manca {key}: vedere gli esempi in resources/studies",
    ),
    "no_study_file": (
        "there is no such study: paper, law, or the name of a file",
        "questo studio non esiste: paper, law, o il nome di un file",
    ),
    "study_no_records": (
        "there is no such folder of records nor such a list",
        "questa cartella di accelerogrammi, o elenco, non esiste",
    ),
    "study_same_name": (
        'two are called "{name}" ({kind}): give each its own name',
        'due si chiamano "{name}" ({kind}): assegnare a ciascuno un nome',
    ),
    "study_same_seed": (
        'spectrum "{name}" would use seed {seed} again: motions of one seed are alike; leave count seeds between two',
        'lo spettro "{name}" userebbe di nuovo il seme {seed}: moti dello stesso seme si somigliano; lasciare count '
        "semi fra due",
    ),
    "study_no_runs": (
        "no wall has a motion: give groups, records, or a grid that --quick keeps",
        "nessuna parete ha un moto: indicare gruppi, accelerogrammi, o una griglia che --quick conserva",
    ),
    "study_no_pga": (
        "no a_g gives a_g S = {pga:g} g with this soil: take another pga_g",
        "nessun a_g dà a_g S = {pga:g} g con questo suolo: scegliere un altro pga_g",
    ),
    "study_no_record": (
        "no acceleration record that can be read is in this folder",
        "in questa cartella non c'è alcun accelerogramma leggibile",
    ),
    "linearised_is_rigid": (
        'method linearised is for the rigid law; wall "{wall}" is trilinear: take method auto',
        'il metodo linearised è per la legge rigida; la parete "{wall}" è trilineare: usare il metodo auto',
    ),
    "restraint_unnamed": (
        "{key} {value!r} names nothing: say what stands behind the wall and holds it, or leave the key out",
        "{key} {value!r} non indica nulla: dire che cosa sta dietro la parete e la trattiene, oppure omettere la "
        "chiave",
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
        "indicare {height_m} e uno solo fra {shapes} (trovati: {height_m} {height}; {found})",
    ),
    "machine_code_differs": (
        "the machine code that came with the program does not give on this processor the numbers it was made for, and "
        "is not used: start the program again, which then compiles its own",
        "il codice macchina fornito con il programma non dà su questo processore i numeri per cui è stato fatto, e "
        "non viene usato: riavviare il programma, che allora compila il proprio",
    ),
    "window_needs_qt": (
        "the window needs PySide6 and pyqtgraph, and on Linux libgl1, libegl1 and libxkbcommon0 ({reason}); "
        "start it with python3 run.py, or run a case with --batch",
        "la finestra richiede PySide6 e pyqtgraph, e in Linux libgl1, libegl1 e libxkbcommon0 ({reason}); "
        "avviarla con python3 run.py, o calcolare un caso con --batch",
    ),
    "no_display": (
        "there is no display for the window: start it in a desktop session (or with ssh -X), or run a case with "
        "--batch",
        "non c'è uno schermo per la finestra: avviarla in una sessione grafica (o con ssh -X), o calcolare un caso con "
        "--batch",
    ),
    "note_is_docx": (
        "{path} is no Word document: name a file that ends in .docx",
        "{path} non è un documento Word: indicare un file che termina in .docx",
    ),
    "report_needs_packages": (
        "the calculation note needs python-docx and matplotlib ({reason}); start the program with python3 run.py, "
        "which installs them",
        "la relazione richiede python-docx e matplotlib ({reason}); avviare il programma con python3 run.py, che li "
        "installa",
    ),
    "picture_not_made": ("The picture cannot be made.", "Non è possibile creare l'immagine."),
}
"""Of cases, settings and results: code -> (English, Italian). A placeholder without a value is a key of the
case."""
