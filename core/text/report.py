"""The workbook's own words."""

REPORT = {
    "about the outer hinge": "rispetto alla cerniera esterna",
    "about the inner hinge": "rispetto alla cerniera interna",
    "Loads": "Carichi",
    "α0 with friction, top {h:.2f} m": "α0 con attrito, {h:.2f} m in alto",
    "e* of that part": "e* di quella parte",
    "lower end of the spread of q SLV": "estremo inferiore della dispersione di q SLV",
    "kin.": "cin.",
    "all hinges": "tutte le cerniere",
    ("The weakest of its {n} hinges asks {force:.2f} kN/m."): (
        "La più debole delle sue {n} cerniere richiede {force:.2f} kN/m."
    ),
    "One of its {n} hinges does not reach it with any.": "Una delle sue {n} cerniere non lo raggiunge con nessuna.",
    "Risk": "Rischio",
    "What each mechanism withstands": "Che cosa sopporta ogni meccanismo",
    (
        "PGA_C = ζ S a_g; the shape of the spectrum is taken as fixed. IS-V is of this mechanism: the class of the "
        "building asks for a global analysis (D.M. 65/2017, Annex A). Limit states by the hazard of the site and "
        "the kinematic check."
    ): (
        "PGA_C = ζ S a_g; la forma dello spettro si assume fissa. L'IS-V è di questo meccanismo: la classe "
        "dell'edificio richiede un'analisi globale (D.M. 65/2017, Allegato A). Stati limite con la pericolosità del "
        "sito e la verifica cinematica."
    ),
    "by": "con",
    "smallest": "minimo",
    "Tie for the ζ required": "Catena per lo ζ richiesto",
    "Force [kN/m]": "Forza [kN/m]",
    "Largest [kN/m]": "Massima [kN/m]",
    "none reaches it": "nessuna lo raggiunge",
    (
        "By hand, no friction: α0 = (W·x {own:.2f} + loads {loads:.2f} + F·h {force:.2f}) / {pushing:.2f} = "
        "{alpha0:.4f}"
    ): (
        "A mano, senza attrito: α0 = (W·x {own:.2f} + carichi {loads:.2f} + F·h {force:.2f}) / {pushing:.2f} = "
        "{alpha0:.4f}"
    ),
    "Before and after": "Prima e dopo",
    "ζ before": "ζ prima",
    "ζ after": "ζ dopo",
    "changed": "che cosa cambia",
    "nothing": "nulla",
    "No tie {h:.2f} m above this hinge reaches the ζ required: the largest, {largest:.2f} kN/m, gives {zeta:.2f}.": (
        "Nessuna catena {h:.2f} m sopra questa cerniera raggiunge lo ζ richiesto: la massima, {largest:.2f} "
        "kN/m, dà {zeta:.2f}."
    ),
    ("No tie {h:.2f} m above this hinge is needed: ζ {zeta:.2f}."): (
        "Non serve una catena {h:.2f} m sopra questa cerniera: ζ {zeta:.2f}."
    ),
    "Not for sizing a tie: a bar yields and is slack when the wall comes back, and other checks ask more.": (
        "Non per dimensionare una catena: una barra snerva ed è lenta quando la parete torna, e altre verifiche "
        "chiedono "
        "di più."
    ),
    "A tie {h:.2f} m above this hinge that holds {force:.2f} kN/m up to collapse gives ζ {zeta:.2f}.": (
        "Una catena {h:.2f} m sopra questa cerniera che mantiene {force:.2f} kN/m fino al collasso dà ζ {zeta:.2f}."
    ),
    "Check": "Verifica",
    "SI of the demand": "SI della domanda",
    "q_eff of the demand": "q_eff della domanda",
    "q = q_eff S a_g / g of the demand": "q = q_eff S a_g / g della domanda",
    "S = S_S S_T ({soil}, {topography})": "S = S_S S_T ({soil}, {topography})",
    "T_R,C = T_R,D ζ^η, min": "T_R,C = T_R,D ζ^η, min",
    "T_R,C, max": "T_R,C, max",
    "q: {check}": "q: {check}",
    "ζ: {check}": "ζ: {check}",
    "ζ_E, {on}": "ζ_E, {on}",
    "Loads, about the outer hinge": "Carichi, rispetto alla cerniera esterna",
    "Loads, about the inner hinge": "Carichi, rispetto alla cerniera interna",
    "Check of the equations": "Verifica delle equazioni",
    (
        "Column C is a live formula of this sheet, column D the value of the program: they must agree. In the "
        "tables of records each pair stands side by side. Yellow cells may be changed."
    ): (
        "La colonna C è una formula viva di questo foglio, la colonna D il valore del programma: devono "
        "coincidere. Nelle tabelle degli accelerogrammi ogni coppia è affiancata. Le celle gialle si possono cambiare."
    ),
    "Demand": "Domanda",
    "a_g on rock": "a_g su suolo rigido",
    "q of the code": "fattore di comportamento q",
    "velocity ratio e ({model})": "coefficiente di restituzione e ({model})",
    "no number": "nessun valore",
    "No demand given: no check.": "Nessuna domanda assegnata: nessuna verifica.",
    "H = 2 R_eq cos α (equivalent)": "H = 2 R_eq cos α (equivalente)",
    "hinge setback u": "arretramento cerniera u",
    "Record (governing sign)": "Accelerogramma (segno più gravoso)",
    "Scale C": "Scala C",
    "program": "programma",
    "q of Eq. 15/16": "q delle Eq. 15/16",
    "q of the time histories, collapse": "q delle storie, collasso",
    "q of the time histories, SLV": "q delle storie, SLV",
    "q of the time histories, robust": "q delle storie, robusto",
    "ratio": "rapporto",
    "outcome": "esito",
    "passed": "soddisfatta",
    "not passed": "non soddisfatta",
    "ζ required": "ζ richiesto",
    "element free to vibrate": "elemento libero di vibrare",
    "not free to vibrate": "non libera di vibrare",
    "run again": "rifare l'analisi",
    "Circolare 7/2019, wall at {z:g} m, {kind}": "Circolare 7/2019, parete a {z:g} m, {kind}",
    "Floors": "Piani",
    "Motion of the floors": "Moto dei piani",
    (
        "The floor moves with the modes of the linear building, what they leave out with the ground. C multiplies the "
        "record of the ground. Code and records are compared at the mechanism's damping; nothing is rescaled."
    ): (
        "Il piano si muove con i modi dell'edificio lineare, ciò che essi non colgono con il suolo. C moltiplica "
        "l'accelerogramma al suolo. Norma e accelerogrammi sono confrontati allo smorzamento del meccanismo; nulla è "
        "riscalato."
    ),
    "years": "anni",
    "T_R,C by the hazard of the site": "T_R,C dalla pericolosità del sito",
    "IS-V of this mechanism, class {letter}": "IS-V di questo meccanismo, classe {letter}",
    "z = {z:g} m": "z = {z:g} m",
    "Mode": "Modo",
    "estimate": "stima",
    "code, C7.2.5": "norma, C7.2.5",
    "mean of the floor motions": "media dei moti di piano",
    "Floor spectra, z = {z:g} m, ξ = {damping:.0f} %": "Spettri di piano, z = {z:g} m, ξ = {damping:.0f} %",
    "Not drawn above the ground and with loads, where Eq. 15 and 16 do not hold.": (
        "Non disegnato sopra il suolo e con carichi, dove le Eq. 15 e 16 non valgono."
    ),
    "Circolare 7/2019, wall on the ground, {kind}": "Circolare 7/2019, parete al suolo, {kind}",
    "not below a_g,SLD / a_g": "non minore di a_g,SLD / a_g",
    "M* per metre": "M* per metro",
    "M* per metre of that part": "M* per metro di quella parte",
    "of the upper {h:.2f} m with friction": "dei {h:.2f} m superiori con attrito",
    "No linear check: T_0 is not known (see the verdict).": (
        "Nessuna verifica lineare: T_0 non è noto (vedere l'esito)."
    ),
    "unit weight": "peso specifico",
    "θmax/θc of the set (Dynamic check)": "θmax/θc dell'insieme (Verifica dinamica)",
    "Dynamic check": "Verifica dinamica",
    "Spectral compatibility": "Compatibilità spettrale",
    "Dynamic check, Circolare 7/2019 C8.7.1.2.1.9": "Verifica dinamica, Circolare 7/2019 C8.7.1.2.1.9",
    (
        "The rule: θc is exceeded in no run and the set of the largest rotations, of each record its worse "
        "sign, stays within the limit: mean from 7 stations, else the largest. FC divides the strength of the "
        "wall (clause .3) or multiplies the demand, as said below. Whether the rule holds is not monotone in the "
        "multiplier: ζ_E is the lowest multiplier of the demand at which half of those within ±10 % of it fail, "
        "ζ_16 that at which 16 % do. Verified: the rule holds at the demand itself and ζ_E reaches what is "
        "required. Steps of {STEP:.2%}; another grid would give a ζ_E within the spread printed."
    ): (
        "La regola: θc non è mai superato e l'insieme delle rotazioni massime, per ogni accelerogramma il "
        "segno peggiore, resta entro il limite: media da 7 stazioni, altrimenti il massimo. FC divide la "
        "resistenza della parete (punto .3) o moltiplica la domanda, come indicato sotto. La regola non è "
        "monotona nel moltiplicatore: ζ_E è il minimo moltiplicatore della domanda al quale metà di quelli "
        "entro ±10 % non la soddisfa, ζ_16 quello al quale non la soddisfa il 16 %. Verificata: la regola "
        "vale alla domanda stessa e ζ_E raggiunge il valore richiesto. Passo {STEP:.2%}; un'altra griglia "
        "darebbe uno ζ_E entro la dispersione indicata."
    ),
    "runs in which θc is exceeded": "analisi in cui θc è superato",
    "limit {limit_state}": "limite {limit_state}",
    "rule at the demand": "regola alla domanda",
    "Compatibility of the records with the target spectrum": ("Compatibilità degli accelerogrammi con lo spettro"),
    "The set is compatible": "L'insieme è compatibile",
    "The set is not compatible": "L'insieme non è compatibile",
    (
        "A rigid block has no period T1: the rules are applied from {low:.2f} to {high:.2f} s, with natural "
        "records up to the longest T_SLV or T_SLC of the walls. Records at the demand, FC apart. Peaks between "
        "samples are seen."
    ): (
        "Un blocco rigido non ha un periodo T1: le regole valgono da {low:.2f} a {high:.2f} s, con "
        "accelerogrammi naturali fino al più lungo T_SLV o T_SLC delle pareti. Accelerogrammi alla domanda, "
        "senza FC. I picchi fra i campioni sono considerati."
    ),
    "target": "spettro",
    "mean": "media",
    "5 % acceleration spectra": "Spettri di accelerazione al 5 %",
    "Not made: it takes records, a demand at SLV or SLC, and a wall on the ground.": (
        "Non eseguita: richiede accelerogrammi, una domanda allo SLV o SLC e una parete al suolo."
    ),
    "Factor": "Fattore",
    "worse": "peggiore",
    "Status": "Esito",
    "spread of ζ_E, from": "dispersione di ζ_E, da",
    "spread of ζ_E, to": "dispersione di ζ_E, a",
    "ζ of the first failure on the grid": "ζ del primo cedimento sulla griglia",
    "share failing within ±10 % of the demand": "quota che cede entro ±10 % dalla domanda",
    "Not shown: it takes records and a target spectrum, of a code or of a file.": (
        "Non mostrata: richiede accelerogrammi e uno spettro, di norma o da file."
    ),
    "Rule": "Regola",
    "Clause": "Paragrafo",
    "Value": "Valore",
    "Limit": "Limite",
    "Unit": "Unità",
    "Outcome": "Esito",
    "q against SI": "q e SI",
    "Histories": "Storie temporali",
    "Survival map": "Mappa di sopravvivenza",
    "Effective q against Housner intensity": "q effettivo e intensità di Housner",
    "Rotation at first collapse": "Rotazione al primo collasso",
    "survives": "resiste",
    "collapses": "crolla",
    (
        "White survives, red collapses, between them both within a column of 2 % in q; grey was not analysed. A "
        "white field right of a red one is a wall surviving a stronger motion."
    ): (
        "Bianco resiste, rosso crolla, in mezzo entrambi entro il 2 % in q; grigio non analizzato. Un campo "
        "bianco a destra di uno rosso è una parete che resiste a un moto più forte."
    ),
    "No run with a number of q.": "Nessuna analisi con un valore di q.",
    "time histories": "storie temporali",
    "No records.": "Nessun accelerogramma.",
    "Wall": "Parete",
    "Mechanism": "Meccanismo",
    "Record": "Accelerogramma",
    "{n} more runs are in the JSON.": "Altre {n} analisi nel JSON.",
    "Not drawn: ": "Non disegnate: ",
    "input": "dato",
    "Equation": "Equazione",
    "Sheet": "Foglio",
    "Program": "Programma",
    "Input": "Dati",
    "Records": "Accelerogrammi",
    "Results": "Risultati",
    "Method": "Metodo",
    "Input as read": "Dati letti",
    "Ground motions": "Accelerogrammi",
    (
        "SI: integral of the 5 % pseudo-velocity from 0.1 to 2.5 s (Eq. 11), not divided by 2.4. PGV and PGD "
        "without baseline step: no meaning for uncorrected records. Nothing trimmed or resampled. SHA-256: first "
        "16 digits of the file's hash; the whole one is in the JSON."
    ): (
        "SI: integrale della pseudo-velocità al 5 % da 0,1 a 2,5 s (Eq. 11), non diviso per 2,4. PGV e PGD "
        "senza correzione della linea di base: senza significato per accelerogrammi non corretti. Nessun taglio o "
        "ricampionamento. SHA-256: prime 16 cifre; per intero nel JSON."
    ),
    "Incremental dynamic analysis: grid step {step:g} %, method {method_words}": (
        "Analisi dinamica incrementale: passo {step:g} %, metodo {method_words}"
    ),
    (
        "q, q SLV, q SLC: first collapse, first peak at 0.40 and 0.60 θc on the grid, bisected to 1e-4. "
        "Survival, share and windows are of the map and depend on the grid step ({step:g} %)."
    ): (
        "q, q SLV, q SLC: primo collasso e prima rotazione pari a 0,40 e 0,60 θc sulla griglia, bisezione "
        "a 1e-4. Sopravvivenza, quota e finestre dipendono dal passo ({step:g} %)."
    ),
    "Method, range of use, provenance": "Metodo, campo d'impiego, provenienza",
    "rigid": "rigida",
    "minimum": "minimo",
    "minimum, too few": "minimo, troppo pochi",
    "incomplete": "incompleto",
    "collapse found": "collasso trovato",
    "no collapse found": "nessun collasso",
    "impact limit": "limite di urti",
    "Format": "Formato",
    "Samples": "Campioni",
    "Event and station": "Evento e stazione",
    "Kind": "Tipo",
    "Date": "Data",
    "Magnitude": "Magnitudo",
    "Distance": "Distanza",
    "Soil": "Categoria di sottosuolo",
    "Filter": "Filtro",
    "Sign": "Segno",
    "bracket low": "da",
    "bracket high": "a",
    "q robust": "q robusto",
    "last survival": "ultima sopravv.",
    "survived share": "quota sopravv.",
    "windows": "finestre",
    "analyses": "analisi",
    "unknown points": "punti ignoti",
    "Eq. 7 clamped": "Eq. 7 limitata",
    "Case SHA-256": "SHA-256 del caso",
    "Search": "Ricerca",
    "Sign of the records": "Segno degli accelerogrammi",
    "Error of the solver": "Errore del risolutore",
    (
        "q by dormand_prince: {_digits} against {q:.4f}, difference {_percent}; history against DOP853 of scipy "
        "at the last survived scale: {_power} of θc."
    ): (
        "q con dormand_prince: {_digits} contro {q:.4f}, differenza {_percent}; storia rispetto a DOP853 di "
        "scipy all'ultima scala sopportata: {_power} di θc."
    ),
    "Spread by definition": "Dispersione per definizione",
    "Methods on this history": "Metodi su questa storia",
    "yes": "sì",
    "no": "no",
    "default": "predefinito",
    "as recorded": "come registrato",
    "reversed": "invertito",
    "trilinear": "trilineare",
    "see Input and the JSON": "vedi Dati e il JSON",
    "How sure": "Quanto è sicuro",
    "Samples rounded to five figures: q spreads ": "Campioni arrotondati a cinque cifre: q varia del ",
    " Sign: ": " Segno: ",
    "q (q robust) by step of the search: ": "q (q robusto) per passo della ricerca: ",
    "Summary": "Sintesi",
    "Overview": "Riepilogo",
    (
        "Out-of-plane overturning of masonry walls: rocking analysis, force reduction factor q (Coccia, Di "
        "Carlo, Imperatore 2016) and checks of the Circolare 7/2019, C8.7.1.2.1"
    ): (
        "Ribaltamento fuori piano di pareti in muratura: analisi del blocco oscillante, fattore di comportamento "
        "q (Coccia, Di Carlo, Imperatore 2016) e verifiche della Circolare 7/2019, C8.7.1.2.1"
    ),
    "Overview of the walls": "Riepilogo delle pareti",
    "record": "accelerogramma",
    "Warnings": "Avvertenze",
    "Assumptions confirmed by the engineer": "Ipotesi confermate dal progettista",
    "Reasoned judgement on the results (NTC 2018 10.2)": (
        "Giudizio motivato di accettabilità dei risultati (NTC 2018 10.2)"
    ),
    "Engineer": "Il progettista",
    "Place and date": "Luogo e data",
    "Signature and stamp": "Firma e timbro",
    "The {SUMMARY_WALLS} lowest of {n} walls; all on the sheet Overview.": (
        "Le {SUMMARY_WALLS} peggiori di {n} pareti; tutte nel foglio Riepilogo."
    ),
    "Client": "Committente",
    "Site": "Luogo",
    "Project": "Progetto",
    "Author": "Autore",
    "Revision": "Revisione",
    "on rock, S apart": "su suolo rigido, S a parte",
    "Verdict": "Esito",
    "Capacity": "Capacità",
    "free to vibrate": "libera di vibrare",
    "demand": "domanda",
    "none": "nessuna",
    "{n} more on the sheets Records and Check.": "Altre {n} nei fogli Accelerogrammi e Verifica.",
    "Seismic site": "Sito sismico",
    "given": "assegnata",
    "of the spectrum": "dello spettro",
    "from the records": "dagli accelerogrammi",
    "Eq. 9, without e* and FC": "Eq. 9, senza e* e FC",
}
"""English -> Italian."""
