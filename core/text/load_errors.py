"""Errors on the loads of a wall, in English and Italian."""

LOAD_ERRORS = {
    "loads_need_weight": (
        "loads act on a metre of a rectangular wall of known weight: give {height_m}, {thickness_m} and "
        "{unit_weight_kn_m3}",
        "i carichi agiscono su un metro di parete rettangolare di peso noto: indicare {height_m}, {thickness_m} e "
        "{unit_weight_kn_m3}",
    ),
    "loads_contradict": (
        "{key} says that the wall carries nothing, and it has loads: leave {key} out, or the loads if they are not "
        "there",
        "{key} dichiara che la parete non porta nulla, ma ci sono carichi: togliere {key}, o i carichi se non esistono",
    ),
    "load_mass_missing": (
        "a vertical load needs {key}: none where the mass is held elsewhere, horizontal where it pushes the wall, "
        "moving where it moves with the wall",
        "un carico verticale richiede {key}: none se la massa è trattenuta altrove, horizontal se spinge la parete, "
        "moving se si muove con la parete",
    ),
    "load_mass_refused": (
        "{key} does not go with {kind}: leave it out; a mass that moves is a load of its own, vertical or carried",
        "{key} non si accorda con {kind}: toglierlo; una massa che si muove è un carico a sé, verticale o portato",
    ),
    "load_distance_missing": (
        "give {key}, the distance of the load from the outer face of the wall",
        "indicare {key}, la distanza del carico dalla faccia esterna della parete",
    ),
    "load_outside": (
        "{key} {found:g} m lies outside the wall: accepted is up to {most:g} m",
        "{key} {found:g} m è fuori dalla parete: si accetta fino a {most:g} m",
    ),
    "unstable_under_loads": (
        "unstable under its own loads: it would turn without any earthquake (at {threshold:.3f} g); check sizes, "
        "distances and heights of the loads, and whether all that really holds the wall is given",
        "instabile sotto i propri carichi: si ribalterebbe senza alcun sisma (a {threshold:.3f} g); controllare "
        "entità, distanze e quote dei carichi, e che sia indicato tutto ciò che trattiene davvero la parete",
    ),
    "collapse_too_far": (
        "with its loads the wall would stand up to a rotation of {found:.0f} degrees, more than the {most:.0f} a rigid "
        "block is taken for here: reduce the loads that hold it",
        "con i suoi carichi la parete resisterebbe fino a una rotazione di {found:.0f} gradi, più dei {most:.0f} "
        "ammessi qui per un blocco rigido: ridurre i carichi che la trattengono",
    ),
    "moving_mass_off_centre": (
        "a mass that moves with a two-sided wall must be at half its thickness: as a lower bound give the wall "
        "twice the distance of the mass from the nearer face as its thickness; the one-sided mechanism would assume "
        "a restraint behind and gives more than the wall has",
        "una massa che si muove con una parete su due lati deve stare a metà spessore: come limite inferiore dare "
        "alla parete uno spessore doppio della distanza della massa dalla faccia più vicina; il meccanismo su un "
        "lato supporrebbe un vincolo posteriore e darebbe più di quanto la parete ha",
    ),
    "two_sided_loads_rigid": (
        "a two-sided wall whose loads differ for its two sides takes the rigid law: give {key} rigid, which may "
        "overturn later than a trilinear law, or loads alike for both sides, no more than the weaker side has; the "
        "one-sided mechanism would assume a restraint behind and gives more than the wall has",
        "una parete su due lati con carichi diversi per i due lati richiede la legge rigida: indicare {key} rigid, "
        "che può ribaltare più tardi di una legge trilineare, oppure carichi uguali per i due lati, non maggiori di "
        "quelli del lato più debole; il meccanismo su un lato supporrebbe un vincolo posteriore e darebbe più di "
        "quanto la parete ha",
    ),
    "return_walls_need_length": (
        "the friction of return walls is shared out over the wall: give {key}",
        "l'attrito dei muri ortogonali si ripartisce sulla parete: indicare {key}",
    ),
    "return_walls_too_many": (
        "return walls of {found:g} m in all are more than the {length:g} m of the wall: check their number and "
        "thickness",
        "i muri ortogonali, {found:g} m in tutto, superano i {length:g} m della parete: controllarne numero e spessore",
    ),
    "holds_one_side": (
        "{key} holds a wall that turns outward only: leave it out; the one-sided mechanism is for a wall that "
        "something behind it stops ({back_restraint})",
        "{key} trattiene solo una parete che ruota verso l'esterno: toglierlo; il meccanismo su un lato è per una "
        "parete che qualcosa dietro di essa arresta ({back_restraint})",
    ),
    "tie_too_strong": (
        "with ties or other inward forces of {found:g} kN/m the wall opens a hinge at {hinge:.2f} m before it turns "
        "about its base, so that it is no one rigid block: accepted is up to {most:.3g} kN/m at these heights",
        "con catene o altre forze verso l'interno da {found:g} kN/m la parete apre una cerniera a {hinge:.2f} m prima "
        "di ruotare alla base, e non è più un solo blocco rigido: si accettano fino a {most:.3g} kN/m a queste quote",
    ),
}
"""Loads a wall cannot have or carry: code -> (English, Italian)."""
