"""What a docx that this program wrote is of: what a process of its own reads, which imports nothing of the note."""

import io

from core.version import NAME


def subject_in(content: bytes) -> str | None:
    """What a docx is of that this program wrote; None of one that another program wrote or saved again. Raises what
    python-docx raises of what is none."""
    import docx

    about = docx.Document(io.BytesIO(content)).core_properties
    return about.subject if about.last_modified_by == NAME else None
