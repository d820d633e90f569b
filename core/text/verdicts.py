"""Sentences of the verdict and its reasons, English and Italian. Never the word "safe"."""

METHOD_WORDS = {
    "dynamic": ("the dynamic check (C8.7.1.2.1.9)", "la verifica dinamica (C8.7.1.2.1.9)"),
    "nonlinear": (
        "the nonlinear kinematic check (C8.7.1.2.1.8)",
        "la verifica cinematica non lineare (C8.7.1.2.1.8)",
    ),
    "linear_q_slv": (
        "the linear kinematic check with the lower q of the time histories (C8.7.1.2.1.7)",
        "la verifica cinematica lineare con il q inferiore delle storie temporali (C8.7.1.2.1.7)",
    ),
    "linear_q_code": (
        "the linear kinematic check with the q of the code (C8.7.1.2.1.7)",
        "la verifica cinematica lineare con il fattore di comportamento q (C8.7.1.2.1.7)",
    ),
    "linear_sld": (
        "the linear kinematic check (C8.7.1.2.1.5)",
        "la verifica cinematica lineare (C8.7.1.2.1.5)",
    ),
}
"""Label of a check -> (English, Italian)."""

SENTENCES = {
    "not_activated": (
        "The mechanism does not start: FC S a_g = {demand:.3f} g does not exceed a_RM = {a_rm:.3f} g.",
        "Il meccanismo non si attiva: FC S a_g = {demand:.3f} g non supera a_RM = {a_rm:.3f} g.",
    ),
    "not_activated_floor": (
        "The mechanism does not start: FC times the largest acceleration of the floor, {demand:.3f} g, does not exceed "
        "a_RM = {a_rm:.3f} g.",
        "Il meccanismo non si attiva: FC per la massima accelerazione del piano, {demand:.3f} g, non supera "
        "a_RM = {a_rm:.3f} g.",
    ),
    "verified": (
        "Verified at {state}: ζ {zeta} by {method}; the check with q = {q:g} agrees.",
        "Verificata allo {state}: ζ {zeta} secondo {method}; la verifica con q = {q:g} concorda.",
    ),
    "verified_plainly": (
        "Verified at {state}: ζ {zeta} by {method}.",
        "Verificata allo {state}: ζ {zeta} secondo {method}.",
    ),
    "verified_simply": (
        "Verified at {state}: ζ {zeta} by {method}, the simplified one.",
        "Verificata allo {state}: ζ {zeta} secondo {method}, quella semplificata.",
    ),
    "verified_refined": (
        "Verified at {state} by {method} only: ζ {zeta}. With q = {q:g} it is not: the designer must "
        "justify the refined method.",
        "Verificata allo {state} solo secondo {method}: ζ {zeta}. Con q = {q:g} non lo è: il progettista "
        "deve motivare il metodo raffinato.",
    ),
    "verified_alone": (
        "Verified at {state} by {method} only: ζ {zeta}. The check with q = {q:g} could not be evaluated: "
        "the designer must justify the refined method.",
        "Verificata allo {state} solo secondo {method}: ζ {zeta}. La verifica con q = {q:g} non si è "
        "potuta valutare: il progettista deve motivare il metodo raffinato.",
    ),
    "q2_unsafe": (
        "Not verified at {state}: ζ {zeta} by {method}. The check with q = {q:g} alone would pass and is "
        "not conservative here.",
        "Non verificata allo {state}: ζ {zeta} secondo {method}. La sola verifica con q = {q:g} sarebbe "
        "soddisfatta: qui non è cautelativa.",
    ),
    "not_verified": (
        "Not verified at {state}: ζ {zeta} by {method}.",
        "Non verificata allo {state}: ζ {zeta} secondo {method}.",
    ),
    "indicative": (
        "Indicative only: ζ {zeta} at {state} by {method}; this is not a code verification.",
        "Solo indicativo: ζ {zeta} allo {state} secondo {method}; non è una verifica di norma.",
    ),
    "undetermined": (
        "Undetermined at {state}: see the reasons.",
        "Non determinabile allo {state}: vedere i motivi.",
    ),
}
"""Code of a verdict, or one of the ways to say `verified` and `verified_refined` -> (English, Italian)."""

