"""Errors of files of several channels, of archives and of the dialects of the world's networks."""

CHANNEL_ERRORS = {
    "which_channel": ("{n} channels here, give {key}: {channels}", "{n} canali qui, indicare {key}: {channels}"),
    "no_such_channel": ("no channel {given} here: {channels}", "nessun canale {given} qui: {channels}"),
    "one_channel": (
        "this {format} file has one channel, not {given}: leave {channel} out",
        "questo file {format} ha un solo canale, non {given}: togliere {channel}",
    ),
    "too_many_channels": (
        "{n} channels or members are too many, up to {most}: unpack what is needed",
        "{n} canali o file sono troppi, fino a {most}: estrarre quelli che servono",
    ),
    "head_lacks": (
        "the head does not give {label} as this format does: download the file again",
        "l'intestazione non dà {label} come vuole questo formato: scaricare di nuovo il file",
    ),
    "not_one_number": ("{label} is {text}, not one number", "{label} è {text}, non un numero"),
    "not_whole": (
        "{n} samples, not as many as the head declares: the file is cut or something was added",
        "{n} campioni, non quanti ne dichiara l'intestazione: il file è troncato o vi è stato aggiunto qualcosa",
    ),
    "rows_differ": (
        "{n} lines of samples of the {declared} that the head declares: the file is cut or something was added",
        "{n} righe di campioni delle {declared} dichiarate nell'intestazione: il file è troncato o vi è stato "
        "aggiunto qualcosa",
    ),
    "columns_not": (
        "lines of {n} numbers are expected: the file is damaged",
        "servono righe di {n} numeri: il file è danneggiato",
    ),
    "counts_not_whole": (
        "the samples are no whole counts: this file was changed",
        "i campioni non sono conteggi interi: questo file è stato modificato",
    ),
    "peak_contradicts": (
        "the samples have a peak of {read:.4g}, the head states {stated:.4g}: unit or scale is wrong",
        "i campioni hanno un picco di {read:.4g}, l'intestazione dichiara {stated:.4g}: unità o scala sbagliata",
    ),
    "uneven_pairs": (
        "the times of the pairs do not grow by up to 0.1 s to the duration that the head states",
        "i tempi delle coppie non crescono di al più 0,1 s fino alla durata dichiarata nell'intestazione",
    ),
    "bad_archive": (
        "this archive or workbook cannot be opened ({reason}): download it again, or unpack it",
        "questo archivio o cartella di lavoro non si apre ({reason}): scaricarlo di nuovo, o estrarne i file",
    ),
    "nested_archive": (
        "an archive within an archive: unpack the outer one",
        "un archivio dentro un archivio: estrarre quello esterno",
    ),
    "no_member": (
        "no accelerogram in this archive or workbook",
        "nessun accelerogramma in questo archivio o cartella di lavoro",
    ),
    "line_too_long": (
        "a line of {n} characters: samples stand one or a few in a line",
        "una riga di {n} caratteri: i campioni stanno uno o pochi per riga",
    ),
    "unpacked_too_large": (
        "unpacked it has {mb:.0f} MB, beyond 20 MB: no accelerogram",
        "estratto ha {mb:.0f} MB, oltre 20 MB: non è un accelerogramma",
    ),
}
"""Code -> (English, Italian)."""
