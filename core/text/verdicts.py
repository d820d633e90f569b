"""Sentences of the verdict and its reasons, English and Italian. Never the word "safe"."""

SHORT = {
    "dynamic": ("time histories", "storie temporali"),
    "nonlinear": ("displacement", "spostamento"),
    "linear_q_slv": ("lower q of the histories", "q inferiore delle storie"),
    "linear_q_code": ("q = {q}", "q = {q}"),
    "linear_sld": ("linear check", "verifica lineare"),
    "confidence_demand": ("FC on the demand", "FC sulla domanda"),
    "confidence_capacity": ("FC on the strength", "FC sulla resistenza"),
}
"""Label of a check -> what a list of checks calls it (English, Italian)."""

SENTENCES = {
    "not_activated": (
        "not activated at {state}{where}{unloaded}: FC S a_g = {demand:.3f} g does not exceed a_RM = {a_rm:.3f} g.",
        "meccanismo non attivato allo {state}{where}{unloaded}: FC S a_g = {demand:.3f} g non supera a_RM = "
        "{a_rm:.3f} g.",
    ),
    "not_activated_floor": (
        "not activated at {state}{where}{unloaded}: FC times the largest acceleration of the floor, {demand:.3f} g, "
        "does "
        "not exceed a_RM = {a_rm:.3f} g.",
        "meccanismo non attivato allo {state}{where}{unloaded}: FC per la massima accelerazione del piano, "
        "{demand:.3f} g, "
        "non supera a_RM = {a_rm:.3f} g.",
    ),
    "verified": (
        "verified at {state}{unloaded}, ζ {zeta}{where}, by {by}.{tail}",
        "verificata allo {state}{unloaded}, ζ {zeta}{where}, secondo {by}.{tail}",
    ),
    "verified_refined": (
        "verified at {state}{unloaded} only by {by}, ζ {zeta}{where}.{tail}",
        "verificata allo {state}{unloaded} solo secondo {by}, ζ {zeta}{where}.{tail}",
    ),
    "q2_unsafe": (
        "not verified at {state}, ζ {zeta}{where}, by {by}.{tail}",
        "non verificata allo {state}, ζ {zeta}{where}, secondo {by}.{tail}",
    ),
    "not_verified": (
        "not verified at {state}, ζ {zeta}{where}, by {by}.{tail}",
        "non verificata allo {state}, ζ {zeta}{where}, secondo {by}.{tail}",
    ),
    "at_limit": (
        "at the limit at {state}{unloaded}: ζ {low} to {high}{where} for {target:.2f} required, counted as not "
        "verified, by "
        "{by}.{tail}",
        "al limite allo {state}{unloaded}: ζ fra {low} e {high}{where} per {target:.2f} richiesto, considerata non "
        "verificata, secondo {by}.{tail}",
    ),
    "indicative": (
        "only indicative at {state}{unloaded}, this is not a code verification: ζ {zeta}{where} by {by}.{tail}",
        "solo indicativa allo {state}{unloaded}, non è una verifica di norma: ζ {zeta}{where} secondo {by}.{tail}",
    ),
    "undetermined": ("not determined at {state}{where}: {missing}", "non determinata allo {state}{where}: {missing}"),
}
"""Code of a verdict -> (English, Italian); the name of the wall stands before it."""

