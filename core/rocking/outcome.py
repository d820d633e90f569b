"""Outcome of one analysis as a code for the kernels, each with its word."""

STABLE = 0
COLLAPSED = 1
IMPACT_LIMIT = 2

WORDS = ("stable", "collapsed", "impact_limit")
