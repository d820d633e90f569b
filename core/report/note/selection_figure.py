"""The figure of the chosen records: their spectra and their mean over the target and the bounds of its code."""

import numpy as np

from core.report.note.parts import Curve, Figure
from core.report.note.words import Words
from core.study.results import StudyResult
from core.units import G


def spectra(result: StudyResult, words: Words) -> Figure | None:
    """5 % spectra of what [select] chose, over its periods; None of a study without."""
    rules, found = result.compliance, result.selection
    if found is None or rules is None:
        return None
    times, target = rules.periods, rules.target / G
    curves = [Curve("", times, spectrum / G, "quiet", width=0.6) for spectrum in rules.spectra]
    low, high, _ = found.bounds
    inside = (times >= rules.period_range[0] - 1e-9) & (times <= rules.period_range[1] + 1e-9)
    for bound in (low, high):
        if np.isfinite(bound):
            curves.append(Curve("", times[inside], bound * target[inside], "bad", "dash", 0.9))
    curves.append(Curve(words.say("target"), times, target, "bad", width=1.4))
    curves.append(Curve(words.say("mean"), times, rules.mean / G, "accent", width=1.8))
    caption = words.say("5 % spectra of the chosen records, their mean and the bounds of the code")
    top = 1.05 * max(float(rules.mean.max()), 1.4 * float(rules.target.max())) / G
    return Figure(caption, curves, "T [s]", "S_a [g]", (0.0, float(times[-1])), (0.0, top))
