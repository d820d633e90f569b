"""The words of the forms of loads, hinges, variants, hazard and reasons."""

WINDOW_FORMS = {
    "floors": "piani",
    "base": "base",
    "{text}: not heights in m": "{text}: non sono quote in m",
    "Loads and what holds the wall": "Carichi e ciò che trattiene la parete",
    "Loads": "Carichi",
    "Load": "Carico",
    "Its mass": "La sua massa",
    "to be chosen": "da scegliere",
    "held elsewhere": "trattenuta altrove",
    "pushes the wall": "spinge la parete",
    "moves with the wall": "si muove con la parete",
    "C8.7.1.2.1.1: Q is what pushes the wall; a floor held by other walls does not": (
        "C8.7.1.2.1.1: Q è ciò che spinge la parete; un solaio trattenuto da altri muri non lo fa"
    ),
    "Size": "Intensità",
    "Above the hinge": "Sopra la cerniera",
    "From the outer face": "Dalla faccia esterna",
    "Find the tie at": "Trova la catena a",
    "The force of a tie at this height that brings ζ to the one required": (
        "La forza di una catena a questa quota che porta ζ a quello richiesto"
    ),
    "Hinges": "Cerniere",
    "Heights above the base in m; floors; or base alone. Empty: base, loads and floors": (
        "Quote dalla base in m; piani; o solo base. Vuoto: base, carichi e piani"
    ),
    "Level of knowledge": "Livello di conoscenza",
    "Investigations": "Indagini svolte",
    "Reasons of the engineer": "Motivazioni del progettista",
    "Why each of these values holds; without a reason it may leave the verdict indicative.": (
        "Perché ciascuno di questi valori è valido; senza motivo può rendere l'esito solo indicativo."
    ),
    "Variant": "Variante",
    "as it is": "stato di fatto",
    "as designed": "progetto",
    "Two walls of one name, one of each variant, are compared": (
        "Due pareti di uno stesso nome, una per variante, vengono confrontate"
    ),
    "Add a load": "Aggiungi un carico",
    "Delete this load": "Elimina questo carico",
    "Friction of return walls (in α0 only)": "Attrito dei muri ortogonali (solo in α0)",
    "Return walls": "Muri di spina",
    "Height of a course": "Altezza di un corso",
    "Length of a unit": "Lunghezza di un elemento",
    "Friction coefficient": "Coefficiente d'attrito",
    "Hazard of the site": "Pericolosità del sito",
    "Paste rows of T_R, a_g, F0, T_C*": "Incolla righe di T_R, a_g, F0, T_C*",
    "T_R [years], a_g [g], F0, T_C* [s]": "T_R [anni], a_g [g], F0, T_C* [s]",
    "none: T_R,C by the exponent of the code": "nessuna: T_R,C con l'esponente di norma",
    "from the file {name}": "dal file {name}",
    "{n} rows, T_R {low:g} to {high:g} years": "{n} righe, T_R da {low:g} a {high:g} anni",
    "Hazard not read": "Pericolosità non letta",
    "Clear": "Svuota",
    "No tie at {h:.2f} m reaches the ζ required: {largest:.2f} kN/m gives {zeta}": (
        "Nessuna catena a {h:.2f} m raggiunge lo ζ richiesto: {largest:.2f} kN/m dà {zeta}"
    ),
    "No tie at {h:.2f} m is needed: ζ {zeta}": "Non serve una catena a {h:.2f} m: ζ {zeta}",
    "A tie of {force:.2f} kN/m at {h:.2f} m gives ζ {zeta}; by hand {hand}": (
        "Una catena di {force:.2f} kN/m a {h:.2f} m dà ζ {zeta}; a mano {hand}"
    ),
    "curve": "curva",
    "mean {value:.2f}, which decides": "media {value:.2f}, che decide",
    "Wall": "Parete",
    "the weakest hinge asks {force:.2f} kN/m": "la cerniera più debole richiede {force:.2f} kN/m",
    "Walls of the study": "Pareti dello studio",
    "Before and after": "Prima e dopo",
    "ζ before": "ζ prima",
    "ζ after": "ζ dopo",
    "by": "con",
    "changed": "che cosa cambia",
    "nothing": "nulla",
    "smallest": "minimo",
    "Read from a file": "Leggi da un file",
}
"""English -> Italian."""
