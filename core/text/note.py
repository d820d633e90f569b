"""Texts of the calculation note."""

NOTE = {
    "PGA used [g]": "PGA usata [g]",
    "Other walls: the derivations are on the sheet Check": "Altre pareti: le derivazioni sono nel foglio Verifica",
    "Annexes": "Allegati",
    ", and the record nearest to the mean of the peaks": (", e l'accelerogramma più vicino alla media dei massimi"),
    "; behind it: {restraint}": "; a tergo: {restraint}",
    "; loads as arrows": "; carichi come frecce",
    "Calculation note: out-of-plane overturning of masonry walls (Circolare 7/2019, C8.7.1.2.1)": (
        "Relazione di calcolo: ribaltamento fuori piano di pareti in muratura (Circolare 7/2019, C8.7.1.2.1)"
    ),
    "Capacity curve (C8.7.1.3) over the demand, spectral displacement and acceleration": (
        "Curva di capacità (C8.7.1.3) e domanda nel piano spostamento-accelerazione spettrale (ADRS)"
    ),
    "Confirmed by": "Confermato da",
    "Deciding check": "Verifica decisiva",
    "Displacement check": "Verifica in spostamento",
    "Displacement of the control point at the demand: the largest peak": (
        "Spostamento del punto di controllo alla domanda: il massimo maggiore"
    ),
    "Distance [km]": "Distanza [km]",
    "Filter [Hz], processing": "Filtro [Hz], trattamento",
    "For comparison only: Eq. 9 of the paper": "Solo per confronto: Eq. 9 dell'articolo",
    (
        "Histories against 40-digit solutions and closed forms, checks against hand calculations, both "
        "repeated by the tests that come with the program; method of this analysis: {method}."
    ): (
        "Storie temporali confrontate con soluzioni a 40 cifre e in forma chiusa, verifiche con calcoli a "
        "mano, ripetuti dalle prove distribuite con il programma; metodo di questa analisi: {method}."
    ),
    (
        "Input changed since the run: q and ζ of the histories, and all that is marked 'of the run', are of the "
        "old wall. Run the case again."
    ): (
        "Dati modificati dopo l'analisi: q e ζ delle storie temporali, e ciò che è indicato «dell'analisi», sono "
        "della vecchia parete. Ripetere l'analisi."
    ),
    "Hazard of the site": "Pericolosità del sito",
    "storeys": "piani",
    "of the damaged building": "dell'edificio danneggiato",
    "Input changed since the run, grey is of the old wall: {title}": (
        "Dati modificati dopo l'analisi, in grigio la vecchia parete: {title}"
    ),
    "Kinematic chain": "Catena cinematica",
    "Largest rotation of each record at the demand over θc": (
        "Rotazione massima di ogni accelerogramma alla domanda, rispetto a θc"
    ),
    "Licence": "Licenza",
    "Limit state {state}": "Stato limite {state}",
    "Linear check": "Verifica lineare",
    "Calculation note": "Relazione",
    "Range of use": "Campo d'impiego",
    (
        "Rigid block, simple overturning about a hinge, loads of constant size and direction, no sliding, no "
        "vertical motion; equations and limits in the sheet Method of the workbook."
    ): (
        "Blocco rigido, ribaltamento semplice attorno a una cerniera, carichi di intensità e direzione "
        "costanti, senza scorrimento né moto verticale; equazioni e limiti nel foglio Metodo della cartella di lavoro."
    ),
    "Scale used": "Fattore usato",
    "Site and demand": "Sito e azione sismica",
    "The block": "Il blocco",
    "The program (NTC 2018 10.2)": "Il programma di calcolo (NTC 2018 10.2)",
    "The set is compatible with the spectrum (workbook, sheet Spectral compatibility).": (
        "L'insieme è compatibile con lo spettro (cartella di lavoro, foglio Compatibilità spettrale)."
    ),
    "The set is not compatible with the spectrum (workbook, sheet Spectral compatibility).": (
        "L'insieme non è compatibile con lo spettro (cartella di lavoro, foglio Compatibilità spettrale)."
    ),
    "Time histories": "Storie temporali",
    "Title": "Titolo",
    "Validation": "Validazione",
    "Verdicts of all walls": "Esito di tutte le pareti",
    "Version": "Versione",
    "Warnings on demand and records": "Avvertenze su azione e accelerogrammi",
    "What the mechanism withstands": "Che cosa sopporta il meccanismo",
    "acceleration that lifts the wall": "accelerazione che solleva la parete",
    "as given": "come data",
    "at collapse": "a collasso",
    "capacity": "capacità",
    "demand {percent} %": "domanda {percent} %",
    "exceeds θc or overturns": "supera θc o ribalta",
    "floor {percent} %": "piano {percent} %",
    "largest between T_0 and T_{state}": "massimo fra T_0 e T_{state}",
    "largest peak": "massimo maggiore",
    "mean of the peaks": "media dei massimi",
    "mean {value:.2f}, which decides": "media {value:.2f}, che decide",
    "not below a_g,SLD": "non minore di a_g,SLD",
    "of that part": "di quella parte",
    "lower end of the spread of q SLV, {q:.2f}, times e*": (
        "estremo inferiore della dispersione di q SLV, {q:.2f}, per e*"
    ),
    "of the run": "dell'analisi",
    "of the wall with the masses that move with it": "della parete con le masse solidali",
    "of this mechanism, class {letter}": "di questo meccanismo, classe {letter}",
    "on rock": "su suolo rigido",
    "one block, no other mass pushes it": "un blocco, nessun'altra massa lo spinge",
    "runs beyond θc": "analisi oltre θc",
    "stands": "resta in piedi",
    "table of walls": "tabella delle pareti",
    "the Ribalta authors": "gli autori di Ribalta",
    "velocity ratio of an impact: {model}": "coefficiente di restituzione: {model}",
    "velocity ratio of an impact: given": "coefficiente di restituzione: assegnato",
    "velocity ratio of an impact: {model}, impacts of the wall with what moves with it": (
        "coefficiente di restituzione: {model}, urti della parete con ciò che si muove con essa"
    ),
    "wall at {z:g} m, {kind}": "parete a {z:g} m, {kind}",
    "with the friction of the return walls, of the upper {h:.2f} m": (
        "con l'attrito dei muri ortogonali, dei {h:.2f} m superiori"
    ),
    "{wall}: sizes, hinge (red point) and mechanism (dashed)": (
        "{wall}: dimensioni, cerniera (punto rosso) e meccanismo (tratteggio)"
    ),
}
"""English -> Italian; the group "report"."""
