"""A StudyResult as JSON and as a workbook. No computation."""
