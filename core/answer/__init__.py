"""What a run says of each wall, chosen once: every face reads it."""