ADDED = {
    "with_pga": ("{where} {pga:.3f} g", "{where} {pga:.3f} g"),
    "share_of_target": (
        " Of the multipliers within 10 % of {target:g} of the demand {share:.0%} fail.",
        " Dei moltiplicatori entro il 10 % dal {target:g} della domanda il {share:.0%} non soddisfa la regola.",
    ),
    "share": (
        " Of the multipliers within 10 % of the demand {share:.0%} fail.",
        " Dei moltiplicatori entro il 10 % dalla domanda il {share:.0%} non soddisfa la regola.",
    ),
    "confidence_demand": (
        " With FC on the demand instead of the strength it is {negation}verified: ζ {zeta}.",
        " Con FC sulla domanda anziché sulla resistenza {negation}è verificata: ζ {zeta}.",
    ),
    "confidence_capacity": (
        " With FC on the strength, as required by C8.7.1.2.1.3, it is {negation}verified: ζ {zeta}.",
        " Con FC sulla resistenza, come richiede il C8.7.1.2.1.3, {negation}è verificata: ζ {zeta}.",
    ),
    "required": ("{zeta} (required {target:g})", "{zeta} (richiesto {target:g})"),
    "at_demand": ("the demand", "alla domanda"),
    "at_share": ("{target:g} of the demand", "allo {target:g} della domanda"),
    "not": ("not ", "non "),
    "nothing": ("", ""),
    "fails_at_demand": (
        "{zeta}, but the rule fails at the demand itself",
        "{zeta}, ma la regola non vale alla domanda stessa",
    ),
    "unloaded": (", if the wall carries no load.", ", se la parete non porta carichi."),
}
"""What a sentence is followed by."""

REASONS = {
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
    "no_number": (
        "A time history ended without a number (impact limit).",
        "Una storia temporale è terminata senza un valore (limite di urti).",
    ),
    "within_spread": (
        "ζ is known from {low:.3f} to {high:.3f} only, and the required {target:.2f} lies between.",
        "ζ è noto solo fra {low:.3f} e {high:.3f}, e il valore richiesto {target:.2f} sta in mezzo.",
    ),
    "weaker_fails": (
        "The rule holds at {at} itself but fails around {zeta:.2f} of it: a weaker motion is worse.",
        "La regola vale {at} ma non intorno a {zeta:.2f} di essa: un moto più debole è più gravoso.",
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
    "no_check": ("No check could be made.", "Nessuna verifica è stata possibile."),
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
        "{n} stazioni: il C8.7.1.2.1.9 consiglia un numero di accelerogrammi maggiore che per l'analisi "
        "globale.",
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
    "no_soil_factor": (
        "S is not given and taken as 1, rock.",
        "S non è assegnato ed è posto pari a 1, roccia.",
    ),
    "disagrees": (
        "{method} gives ζ {zeta}: {outcome}.",
        "{method}: ζ {zeta}, {outcome}.",
    ),
}

MISSING_WORDS = {
    "elastic_modulus_mpa": ("the elastic modulus E", "il modulo elastico E"),
    "unit_weight_kn_m3": ("the unit weight", "il peso specifico"),
    "height_m": ("a rectangular wall", "una parete rettangolare"),
    "spectrum": ("the spectrum of the demand", "lo spettro della domanda"),
    "period_0": (
        "a shorter T_0 (E, unit weight and H/t as given make the wall elastic up to d_SLV)",
        "un T_0 più breve (con E, peso specifico e H/t dati la parete è elastica fino a d_SLV)",
    ),
}
"""What T_0 and the spectrum there take -> (English, Italian)."""
