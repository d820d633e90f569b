"""What is derived, described once: every quantity a function, read from top to bottom like a calculation by hand."""
