"""The paragraphs of the Method sheet: label and body of each."""

METHOD_LABELS = {
    "motion": ("Equation of motion", "Equazione del moto"),
    "equations": ("Equations used", "Equazioni usate"),
    "misprints": ("Misprints of the paper handled", "Refusi dell'articolo trattati"),
    "q": ("q and its search", "q e la sua ricerca"),
    "set": ("Set of records, sign", "Insieme degli accelerogrammi, segno"),
    "outcomes": ("Words of an outcome", "Parole degli esiti"),
    "range": ("Range of Eq. 15 and 16", "Campo delle Eq. 15 e 16"),
    "circolare": ("Checks of the Circolare 7/2019", "Verifiche della Circolare 7/2019"),
    "loads": ("Loads, ties, return walls", "Carichi, catene, muri ortogonali"),
    "left_out": ("What is left out", "Che cosa è escluso"),
}
"""Code -> (English, Italian), in the order of the sheet."""

METHOD_BODIES = {
    "motion": (
        "Rigid block on a rigid base, Eq. 1 in the form phi'' = -p^2 [moment law - beta cos(alpha - phi)], "
        "seen from the pivot; ground acceleration linear between samples; start at rest; g = 9.80665 m/s2. "
        "Uplift, impact and the kinks of a trilinear law are located inside the sample. After the record the "
        "outcome is decided by energy.",
        "Blocco rigido su base rigida, Eq. 1 nella forma phi'' = -p^2 [legge del momento - beta cos(alpha - "
        "phi)], vista dalla cerniera; accelerazione del suolo lineare fra i campioni; partenza da fermo; g = "
        "9,80665 m/s2. Sollevamento, urto e spigoli della legge trilineare sono localizzati nel passo. Dopo "
        "l'accelerogramma l'esito è deciso dall'energia.",
    ),
    "equations": (
        "Eq. 2 a_RM = g tan(alpha); Eq. 3-7 velocity ratio of an impact; Eq. 8 overturning velocity; Fig. 3 "
        "trilinear law; Eq. 9 a_RM >= S a_g / q; Eq. 10 q = C PGA / a_RM; Eq. 11 Housner intensity; Eq. 12 "
        "q_eff = q g / (a_g S); Eq. 13 q_eff = C1 SI^C2; Eq. 15, 16.",
        "Eq. 2 a_RM = g tan(alpha); Eq. 3-7 coefficiente di restituzione all'urto; Eq. 8 velocità di ribaltamento; "
        "Fig. 3 legge trilineare; Eq. 9 a_RM >= S a_g / q; Eq. 10 q = C PGA / a_RM; Eq. 11 intensità di "
        "Housner; Eq. 12 q_eff = q g / (a_g S); Eq. 13 q_eff = C1 SI^C2; Eq. 15, 16.",
    ),
    "misprints": (
        "Eq. 1 is printed for positive rotations only. Eq. 6: the bracket in cos is negative for slender "
        "walls, which is the reversal itself; its modulus is used. Eq. 8 lacks a square root. Eq. 15 and 16 "
        "give q_eff, not q: q = q_eff a_g S / g. r is an energy ratio; here the velocity ratio sqrt(r) is "
        "shown. Eq. 7 is held at 0 where it turns negative.",
        "L'Eq. 1 è stampata per sole rotazioni positive. Eq. 6: la parentesi in cos è negativa per pareti "
        "snelle, ed è l'inversione stessa; se ne usa il modulo. All'Eq. 8 manca una radice. Le Eq. 15 e 16 "
        "danno q_eff, non q: q = q_eff a_g S / g. r è un rapporto di energie; qui si mostra il rapporto di "
        "velocità sqrt(r). L'Eq. 7 è limitata a 0.",
    ),
    "q": (
        "Collapse is not monotone in the multiplier: a wall can survive a stronger scale of the same record. "
        "q is therefore the first collapse on a geometric grid, bisected, and is given with the grid step. "
        "q_robust is the smallest grid q whose neighbourhood of +-10 % (default) holds 16 % of collapsing "
        "points: it hardly depends on the step, and can lie above or below q. Nor is the peak monotone: q SLV of two "
        "copies of a record that differ by 1e-9 can lie 10 % apart. The linear check of the Circolare takes the lower "
        "end of its spread, the grid point below the first peak of 0.36 θc, nine tenths of the limit.",
        "Il collasso non è monotono nel moltiplicatore: una parete può sopravvivere a una scala maggiore "
        "dello stesso accelerogramma. q è quindi il primo collasso su una griglia geometrica, con bisezione, e si dà "
        "col passo della griglia. q_robust è il minimo q di griglia il cui intorno di +-10 % (predefinito) "
        "contiene il 16 % di punti di collasso: dipende poco dal passo e può essere maggiore o minore di q. Nemmeno il "
        "picco è monotono: i q SLV di due copie di un accelerogramma che differiscono di 1e-9 possono distare il "
        "10 %. La verifica lineare della Circolare usa l'estremo inferiore della sua dispersione, il punto "
        "di griglia sotto il primo picco di 0,36 θc, nove decimi del limite.",
    ),
    "set": (
        "Records with a number of 7 or more stations: mean; of 3 to 6: minimum; of fewer: minimum, flagged. Two "
        "components of a station are one station. A one-sided wall is "
        "analysed with both signs of each record and the lower governs.",
        "Accelerogrammi con un valore di 7 o più stazioni: media; da 3 a 6: minimo; meno: minimo, segnalato. Due "
        "componenti di una stazione sono una stazione. La parete su un lato "
        "si analizza con entrambi i segni di ogni accelerogramma e governa il minore.",
    ),
    "outcomes": (
        "collapse found: q is a number. No collapse found: none up to the largest q searched, left out of the set and "
        "counted. Impact limit: more than 10 000 impacts within a sample, outcome unknown, the set is "
        "incomplete.",
        "Collasso trovato: q è un numero. Nessun collasso: fino al massimo q cercato, escluso dall'insieme e contato. "
        "Limite di urti: oltre 10 000 urti in un campione, esito ignoto, insieme incompleto.",
    ),
    "range": (
        "Fitted on rectangular blocks, rigid law, Eq. 4 or Eq. 6, alpha 3.1-11.3 deg, H 3-11 m, PGA "
        "0.106-0.312 g, no load: outside, a warning. SI and a_g S belong to the same motion.",
        "Tarate su blocchi rettangolari, legge rigida, Eq. 4 o Eq. 6, alpha 3,1-11,3°, H 3-11 m, PGA "
        "0,106-0,312 g, senza carico: fuori, un'avvertenza. SI e a_g S sono dello stesso moto.",
    ),
    "circolare": (
        "C8.7.1.2.1.9: time histories of the capacity curve with FC on its strength (p^2 / FC under the "
        "ground times FC; or FC on the demand), θc (alpha without loads) exceeded in none, mean of the "
        "largest rotations (7 "
        "stations or more, else the largest) within 0.40 θc (SLV), 0.60 (SLC); ζ_E is the lowest "
        "multiplier of the demand at which half of those within 10 % of it fail this rule. C8.7.1.2.1.8: d = "
        "0.40 d0 (0.60), T = 1.68 pi sqrt(d/a) (1.56 pi), damping 8 % (10 %), against the largest S_De on "
        "[T_0, T], T_0 = 0 for restrained walls; not below a_g,SLD. C8.7.1.2.1.5 and .7: a_g,SLD from a0* = "
        "alpha0 g / (e* FC), e* = 1 for one wall without masses that push it (its weight at its centroid), "
        "against a_g S or, free to "
        "vibrate, S_e(T_0, 5 %); a_g,SLV = q a_g,SLD. The verdict follows the most refined check that could "
        "be made, in this order.",
        "C8.7.1.2.1.9: storie temporali della curva di capacità con FC sulla resistenza (p^2 / FC sotto il "
        "moto moltiplicato per FC; oppure FC sulla domanda), θc (alpha senza carichi) mai superato, media "
        "delle rotazioni "
        "massime (da 7 stazioni, altrimenti il massimo) entro 0,40 θc (SLV), 0,60 (SLC); ζ_E è il "
        "minimo moltiplicatore della domanda al quale metà di quelli entro il 10 % non soddisfa la regola. "
        "C8.7.1.2.1.8: d = 0,40 d0 (0,60), T = 1,68 pi sqrt(d/a) (1,56 pi), smorzamento 8 % (10 %), rispetto "
        "al massimo S_De in [T_0, T], T_0 = 0 per pareti vincolate; non minore di a_g,SLD. C8.7.1.2.1.5 e .7: "
        "a_g,SLD da a0* = alpha0 g / (e* FC), e* = 1 per una parete senza masse che la spingono (peso nel "
        "baricentro), rispetto ad a_g S "
        "o, se libera di vibrare, S_e(T_0, 5 %); a_g,SLV = q a_g,SLD. L'esito segue la verifica più raffinata "
        "disponibile, in quest'ordine.",
    ),
    "loads": (
        "A force of constant size and direction is exact: phi'' = -p^2 [a sin(alpha - phi) + c cos(alpha - phi) - "
        "beta cos(alpha - phi)]; it uplifts at a_RM = g (a tan(alpha) + c) and overturns at θc = alpha + "
        "arctan(c/a), which takes the place of alpha in 0.40, 0.60 and 1.00. Masses that move with the wall or push "
        "it are one block with it; of those that push, inertia is overstated by up to sin^2(alpha_i - theta). "
        "C8.7.1.1: alpha0 = (W x + sum N d + sum F h)/(W y + sum Q h); C8.7.1.5: e*; C8.7.1.4: d0. Friction of "
        "return "
        "walls counts in alpha0 only, the least over the height that turns: never in histories or d0. A tie is of "
        "constant force; a wall that would bend between base and tie is refused. Periods T_0 add masses by "
        "Dunkerley's "
        "rule.",
        "Una forza di intensità e direzione costanti è esatta: phi'' = -p^2 [a sin(alpha - phi) + c cos(alpha - phi) "
        "- beta cos(alpha - phi)]; si solleva per a_RM = g (a tan(alpha) + c) e ribalta a θc = alpha + "
        "arctan(c/a), che sostituisce alpha in 0,40, 0,60 e 1,00. Le masse che si muovono con la parete o la "
        "spingono "
        "formano con essa un solo blocco; per quelle che spingono l'inerzia è sovrastimata al più di sin^2(alpha_i - "
        "theta). C8.7.1.1: alpha0 = (W x + somma N d + somma F h)/(W y + somma Q h); C8.7.1.5: e*; C8.7.1.4: d0. "
        "L'attrito dei muri ortogonali conta solo in alpha0, il minimo al variare dell'altezza che ruota: mai nelle "
        "storie né in d0. La catena ha forza costante; una parete che si inflette fra base e catena è rifiutata. I "
        "periodi T_0 sommano le masse con la regola di Dunkerley.",
    ),
    "left_out": (
        "Ties that yield or slacken, bearings that move with the rotation, sliding, vertical motion, cracking "
        "and crushing of the "
        "masonry, the yielding of the building that carries a wall above the ground and its motion in plan. "
        "Eq. 9 is without FC and e*. The motion amplifies small differences: an "
        "input known to 1 % does not give a rotation known to 1 %.",
        "Catene che snervano o si allentano, appoggi che si spostano con la rotazione, scorrimento, moto "
        "verticale, fessurazione e "
        "schiacciamento della muratura, snervamento dell'edificio che porta una parete sopra il suolo e suo moto in "
        "pianta. L'Eq. 9 è senza FC ed e*. Il moto amplifica le piccole "
        "differenze: un dato noto all'1 % non dà una rotazione nota all'1 %.",
    ),
}
"""Code -> (English, Italian)."""
