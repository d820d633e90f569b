"""Eq. 1, the equation of motion: the exact method, its analyses in lanes, and the methods kept for comparison."""
