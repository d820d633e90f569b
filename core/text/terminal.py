"""What a terminal shows."""

TERMINAL = {
    "the calculation note too, as a Word document (.docx)": "anche la relazione, come documento Word (.docx)",
    "--report goes with --batch": "--report va con --batch",
    "minimum": "minimo",
    "too_few": "minimo, troppo pochi",
    "incomplete": "incompleto",
    "refused: {error}": "rifiutato: {error}",
    (
        "{path}: {format}, {samples} samples every {step:g} s, unit {unit}, PGA {pga:.4f} g, PGV {pgv:.2f} cm/s, "
        "SI {si:.2f} cm, 5-95 % {duration:.2f} s"
    ): (
        "{path}: {format}, {samples} campioni ogni {step:g} s, unità {unit}, PGA {pga:.4f} g, PGV {pgv:.2f} "
        "cm/s, SI {si:.2f} cm, 5-95 % {duration:.2f} s"
    ),
    (
        "{path}: {format}, {samples} samples every {step:g} s, peak {peak:.5g}; the unit is not stated: give it "
        "in the case"
    ): (
        "{path}: {format}, {samples} campioni ogni {step:g} s, picco {peak:.5g}; l'unità non è indicata: darla nel caso"
    ),
    "finished runs of an earlier start are in {path}: to go on with them, rename it and add --resume": (
        "le analisi finite di un avvio precedente sono in {path}: per proseguirle, rinominarlo e aggiungere --resume"
    ),
    "the solver is being compiled, once for each version: it takes some seconds": (
        "il risolutore viene compilato, una volta per versione: servono alcuni secondi"
    ),
    "{n} damaged line(s) of the journal were dropped: these runs are made again": (
        "{n} righe danneggiate del registro scartate: queste analisi si rifanno"
    ),
    "cancelled: finished runs are in {path}; go on with --resume": (
        "annullato: le analisi finite sono in {path}; proseguire con --resume"
    ),
    "no number: {wall}, {record} ({sign}): {status}": "nessun valore: {wall}, {record} ({sign}): {status}",
    "wall": "parete",
    "mechanism": "meccanismo",
    "rule": "regola",
    "q": "q",
    "robust": "robusto",
    "zeta": "zeta",
    "verdict": "esito",
    "by": "verifica",
    "{runs} runs, {analyses} analyses in {seconds:.1f} s": ("{runs} serie, {analyses} analisi in {seconds:.1f} s"),
    "workbook, JSON and CSV are written: {path}": "cartella di lavoro, JSON e CSV sono scritti: {path}",
    "{done}/{planned} runs and checks": "{done}/{planned} serie e verifiche",
    "{done}/{planned} runs and checks, about {left:.0f} s left": (
        "{done}/{planned} serie e verifiche, restano circa {left:.0f} s"
    ),
    "writing the results: {share:.0f} %": "scrittura dei risultati: {share:.0f} %",
    "How strong an earthquake a masonry wall withstands before it overturns.": (
        "Quanto forte è il terremoto che una parete in muratura sopporta prima di ribaltarsi."
    ),
    "case file to open in the window": "caso da aprire nella finestra",
    "run a case without a window": "calcolare un caso senza finestra",
    "folder of the results": "cartella dei risultati",
    "threads (default: all cores)": "thread (predefinito: tutti i processori)",
    "no progress, no summary": "senza avanzamento né riepilogo",
    "go on from the journal": "proseguire dal registro",
    "summarise the contents of records": "riassumere il contenuto degli accelerogrammi",
    "version and commit": "versione e commit",
    "{word!r} is not a number of threads from 1 to 1024": "{word!r} non è un numero di thread da 1 a 1024",
    "--batch, --study and --inspect do not go together": "--batch, --study e --inspect non vanno insieme",
    "--output, --jobs and --resume go with --batch or --study": (
        "--output, --jobs e --resume vanno con --batch o --study"
    ),
    "--quick and --records go with --study": "--quick e --records vanno con --study",
    "run a parametric study: paper, law or a file": "esegue uno studio parametrico: paper, law o un file",
    "and {n} more, in the CSV": "e altre {n}, nel CSV",
    "a short form of the study": "una forma breve dello studio",
    "natural records of the study": "accelerogrammi naturali dello studio",
    "q: acceleration of the motion that first overturns the wall, over that which lifts it": (
        "q: accelerazione del moto che per prima ribalta la parete, rispetto a quella che la solleva"
    ),
    "robust: the q around which 16 % of the motions overturn it": (
        "robusto: il q attorno al quale il 16 % dei moti la ribalta"
    ),
    "zeta: share of the demand at which the wall begins to fail; 1 is what the code asks": (
        "zeta: quota della domanda a cui la parete comincia a non resistere; la norma chiede 1"
    ),
    "verdict: that of the most refined check that could be made; the last column names it": (
        "esito: quello della verifica più raffinata fra quelle possibili; l'ultima colonna la nomina"
    ),
    "open {path}: its first sheet sums up the walls": "aprire {path}: il primo foglio riassume le pareti",
    "error: {error}": "errore: {error}",
    "stopped": "interrotto",
    "internal error: no file was left half written; please send {path}": (
        "errore interno: nessun file è rimasto scritto a metà; inviare {path}"
    ),
    "; did you mean {nearest}?": "; si intendeva {nearest}?",
    "usage: ": "uso: ",
    "arguments": "argomenti",
    "this help": "questo aiuto",
    "not known here: {words}": "sconosciuto qui: {words}",
    "{words} takes a value": "{words} richiede un valore",
    "{words} takes no value": "{words} non ammette un valore",
    "{words} may mean several options: write it out": "{words} può indicare più opzioni: scriverla per intero",
}
"""English -> Italian."""
