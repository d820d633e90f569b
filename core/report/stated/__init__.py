"""The results of a study described once: each quantity with its key, unit, meaning and how it is read."""
