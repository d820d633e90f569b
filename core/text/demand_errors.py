"""Errors on the demand: its spectrum, hazard, return period and confidence factor, in English and Italian."""

DEMAND_ERRORS = {
    "spectrum_ends": (
        "{name} ends at {end:.2f} s, before {period_name} = {period:.2f} s (C8.7.1.2.1.8): give the spectrum "
        "up to there",
        "{name} finisce a {end:.2f} s, prima di {period_name} = {period:.2f} s (C8.7.1.2.1.8): indicare lo "
        "spettro fino a quel periodo",
    ),
    "return_period_short": (
        "{return_period_years} = {stated:g} is below the {shortest:.0f} years of {state} for V_R = {life:g} "
        "years (NTC 2018 3.2.0): the motion of another limit state? Give {nominal_life_years} and "
        "{use_class_factor} if it is right",
        "{return_period_years} = {stated:g} è sotto i {shortest:.0f} anni dello {state} per V_R = {life:g} "
        "anni (NTC 2018 3.2.0): il moto di un altro stato limite? Dare {nominal_life_years} e "
        "{use_class_factor} se è giusto",
    ),
    "return_period_contradicts": (
        "{return_period_years} = {stated:g} contradicts {nominal_life_years} and {use_class_factor}, which "
        "give {own:.0f} years at {state} (NTC 2018 3.2.0): correct one of them",
        "{return_period_years} = {stated:g} contraddice {nominal_life_years} e {use_class_factor}, che danno "
        "{own:.0f} anni allo {state} (NTC 2018 3.2.0): correggere uno dei dati",
    ),
    "hazard_disagrees": (
        "{key} {given:g} contradicts the hazard of this case, which has {stated:.4g} at {years:.0f} years ({state}): "
        "correct one of them",
        "{key} {given:g} contraddice la pericolosità di questo caso, che ha {stated:.4g} a {years:.0f} anni ({state}): "
        "correggere uno dei due",
    ),
    "scale_and_pga_scaling": (
        "{key} {found:g} has no effect with {demand_scaling} pga, which scales every record to a_g S: remove one of "
        "them",
        "{key} {found:g} non ha effetto con {demand_scaling} pga, che scala ogni accelerogramma ad a_g S: togliere uno "
        "dei due",
    ),
    "return_period_of_other": (
        "{return_period_years} = {stated:g} is that of {weaker} for V_R = {life:g} years, not of {state}, "
        "which has {own:.0f} (NTC 2018 3.2.0): give the motion of {state}, or {nominal_life_years} and "
        "{use_class_factor} if it is right",
        "{return_period_years} = {stated:g} è quello dello {weaker} per V_R = {life:g} anni, non dello "
        "{state}, che ha {own:.0f} (NTC 2018 3.2.0): indicare il moto dello {state}, oppure {nominal_life_years} "
        "e {use_class_factor} se è giusto",
    ),
    "period_range_beyond": (
        "{period_range_s} goes to {high:.2f} s, but {name} ends at {end:.2f} s: give the spectrum up to there (a "
        "range that leaves out periods that matter makes the verdict indicative)",
        "{period_range_s} arriva a {high:.2f} s, ma {name} finisce a {end:.2f} s: indicare lo spettro fino a quel "
        "periodo (un intervallo che esclude periodi che contano rende l'esito indicativo)",
    ),
    "t_c_above_t_d": (
        "{tc_star_s} = {stated:g} s on soil {soil} gives T_C = {t_c:.2f} s, not below T_D = {t_d:.2f} s: "
        "check {tc_star_s} and {ag_g}",
        "{tc_star_s} = {stated:g} s su suolo {soil} dà T_C = {t_c:.2f} s, non inferiore a T_D = {t_d:.2f} s: "
        "controllare {tc_star_s} e {ag_g}",
    ),
    "spectrum_too_short": (
        "{rows} rows are too few for a spectrum: at least 5",
        "{rows} righe sono poche per uno spettro: almeno 5",
    ),
    "spectrum_values": (
        "periods from 0 s and ordinates above 0 g to 20 g are accepted",
        "sono ammessi periodi da 0 s e ordinate sopra 0 g fino a 20 g",
    ),
    "spectrum_range": (
        "covers {low:g} to {high:g} s: the range 0.1 to 2.5 s of the Housner intensity must be inside",
        "copre da {low:g} a {high:g} s: l'intervallo da 0.1 a 2.5 s dell'intensità di Housner deve starci "
        "dentro",
    ),
    "spectrum_start": (
        "it starts at {start:.3f} g, but a_g S of the demand is {pga:.3f} g: give {ag_g} and {soil_factor} of "
        "the same site",
        "comincia da {start:.3f} g, ma a_g S della domanda è {pga:.3f} g: indicare {ag_g} e {soil_factor} dello "
        "stesso sito",
    ),
    "spectrum_largest": (
        "its largest ordinate, {largest:.3f} g, is {ratio:.2f} times a_g S of the demand (1.2 to 6 is "
        "accepted): is the file in g, and of the same site?",
        "la sua ordinata massima, {largest:.3f} g, è {ratio:.2f} volte a_g S della domanda (ammesso da 1.2 a "
        "6): il file è in g e dello stesso sito?",
    ),
    "spectrum_not_rising": (
        "the periods must rise, found {period:g} s",
        "i periodi devono crescere, trovato {period:g} s",
    ),
    "no_hazard_file": (
        "there is no such file of the hazard; give its name as in its folder",
        "il file della pericolosità non esiste; indicare il nome come nella sua cartella",
    ),
    "hazard_too_large": (
        "larger than a table of the hazard: give one row for each return period",
        "più grande di una tabella di pericolosità: indicare una riga per ogni periodo di ritorno",
    ),
    "hazard_line": (
        "a row of the hazard has two or four numbers, T_R in years, a_g in g, F0, T_C* in s, in at most 100 rows: "
        '"{text}"',
        "una riga della pericolosità ha due o quattro numeri, T_R in anni, a_g in g, F0, T_C* in s, in al più 100 "
        'righe: "{text}"',
    ),
    "no_hazard_rows": (
        "no row of numbers: each row has T_R in years, a_g in g and, for NTC 2018, F0 and T_C* in s",
        "nessuna riga di numeri: ogni riga ha T_R in anni, a_g in g e, per le NTC 2018, F0 e T_C* in s",
    ),
    "two_hazards": (
        "the hazard is given by a file and by rows: leave one of them out",
        "la pericolosità è data da un file e da righe: togliere l'uno o le altre",
    ),
    "no_spectrum_file": ("there is no such spectrum file", "questo file di spettro non esiste"),
    "spectrum_too_large": (
        "larger than 1 MB: no spectrum of two columns",
        "più di 1 MB: non è uno spettro di due colonne",
    ),
    "spectrum_units": (
        "the head names {unit}: periods are read in s and S_e in g, convert them",
        "l'intestazione nomina {unit}: i periodi si leggono in s e S_e in g, convertirli",
    ),
    "spectrum_line": (
        "two numbers expected, period in s and S_e in g, found {text!r}",
        "due numeri attesi, periodo in s e S_e in g, trovato {text!r}",
    ),
    "hazard_not_rising": (
        "a hazard needs two rows or more, return periods and a_g rising: give them in this order",
        "una pericolosità richiede almeno due righe, con tempi di ritorno e a_g crescenti: darle in quest'ordine",
    ),
    "generate_needs_spectrum": (
        "{section_generate} makes motions compatible with the spectrum of the demand: give "
        "{section_demand_spectrum} or {spectrum_file}",
        "{section_generate} genera moti compatibili con lo spettro della domanda: indicare "
        "{section_demand_spectrum} o {spectrum_file}",
    ),
    "two_spectra": (
        "give {spectrum} or {spectrum_file}, not both",
        "indicare {spectrum} o {spectrum_file}, non entrambi",
    ),
    "soil_factor_follows": (
        "{soil_factor} follows from {section_demand_spectrum}: leave it out",
        "{soil_factor} segue da {section_demand_spectrum}: toglierlo",
    ),
    "intensity_follows": (
        "{housner_intensity_cm} follows from the spectrum: leave one of them out",
        "{housner_intensity_cm} segue dallo spettro: togliere uno dei due",
    ),
    "code_needs": ("code {code} needs {key}", "la norma {code} richiede {key}"),
    "code_does_not_take": ("code {code} does not take {key}", "la norma {code} non ammette {key}"),
    "low_confidence_factor": (
        "{confidence_factor} = {stated:g} takes more than LC1: give {knowledge_level} LC2 or LC3 and what was "
        "investigated "
        "({investigations}), with {compressive_strength_mpa} of each wall (Circolare C8.7.1.2.1, Tab. C8.5.IV), or "
        "1.35",
        "{confidence_factor} = {stated:g} richiede più di LC1: indicare {knowledge_level} LC2 o LC3 e le indagini "
        "svolte "
        "({investigations}), con {compressive_strength_mpa} di ogni parete (Circolare C8.7.1.2.1, Tab. C8.5.IV), "
        "oppure 1.35",
    ),
    "confidence_below_level": (
        "{confidence_factor} = {stated:g} is below the {least:.2f} of {level} (Circolare Tab. C8.5.IV): give "
        "{least:.2f} "
        "or more",
        "{confidence_factor} = {stated:g} è minore di {least:.2f}, quello di {level} (Circolare Tab. C8.5.IV): "
        "indicare "
        "{least:.2f} o più",
    ),
    "confidence_needs_strength": (
        "{confidence_factor} = {stated:g} is for walls whose compressive strength is in alpha (Circolare C8.7.1.2.1): "
        "give {key} from {low:g} to {high:g} MPa (found {found}), from which the setback of the hinge follows, or FC "
        "1.35",
        "{confidence_factor} = {stated:g} è per pareti con la resistenza a compressione in alpha (Circolare "
        "C8.7.1.2.1): "
        "indicare {key} da {low:g} a {high:g} MPa (trovato {found}), da cui segue l'arretramento della cerniera, "
        "oppure FC "
        "1.35",
    ),
}
"""Code -> (English, Italian)."""
