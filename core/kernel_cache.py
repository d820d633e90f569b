"""The decorator of every compiled kernel, and where its machine code is kept."""

from numba import njit

kernel = njit(cache=True, nogil=True, error_model="numpy")
"""Compiled once per machine; no lock held while it runs; never fastmath, never parallel."""
