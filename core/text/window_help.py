"""Texts of the overview, of help and of what leads to a field."""

WINDOW_HELP = {
    "Overview": "Quadro generale",
    "Click the name of a wall to open it, a head to sort by it.": (
        "Clic sul nome di una parete per aprirla, su un'intestazione per ordinare."
    ),
    "Lowest ζ first. Click the name of a wall to open it.": (
        "ζ minore per primo. Clic sul nome di una parete per aprirla."
    ),
    "Running: {n} walls are finished.": "In corso: {n} pareti terminate.",
    "1. Walls: sizes, mechanism, what stands behind them (left, or Table… for many).": (
        "1. Pareti: dimensioni, meccanismo, che cosa sta dietro (a sinistra, o Tabella… per molte)."
    ),
    "2. Demand: a_g, spectrum, confidence factor; records: drop files, or Generate…": (
        "2. Domanda: a_g, spettro, fattore di confidenza; accelerogrammi: trascinare i file, o Genera…"
    ),
    "3. F5. Then this overview, the tab Check of each wall, and File → Export.": (
        "3. F5. Poi questo quadro, la scheda Verifica di ogni parete, e File → Esporta."
    ),
    "{n} more walls on the tab Overview": "altre {n} pareti nel Quadro generale",
    "The solver is being compiled, once for each version: some seconds.": (
        "Si compila il solutore, una volta per ogni versione: alcuni secondi."
    ),
    "Show where": "Mostra dove",
    "Scale": "Fattore",
    "Factor of the record; negative reverses it": "Fattore dell'accelerogramma; se negativo lo inverte",
    "Double-click a record to change its scale, unit, time step or kind.": (
        "Doppio clic su un accelerogramma per cambiarne fattore, unità, passo o tipo."
    ),
    "Change…": "Modifica…",
    "Scale all to the spectrum": "Scala tutti allo spettro",
    "There are records already. Put seven generated ones in their place, or add them?": (
        "Ci sono già accelerogrammi. Sostituirli con sette generati, o aggiungere questi?"
    ),
    "The values of the site are still to be given.": "I valori del sito sono ancora da indicare.",
    "Replace": "Sostituisci",
    "Add to them": "Aggiungi",
    "It takes records of files and a spectrum on the sheet Demand.": (
        "Richiede accelerogrammi da file e uno spettro nella scheda Domanda."
    ),
    "The records are scaled to PGA = a_g S already (sheet Demand).": (
        "Gli accelerogrammi sono già scalati a PGA = a_g S (scheda Domanda)."
    ),
    "Scaled by {factor:.3f}, the factor nearest to the spectrum.": (
        "Scalati di {factor:.3f}, il fattore più vicino allo spettro."
    ),
    "What is this field?": "Che cos'è questo campo?",
    "&Guide": "&Guida",
    "Guide": "Guida",
    "Page": "Pagina",
    "&Shortcuts": "&Scorciatoie",
    "Shortcuts": "Scorciatoie",
    "Save the empty table of &walls…": "Salva la tabella vuota delle &pareti…",
    "Save the table of walls": "Salva la tabella delle pareti",
    "&Reset layout": "&Ripristina la disposizione",
    "&Study": "&Studio",
    "&Parametric study…": "Studio &parametrico…",
    "Parametric study": "Studio parametrico",
    "Study": "Studio",
    "Short form": "Forma breve",
    "Folder of the results": "Cartella dei risultati",
    "Natural records": "Accelerogrammi naturali",
    "none": "nessuno",
    "Run or go on": "Esegui o prosegui",
    "File…": "File…",
    "Folder…": "Cartella…",
    "Cancelled: finished runs are kept, Run goes on with them.": (
        "Annullato: le analisi finite sono conservate, Esegui prosegue da lì."
    ),
    "Written to {folder}": "Scritto in {folder}",
    "Claims": "Affermazioni",
    "Figures": "Figure",
    "Source": "Fonte",
    "Claim of the paper": "Affermazione dell'articolo",
    "holds in": "vale in",
    "of": "su",
    "What is found": "Che cosa si trova",
    "q against Π": "q e Π",
    "Ribalta's law (research)": "legge di Ribalta (ricerca)",
    "Research, no records, {kind}: q {q:.1f} ({low:.1f}–{high:.1f}), q SLV {q_slv:.1f}": (
        "Ricerca, senza accelerogrammi, {kind}: q {q:.1f} ({low:.1f}–{high:.1f}), q SLV {q_slv:.1f}"
    ),
    "outside its range": "fuori dal suo campo",
    "Name a folder for the results.": "Indicare una cartella per i risultati.",
    "q robust": "q robusto",
}
"""English -> Italian; the group "window"."""
