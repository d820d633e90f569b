"""Outcome of one analysis as a code for the kernels, each with its word and its sentence."""

STABLE = 0
COLLAPSED = 1
IMPACT_LIMIT = 2

WORDS = ("stable", "collapsed", "impact_limit")
SENTENCES = (
    "The block survives the record and comes back by energy.",
    "The block overturns during the record, or its energy at the end carries it over.",
    "More than 10 000 impacts within one sample: the outcome is unknown.",
)
