"""What run.py says before anything is installed, and what an installation lacks. Read by any Python from 3.6 on."""

import locale
import os

CODES = ("en", "it")


def system_language():
    """The system's language where it is one of ours, else English."""
    named = next(filter(None, map(os.environ.get, ("LC_ALL", "LC_MESSAGES", "LANG"))), None)
    code = (named or locale.getlocale()[0] or "")[:2].lower()
    return code if code in CODES else "en"


START = {
    "Python {first} to {last}": "Python da {first} a {last}",
    "Ribalta does not run with {kind}: take {pythons} (python.org)": (
        "Ribalta non funziona con {kind}: usare {pythons} (python.org)"
    ),
    "{asked} cannot be installed here ({place}): {package} has no wheel for it; take {instead}": (
        "{asked} non si può installare qui ({place}): manca il pacchetto compilato di {package}; usare {instead}"
    ),
    "the window": "la finestra",
    "the benchmark of peers": "il confronto con altri programmi",
    "; a case runs without a window: --batch CASE": "; senza finestra un caso si calcola: --batch CASO",
    "unknown word {word}": "parola sconosciuta {word}",
    "unknown word {word}: did you mean {nearest}?": "parola sconosciuta {word}: si intendeva {nearest}?",
    "the environment cannot be made in {folder}: {reason}; name a folder you can write in the variable RIBALTA_ENV": (
        "l'ambiente non si può creare in {folder}: {reason}; indicare una cartella scrivibile nella variabile "
        "RIBALTA_ENV"
    ),
    "another start is preparing the environment: waiting for it": (
        "un altro avvio sta preparando l'ambiente: si attende che finisca"
    ),
    "{failure}; started with the packages of an earlier version instead": (
        "{failure}; avviato con i pacchetti di una versione precedente"
    ),
    (
        "the environment cannot be written in {folder}: {reason}; free some space, end the programs that run from it, "
        "or name another folder in the variable RIBALTA_ENV"
    ): (
        "l'ambiente non si può scrivere in {folder}: {reason}; liberare spazio, chiudere i programmi che lo usano, o "
        "indicare un'altra cartella nella variabile RIBALTA_ENV"
    ),
    (
        "{folder} was not made by run.py and stays as it is: move it away, or name another folder, empty or new, in "
        "the variable RIBALTA_ENV"
    ): (
        "{folder} non è stata creata da run.py e resta com'è: spostarla, o indicare un'altra cartella, vuota o nuova, "
        "nella variabile RIBALTA_ENV"
    ),
    (
        "this Python lacks the module {module}: install it (Debian and Ubuntu: apt install python3-venv) or start "
        "with a Python from python.org"
    ): (
        "a questo Python manca il modulo {module}: installarlo (Debian e Ubuntu: apt install python3-venv) o avviare "
        "con un Python di python.org"
    ),
    "making the environment in {folder} (once)": "si crea l'ambiente in {folder} (una volta)",
    "the environment could not be made": "l'ambiente non si è potuto creare",
    (
        "installing {groups}: {fetch:.0f} MB to fetch, {disk:.0f} MB on the disk, about {minutes:.0f} minutes at 10 "
        "Mbit/s (once)"
    ): (
        "si installa {groups}: {fetch:.0f} MB da scaricare, {disk:.0f} MB su disco, circa {minutes:.0f} minuti a 10 "
        "Mbit/s (una volta)"
    ),
    "{n} of {total} packages: {package}": "{n} pacchetti di {total}: {package}",
    "unpacking": "si estraggono i pacchetti",
    "the installation failed: check the network or the proxy settings of pip": (
        "l'installazione non è riuscita: controllare la rete o il proxy di pip"
    ),
    "the installation was refused: a package served is not the one requirements.lock names": (
        "installazione rifiutata: un pacchetto ricevuto non è quello indicato da requirements.lock"
    ),
    "{trouble} ({cause}); the whole output is in {log}": ("{trouble} ({cause}); tutto il dettaglio è in {log}"),
    "no word": "nessun messaggio",
}
"""English -> Italian."""

WAYS = {
    "work_report": ("the calculation note", "la relazione"),
    "work_study": ("a parametric study", "uno studio parametrico"),
    "work_accuracy": ("the statement of accuracy", "la valutazione dell'accuratezza"),
    "way_sources": (
        "start the program with python3 run.py, which installs what is missing",
        "avviare il programma con python3 run.py, che installa ciò che manca",
    ),
    "way_frozen": ("install the program again", "installare di nuovo il programma"),
    "way_wheel": (
        "install what is missing into the environment of the program (pipx inject ribalta {packages})",
        "installare ciò che manca nell'ambiente del programma (pipx inject ribalta {packages})",
    ),
}
"""Words of what an installation lacks: code -> (English, Italian)."""


def phrase(text, **values):
    """A text of `START` in the language of the system."""
    return (START[text] if system_language() == "it" else text).format(**values)
