"""What F1 says of a field: one paragraph with its clause or equation."""

HELP = {
    "height_m": (
        "Height H of the wall above its hinge [m]. With t it gives alpha = arctan(t/H) and R = sqrt(H^2 + "
        "t^2)/2 (Fig. 1 of the paper).",
        "Altezza H della parete sopra la cerniera [m]. Con t dà alpha = arctan(t/H) e R = sqrt(H^2 + t^2)/2"
        " (Fig. 1 dell'articolo).",
    ),
    "thickness_m": (
        "Thickness t of the wall. The wall uplifts at a_RM = g t/H (Eq. 2); alpha_0 = t/H (C8.7.1.1).",
        "Spessore t della parete. La parete si solleva per a_RM = g t/H (Eq. 2); alpha_0 = t/H (C8.7.1.1).",
    ),
    "slenderness_deg": (
        "alpha = arctan(t/H): larger is stockier, not more slender (Fig. 1 of the paper).",
        "alpha = arctan(t/H): se maggiore la parete è più tozza, non più snella (Fig. 1 dell'articolo).",
    ),
    "hinge_setback_m": (
        "The hinge lies inside the edge by u, since the masonry crushes there: tan(alpha) = (t - 2u)/H. 0 "
        "for a rigid edge.",
        "La cerniera è arretrata di u dallo spigolo, dove la muratura si schiaccia: tan(alpha) = (t - "
        "2u)/H. 0 per spigolo rigido.",
    ),
    "compressive_strength_mpa": (
        "Compressive strength f of the masonry [MPa]: u = 2 N/(3 f L), the triangle of stress at the hinge "
        "(C8.7.1.2.1). It lowers ζ; an FC below 1.35 takes it of every wall, from 0.5 to 10 MPa.",
        "Resistenza a compressione f della muratura [MPa]: u = 2 N/(3 f L), diagramma triangolare alla cerniera "
        "(C8.7.1.2.1). Abbassa ζ; un FC sotto 1,35 la richiede per ogni parete, da 0,5 a 10 MPa.",
    ),
    "velocity_ratio": (
        "Ratio e of the velocities after and before an impact: 1 loses nothing. Eq. 4 to 7 of the paper give it; a "
        "smaller one lifts ζ. Of a value of your own the verdict gives ζ with e + 0.1 and with Eq. 4 or 6, and asks "
        "for a reason where one of them turns it.",
        "Rapporto e fra le velocità dopo e prima di un urto: 1 non dissipa nulla. Le Eq. 4-7 dell'articolo lo "
        "danno; uno minore alza ζ. Di un valore proprio l'esito dà ζ con e + 0,1 e con l'Eq. 4 o 6, e chiede un "
        "motivo se uno di questi lo capovolge.",
    ),
    "restitution": (
        "Rule of the velocity ratio of an impact; empty, Eq. 4 two-sided and Eq. 6 one-sided, also of a wall with "
        "masses that move with it. Of a model of experiments the verdict gives ζ with e + 0.1 and by Eq. 4 or 6, "
        "and asks for a reason where one of them turns it.",
        "Regola del coefficiente di restituzione di un urto; vuota, Eq. 4 su due lati ed Eq. 6 su un lato, anche di "
        "una parete con masse che si muovono con essa. Di un modello da prove l'esito dà ζ con e + 0,1 e con l'Eq. "
        "4 o 6, e chiede un motivo se uno di questi lo capovolge.",
    ),
    "base_z_m": (
        "Height z of the hinge above the ground [m]: 0 on the ground. Above it the motion is that of the floor at "
        "the hinge (C7.2.3), which takes the building; the verdict gives ζ for the motion at the centroid beside "
        "it, and asks for a reason where that turns it.",
        "Quota z della cerniera dal suolo [m]: 0 a terra. Sopra, il moto è quello del piano alla cerniera (C7.2.3), "
        "che richiede i dati dell'edificio; l'esito dà accanto ζ per il moto al baricentro, e chiede un motivo se "
        "questo lo capovolge.",
    ),
    "free_element": (
        "Free to vibrate before it moves: parapet, gable top, free wall. Its demand is S_e(T_0) (C8.7.1.9), that of "
        "a wall held by transverse walls a_g S (C8.7.1.8). Of a two-sided wall said not to be free the verdict "
        "gives ζ as a free one, and asks by what it is held; of a one-sided one said to be free ζ as held.",
        "Libero di vibrare prima di muoversi: parapetto, timpano, muro isolato. La domanda è S_e(T_0) (C8.7.1.9); "
        "per la parete vincolata da muri trasversali a_g S (C8.7.1.8). Di una parete su due lati dichiarata non "
        "libera l'esito dà ζ come libera, e chiede da che cosa è trattenuta; di una su un lato dichiarata libera ζ "
        "come trattenuta.",
    ),
    "elastic_modulus_mpa": (
        "Elastic modulus E [MPa]: with the unit weight it gives T_0 = 6.2 (H/t) H sqrt(w/(E g)) of an "
        "element free to vibrate (C8.7.1.7).",
        "Modulo elastico E [MPa]: con il peso specifico dà T_0 = 6,2 (H/t) H sqrt(w/(E g)) di un elemento "
        "libero di vibrare (C8.7.1.7).",
    ),
    "unit_weight_kn_m3": (
        "Unit weight of the masonry [kN/m3]. Weight of the wall, M*, T_0 and loads need it; q of a wall "
        "alone does not.",
        "Peso specifico della muratura [kN/m3]. Serve per peso, M*, T_0 e carichi; non per il q di una parete sola.",
    ),
    "length_m": (
        "Length L of the wall [m]: it gives the weight W for the report and spreads the friction of the return walls.",
        "Lunghezza L della parete [m]: dà il peso W per la relazione e ripartisce l'attrito dei muri ortogonali.",
    ),
    "back_restraint": (
        "What stands behind a one-sided wall and holds it: transverse walls, floors; three letters or more. Without "
        "it the verdict is only indicative; with it ζ without the restraint stands among the limits.",
        "Che cosa sta dietro una parete su un lato e la trattiene: muri trasversali, solai; almeno tre lettere. "
        "Senza, l'esito è solo indicativo; con esso lo ζ senza vincolo sta fra i limiti.",
    ),
    "unloaded_confirmed": (
        'Tick where nothing rests on the wall; else the verdict says "if the wall carries no load".',
        "Spuntare se nulla grava sulla parete; altrimenti l'esito dice «se la parete non porta carichi».",
    ),
    "law": (
        "Moment against rotation: rigid, or trilinear with an elastic branch and a plateau. Of a trilinear one the "
        "verdict gives ζ with the rigid law, and asks for a reason where that turns it.",
        "Momento in funzione della rotazione: rigida, o trilineare con un ramo elastico e un tratto costante. Di una "
        "trilineare l'esito dà ζ con la legge rigida, e chiede un motivo se questa lo ribalta.",
    ),
    "hinge_heights": (
        "Hinges above the base: each makes a wall of the part above it, and the worst gives the verdict of the "
        "wall. Empty: the base and, with the building, loads and storey ends with H/t of 3 above them; base: it "
        "alone, and the verdict names the heights left out.",
        "Cerniere sopra la base: ognuna dà una parete della parte sovrastante, e la peggiore dà l'esito della "
        "parete. Vuoto: la base e, con l'edificio, i carichi e i piani che hanno sopra H/t di 3; base: solo questa, "
        "e l'esito nomina le quote escluse.",
    ),
    "tie_height_m": (
        "Height of a tie whose force is looked for, so that ζ reaches the one required.",
        "Quota di una catena di cui si cerca la forza, perché ζ raggiunga quello richiesto.",
    ),
    "kind": (
        "What the load is: a vertical load that rests on the wall, a thrust outward, a tie that pulls inward, or a "
        "carried mass, which moves with the wall.",
        "Che cos'è il carico: carico verticale appoggiato sulla parete, spinta verso l'esterno, catena che tira verso "
        "l'interno, o massa portata, che si muove con la parete.",
    ),
    "kn_m": (
        "Intensity of the load per metre of wall [kN/m]; it keeps its size and direction.",
        "Intensità del carico per metro di parete [kN/m]; conserva intensità e direzione.",
    ),
    "d_m": (
        "Distance of the load from the outer face [m]: lever arm d of C8.7.1.1.",
        "Distanza del carico dalla faccia esterna [m]: braccio d di C8.7.1.1.",
    ),
    "h_m": (
        "Height of the load above the base [m]: lever arm h of C8.7.1.1.",
        "Quota del carico sulla base [m]: braccio h di C8.7.1.1.",
    ),
    "mass": (
        "Whether the mass of the load pushes the wall in an earthquake: Q of C8.7.1.1, and a part of e*.",
        "Se la massa del carico spinge la parete durante il sisma: Q di C8.7.1.1, e parte di e*.",
    ),
    "limit_state": (
        "SLV: d_SLV = 0.40 d_0; SLC: 0.60 d_0; SLD: the wall does not uplift (C8.7.1.2.1.5, .6). The verdict is of "
        "this state; another at which the wall fails is among its limits.",
        "SLV: d_SLV = 0,40 d_0; SLC: 0,60 d_0; SLD: la parete non si solleva (C8.7.1.2.1.5, .6). L'esito è di "
        "questo stato; un altro in cui la parete non è verificata sta fra i limiti.",
    ),
    "ag_g": (
        "a_g on rigid ground, in g, without S; of the site and the return period of the limit state (NTC 2018 3.2).",
        "a_g su suolo rigido, in g, senza S; del sito e del periodo di ritorno dello stato limite (NTC 2018 3.2).",
    ),
    "soil_factor": (
        "S = S_S S_T, ground and topography (NTC 2018 3.2.3), 0.9 at least. With the spectrum of a code it follows "
        "from the categories.",
        "S = S_S S_T, sottosuolo e topografia (NTC 2018 3.2.3), almeno 0,9. Con lo spettro di norma segue dalle "
        "categorie.",
    ),
    "f0": (
        "F0: largest spectral amplification on rigid ground, of the site (NTC 2018, Annex B).",
        "F0: massima amplificazione spettrale su suolo rigido, del sito (NTC 2018, Allegato B).",
    ),
    "tc_star_s": (
        "T_C*: start of the branch of constant velocity on rigid ground [s], of the site (NTC 2018, Annex B).",
        "T_C*: inizio del tratto a velocità costante su suolo rigido [s], del sito (NTC 2018, Allegato B).",
    ),
    "soil": (
        "Ground category A to E (NTC 2018 Tab. 3.2.II): S_S and C_C follow from it.",
        "Categoria di sottosuolo da A a E (NTC 2018 Tab. 3.2.II): ne seguono S_S e C_C.",
    ),
    "topography": (
        "Topographic category T1 to T4 (NTC 2018 Tab. 3.2.III): S_T follows from it.",
        "Categoria topografica da T1 a T4 (NTC 2018 Tab. 3.2.III): ne segue S_T.",
    ),
    "housner_intensity_cm": (
        "Housner intensity SI: area under the 5 % pseudo-velocity from 0.1 to 2.5 s (Eq. 11), not divided by 2.4.",
        "Intensità di Housner SI: area sotto la pseudo-velocità al 5 % da 0,1 a 2,5 s (Eq. 11), non divisa per 2,4.",
    ),
    "confidence_factor": (
        "Confidence factor FC: 1.35 where the compressive strength is not in the hinge (C8.7.1.2.1). A lower one "
        "lifts ζ: it takes LC2 or LC3, the investigations and the strength of every wall; the verdict gives ζ with "
        "1.35, and asks for a reason where that turns it.",
        "Fattore di confidenza FC: 1,35 se la resistenza a compressione non entra nella cerniera (C8.7.1.2.1). Uno "
        "minore alza ζ: richiede LC2 o LC3, le indagini e la resistenza di ogni parete; l'esito dà ζ con 1,35, e "
        "chiede un motivo se questo lo capovolge.",
    ),
    "knowledge_level": (
        "Level of knowledge of the building: LC1 has FC 1.35, LC2 1.20, LC3 1.00 (Tab. C8.5.IV). An FC below 1.35 "
        "raises ζ: "
        "it takes LC2 or LC3, the investigations and the compressive strength of the masonry.",
        "Livello di conoscenza della costruzione: LC1 ha FC 1,35, LC2 1,20, LC3 1,00 (Tab. C8.5.IV). Un FC sotto 1,35 "
        "alza "
        "ζ: richiede LC2 o LC3, le indagini svolte e la resistenza a compressione della muratura.",
    ),
    "investigations": (
        "What was surveyed and tested, on which the level of knowledge rests: needed for an FC below 1.35, and "
        "named in the verdict.",
        "Che cosa è stato rilevato e provato, su cui si basa il livello di conoscenza: necessario per un FC sotto "
        "1,35, e nominato nell'esito.",
    ),
    "confidence_on": (
        "FC divides the strength of the capacity curve (C8.7.1.2.1.3), or multiplies the demand, which is more "
        "cautious. ζ of the other side is in the verdict where it fails; where the displacement check fails too, "
        "the verdict is only indicative.",
        "FC divide la resistenza della curva di capacità (C8.7.1.2.1.3), o moltiplica la domanda, più cautelativo. "
        "Lo ζ dell'altro lato sta nell'esito se non è soddisfatto; se non lo è nemmeno la verifica in spostamento, "
        "l'esito è solo indicativo.",
    ),
    "demand_scaling": (
        "Records as they are, or each scaled to PGA = a_g S: then the verdict is only indicative, for the "
        "set no longer follows the spectrum.",
        "Accelerogrammi come sono, o ciascuno scalato a PGA = a_g S: allora l'esito è solo indicativo, "
        "perché l'insieme non segue più lo spettro.",
    ),
    "period_range_s": (
        "Periods at which the mean spectrum is compared with the target (NTC 2018 3.2.3.6). A range that leaves out "
        "periods that matter makes the verdict indicative. A rigid block has no period of its own.",
        "Periodi in cui lo spettro medio si confronta con quello di riferimento (NTC 2018 3.2.3.6). Un intervallo "
        "che esclude periodi che contano rende l'esito solo indicativo. Un blocco rigido non ha periodo proprio.",
    ),
    "zeta_target": (
        "ζ_E required: 1 for adaptation, less for improvement (NTC 2018 8.4).",
        "ζ_E richiesto: 1 per l'adeguamento, meno per il miglioramento (NTC 2018 8.4).",
    ),
    "q_code": (
        "Behaviour factor of the linear check: q = 2 (C8.7.1.2.1.7). A larger one lifts ζ: the verdict gives that "
        "with q = 2, and asks for a reason where it turns it.",
        "Fattore di comportamento della verifica lineare: q = 2 (C8.7.1.2.1.7). Uno maggiore alza ζ: l'esito dà "
        "quello con q = 2, e chiede un motivo se questo lo capovolge.",
    ),
    "nominal_life_years": ("Nominal life V_N [years] (NTC 2018 2.4.1).", "Vita nominale V_N [anni] (NTC 2018 2.4.1)."),
    "use_class_factor": (
        "Coefficient C_U of the class of use (NTC 2018 2.4.3).",
        "Coefficiente d'uso C_U della classe d'uso (NTC 2018 2.4.3).",
    ),
    "return_period_years": (
        "Return period T_R [years]; else from V_N and C_U (NTC 2018 3.2.0).",
        "Periodo di ritorno T_R [anni]; altrimenti da V_N e C_U (NTC 2018 3.2.0).",
    ),
    "type": (
        "Type of the spectrum of EN 1998-1 3.2.2.2: 1 where strong earthquakes govern the hazard, 2 where those of a "
        "magnitude up to 5.5 do.",
        "Tipo dello spettro della EN 1998-1 3.2.2.2: 1 dove la pericolosità viene da terremoti forti, 2 dove da quelli "
        "di magnitudo fino a 5,5.",
    ),
    "method": (
        "Method of integration: automatic takes the Taylor series, of order 6 or 8; a verdict rests on it or on "
        "dormand_prince, the others are for comparison.",
        "Metodo di integrazione: quello automatico usa la serie di Taylor, di ordine 6 o 8; un esito si fonda su di "
        "esso o su dormand_prince, gli altri servono al confronto.",
    ),
    "language": (
        "Language of workbook and note, whatever that of the window.",
        "Lingua di cartella di lavoro e relazione, qualunque sia quella della finestra.",
    ),
    "q_step": (
        "Step of the geometric grid of q: a smaller one finds an earlier first collapse. q robust hardly "
        "depends on it.",
        "Passo della griglia geometrica di q: uno minore trova un primo collasso anticipato. q robusto ne "
        "dipende poco.",
    ),
    "q_limit": ("Largest q searched for a collapse.", "Massimo q a cui si cerca un collasso."),
    "map_span": ("How far beyond q the survival map goes on.", "Di quanto la mappa di sopravvivenza prosegue oltre q."),
    "robust_window": (
        "Half-width of the neighbourhood of q robust: the smallest q around which 16 % of the points collapse.",
        "Semiampiezza dell'intorno di q robusto: il minimo q attorno al quale collassa il 16 % dei punti.",
    ),
    "polarity": (
        "Sign of the records: a one-sided wall takes both, and the lower q governs.",
        "Segno degli accelerogrammi: la parete su un lato li prende entrambi, e governa il q minore.",
    ),
    "period_s": (
        "Elastic period T_1 of the building [s]; at the ultimate limit states 1.5 T_1 is taken (C8.7.1.2.1.4). "
        "Empty it is an estimate, 0.05 H^0.75, and the verdict only indicative.",
        "Periodo elastico T_1 dell'edificio [s]; agli stati limite ultimi si assume 1,5 T_1 (C8.7.1.2.1.4). Vuoto è "
        "una stima, 0,05 H^0,75, e l'esito solo indicativo.",
    ),
    "height_over_thickness": (
        "H/t: the slenderness as a ratio; alpha = arctan(t/H).",
        "H/t: la snellezza come rapporto; alpha = arctan(t/H).",
    ),
    "radius_m": (
        "R: distance of the centroid from the hinge [m], of a general block (Fig. 1 of the paper).",
        "R: distanza del baricentro dalla cerniera [m], di un blocco qualsiasi (Fig. 1 dell'articolo).",
    ),
    "inertia_over_mass_m2": (
        "I_0/m: moment of inertia about the hinge over the mass [m2]; 4 R^2/3 of a rectangle (Eq. 1).",
        "I_0/m: momento d'inerzia rispetto alla cerniera sulla massa [m2]; 4 R^2/3 di un rettangolo (Eq. 1).",
    ),
    "storeys": (
        "Storeys of the building: the participation gamma of its first mode follows from them (C7.2.3).",
        "Piani dell'edificio: ne segue la partecipazione gamma del primo modo (C7.2.3).",
    ),
    "period_factor": (
        "Period of the damaged building over the elastic one: 1.5 to 2.0 at the ultimate limit states "
        "(C8.7.1.2.1.4). The verdict gives ζ at the other end, and asks for a reason where a value given here "
        "decides.",
        "Periodo dell'edificio danneggiato su quello elastico: da 1,5 a 2,0 agli stati limite ultimi "
        "(C8.7.1.2.1.4). L'esito dà ζ all'altro estremo, e chiede un motivo se decide un valore dato qui.",
    ),
    "damping": (
        "Damping of the building: 10 to 20 % at the ultimate limit states (C8.7.1.2.1.4). The verdict gives ζ at "
        "the other end, and asks for a reason where a value given here decides.",
        "Smorzamento dell'edificio: dal 10 al 20 % agli stati limite ultimi (C8.7.1.2.1.4). L'esito dà ζ all'altro "
        "estremo, e chiede un motivo se decide un valore dato qui.",
    ),
    "number": (
        "Return walls along the wall, whose courses it drags out as it turns (C8.7.1.2.1.1). Their friction lifts ζ "
        "of the linear checks only: the verdict gives it without, and asks for a reason where that turns it.",
        "Muri ortogonali lungo la parete, i cui corsi essa trascina ruotando (C8.7.1.2.1.1). Il loro attrito alza ζ "
        "delle sole verifiche lineari: l'esito lo dà senza, e chiede un motivo se questo lo capovolge.",
    ),
    "return_walls": (
        "Friction of the return walls lifts ζ of the linear checks. Why it may be counted: bond of the corners, "
        "state of the masonry.",
        "L'attrito dei muri ortogonali alza ζ delle verifiche lineari. Perché si può contare: ammorsamento degli "
        "angoli, stato della muratura.",
    ),
    "building": (
        "Why the period and the damping of the damaged building hold, where ζ at the other end of C8.7.1.2.1.4 "
        "turns the verdict.",
        "Perché periodo e smorzamento dell'edificio danneggiato sono validi, dove ζ all'altro estremo del "
        "C8.7.1.2.1.4 capovolge l'esito.",
    ),
    "participation": (
        "γψ of the first mode at the walls. Below that of C7.2.10 it lifts ζ: the verdict gives it with that one, "
        "and asks for a reason where that turns it.",
        "γψ del primo modo alle pareti. Sotto quella del C7.2.10 alza ζ: l'esito lo dà con questa, e chiede un "
        "motivo se questa lo capovolge.",
    ),
    "brick_height_m": (
        "Height h_b of a course of the return walls [m]: how many are dragged out.",
        "Altezza h_b di un corso dei muri ortogonali [m]: quanti ne vengono trascinati.",
    ),
    "brick_length_m": (
        "Length l of a unit of the return walls [m]: half of it rests on the next course.",
        "Lunghezza l di un elemento dei muri ortogonali [m]: metà poggia sul corso successivo.",
    ),
    "friction": (
        "Friction coefficient mu between the courses; 0.577 is tan 30 degrees.",
        "Coefficiente d'attrito mu fra i corsi; 0,577 è tan 30 gradi.",
    ),
    "time_step_s": (
        "Time step of the record [s], only where the file does not say.",
        "Passo temporale dell'accelerogramma [s], solo se il file non lo dice.",
    ),
}
"""Key of a field -> (English, Italian)."""
