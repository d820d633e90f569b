"""Setting of a study, known before its first analysis: demand, records, floors, walls about their hinges."""
