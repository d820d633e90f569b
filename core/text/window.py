"""The words of the window."""

WINDOW = {
    "Check": "Verifica",
    "Histories": "Storie temporali",
    "Capacity": "Capacità",
    "q against SI": "q e SI",
    "Spectra": "Spettri",
    "Validation": "Validazione",
    "Wall shown": "Parete mostrata",
    "Run (F5)": "Esegui (F5)",
    "Walls": "Pareti",
    "Demand": "Domanda",
    "Report": "Relazione",
    "Input": "Dati",
    "Records": "Accelerogrammi",
    "No result yet: press F5.": "Nessun risultato: premere F5.",
    "Verdict": "Esito",
    "&File": "&File",
    "&New": "&Nuovo",
    "&Open…": "&Apri…",
    "Open &recent": "Apri &recenti",
    "Open the &example": "Apri l'&esempio",
    "&Save": "&Salva",
    "Save &as…": "Salva &con nome…",
    "&Export workbook…": "&Esporta cartella di lavoro…",
    "&Quit": "&Esci",
    "&Edit": "&Modifica",
    "&Undo": "&Annulla",
    "&Redo": "&Ripeti",
    "&Paste walls": "&Incolla pareti",
    "&Run": "E&segui",
    "&Cancel": "&Interrompi",
    "&View": "&Visualizza",
    "Theme": "Tema",
    "light": "chiaro",
    "dark": "scuro",
    "Language": "Lingua",
    "&Help": "&Aiuto",
    "&About": "&Informazioni",
    "Progress": "Avanzamento",
    "Cancel": "Interrompi",
    "untitled": "senza nome",
    "The input has changed: press F5.": "I dati sono cambiati: premere F5.",
    "Cancelled.": "Interrotto.",
    "Running…": "In esecuzione…",
    "{done} of {planned}, {elapsed:.0f} s": "{done} di {planned}, {elapsed:.0f} s",
    "{done} of {planned}, {elapsed:.0f} s, about {left:.0f} s left": (
        "{done} di {planned}, {elapsed:.0f} s, restano circa {left:.0f} s"
    ),
    "Details are in {log}": "I dettagli sono in {log}",
    "Not done.": "Non eseguito.",
    "Not done": "Non eseguito",
    "{n} analyses in {seconds:.1f} s": "{n} analisi in {seconds:.1f} s",
    "Not opened": "Non aperto",
    "Open a case": "Apri un caso",
    "Cases": "Casi",
    "Save the case": "Salva il caso",
    "Not saved": "Non salvato",
    "Export the workbook": "Esporta la cartella di lavoro",
    "The results are not of this input: run it first (F5).": (
        "I risultati non sono di questi dati: eseguire prima (F5)."
    ),
    "{path} is there already. Overwrite it?": "{path} esiste già. Sovrascrivere?",
    "Nothing exported": "Nulla esportato",
    "Written: {path}": "Scritto: {path}",
    "Unsaved changes": "Modifiche non salvate",
    "Save the changes of this case?": "Salvare le modifiche di questo caso?",
    (
        "{name} {version}\nOut-of-plane overturning of masonry walls (Coccia, Di Carlo, Imperatore 2016; "
        "Circolare 7/2019 C8.7.1.2.1). The results are the engineer's responsibility."
    ): (
        "{name} {version}\nRibaltamento fuori piano di pareti in muratura (Coccia, Di Carlo, Imperatore 2016; "
        "Circolare 7/2019 C8.7.1.2.1). I risultati sono responsabilità del progettista."
    ),
    "Autosaved case found": "Trovato un caso salvato automaticamente",
    "The program ended by a fault the last time; please send {path}": (
        "L'ultima volta il programma è terminato per un errore interno; si prega di inviare {path}"
    ),
    "The program ended without saving. Bring back the unsaved case?": (
        "Il programma si è chiuso senza salvare. Recuperare il caso non salvato?"
    ),
    "Compiling the solver, once for each version: some seconds…": (
        "Compilazione del risolutore, una volta per versione: alcuni secondi…"
    ),
    "Preparing the solver…": "Preparazione del risolutore…",
    "Ready.": "Pronto.",
    "Check against a demand": "Verifica rispetto a una domanda",
    "Limit state": "Stato limite",
    "On rigid ground (su suolo rigido); S apart": "Su suolo rigido; S a parte",
    "a_g on rigid ground, S apart": "a_g su suolo rigido, S a parte",
    "Spectrum": "Spettro",
    "no spectrum, S given": "nessuno spettro, S assegnato",
    "spectrum of a file": "spettro da file",
    "Intensity SI": "Intensità SI",
    "Soil": "Categoria di sottosuolo",
    "Topography": "Categoria topografica",
    "Type": "Tipo",
    "Choose file…": "Scegli file…",
    "Less than 1.35: with LC2 or LC3, what was investigated and the strength f of each wall": (
        "Meno di 1,35: con LC2 o LC3, le indagini svolte e la resistenza f di ogni parete"
    ),
    "Level of knowledge": "Livello di conoscenza",
    "Investigations": "Indagini svolte",
    "Records at the demand": "Accelerogrammi alla domanda",
    "as given": "come dati",
    "scaled to PGA = a_g S": "scalati a PGA = a_g S",
    "ζ required": "ζ richiesto",
    "q of the code": "fattore di comportamento q",
    "Site": "Sito",
    "Coordinates": "Coordinate",
    "years": "anni",
    "Spectrum: two columns, s and g": "Spettro: due colonne, s e g",
    "Method": "Metodo",
    "automatic": "automatico",
    "Step of the search": "Passo della ricerca",
    "Largest q": "q massimo",
    "Map up to times q": "Estensione della mappa (× q)",
    "Robust window": "Finestra robusta",
    "Sign of the records": "Segno degli accelerogrammi",
    "as recorded": "come registrato",
    "reversed": "invertito",
    "State the accuracy": "Valuta l'accuratezza",
    "Seconds a wall: error of the solver and spread of q in the report": (
        "Secondi per parete: errore del risolutore e dispersione di q nella relazione"
    ),
    "Client": "Committente",
    "Place": "Luogo",
    "Project": "Progetto",
    "Author": "Autore",
    "Revision": "Revisione",
    "Date": "Data",
    "Report in": "Relazione in",
    "Title": "Titolo",
    "Analysis": "Analisi",
    "a number is needed here": "qui è richiesto un numero",
    "{text}: not a number": "{text}: non è un numero",
    "Records found": "Accelerogrammi trovati",
    "Preview": "Anteprima",
    "as the file says": "come dice il file",
    "Unit": "Unità",
    "Kind": "Tipo",
    "Choices apply to the files selected; those not readable are left out. Tick the channels to take.": (
        "Le scelte valgono per i file selezionati; quelli non leggibili sono esclusi. Spuntare i canali da prendere."
    ),
    "{name} (vertical)": "{name} (verticale)",
    "Use": "Usa",
    "Record": "Accelerogramma",
    "D5-95 [s]": "D5-95 [s]",
    "Sign": "Segno",
    "Format": "Formato",
    "Drop accelerograms or folders here.": "Trascinare qui accelerogrammi o cartelle.",
    "Add…": "Aggiungi…",
    "Add accelerograms": "Aggiungi accelerogrammi",
    "Generate…": "Genera…",
    "Seven motions compatible with the spectrum": "Sette moti compatibili con lo spettro",
    "Reverse": "Inverti",
    "Change the sign of the selected records": "Cambia il segno degli accelerogrammi selezionati",
    "Remove": "Togli",
    "Remove the selected records": "Togli gli accelerogrammi selezionati",
    "{n} records in use. Drop accelerograms or folders here.": (
        "{n} accelerogrammi in uso. Trascinare qui accelerogrammi o cartelle."
    ),
    "Choose a spectrum on the sheet Demand first.": "Scegliere prima uno spettro nella scheda Domanda.",
    "default of the mechanism": "secondo il meccanismo",
    "Sorrentino, experimental (Eq. 5)": "Sorrentino, sperimentale (Eq. 5)",
    "Costa, upper bound": "Costa, limite superiore",
    "one-sided, theoretical (Eq. 6)": "un lato, teorico (Eq. 6)",
    "one-sided, experimental (Eq. 7)": "un lato, sperimentale (Eq. 7)",
    "given velocity ratio": "coefficiente di restituzione dato",
    "Name": "Nome",
    "Height H": "Altezza H",
    "Thickness t": "Spessore t",
    "Slenderness α": "Angolo α = arctan(t/H)",
    "arctan(t/H): larger is stockier": "arctan(t/H): maggiore è più tozza",
    "Radius R": "Raggio R",
    "Hinge setback u": "Arretramento u",
    "The wall turns about a hinge inside its edge: tan α = (t − 2u)/H": (
        "La parete ruota attorno a una cerniera arretrata dal bordo: tan α = (t − 2u)/H"
    ),
    "Strength f": "Resistenza f",
    "Gives the setback u = 2 N / (3 f L), N with the loads: give the unit weight and omit the setback": (
        "Dà l'arretramento u = 2 N / (3 f L), N con i carichi: indicare il peso specifico e omettere l'arretramento"
    ),
    "Unit weight": "Peso specifico",
    "Length L": "Lunghezza L",
    "Base above ground z": "Base sopra il suolo z",
    "Floor": "Piano",
    "Restraint behind": "Vincolo posteriore",
    "Notes": "Note",
    "No load from floors or roof": "Nessun carico da solai o tetto",
    "Model": "Modello",
    "Velocity ratio e": "Coefficiente di restituzione e",
    "rigid": "rigida",
    "own D1, D2": "D1, D2 propri",
    "Moment-rotation law": "Legge momento-rotazione",
    "Add": "Nuova",
    "Add a wall": "Aggiungi una parete",
    "Duplicate": "Duplica",
    "Copy this wall": "Copia questa parete",
    "Delete": "Elimina",
    "Delete this wall": "Elimina questa parete",
    "Paste": "Incolla",
    "Paste rows copied from Excel": "Incolla righe copiate da Excel",
    "Table…": "Tabella…",
    "Read walls from .xlsx or .csv": "Leggi pareti da .xlsx o .csv",
    "Geometry": "Geometria",
    "Geometry given by": "Geometria data da",
    "height and thickness": "altezza e spessore",
    "height and slenderness": "altezza e snellezza",
    "height and H/t": "altezza e H/t",
    "general block": "blocco generico",
    "Mechanism": "Meccanismo",
    "Free on both faces: rocks to both sides": "Libera sulle due facce: oscilla sui due lati",
    "A restraint behind: rocks outwards only": "Vincolo posteriore: oscilla solo verso l'esterno",
    "Two results: with the restraint behind and without": "Due risultati: con il vincolo posteriore e senza",
    "Restitution and law": "Restituzione e legge",
    "For checks and report": "Per verifiche e relazione",
    "No wall yet: press Add.": "Nessuna parete: premere Nuova.",
    "Choose a mechanism.": "Scegliere un meccanismo.",
    "Sizes, weights or loads are still to be given.": "Dimensioni, pesi o carichi sono ancora da indicare.",
    "wall": "parete",
    "Read walls": "Leggi pareti",
    "Tables": "Tabelle",
    "Walls not read": "Pareti non lette",
    "Reset": "Tutto",
    "Show everything": "Mostra tutto",
    "Copy": "Copia",
    "Copy the picture": "Copia l'immagine",
    "Save the data as CSV": "Salva i dati come CSV",
    "Save the chart": "Salva il grafico",
    "Multiplier of the record": "Moltiplicatore dell'accelerogramma",
    "Play": "Riproduci",
    "Ground motion": "Moto del suolo",
    "Rotation": "Rotazione",
    "Building of the walls above the ground": "Edificio delle pareti sopra il suolo",
    "Storeys": "Piani",
    "Elastic period T_1": "Periodo elastico T_1",
    "Empty: 0.05 H^0.75, an estimate": "Vuoto: 0,05 H^0,75, una stima",
    "Damaged over elastic period": "Periodo danneggiato su elastico",
    "C8.7.1.2.1.4: 1.5 to 2.0 at SLV and SLC; empty: 1.5, at SLD 1.0": (
        "C8.7.1.2.1.4: da 1,5 a 2,0 a SLV e SLC; vuoto: 1,5, a SLD 1,0"
    ),
    "Damping of the building": "Smorzamento dell'edificio",
    "C8.7.1.2.1.4: 10 to 20 % at SLV and SLC; empty: 10 %, at SLD 5 %": (
        "C8.7.1.2.1.4: dal 10 al 20 % a SLV e SLC; vuoto: 10 %, a SLD 5 %"
    ),
    "Needed where a wall has its base above the ground.": ("Serve dove una parete ha la base sopra il suolo."),
    "At the top: T {period:.3f} s, ξ {damping:.0f} %, γψ {part:.3f}": (
        "In sommità: T {period:.3f} s, ξ {damping:.0f} %, γψ {part:.3f}"
    ),
    "T_1 {period:.3f} s is an estimate.": "T_1 {period:.3f} s è una stima.",
    "Floor spectra": "Spettri di piano",
    "code, z {z:g} m, ξ {damping:.0f} %": "norma, z {z:g} m, ξ {damping:.0f} %",
    "T_R,C {years} years": "T_R,C {years} anni",
    "IS-V of this mechanism {index:.2f}, class {letter}": ("IS-V di questo meccanismo {index:.2f}, classe {letter}"),
    "mean of the floors": "media dei piani",
    "floor": "piano",
    "ground": "suolo",
    "impacts": "urti",
    "stands": "resiste",
    "State the accuracy for this wall (some seconds)": ("Valuta l'accuratezza per questa parete (alcuni secondi)"),
    "Error of the solver and spread of q by definition, for this wall and its governing record.": (
        "Errore del risolutore e dispersione di q per definizione, per questa parete e il suo "
        "accelerogramma più gravoso."
    ),
    "time per history [ms]": "tempo per storia [ms]",
    "error / α [-]": "errore / α [-]",
    "Accuracy against speed": "Accuratezza e velocità",
    "Phase portrait": "Piano delle fasi",
    "Moment against rotation": "Momento e rotazione",
    "law": "legge",
    "survives": "resiste",
    "Solver ({method}): error of q {q}, of the history {history} α ({record}).": (
        "Solutore ({method}): errore di q {q}, della storia {history} α ({record})."
    ),
    (
        "Definition: by the step of the search q spreads {q}, q robust {robust}; by rounding the record to five "
        "figures {rounded} and {rounded_robust}."
    ): (
        "Definizione: con il passo della ricerca q varia del {q}, q robusto del {robust}; arrotondando "
        "l'accelerogramma a cinque cifre del {rounded} e {rounded_robust}."
    ),
    "Checks": "Verifiche",
    "Clause": "Paragrafo",
    "Outcome": "Esito",
    "record": "accelerogramma",
    "Peaks at the demand": "Massimi alla domanda",
    "No demand: no check. q of the wall: {q}": "Nessuna domanda: nessuna verifica. q della parete: {q}",
    "within θc": "entro θc",
    "exceeds θc or overturns": "supera θc o ribalta",
    "Peak rotation against q": "Rotazione massima e q",
    "run": "analisi",
    "Survival map": "Mappa di sopravvivenza",
    "share collapsed [-]": "quota di collassi [-]",
    "Fragility": "Fragilità",
    "fragility": "fragilità",
    "Logarithmic axes": "Assi logaritmici",
    "Not drawn above the ground and with loads, where Eq. 15 and 16 do not hold.": (
        "Non disegnato sopra il suolo e con carichi, dove le Eq. 15 e 16 non valgono."
    ),
    "No record with a q.": "Nessun accelerogramma con un q.",
    "time histories": "storie temporali",
    "set: q {q}, q robust {robust}": "insieme: q {q}, q robusto {robust}",
    "Compatibility": "Compatibilità",
    "Rule": "Regola",
    "Value": "Valore",
    "Limit": "Limite",
    "mean of the records": "media degli accelerogrammi",
    "target: {name}": "spettro: {name}",
    "SI is the area under the pseudo-velocity from 0.1 to 2.5 s (shaded).": (
        "SI è l'area sotto la pseudo-velocità da 0,1 a 2,5 s (in grigio)."
    ),
    "Files": "File",
    "Time step": "Passo temporale",
    "Column": "Colonna",
    "Lines to skip": "Righe da saltare",
    "Of plain text: the column of the acceleration, 1 is the first": (
        "Di testo semplice: la colonna dell'accelerazione, 1 è la prima"
    ),
    "Of plain text: lines of the head before the numbers": ("Di testo semplice: righe d'intestazione prima dei numeri"),
    "{n} more files are not shown: add them in parts.": ("Altri {n} file non sono mostrati: aggiungerli a parti."),
    "Generated motions are one set: Remove takes them all, Generate… makes others.": (
        "I moti generati sono un solo gruppo: Togli li toglie tutti, Genera… ne fa altri."
    ),
    "No files there.": "Nessun file trovato.",
    "theory: angular momentum kept, no sliding, no bouncing": (
        "teoria: momento angolare conservato, senza scorrimento né rimbalzo"
    ),
    "tests on walls of tuff units and of clay bricks": "prove su pareti di tufo e di mattoni pieni",
    "tests on sack stone masonry; above Eq. 4 for α > 6.63°": (
        "prove su muratura a sacco; sopra l'Eq. 4 per α > 6,63°"
    ),
    "theory: impacts of base, upper corner and base again": ("teoria: urti di base, spigolo superiore e di nuovo base"),
    "tests; v over the overturning velocity, beyond v = 1.58 held at e = 0; value for v = 0": (
        "prove; v sulla velocità di ribaltamento, oltre v = 1,58 tenuto a e = 0; valore per v = 0"
    ),
    "given, 0 to 1": "dato, da 0 a 1",
    "It is being written.": "È in corso la scrittura.",
    "{n} files were left out: they cannot be read as they are.": (
        "{n} file sono stati lasciati fuori: così come sono non si leggono."
    ),
    "Saved without what stands in the red field.": "Salvato senza quanto sta nel campo rosso.",
    "Another program has changed {path}. Overwrite it?": ("Un altro programma ha cambiato {path}. Sovrascriverlo?"),
    "Needed with a demand: 0 on the ground; above it the building is needed too (sheet Demand)": (
        "Richiesta con una domanda: 0 al suolo; più in alto serve anche l'edificio (scheda Domanda)"
    ),
    "Free to vibrate": "Libera di vibrare",
    "two-sided yes, one-sided no": "su due lati sì, su un lato no",
    "yes": "sì",
    "no": "no",
    "Parapet, gable top, pinnacle, free wall: no transverse wall holds it before it moves": (
        "Parapetto, sommità di timpano, pinnacolo, muro isolato: nessun muro trasversale la trattiene prima del moto"
    ),
    "Elastic modulus E": "Modulo elastico E",
    "With the unit weight gives T_0 of an element free to vibrate (C8.7.1.7)": (
        "Con il peso specifico dà T_0 di un elemento libero di vibrare (C8.7.1.7)"
    ),
    "FC acts": "FC agisce",
    "on the strength": "sulla resistenza",
    "on the demand": "sulla domanda",
    "C8.7.1.2.1.3: on the strength of the capacity curve; on the demand is more cautious": (
        "C8.7.1.2.1.3: sulla resistenza della curva di capacità; sulla domanda è più cautelativo"
    ),
    "Periods compared": "Periodi confrontati",
    "Compatibility of the records; empty: 0.15 to 2.0 s, natural records to T_SLV": (
        "Compatibilità degli accelerogrammi; vuoto: da 0,15 a 2,0 s, naturali fino a T_SLV"
    ),
    "{text}: not two numbers": "{text}: non sono due numeri",
    "Element free to vibrate": "Elemento libero di vibrare",
    "Not free to vibrate": "Non libera di vibrare",
    "failing within ±10 % of the demand: {share}": "cedono entro ±10 % dalla domanda: {share}",
}
"""English -> Italian."""
