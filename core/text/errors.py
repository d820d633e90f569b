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
        "{text!r} ha punto e virgola insieme: scriverlo con un solo segno decimale e senza separatore delle migliaia",
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
        "{compressive_strength_mpa} gives the setback of the hinge: give {unit_weight_kn_m3} and omit "
        "{hinge_setback_m}",
        "{compressive_strength_mpa} dà l'arretramento della cerniera: indicare {unit_weight_kn_m3} e omettere "
        "{hinge_setback_m}",
    ),
    "inertia_too_large": (
        "{key} {given:g} m² is no wall's: up to {most:.3g} m², {ratio:g} R² (4/3 R² of a rectangle, 3/2 R² of a "
        "triangle)",
        "{key} {given:g} m² non è di una parete: fino a {most:.3g} m², {ratio:g} R² (4/3 R² di un rettangolo, 3/2 R² "
        "di un triangolo)",
    ),
    "setback_too_large": (
        "{key}: the hinge setback {setback:.3f} m is not accepted: up to {most:.3f} m, {share:.0f} % of the thickness",
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
    "spectrum_ends": (
        "{name} ends at {end:.2f} s, before {period_name} = {period:.2f} s (C8.7.1.2.1.8): give the spectrum "
        "up to there",
        "{name} finisce a {end:.2f} s, prima di {period_name} = {period:.2f} s (C8.7.1.2.1.8): indicare lo "
        "spettro fino a quel periodo",
    ),
    "period_range_beyond": (
        "{period_range_s} goes to {high:.2f} s, but {name} ends at {end:.2f} s: give the spectrum up to there (a "
        "range that leaves out periods that matter makes the verdict indicative)",
        "{period_range_s} arriva a {high:.2f} s, ma {name} finisce a {end:.2f} s: indicare lo spettro fino a quel "
        "periodo (un intervallo che esclude periodi che contano rende l'esito indicativo)",
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
        "copre da {low:g} a {high:g} s: l'intervallo da 0.1 a 2.5 s dell'intensità di Housner deve starci dentro",
    ),
    "spectrum_start": (
        "it starts at {start:.3f} g, but a_g S of the demand is {pga:.3f} g: give {ag_g} and {soil_factor} of "
        "the same site",
        "comincia da {start:.3f} g, ma a_g S della domanda è {pga:.3f} g: indicare {ag_g} e {soil_factor} dello "
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
    "no_hazard_file": (
        "there is no such file of the hazard; give its name as in its folder",
        "il file della pericolosità non esiste; indicare il nome come nella sua cartella",
    ),
    "hazard_too_large": (
        "larger than a table of the hazard: give one row for each return period",
        "più grande di una tabella di pericolosità: indicare una riga per ogni periodo di ritorno",
    ),
    "hazard_line": (
        "a row of the hazard has two or four numbers, T_R in years, a_g in g, F0, T_C* in s, in at most 100 rows: "
        '"{text}"',
        "una riga della pericolosità ha due o quattro numeri, T_R in anni, a_g in g, F0, T_C* in s, in al più 100 "
        'righe: "{text}"',
    ),
    "no_hazard_rows": (
        "no row of numbers: each row has T_R in years, a_g in g and, for NTC 2018, F0 and T_C* in s",
        "nessuna riga di numeri: ogni riga ha T_R in anni, a_g in g e, per le NTC 2018, F0 e T_C* in s",
    ),
    "two_hazards": (
        "the hazard is given by a file and by rows: leave one of them out",
        "la pericolosità è data da un file e da righe: togliere l'uno o le altre",
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
    "journal_not_writable": ("the journal cannot be written: {reason}", "il registro non si può scrivere: {reason}"),
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
    "not_accepted": ("{key} = {value} is not accepted: {accepted}", "{key} = {value} non è ammesso: {accepted}"),
    "missing": ("{key} is missing: it is required ({accepted})", "manca {key}: è richiesto ({accepted})"),
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
        "hinges above the base need a wall by its {height_m}: give it; a wall without it is checked at its base alone",
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
    "hazard_not_rising": (
        "a hazard needs two rows or more, return periods and a_g rising: give them in this order",
        "una pericolosità richiede almeno due righe, con tempi di ritorno e a_g crescenti: darle in quest'ordine",
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
    "generate_needs_spectrum": (
        "{section_generate} makes motions compatible with the spectrum of the demand: give "
        "{section_demand_spectrum} or {spectrum_file}",
        "{section_generate} genera moti compatibili con lo spettro della domanda: indicare "
        "{section_demand_spectrum} o {spectrum_file}",
    ),
    "no_wall": ("no [[wall]]: a case needs at least one wall", "nessuna [[wall]]: un caso richiede almeno una parete"),
    "two_spectra": (
        "give {spectrum} or {spectrum_file}, not both",
        "indicare {spectrum} o {spectrum_file}, non entrambi",
    ),
    "soil_factor_follows": (
        "{soil_factor} follows from {section_demand_spectrum}: leave it out",
        "{soil_factor} segue da {section_demand_spectrum}: toglierlo",
    ),
    "intensity_follows": (
        "{housner_intensity_cm} follows from the spectrum: leave one of them out",
        "{housner_intensity_cm} segue dallo spettro: togliere uno dei due",
    ),
    "code_needs": ("code {code} needs {key}", "la norma {code} richiede {key}"),
    "code_does_not_take": ("code {code} does not take {key}", "la norma {code} non ammette {key}"),
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
    "unknown_key": ("unknown key {value}; known: {known}", "chiave sconosciuta {value}; note: {known}"),
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
        "{way}, or run a case with --batch",
        "la finestra richiede PySide6 e pyqtgraph, e in Linux libgl1, libegl1 e libxkbcommon0 ({reason}); "
        "{way}, o calcolare un caso con --batch",
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
    "packages_missing": ("{work} needs {packages} ({reason}): {way}", "{work} richiede {packages} ({reason}): {way}"),
    "picture_not_made": ("The picture cannot be made.", "Non è possibile creare l'immagine."),
}
"""Of cases, settings, spectra and results: code -> (English, Italian). A placeholder without a value is a key of the
case."""