ADDED = {
    "with_pga": ("{where} {pga:.3f} g", "{where} {pga:.3f} g"),
    "required": ("{zeta} (required {target:g})", "{zeta} (richiesto {target:g})"),
    "at_hinge": (" at the hinge of +{height:.4g} m", " alla cerniera a +{height:.4g} m"),
    "at_base": (" at the base, {z:.4g} m above the ground", " alla base, a {z:.4g} m dal suolo"),
    "at_demand": ("the demand", "alla domanda"),
    "at_share": ("{target:g} of the demand", "allo {target:g} della domanda"),
    "nothing": ("", ""),
    "unloaded": (" if the wall carries no load", " se la parete non porta carichi"),
    "by_dynamic_mean": (
        "time histories (mean peak {peak} θ_c, limit {limit})",
        "storie temporali (media dei massimi {peak} θ_c, limite {limit})",
    ),
    "by_dynamic_maximum": (
        "time histories (largest peak {peak} θ_c, limit {limit})",
        "storie temporali (massimo {peak} θ_c, limite {limit})",
    ),
    "by_dynamic_falls": ("time histories ({n} of {m} overturn)", "storie temporali ({n} su {m} ribaltano)"),
    "by_nonlinear": (
        "the displacement check (d {demand} m, limit {capacity} m)",
        "la verifica in spostamento (d {demand} m, limite {capacity} m)",
    ),
    "by_linear_q_code": (
        "the linear check with q = {q} (a_g {demand} g, limit {capacity} g)",
        "la verifica lineare con q = {q} (a_g {demand} g, limite {capacity} g)",
    ),
    "by_linear_q_slv": (
        "the linear check with the lower q of the histories, {q} (a_g {demand} g, limit {capacity} g)",
        "la verifica lineare con il q inferiore delle storie, {q} (a_g {demand} g, limite {capacity} g)",
    ),
    "by_linear_sld": (
        "the linear check (acceleration {demand} g, limit {capacity} g)",
        "la verifica lineare (accelerazione {demand} g, limite {capacity} g)",
    ),
    "by_dynamic": ("time histories", "storie temporali"),
    "decides": ("{by}, {clause}", "{by}, {clause}"),
    "check_zeta": ("{check} {zeta}", "{check} {zeta}"),
    "not_by": (" Not by: {checks}.", " Non secondo: {checks}."),
    "q_agrees": (" The check with q = {q:g} agrees.", " La verifica con q = {q:g} concorda."),
    "q_would_pass": (
        "{tail} The check with q = {q:g} alone would pass: here it is not conservative.",
        "{tail} La sola verifica con q = {q:g} sarebbe soddisfatta: qui non è cautelativa.",
    ),
    "no_q_check": (
        "{tail} The check with q = {q:g} could not be evaluated.",
        "{tail} La verifica con q = {q:g} non si è potuta valutare.",
    ),
    "fails_at_demand": (
        "{zeta}, but the rule fails at the demand itself",
        "{zeta}, ma la regola non vale alla domanda stessa",
    ),
}
"""Parts of a sentence."""

