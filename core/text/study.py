"""The words of a parametric study, in its workbook, figures and summary."""

STUDY = {
    "two-sided": "su due lati",
    "one-sided": "su un lato",
    (
        "The paper's Table 1 and figures are lost: spectra, seeds and steps of H are a reconstruction. Signs and "
        "ranges are compared, not digits."
    ): (
        "La Tabella 1 e le figure dell'articolo sono perdute: spettri, semi e passi di H sono una ricostruzione. Si "
        "confrontano segni e intervalli, non cifre."
    ),
    "C1, C2 of the paper": "C1, C2 dell'articolo",
    "C2 in [{low:g}, {high:g}], {name}": "C2 in [{low:g}, {high:g}], {name}",
    "C2 {low:.2f} to {high:.2f}; q_eff holds 1/PGA": "C2 da {low:.2f} a {high:.2f}; q_eff contiene 1/PGA",
    "One-sided walls: the lower q of both signs of each motion, unless it says as recorded.": (
        "Pareti su un lato: il q minore fra i due segni di ogni moto, salvo dove è detto segno registrato."
    ),
    "{n} runs were finished by an earlier start; the time is that of this one.": (
        "{n} analisi erano finite in un avvio precedente; il tempo è di questo."
    ),
    "No fit: it takes four shapes and the restitution that follows the mechanism.": (
        "Nessuna regressione: servono quattro forme e la restituzione che segue il meccanismo."
    ),
    "Single motions": "Moti singoli",
    "motion": "moto",
    "Claim of the paper": "Affermazione dell'articolo",
    "Eq. 13: power laws of q_eff in SI": "Eq. 13: leggi di potenza di q_eff in SI",
    "Eq. 14: C1 = A1 α + A2 H + A3": "Eq. 14: C1 = A1 α + A2 H + A3",
    "Eq. 14: C1 against H, {mechanism}": "Eq. 14: C1 e H, {mechanism}",
    "Eq. 15 and 16 against q": "Eq. 15 e 16 rispetto a q",
    "Eq. over q, mean - 1": "Eq. su q, media - 1",
    "q of the sets within 20 % of Eq. {number} (ours)": "q degli insiemi entro il 20 % dall'Eq. {number} (nostro)",
    "Fig. 19: rigid and trilinear law, 6.8 degrees, 7 m": "Fig. 19: legge rigida e trilineare, 6,8 gradi, 7 m",
    "Fig. 20: q of the time histories against Eq. 15 and 16": "Fig. 20: q delle storie temporali ed Eq. 15 e 16",
    "Fig. 4: free rocking of the tuff block, 0.800 x 0.123 m": (
        "Fig. 4: oscillazione libera del blocco di tufo, 0,800 x 0,123 m"
    ),
    "Fig. 5: target spectra and motions, group {group}": "Fig. 5: spettri e moti generati, gruppo {group}",
    "Fig. 9: q against H at 6.8 degrees, all spectra": "Fig. 9: q e H a 6,8 gradi, tutti gli spettri",
    "Fig. {number}: q against H, {restitution}, group B": "Fig. {number}: q e H, {restitution}, gruppo B",
    "Fig. {number}: q of both restitution models": "Fig. {number}: q dei due modelli di restituzione",
    "q_eff against SI, {mechanism}, {alpha:g} degrees": "q_eff e SI, {mechanism}, {alpha:g} gradi",
    "Fig. {number}: q_eff of natural records, {mechanism}": (
        "Fig. {number}: q_eff di accelerogrammi naturali, {mechanism}"
    ),
    "Figure data": "Dati delle figure",
    "Figures": "Figure",
    "First rotation {share:g} alpha: assumed, the figure is lost.": (
        "Prima rotazione {share:g} alfa: ipotesi, la figura è perduta."
    ),
    "Means of the sets": "Medie degli insiemi",
    "PGA alone does not decide (ours: q differs by more than 10 % inside a group), {name}": (
        "la sola PGA non decide (nostro: q varia di oltre il 10 % dentro un gruppo), {name}"
    ),
    "Rank correlation of q_eff over Eq. 15 with {words}.": "Correlazione di rango di q_eff su Eq. 15 con {words}.",
    "R² {low:.2f} to {high:.2f}": "R² da {low:.2f} a {high:.2f}",
    "SI of motions [cm]": "SI dei moti [cm]",
    "Short run: fewer motions and heights, and without what takes long.": (
        "Esecuzione breve: meno moti e altezze, e senza ciò che richiede tempo."
    ),
    "Source": "Fonte",
    "Study": "Studio",
    "Table 1: the spectra, our reconstruction": "Tabella 1: gli spettri, ricostruiti da noi",
    "Table 2: natural records, 6.8 degrees, 7 m": "Tabella 2: accelerogrammi naturali, 6,8 gradi, 7 m",
    ("The print gives PGA to 0.01 g: its rows of 0.02 and 0.03 g are uncertain by 17 to 25 % and cannot test ±20 %."): (
        "La stampa dà la PGA a 0,01 g: le sue righe da 0,02 e 0,03 g sono incerte del 17-25 % e non possono provare "
        "il ±20 %."
    ),
    "What goes with the integrator, the step of the search and the shape of the spectra; no cause is claimed.": (
        "Quanto dipende dall'integratore, dal passo della ricerca e dalla forma degli spettri; nessuna causa è "
        "affermata."
    ),
    "What is found": "Che cosa si trova",
    "a clear power law (ours: R² of at least 0.9), {name}": (
        "una chiara legge di potenza (nostro: R² almeno 0,9), {name}"
    ),
    "exact, as recorded": "esatto, segno registrato",
    "exact, spectrum {name}": "esatto, spettro {name}",
    "exact, step 0.5 %": "esatto, passo 0,5 %",
    "exact, step {step:g} %": "esatto, passo {step:g} %",
    "experimental over theoretical q: {low:.2f} to {high:.2f}": (
        "q sperimentale su q teorico: da {low:.2f} a {high:.2f}"
    ),
    "exponent of q in SI/PGA": "esponente di q in SI/PGA",
    "fitted, C2 of the paper": "regressione, C2 dell'articolo",
    "fitted, mean of the free C2": "regressione, media dei C2 liberi",
    "group": "gruppo",
    "holds in": "vale in",
    "largest over smallest q of a group: up to {most:.1f}": "q massimo su minimo di un gruppo: fino a {most:.1f}",
    "means of sets": "medie degli insiemi",
    "mechanism": "meccanismo",
    "natural records within 20 % of Eq. {number}": "accelerogrammi naturali entro il 20 % dall'Eq. {number}",
    "of": "su",
    "paper": "articolo",
    "q [-], Eq. 15 or 16": "q [-], Eq. 15 o 16",
    "q [-], rigid": "q [-], rigida",
    "q [-], time histories": "q [-], storie temporali",
    "q [-], trilinear": "q [-], trilineare",
    "q against H": "q e H",
    "q against SI/PGA, {mechanism}, 6.8 degrees": "q e SI/PGA, {mechanism}, 6,8 gradi",
    "q against Π = p² SI/PGA": "q e Π = p² SI/PGA",
    "q grows with H, {name}": "q cresce con H, {name}",
    "q grows with alpha, {name}": "q cresce con alfa, {name}",
    "q of the time histories": "q delle storie temporali",
    "q one-sided": "q su un lato",
    "q two-sided": "q su due lati",
    "q robust": "q robusto",
    "q_eff = q g/PGA holds 1/PGA, and so part of its correlation with SI: the last two columns are free of it.": (
        "q_eff = q g/PGA contiene 1/PGA, e quindi parte della sua correlazione con SI: le ultime due colonne ne sono "
        "prive."
    ),
    "q_eff over Eq. 15": "q_eff su Eq. 15",
    "q_eff over Eq. 16": "q_eff su Eq. 16",
    "q_eff over the equation: {low:.2f} to {high:.2f}, median {middle:.2f}": (
        "q_eff sull'equazione: da {low:.2f} a {high:.2f}, mediana {middle:.2f}"
    ),
    "records": "accelerogrammi",
    "record": "accelerogramma",
    "scatter": "dispersione",
    "shape": "forma",
    "single motions": "moti singoli",
    "source": "fonte",
    "spectrum": "spettro",
    "the paper claims 20 % for Fig. 21 only": "l'articolo afferma il 20 % solo per la Fig. 21",
    "theoretical restitution is on the safe side, {name}, sets": (
        "la restituzione teorica è a favore di sicurezza, {name}, insiemi"
    ),
    "theoretical restitution is on the safe side, {name}, single motions": (
        "la restituzione teorica è a favore di sicurezza, {name}, moti singoli"
    ),
    "trilinear law {law} is more conservative, {name}": "la legge trilineare {law} è più cautelativa, {name}",
    "wall": "parete",
    "{alpha:g}°, paper": "{alpha:g}°, articolo",
    "{name}, motions": "{name}, moti",
    "{n} files are left out: no accelerograms the program reads, or vertical components.": (
        "{n} file sono esclusi: non sono accelerogrammi che il programma legge, o sono componenti verticali."
    ),
    "{n} of {of} runs have no number and are left out.": "{n} analisi su {of} non hanno un valore e sono escluse.",
    "{n} records, {share:.0%} of them within ±20 % of the equation.": (
        "{n} accelerogrammi, il {share:.0%} entro il ±20 % dall'equazione."
    ),
    (
        "q = limit + exp(a0 + a1 s) Π^-(b0 + b1 s), s = sqrt(1 - e), Π = p² SI/PGA. Intervals of 90 % by leaving out "
        "one shape at a time. Natural records were never used in a fit."
    ): (
        "q = limite + exp(a0 + a1 s) Π^-(b0 + b1 s), s = sqrt(1 - e), Π = p² SI/PGA. Intervalli del 90 % escludendo "
        "una forma alla volta. Gli accelerogrammi naturali non sono mai usati in una regressione."
    ),
    "What q = 2 is worth: share of the spectra for which q at SLV stays below 2": (
        "Quanto vale q = 2: quota degli spettri per cui q allo SLV resta sotto 2"
    ),
    "law": "legge",
    "quantity": "grandezza",
    "limit": "limite",
    "scatter of sets": "dispersione degli insiemi",
    "scatter, shape left out": "dispersione, forma esclusa",
    "scatter of single motions": "dispersione dei moti singoli",
    "natural records, mean - 1": "accelerogrammi naturali, media - 1",
    "natural records, scatter": "accelerogrammi naturali, dispersione",
    "natural records": "accelerogrammi naturali",
    "least Π": "Π minimo",
    "largest Π": "Π massimo",
    "Ribalta's law of q, a research output": "La legge di Ribalta per q, un risultato di ricerca",
    "law of q": "legge di q",
    "mean - 1": "media - 1",
    "Laws of q side by side": "Leggi di q a confronto",
    "SI/PGA from [cm/g]": "SI/PGA da [cm/g]",
    "to [cm/g]": "a [cm/g]",
    "q SLV below 2 [%]": "q SLV sotto 2 [%]",
    "median q SLV": "q SLV mediano",
    "{quantity} against Π = p² SI/PGA, {mechanism}": "{quantity} e Π = p² SI/PGA, {mechanism}",
    "Π, shape left out": "Π, forma esclusa",
    "p PGV/PGA, shape left out": "p PGV/PGA, forma esclusa",
    "Eq. {number} refitted on these walls, shape left out": (
        "Eq. {number} ricalibrata su queste pareti, forma esclusa"
    ),
    "Π on these walls, shape left out": "Π su queste pareti, forma esclusa",
    "These shares are of the walls and spectra of this study, not of buildings.": (
        "Le quote riguardano le pareti e gli spettri di questo studio, non gli edifici."
    ),
    "A wall free to rock to both sides has q at SLV below 2 in {share:.0%} of the cases.": (
        "Una parete libera di oscillare su due lati ha q allo SLV sotto 2 nel {share:.0%} dei casi."
    ),
    "A wall restrained from behind has it below 2 in {share:.0%}; its median is {median:.1f}.": (
        "Una parete trattenuta da dietro lo ha sotto 2 nel {share:.0%}; la mediana è {median:.1f}."
    ),
    (
        "Of walls up to 7 m and 7 degrees that rock to both sides q = 2 is too much in {short:.0%}, of those of 12 m "
        "and more in {tall:.0%}."
    ): (
        "Fra le pareti fino a 7 m e 7 gradi che oscillano su due lati q = 2 è troppo nel {short:.0%}, fra quelle da "
        "12 m in su nel {tall:.0%}."
    ),
    "Π, natural records": "Π, accelerogrammi naturali",
    "p PGV/PGA, natural records": "p PGV/PGA, accelerogrammi naturali",
    "all walls": "tutte le pareti",
    "walls near the paper's": "pareti vicine a quelle dell'articolo",
    "{quantity} of Ribalta's law, a research output": "{quantity} della legge di Ribalta, risultato di ricerca",
    "outside its range": "fuori dal suo campo",
    "Ribalta's law": "legge di Ribalta",
    "{runs} runs, {analyses} analyses, {motions} motions, {seconds:.0f} s": (
        "{runs} analisi incrementali, {analyses} integrazioni, {motions} moti, {seconds:.0f} s"
    ),
}
"""English -> Italian."""
