"""Methods kept for comparison, each in its file with what it costs and where it fails."""
