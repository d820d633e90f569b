"""What is known before the first analysis: demand, records, floors, walls about their hinges."""
