"""Studies, solved cases and tests against experiments: they use the program, and nothing of it but app imports them."""
