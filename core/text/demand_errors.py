"""Sentences of demands that contradict themselves or take more than is given."""

DEMAND_ERRORS = {
    "hazard_disagrees": (
        "{key} {given:g} contradicts the hazard of this case, which has {stated:.4g} at {years:.0f} years ({state}): "
        "correct one of them",
        "{key} {given:g} contraddice la pericolosità di questo caso, che ha {stated:.4g} a {years:.0f} anni ({state}): "
        "correggere uno dei due",
    ),
    "hazard_above": (
        "{key} {given:g} is below the {stated:.4g} that the hazard of this case has at {years:.0f} years, the shortest "
        "return period of {state} (V_R = {life:g} years): correct it, or give {nominal_life_years} and "
        "{use_class_factor}",
        "{key} {given:g} è minore di {stated:.4g}, che la pericolosità di questo caso ha a {years:.0f} anni, il "
        "periodo di ritorno minimo dello {state} (V_R = {life:g} anni): correggerlo, oppure indicare "
        "{nominal_life_years} e {use_class_factor}",
    ),
    "scale_and_pga_scaling": (
        "{key} {found:g} has no effect with {demand_scaling} pga, which scales every record to a_g S: remove one of "
        "them",
        "{key} {found:g} non ha effetto con {demand_scaling} pga, che scala ogni accelerogramma ad a_g S: togliere uno "
        "dei due",
    ),
    "return_period_contradicts": (
        "{return_period_years} = {stated:g} contradicts {nominal_life_years} and {use_class_factor}, which "
        "give {own:.0f} years at {state} (NTC 2018 3.2.0): correct one of them",
        "{return_period_years} = {stated:g} contraddice {nominal_life_years} e {use_class_factor}, che danno "
        "{own:.0f} anni allo {state} (NTC 2018 3.2.0): correggere uno dei dati",
    ),
    "return_period_of_other": (
        "{return_period_years} = {stated:g} is that of {weaker} for V_R = {life:g} years, not of {state}, "
        "which has {own:.0f} (NTC 2018 3.2.0): give the motion of {state}, or {nominal_life_years} and "
        "{use_class_factor} if it is right",
        "{return_period_years} = {stated:g} è quello dello {weaker} per V_R = {life:g} anni, non dello "
        "{state}, che ha {own:.0f} (NTC 2018 3.2.0): indicare il moto dello {state}, oppure {nominal_life_years} "
        "e {use_class_factor} se è giusto",
    ),
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
    "reason_says_nothing": (
        "the reason {value!r} for {key} says nothing: write in words why its value holds, or leave it out",
        "il motivo {value!r} per {key} non dice nulla: scrivere a parole perché il valore è valido, oppure ometterlo",
    ),
    "restraint_unnamed": (
        "{key} {value!r} names nothing: say what stands behind the wall and holds it, or leave the key out",
        "{key} {value!r} non indica nulla: dire che cosa sta dietro la parete e la trattiene, oppure omettere la "
        "chiave",
    ),
    "return_period_short": (
        "{return_period_years} = {stated:g} is below the {shortest:.0f} years of {state} for V_R = {life:g} "
        "years (NTC 2018 3.2.0): the motion of another limit state? Give {nominal_life_years} and "
        "{use_class_factor} if it is right",
        "{return_period_years} = {stated:g} è sotto i {shortest:.0f} anni dello {state} per V_R = {life:g} "
        "anni (NTC 2018 3.2.0): il moto di un altro stato limite? Dare {nominal_life_years} e "
        "{use_class_factor} se è giusto",
    ),
}
"""Code -> (English, Italian). A placeholder without a value is a key of the case."""
