"""Cases whose answer is known from elsewhere, and what the program finds (NTC 2018, 10.2)."""
