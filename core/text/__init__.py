"""Every text a person reads, in English and Italian: the wording by group and code, and the sentence as data."""
