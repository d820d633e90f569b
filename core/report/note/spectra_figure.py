"""The figure of the records: their spectra and their mean over the target and the bounds of its code."""

import numpy as np

from core.codes.record_compatibility import LOWER_BOUND, UPPER
from core.report.note.parts import Curve, Figure
from core.report.words import Words
from core.study.results import StudyResult
from core.units import G


def bounds_of(result: StudyResult) -> tuple[float, float]:
    """Least and largest mean over the target that the code allows: of [select] as it was asked, else those of
    NTC 2018 3.2.3.6."""
    if result.selection is not None:
        return result.selection.bounds[0], result.selection.bounds[1]
    upper = UPPER["natural"]
    return 1.0 + max(LOWER_BOUND[kind] for kind in result.kinds), 1.0 + upper if "natural" in result.kinds else np.inf


def spectra(result: StudyResult, words: Words) -> Figure | None:
    """5 % spectra of the records at the demand, over the periods of the rules; None without a target."""
    rules = result.compliance
    if rules is None:
        return None
    times, target = rules.periods, rules.target / G
    curves = [Curve("", times, spectrum / G, "quiet", width=0.6) for spectrum in rules.spectra]
    low, high = bounds_of(result)
    inside = (times >= rules.period_range[0] - 1e-9) & (times <= rules.period_range[1] + 1e-9)
    for bound in (low, high):
        if np.isfinite(bound):
            curves.append(Curve("", times[inside], bound * target[inside], "bad", "dash", 0.9))
    curves.append(Curve(words.say("target"), times, target, "bad", width=1.4))
    curves.append(Curve(words.say("mean"), times, rules.mean / G, "accent", width=1.8))
    caption = words.say("5 % spectra of the records at the demand, their mean and the bounds of the code")
    top = 1.05 * max(float(rules.mean.max()), 1.4 * float(rules.target.max())) / G
    return Figure(caption, curves, "T [s]", "S_a [g]", (0.0, float(times[-1])), (0.0, top))
