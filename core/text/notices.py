"""Warnings of a result."""

SENTENCES = {
    "large_pga": (
        "PGA {pga:.3g} g is above 2 g: check the unit.",
        "PGA {pga:.3g} g oltre 2 g: verificare l'unità di misura.",
    ),
    "small_pga": (
        "PGA {pga:.2g} g is below 0.001 g: check the unit.",
        "PGA {pga:.2g} g sotto 0,001 g: verificare l'unità di misura.",
    ),
    "offset": (
        "The samples have a mean of {mean:.3g} g and leave a velocity of {velocity:.2g} m/s: an offset of the "
        "baseline, which pushes the wall to one side. Correct the record.",
        "I campioni hanno media {mean:.3g} g e lasciano una velocità di {velocity:.2g} m/s: uno scostamento "
        "della linea di base, che spinge la parete da un lato. Correggere l'accelerogramma.",
    ),
    "below_floor": (
        "{n} run(s) fail below q {floor:g}, where the search ends: q, q SLV or q SLC of these is an upper limit.",
        "{n} analisi cedono sotto q {floor:g}, dove la ricerca termina: il loro q, q SLV o q SLC è un limite "
        "superiore.",
    ),
    "thin": (
        "t = {cm:.1f} cm is below 10 cm: was another unit meant (m, cm, mm)?",
        "t = {cm:.1f} cm è sotto 10 cm: si intendeva un'altra unità (m, cm, mm)?",
    ),
    "slender": (
        "H/t = {ratio:.0f} is above 30 (H {h:g} m, t {t:g} m): is one of them in another unit?",
        "H/t = {ratio:.0f} supera 30 (H {h:g} m, t {t:g} m): uno dei due è in un'altra unità?",
    ),
    "odd_weight": (
        "Unit weight {w:g} kN/m3 is outside {low:g} to {high:g}: kg/m3 or t/m3 instead of kN/m3?",
        "Peso specifico {w:g} kN/m³ fuori da {low:g}-{high:g}: kg/m³ o t/m³ al posto di kN/m³?",
    ),
    "odd_modulus": (
        "E = {e:g} MPa is outside {low:g} to {high:g}: GPa, kPa or kg/cm2 instead of MPa?",
        "E = {e:g} MPa fuori da {low:g}-{high:g}: GPa, kPa o kg/cm² al posto di MPa?",
    ),
    "hazard_incomplete": (
        "No ζ at SLD, SLV and SLC: beside the hazard give V_N and C_U and, for NTC 2018, F0 and T_C* in its rows.",
        "Nessuno ζ allo SLD, SLV e SLC: oltre alla pericolosità indicare V_N e C_U e, per le NTC 2018, F0 e "
        "T_C* nelle "
        "righe.",
    ),
    "hazard_too_short": (
        "No ζ at {states}: the return period lies outside the rows of the hazard.",
        "Nessuno ζ allo {states}: il periodo di ritorno è fuori dalle righe della pericolosità.",
    ),
    "variant_alone": (
        "Variant without its counterpart: no other wall of this name and mechanism is of the other variant.",
        "Variante senza corrispondente: nessun'altra parete con questo nome e meccanismo è dell'altra variante.",
    ),
    "heavy_load": (
        "The loads press the base with {stress:.2g} MPa: N/m entered as kN/m?",
        "I carichi comprimono la base con {stress:.2g} MPa: N/m inseriti come kN/m?",
    ),
    "large_ag": (
        "a_g = {ag:.3g} g is above 0.6 g, beyond the hazard of Italy at 2475 years: was {ag:.3g} m/s2 meant, which is "
        "{meant:.3f} g, or %, or is S counted in it?",
        "a_g = {ag:.3g} g supera 0,6 g, oltre la pericolosità italiana a 2475 anni: si intendeva {ag:.3g} m/s², cioè "
        "{meant:.3f} g, o %, oppure S è già compreso?",
    ),
    "table_sheet": ("Walls read from the sheet {sheet}.", "Pareti lette dal foglio {sheet}."),
    "hidden_rows": (
        "Hidden rows of the table of walls were not read: {rows}.",
        "Righe nascoste della tabella delle pareti non lette: {rows}.",
    ),
    "hidden_columns": (
        "Hidden columns of the table of walls were not read: {columns}.",
        "Colonne nascoste della tabella delle pareti non lette: {columns}.",
    ),
    "hidden_rows_read": (
        "Hidden rows of the sheet were read like the others: {rows}. Do they belong to the record?",
        "Righe nascoste del foglio lette come le altre: {rows}. Appartengono all'accelerogramma?",
    ),
    "hidden_columns_read": (
        "Hidden columns of the sheet count like the others: {columns}. Is the column that is read the one meant?",
        "Colonne nascoste del foglio contate come le altre: {columns}. La colonna letta è quella voluta?",
    ),
    "hidden_sheets": (
        "Hidden sheets of the workbook were not read: {names}.",
        "Fogli nascosti della cartella di lavoro non letti: {names}.",
    ),
    "formulas_read": (
        "Formulas of the sheet were read by the values last computed: {cells}.",
        "Formule del foglio lette con i valori calcolati l'ultima volta: {cells}.",
    ),
    "other_sheets": (
        "Other sheets of the table of walls were not read: {names}.",
        "Altri fogli della tabella delle pareti non letti: {names}.",
    ),
    "unit_as_given": (
        "The file does not state its unit: read as {unit}, as given. Does its PGA agree with what is known of it?",
        "Il file non dice la sua unità: letto come {unit}, come indicato. La PGA concorda con ciò che se ne sa?",
    ),
    "vertical": (
        "A vertical component: the histories take it as horizontal.",
        "Componente verticale: le storie la usano come orizzontale.",
    ),
    "unprocessed": (
        "Not processed, as recorded: no filter; its PGV and PGD mean nothing, and its mean and drift stay in.",
        "Non processato, come registrato: senza filtro; PGV e PGD non hanno senso, media e deriva restano.",
    ),
    "borehole": (
        "Recorded at the bottom of a borehole, not at the surface.",
        "Registrato in fondo a un pozzo, non in superficie.",
    ),
    "drawn_on_grid": (
        "Samples at uneven times, drawn on steps of 0.001 s: the same motion, linear between its samples.",
        "Campioni a tempi irregolari, riportati a passi di 0,001 s: lo stesso moto, lineare fra i campioni.",
    ),
    "weaker_records": (
        "The records as given have a mean PGA of {share:.0%} of a_g S: the dynamic check is not at the demand.",
        "Gli accelerogrammi così come dati hanno PGA media pari al {share:.0%} di a_g S: la verifica dinamica non è "
        "alla domanda.",
    ),
    "partial_last_line": (
        "{found} samples of the {declared} declared: the last line is incomplete.",
        "{found} campioni dei {declared} dichiarati: l'ultima riga è incompleta.",
    ),
    "ends_moving": (
        "The file declares no count and ends at {share:.0%} of its peak, not at rest: is its end cut off?",
        "Il file non dichiara il numero di campioni e termina al {share:.0%} del picco, non in quiete: è troncato?",
    ),
    "surplus_dropped": (
        "{count} surplus zeros or NaN at the end were dropped.",
        "{count} zeri o NaN in eccesso alla fine sono stati ignorati.",
    ),
    "already_scaled": (
        "The file says it is already scaled by {factor}.",
        "Il file dichiara di essere già scalato per {factor}.",
    ),
    "peak_differs": (
        "The peak read, {read:.4g}, differs from the {stated:.4g} stated in the file (same unit).",
        "Il picco letto, {read:.4g}, differisce da {stated:.4g} dichiarato nel file (stessa unità).",
    ),
    "number_not_understood": (
        "Numbers of the head that are not understood: {lines}. Is one of them a time step, a rate, a count of samples "
        "or a factor?",
        "Numeri dell'intestazione non compresi: {lines}. Uno di essi è un passo, una frequenza di campionamento, un "
        "numero di campioni o un fattore?",
    ),
    "jump": (
        "Near sample {sample} the record jumps as nowhere around it: lines doubled, swapped or missing?",
        "Presso il campione {sample} l'accelerogramma salta come in nessun punto vicino: righe doppie, scambiate o "
        "mancanti?",
    ),
    "scaled": ("Scaled by {scale:g} as asked.", "Scalato per {scale:g} come richiesto."),
    "scaled_far": (
        "Scaled by {scale:g} as asked: beyond 3 a record stands for an earthquake it was not.",
        "Scalato per {scale:g} come richiesto: oltre 3 l'accelerogramma rappresenta un terremoto che non era.",
    ),
    "costa_above_housner": (
        "Costa's upper ratio: 0.98 exceeds Eq. 4 above alpha 6.63 deg (here {alpha:.2f}).",
        "Coefficiente superiore di Costa: 0,98 supera l'Eq. 4 oltre alpha 6,63° (qui {alpha:.2f}).",
    ),
    "hogan": (
        "{model} on a one-sided wall is Hogan's hypothesis (1992): far less dissipation than Eq. 6.",
        "{model} per oscillazione su un lato è l'ipotesi di Hogan (1992): dissipa molto meno dell'Eq. 6.",
    ),
    "general_contact": (
        "General block: Eq. 6 assumes the upper contact at 2 R cos(alpha) above the pivot.",
        "Blocco generico: l'Eq. 6 assume il contatto superiore a 2 R cos(alpha) dalla cerniera.",
    ),
    "general_height": (
        "General block: Eq. 15/16 use the equivalent height 2 R_eq cos(alpha) = {height:.2f} m.",
        "Blocco generico: le Eq. 15/16 usano l'altezza equivalente 2 R_eq cos(alpha) = {height:.2f} m.",
    ),
    "setback_height": (
        "Hinge setback: Eq. 15/16, fitted without one, use the height of the rectangle with the same p and "
        "alpha, {height:.2f} m.",
        "Arretramento della cerniera: le Eq. 15/16, tarate senza, usano l'altezza del rettangolo con gli "
        "stessi p e alpha, {height:.2f} m.",
    ),
    "no_power_law": (
        "The power law of q_eff (Eq. 13) is not given: the SI of the records hardly differs ({low:.1f} to {high:.1f} "
        "cm).",
        "La legge di potenza di q_eff (Eq. 13) non è data: gli SI degli accelerogrammi differiscono appena (da "
        "{low:.1f} a "
        "{high:.1f} cm).",
    ),
    "narrow_si": (
        "The power law of q_eff rests on SI from {low:.0f} to {high:.0f} cm only: no meaning outside.",
        "La legge di potenza di q_eff si basa solo su SI da {low:.0f} a {high:.0f} cm: senza significato fuori.",
    ),
    "trilinear_threshold": (
        "Trilinear law: q keeps a_RM = g tan(alpha), although the wall starts to move at once and its plateau "
        "is near {plateau:.2f} a_RM.",
        "Legge trilineare: q mantiene a_RM = g tan(alpha), benché la parete si muova subito e il plateau sia "
        "circa {plateau:.2f} a_RM.",
    ),
    "no_closed_forms": (
        "Eq. 15/16 were fitted to walls without loads: not shown for this wall.",
        "Le Eq. 15/16 sono tarate su pareti senza carichi: non riportate per questa parete.",
    ),
    "eq15_slenderness": (
        "alpha {alpha:.2f} deg is outside the 3.1-11.3 deg Eq. 15/16 were fitted on.",
        "alpha {alpha:.2f}° fuori dall'intervallo 3,1-11,3° di taratura delle Eq. 15/16.",
    ),
    "eq15_height": (
        "H {height:.2f} m is outside the 3-11 m Eq. 15/16 were fitted on.",
        "H {height:.2f} m fuori dall'intervallo 3-11 m di taratura delle Eq. 15/16.",
    ),
    "eq15_pga": (
        "PGA outside the 0.106-0.312 g Eq. 15/16 were fitted on: {where}.",
        "PGA fuori dall'intervallo 0,106-0,312 g di taratura delle Eq. 15/16: {where}.",
    ),
    "eq15_model": (
        "Eq. 15/16 were fitted with the rigid law and {fitted}; this wall uses {used}.",
        "Le Eq. 15/16 sono tarate con legge rigida e {fitted}; questa parete usa {used}.",
    ),
    "si_from_records": (
        "SI of the demand {si:.1f} cm is the mean of the records scaled to a_g S: from the records, not "
        "independent of them.",
        "SI della domanda {si:.1f} cm: media degli accelerogrammi scalati ad a_g S, non indipendente da essi.",
    ),
    "too_few": (
        "{n} station(s) with a number: the minimum is taken, too few for a design value.",
        "{n} stazioni con un valore: si assume il minimo, troppo poche per un valore di progetto.",
    ),
    "few_stations": (
        "{files} records with a number are of {n} station(s): below 7 stations the set takes the minimum, not the "
        "mean.",
        "{files} accelerogrammi con un valore sono di {n} stazioni: sotto 7 stazioni l'insieme assume il minimo, "
        "non la media.",
    ),
    "coarse_window": (
        "The step of the search is coarse for the robust window ({n} points on either side): one collapsing point "
        "decides q_robust.",
        "Il passo della ricerca è grande per la finestra robusta ({n} punti per lato): un solo punto di collasso "
        "decide q_robust.",
    ),
    "no_numbers": (
        "No record gives a number: the set has no value.",
        "Nessun accelerogramma dà un valore: l'insieme non ha un valore.",
    ),
    "nearly_elastic": (
        "Velocity ratio {ratio:.3f}: impacts hardly dissipate, far from any measured wall.",
        "Coefficiente di restituzione {ratio:.3f}: gli urti quasi non dissipano, lontano da ogni misura.",
    ),
    "no_collapse": (
        "{n} run(s) without collapse up to q = {limit:g}: left out of the set and counted.",
        "{n} analisi senza collasso fino a q = {limit:g}: escluse dall'insieme e contate.",
    ),
    "incomplete": (
        "The set is incomplete: {n} run(s) ended as impact_limit and have no number.",
        "L'insieme è incompleto: {n} analisi terminate per limite di urti, senza valore.",
    ),
    "few_runs": (
        "Fragility over {n} run(s): its resolution is 1/{n}.",
        "Fragilità su {n} analisi: la risoluzione è 1/{n}.",
    ),
    "clamped": (
        "Eq. 7 gave a negative velocity ratio {n} times in all analyses and was held at 0.",
        "L'Eq. 7 ha dato un coefficiente di restituzione negativo {n} volte ed è stata posta a 0.",
    ),
    "only_robust": (
        "The check passes on q_robust alone: first collapse does not pass.",
        "La verifica è soddisfatta solo con q_robust: il primo collasso non la soddisfa.",
    ),
    "pga_scaling": (
        "Every record is rescaled to PGA = a_g S: a compatible set loses its compatibility.",
        "Ogni accelerogramma è riscalato a PGA = a_g S: un insieme compatibile perde la compatibilità.",
    ),
    "large_scaling": (
        "{n} record(s) are scaled by more than 3 to reach the demand.",
        "{n} accelerogrammi sono scalati oltre 3 volte per raggiungere la domanda.",
    ),
    "pga_too_small": (
        "{n} record(s) must be scaled by more than 10 to reach collapse.",
        "{n} accelerogrammi devono essere scalati oltre 10 volte per raggiungere il collasso.",
    ),
}
"""Code -> (English, Italian)."""