REASONS = {
    "weaker_fails": (
        "A weaker motion fails already, at {first:.3f} of the demand; around {zeta_16} of it one multiplier in six "
        "does.",
        "Un moto più debole non soddisfa già a {first:.3f} della domanda; intorno a {zeta_16} di essa uno su sei.",
    ),
    "share": (
        "Of the multipliers within 10 % of {target:g} of the demand {share:.0%} fail.",
        "Dei moltiplicatori entro il 10 % dal {target:g} della domanda il {share:.0%} non soddisfa la regola.",
    ),
    "alone": (
        "Neither the displacement check nor FC on the other side confirms the time histories.",
        "Né la verifica in spostamento né FC sull'altro lato confermano le storie temporali.",
    ),
    "restraint_fails": (
        "Should the restraint behind the wall fail, it rocks on both sides: ζ {zeta}.",
        "Se il vincolo dietro la parete cede, la parete oscilla su due lati: ζ {zeta}.",
    ),
    "no_check": (
        "no check could be made; give records or {spectrum}, and of an element free to vibrate {modulus} and {weight}.",
        "nessuna verifica è stata possibile; indicare accelerogrammi o {spectrum}, e di un elemento libero di vibrare "
        "{modulus} e {weight}.",
    ),
    "no_number": (
        "a time history ended without a number (impact limit); put another record in its place, so that there are "
        "no fewer.",
        "una storia temporale è terminata senza un valore (limite di urti); mettere al suo posto un altro "
        "accelerogramma, così che non siano di meno.",
    ),
    "other_state": (
        "At {state} it is {outcome}: ζ {zeta} by {check}.",
        "Allo {state} è {outcome}: ζ {zeta} secondo {check}.",
    ),
    "heights_left_out": (
        "Hinges at {heights} m above its base are not checked: give [building], or hinge_heights.",
        "Le cerniere a {heights} m dalla base non sono verificate: indicare [building], o hinge_heights.",
    ),
    "hinges_as_asked": (
        "Only the hinges asked for (hinge_heights) are checked; others lie at {heights} m above its base.",
        "Sono verificate solo le cerniere richieste (hinge_heights); altre sono a {heights} m dalla base.",
    ),
    "justify": (
        "The designer justifies the refined method in the note (C8.7.1.2.1.9).",
        "Il progettista motiva nella relazione il metodo raffinato (C8.7.1.2.1.9).",
    ),
    "strengthen": (
        "Strengthen the wall (tie, restraint, less thrust) and check it again as the variant progetto.",
        "Rinforzare la parete (catena, vincolo, spinta ridotta) e verificarla di nuovo come variante progetto.",
    ),
    "give_reason": (
        "Write under justification why the value of {key} holds, or take the one that lowers ζ.",
        "Scrivere in justification perché il valore di {key} è valido, o usare quello che abbassa ζ.",
    ),
    "to_no_restraint": (
        "Name what holds the wall from behind (back_restraint), or study it as two-sided.",
        "Indicare che cosa trattiene la parete da dietro (back_restraint), o studiarla su due lati.",
    ),
    "to_no_spectrum": ("Give the spectrum of the demand.", "Indicare lo spettro della domanda."),
    "to_not_compatible": (
        "Choose natural records compatible with the spectrum, no fewer than now (tab Spectra).",
        "Scegliere accelerogrammi naturali compatibili con lo spettro, non meno di ora (scheda Spettri).",
    ),
    "to_few_records": (
        "Give records of seven stations or more, compatible with the spectrum.",
        "Indicare accelerogrammi di almeno sette stazioni, compatibili con lo spettro.",
    ),
    "to_bundled": (
        "Replace the bundled motions by records of the site.",
        "Sostituire i moti di esempio con accelerogrammi del sito.",
    ),
    "to_one_sign": (
        "Take both signs of each record (polarity both).",
        "Usare entrambi i segni di ogni accelerogramma (polarity both).",
    ),
    "to_no_soil_factor": ("Give the soil factor S.", "Indicare il coefficiente S."),
    "to_period_estimated": (
        "Give the period of the building, from a model of it or measured (period_s).",
        "Indicare il periodo dell'edificio, da un suo modello o misurato (period_s).",
    ),
    "lift_velocity_ratio": (
        "The velocity ratio {e:.3f} is given: with {more:.3f} ζ is {zeta_more}, with the theoretical {theory:.3f} it "
        "is "
        "{zeta_theory}.",
        "Il coefficiente di restituzione {e:.3f} è dato: con {more:.3f} ζ è {zeta_more}, con quello teorico "
        "{theory:.3f} è "
        "{zeta_theory}.",
    ),
    "lift_confidence_factor": (
        "FC {fc:g} by {level} ({investigations}): with 1.35 ζ is {zeta}.",
        "FC {fc:g} per {level} ({investigations}): con 1,35 ζ è {zeta}.",
    ),
    "lift_q_code": (
        "q = {q:g} is given in place of 2: with q = 2 ζ of the linear check is {zeta}.",
        "È dato q = {q:g} al posto di 2: con q = 2 ζ della verifica lineare è {zeta}.",
    ),
    "lift_return_walls": (
        "The friction of the return walls is counted: without it ζ is {zeta}.",
        "È contato l'attrito dei muri ortogonali: senza, ζ è {zeta}.",
    ),
    "lift_participation": (
        "The participation {given:.2f} is below the {expected:.2f} of C7.2.10: with that ζ is {zeta}.",
        "La partecipazione {given:.2f} è minore di {expected:.2f} di C7.2.10: con questa ζ è {zeta}.",
    ),
    "lift_free_element": (
        "The two-sided wall is declared not free to vibrate: as a free element ζ is {zeta} by {check}. By what is it "
        "held?",
        "La parete su due lati è dichiarata non libera di vibrare: come elemento libero ζ è {zeta} secondo {check}. Da "
        "che cosa è trattenuta?",
    ),
    "lift_one_sided_free": (
        "The one-sided wall is declared free to vibrate: held, ζ is {zeta} by {check}.",
        "La parete su un lato è dichiarata libera di vibrare: trattenuta, ζ è {zeta} secondo {check}.",
    ),
    "lift_law": (
        "A trilinear law is given: with the rigid law ζ is {zeta}.",
        "È data una legge trilineare: con la legge rigida ζ è {zeta}.",
    ),
    "lifts_together": (
        "With the other ends of {keys} together ζ is {zeta}.",
        "Con gli altri estremi di {keys} insieme ζ è {zeta}.",
    ),
    "q_rests_on": (
        "At the other end of {keys} the check with q = {q} fails: it does not count as one that agrees.",
        "All'altro estremo di {keys} la verifica con q = {q} non è soddisfatta: non conta come verifica concorde.",
    ),
    "generated_motions": (
        "The motions are generated: C8.7.1.2.1.9 advises natural records, under which ζ may be lower.",
        "I moti sono generati: il C8.7.1.2.1.9 consiglia accelerogrammi naturali, con i quali ζ può essere minore.",
    ),
    "friction_hinge": (
        "The friction of return walls governs for the upper {height:.2f} m of the wall; their demand is taken "
        "at the base.",
        "L'attrito dei muri ortogonali governa per i {height:.2f} m superiori della parete; la loro domanda è "
        "quella alla "
        "base.",
    ),
    "upper_floor": (
        "The base of the wall is {z:g} m above the ground: not assessable with the ground motion alone. "
        "For the motion of the floor three numbers are missing: {height}, {storeys} and {period} of {building}.",
        "La base della parete è a {z:g} m dal suolo: non valutabile con il solo moto del terreno. Per il moto "
        "del piano mancano tre numeri: {height}, {storeys} e {period} di {building}.",
    ),
    "odd_storeys": (
        "The building has storeys of {storey:.1f} m: check the height and the number of storeys.",
        "L'edificio ha piani di {storey:.1f} m: controllare l'altezza e il numero di piani.",
    ),
    "odd_building_period": (
        "The period {period:g} s of the building is far from the {expected:.2f} s of its height: mistyped?",
        "Il periodo {period:g} s dell'edificio è lontano da {expected:.2f} s della sua altezza: errato?",
    ),
    "stiff_building": (
        "The building is taken at {factor:g} times its elastic period and {damping:.0%} damping: at the ultimate limit "
        "states C8.7.1.2.1.4 has 1.5 to 2.0 and 10 to 20%.",
        "L'edificio è preso a {factor:g} volte il periodo elastico e smorzamento {damping:.0%}: agli stati limite "
        "ultimi C8.7.1.2.1.4 indica 1,5-2,0 e 10-20%.",
    ),
    "period_estimated": (
        "The period of the building is an estimate, 0.05 H^0.75: give its period.",
        "Il periodo dell'edificio è una stima, 0,05 H^0,75: indicarne il periodo.",
    ),
    "other_building": (
        "With the building at {factor:g} times its elastic period and {damping:.0%} damping ζ is {zeta}.",
        "Con l'edificio a {factor:g} volte il periodo elastico e smorzamento {damping:.0%} ζ è {zeta}.",
    ),
    "weaker_records": (
        "The records as given have a mean PGA of {share:.0%} of a_g S: the dynamic check is not at the demand, and "
        "no PGA_C follows from it.",
        "Gli accelerogrammi così come dati hanno PGA media pari al {share:.0%} di a_g S: la verifica dinamica non è "
        "alla domanda, e non se ne ricava alcuna PGA_C.",
    ),
    "at_centroid": (
        "With the motion at {z:.2f} m, the height of the wall's centroid up to that of the building, ζ is {zeta}.",
        "Con il moto a {z:.2f} m, quota del baricentro della parete fino a quella dell'edificio, ζ è {zeta}.",
    ),
    "code_below_records": (
        "On [T_0, T_SLV] the floor spectrum of the code falls to {ratio:.2f} of the mean of the floor motions: its "
        "checks ask less than these records do.",
        "Su [T_0, T_SLV] lo spettro di piano della norma scende a {ratio:.2f} della media dei moti di piano: le sue "
        "verifiche chiedono meno di questi accelerogrammi.",
    ),
    "demand_fails": (
        "The rule fails at {at} itself, though at fewer than half of the multipliers around.",
        "La regola non vale {at} stessa, benché cada a meno di metà dei moltiplicatori intorno.",
    ),
    "whole_demand_fails": (
        "The rule holds at the {target:g} of the demand that is required, and fails at the demand itself.",
        "La regola vale al {target:g} della domanda richiesto, e non alla domanda stessa.",
    ),
    "narrow_range": (
        "The records are compared with the spectrum from {low:g} to {high:g} s only, as asked: {least:g} to "
        "{most:.2f} s are the periods that matter.",
        "Gli accelerogrammi sono confrontati con lo spettro solo da {low:g} a {high:g} s, come richiesto: "
        "contano i periodi da {least:g} a {most:.2f} s.",
    ),
    "rigid_free": (
        "C8.7.1.2.1.3 asks an initial elastic branch of an element free to vibrate: the histories use the "
        "rigid law; compare with a trilinear law.",
        "Il C8.7.1.2.1.3 richiede un ramo elastico iniziale per un elemento libero di vibrare: le storie "
        "usano la legge rigida; confrontare con una legge trilineare.",
    ),
    "no_period": (
        "Linear checks not made: an element free to vibrate is compared with the spectrum at T_0 "
        "(C8.7.1.2.1.5, .7), which takes {missing}.",
        "Verifiche lineari non eseguite: un elemento libero di vibrare si confronta con lo spettro in T_0 "
        "(C8.7.1.2.1.5, .7), che richiede {missing}.",
    ),
    "no_restraint": (
        "The restraint behind the wall is not named: one-sided rocking rests on it.",
        "Il vincolo dietro la parete non è indicato: l'oscillazione su un lato si basa su di esso.",
    ),
    "lower_q_slv": (
        "The linear check takes q {low:.2f}, the lower end of the spread of q SLV: with q SLV itself, {q:.2f}, it "
        "would pass.",
        "La verifica lineare usa q {low:.2f}, l'estremo inferiore della dispersione di q SLV: con q SLV stesso, "
        "{q:.2f}, sarebbe soddisfatta.",
    ),
    "more_records": (
        "{n} stations: C8.7.1.2.1.9 advises more records than the analysis of the whole building takes.",
        "{n} stazioni: il C8.7.1.2.1.9 consiglia un numero di accelerogrammi maggiore che per l'analisi globale.",
    ),
    "no_station": (
        "{n} file(s) name no station: each was counted as a station of its own.",
        "{n} file non indicano la stazione: ognuno è stato contato come una stazione a sé.",
    ),
    "not_compatible": (
        "The set of records is not compatible with the target spectrum.",
        "L'insieme degli accelerogrammi non è compatibile con lo spettro.",
    ),
    "no_spectrum": (
        "No target spectrum is given: the compatibility of the records is not shown.",
        "Spettro non assegnato: la compatibilità degli accelerogrammi non è dimostrata.",
    ),
    "few_records": ("{n} station(s): fewer than 3.", "{n} stazioni: meno di 3."),
    "bundled": (
        "The records are the bundled example, for trials only.",
        "Gli accelerogrammi sono quelli di esempio, solo per prova.",
    ),
    "stocky": (
        "alpha {alpha:.1f} deg is outside the range in which the kinematic model is usual (up to 20 deg).",
        "alpha {alpha:.1f}° è fuori dal campo usuale del modello cinematico (fino a 20°).",
    ),
    "pga_scaling": (
        "Every record is rescaled to a_g S: the compatibility of the set is broken.",
        "Ogni accelerogramma è riscalato ad a_g S: la compatibilità dell'insieme non vale più.",
    ),
    "one_sign": (
        "A one-sided wall was given each record with one sign only.",
        "Una parete su un lato è stata analizzata con un solo segno di ogni accelerogramma.",
    ),
    "comparison_method": (
        "The integrator chosen is for comparison only.",
        "L'integratore scelto serve solo per confronto.",
    ),
    "no_soil_factor": ("S is not given and taken as 1, rock.", "S non è assegnato ed è posto pari a 1, roccia."),
}

MISSING_WORDS = {
    "elastic_modulus_mpa": ("the elastic modulus E", "il modulo elastico E"),
    "unit_weight_kn_m3": ("the unit weight", "il peso specifico"),
    "height_m": ("a rectangular wall", "una parete rettangolare"),
    "spectrum": ("the spectrum of the demand", "lo spettro della domanda"),
    "period_0": (
        "a T_0 at which the wall does not stay elastic up to d_SLV (are E, unit weight and H/t right?)",
        "un T_0 al quale la parete non resti elastica fino a d_SLV (E, peso specifico e H/t sono giusti?)",
    ),
}
"""What T_0 and the spectrum there take -> (English, Italian)."""
