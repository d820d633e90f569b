"""Words of results in each language, for report and window."""

WORDS = {
    "one_sided": ("one-sided", "su un lato"),
    "two_sided": ("two-sided", "su due lati"),
    "both": ("both", "entrambi"),
    "dynamic": ("Dynamic, time histories", "Dinamica, storie temporali"),
    "nonlinear": ("Nonlinear kinematic", "Cinematica non lineare"),
    "linear_q_slv": (
        "Linear kinematic, lower q of the histories",
        "Cinematica lineare, q inferiore delle storie",
    ),
    "linear_q_code": (
        "Linear kinematic, q of the code",
        "Cinematica lineare, fattore di comportamento q",
    ),
    "linear_sld": ("Linear kinematic", "Cinematica lineare"),
    "floor_sld": ("a_g,SLD / a_g", "a_g,SLD / a_g"),
    "dynamic_capacity": ("Dynamic, FC on the strength", "Dinamica, FC sulla resistenza"),
    "dynamic_demand": ("Dynamic, FC on the demand", "Dinamica, FC sulla domanda"),
    "confidence_capacity": ("FC on the strength", "FC sulla resistenza"),
    "confidence_demand": ("FC on the demand", "FC sulla domanda"),
    "code": ("Eq. 9, q of the code", "Eq. 9, fattore di comportamento q"),
    "closed_form": ("Eq. 9, q of Eq. 15/16", "Eq. 9, q delle Eq. 15/16"),
    "time_histories": ("Eq. 9, q at collapse", "Eq. 9, q a collasso"),
    "time_histories_slv": ("Eq. 9, q at SLV", "Eq. 9, q allo SLV"),
    "time_histories_robust": ("Eq. 9, q robust", "Eq. 9, q robusto"),
    "law_q": ("Eq. 9, Ribalta's law of q (research)", "Eq. 9, legge di Ribalta per q (ricerca)"),
    "law_q_slv": (
        "Eq. 9, Ribalta's law of q at SLV (research)",
        "Eq. 9, legge di Ribalta per q allo SLV (ricerca)",
    ),
    "not_activated": ("mechanism not activated", "meccanismo non attivato"),
    "verified": ("verified", "verificata"),
    "verified_refined": ("verified, refined method only", "verificata, solo metodo raffinato"),
    "q2_unsafe": (
        "not verified, q of the code would pass",
        "non verificata, con q di norma risulterebbe verificata",
    ),
    "not_verified": ("not verified", "non verificata"),
    "indicative": ("indicative only", "solo indicativa"),
    "at_limit": ("at the limit, not verified", "al limite, non verificata"),
    "undetermined": ("not determined", "non determinata"),
    "no_hazard": ("no hazard given", "pericolosità non assegnata"),
    "reason_given": ("Reason of the engineer", "Motivo del progettista"),
    "to_do": ("To do", "Da fare"),
    "limits": ("Limits", "Limiti"),
    "note": ("Note", "Nota"),
    "passed": ("passed", "soddisfatta"),
    "not_passed": ("not passed", "non soddisfatta"),
    "shown": ("shown only", "solo mostrato"),
    "no_number": ("no number", "nessun valore"),
    "comparison": ("comparison", "confronto"),
    "mean_lower": ("mean spectrum, lowest below target", "spettro medio, minimo sotto lo spettro"),
    "mean_upper": (
        "mean spectrum, highest above target",
        "spettro medio, massimo sopra lo spettro",
    ),
    "records": ("records, a station once", "accelerogrammi, una stazione una volta"),
    "mean_pga": ("mean PGA against a_g S", "PGA media rispetto ad a_g S"),
    "strong_part": ("pseudo-stationary part", "parte pseudo-stazionaria"),
    "duration": ("total duration", "durata totale"),
    "stable": ("stable", "stabile"),
    "overturned": ("overturns", "ribalta"),
    "impact_limit": ("impact limit", "limite di urti"),
    "maximum": ("largest", "massimo"),
    "mean": ("mean", "media"),
    "natural": ("natural", "naturale"),
    "artificial": ("artificial", "artificiale"),
    "simulated": ("simulated", "simulato"),
}
"""Key -> (English, Italian)."""

LOADS = {
    "load_vertical": ("vertical load", "carico verticale"),
    "load_thrust": ("thrust", "spinta"),
    "load_tie": ("tie", "catena"),
    "load_carried_mass": ("carried mass", "massa portata"),
}
"""Kinds of loads: code -> (English, Italian)."""

ASSUMPTIONS = {
    "monolithic": (
        "monolithic wall, no leaves that part",
        "parete monolitica, senza paramenti che si separano",
    ),
    "no_load": (
        "no load or thrust of floors and roof",
        "nessun carico o spinta di solai e copertura",
    ),
    "no_ties": (
        "no ties, no other restraint than the one named",
        "nessuna catena, nessun altro vincolo oltre a quello indicato",
    ),
    "loads_as_given": (
        "loads as given, of constant size and direction; nothing else rests on the walls",
        "carichi come indicati, di intensità e direzione costanti; nient'altro grava sulle pareti",
    ),
    "ties_as_given": (
        "ties hold their force up to collapse; anchorage checked apart",
        "le catene mantengono la forza fino al collasso; ancoraggi verificati a parte",
    ),
    "no_sliding": ("no sliding at the base", "nessuno scorrimento alla base"),
    "no_vertical_motion": ("no vertical ground motion", "nessun moto verticale del suolo"),
}
"""What the engineer confirms by ticking; no_load is ticked where every wall says unloaded_confirmed."""
