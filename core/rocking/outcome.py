"""Outcome of one analysis as a code for the kernels, each with its word."""

STABLE = 0
COLLAPSED = 1
IMPACT_LIMIT = 2
BAD_INPUT = 3

OUTCOME_WORDS = ("stable", "collapsed", "impact_limit", "bad_input")

MAX_GROUND = 1e6
"""Largest ground acceleration integrated [m/s2]; beyond it, and where it is no number, an analysis ends before it
begins, with BAD_INPUT."""
