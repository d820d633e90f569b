"""Texts of charts, figures and tables of the window."""

WINDOW_CHARTS = {
    "Figure…": "Figura…",
    "Save as a figure for a report: PNG, SVG or PDF": "Salva come figura per una relazione: PNG, SVG o PDF",
    "Figure for a report": "Figura per una relazione",
    "Width": "Larghezza",
    "Resolution of a PNG": "Risoluzione di un PNG",
    "with a caption": "con didascalia",
    "Axis limits…": "Limiti degli assi…",
    "Axis limits": "Limiti degli assi",
    "from": "da",
    "to": "a",
    "OK": "OK",
    "The input has changed since these results.": "I dati sono cambiati dopo questi risultati.",
    "Compare with": "Confronta con",
    "all records, with their mean": "tutti gli accelerogrammi, con la media",
    "compare with no other wall": "senza confronto con un'altra parete",
    "compare with {wall}": "confronta con {wall}",
    "mean and standard deviation, until a record overturns": "media e scarto quadratico medio, finché nessuno ribalta",
    "not searched": "non analizzato",
    "No records.": "Nessun accelerogramma.",
    "No demand: nothing to compare the peaks with.": "Nessuna domanda: i massimi non si confrontano con nulla.",
    "No dynamic check: it takes records and a demand at SLV or SLC.": (
        "Nessuna verifica dinamica: richiede accelerogrammi e una domanda allo SLV o SLC."
    ),
    "of the upper {h:.2f} m with friction": "dei {h:.2f} m superiori con attrito",
    "Multiplier at once": "Moltiplicatore diretto",
    "Set to…": "Porta a…",
    "the demand": "la domanda",
    "the demand with FC": "la domanda con FC",
    "just before collapse": "appena prima del collasso",
    "just after collapse": "appena dopo il collasso",
    "Not known here: no demand, or no collapse of this record.": (
        "Qui non noto: nessuna domanda, o nessun collasso con questo accelerogramma."
    ),
    "Not stated yet for this wall: press the button above.": (
        "Non ancora valutata per questa parete: premere il pulsante qui sopra."
    ),
    "Export calculation &note…": "Esporta la &relazione…",
    "Export the calculation note": "Esporta la relazione",
    "Export all &figures…": "Esporta tutte le &figure…",
    "Export all figures": "Esporta tutte le figure",
    "{n} figures written to {folder}": "{n} figure scritte in {folder}",
}
"""English -> Italian; the group "window"."""
