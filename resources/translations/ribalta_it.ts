<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it_IT">
<context>
    <name />
    <message>
        <source>q robust</source>
        <translation>q robusto</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Histories</source>
        <translation>Storie temporali</translation>
    </message>
    <message>
        <source>Capacity</source>
        <translation>Capacità</translation>
    </message>
    <message>
        <source>q against SI</source>
        <translation>q e SI</translation>
    </message>
    <message>
        <source>Spectra</source>
        <translation>Spettri</translation>
    </message>
    <message>
        <source>Validation</source>
        <translation>Validazione</translation>
    </message>
    <message>
        <source>Wall shown</source>
        <translation>Parete mostrata</translation>
    </message>
    <message>
        <source>Run (F5)</source>
        <translation>Esegui (F5)</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Pareti</translation>
    </message>
    <message>
        <source>Demand</source>
        <translation>Domanda</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relazione</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Dati</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Accelerogrammi</translation>
    </message>
    <message>
        <source>No result yet: press F5.</source>
        <translation>Nessun risultato: premere F5.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Esito</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;File</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuovo</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Apri…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Apri &amp;recenti</translation>
    </message>
    <message>
        <source>Open the &amp;example</source>
        <translation>Apri l'&amp;esempio</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salva &amp;con nome…</translation>
    </message>
    <message>
        <source>&amp;Export workbook…</source>
        <translation>&amp;Esporta cartella di lavoro…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Esci</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifica</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ripeti</translation>
    </message>
    <message>
        <source>&amp;Paste walls</source>
        <translation>&amp;Incolla pareti</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;segui</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Interrompi</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>light</source>
        <translation>chiaro</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>scuro</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Lingua</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;Informazioni</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Interrompi</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>senza nome</translation>
    </message>
    <message>
        <source>A field holds what is not accepted: see the words below it.</source>
        <translation>Un campo contiene un valore non accettato: vedere le parole sotto di esso.</translation>
    </message>
    <message>
        <source>The input has changed: press F5.</source>
        <translation>I dati sono cambiati: premere F5.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Interrotto.</translation>
    </message>
    <message>
        <source>Running…</source>
        <translation>In esecuzione…</translation>
    </message>
    <message>
        <source>{done} of {planned}, {elapsed:.0f} s, about {left:.0f} s left</source>
        <translation>{done} di {planned}, {elapsed:.0f} s, restano circa {left:.0f} s</translation>
    </message>
    <message>
        <source>Details are in {log}</source>
        <translation>I dettagli sono in {log}</translation>
    </message>
    <message>
        <source>Not done.</source>
        <translation>Non eseguito.</translation>
    </message>
    <message>
        <source>Not done</source>
        <translation>Non eseguito</translation>
    </message>
    <message>
        <source>one-sided</source>
        <translation>su un lato</translation>
    </message>
    <message>
        <source>two-sided</source>
        <translation>su due lati</translation>
    </message>
    <message>
        <source>{n} analyses in {seconds:.1f} s</source>
        <translation>{n} analisi in {seconds:.1f} s</translation>
    </message>
    <message>
        <source>Not opened</source>
        <translation>Non aperto</translation>
    </message>
    <message>
        <source>Open a case</source>
        <translation>Apri un caso</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Casi</translation>
    </message>
    <message>
        <source>Save the case</source>
        <translation>Salva il caso</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Non salvato</translation>
    </message>
    <message>
        <source>Export the workbook</source>
        <translation>Esporta la cartella di lavoro</translation>
    </message>
    <message>
        <source>The results are not of this input: run it first (F5).</source>
        <translation>I risultati non sono di questi dati: eseguire prima (F5).</translation>
    </message>
    <message>
        <source>{path} is there already. Overwrite it?</source>
        <translation>{path} esiste già. Sovrascrivere?</translation>
    </message>
    <message>
        <source>Nothing exported</source>
        <translation>Nulla esportato</translation>
    </message>
    <message>
        <source>Written: {path}</source>
        <translation>Scritto: {path}</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifiche non salvate</translation>
    </message>
    <message>
        <source>Save the changes of this case?</source>
        <translation>Salvare le modifiche di questo caso?</translation>
    </message>
    <message>
        <source>{name} {version}
Out-of-plane overturning of masonry walls (Coccia, Di Carlo, Imperatore 2016; Circolare 7/2019 C8.7.1.2.1). The results are the engineer's responsibility.</source>
        <translation>{name} {version}
Ribaltamento fuori piano di pareti in muratura (Coccia, Di Carlo, Imperatore 2016; Circolare 7/2019 C8.7.1.2.1). I risultati sono responsabilità del progettista.</translation>
    </message>
    <message>
        <source>Autosaved case found</source>
        <translation>Trovato un caso salvato automaticamente</translation>
    </message>
    <message>
        <source>The program ended without saving. Bring back the unsaved case?</source>
        <translation>Il programma si è chiuso senza salvare. Recuperare il caso non salvato?</translation>
    </message>
    <message>
        <source>Preparing the solver…</source>
        <translation>Preparazione del solutore…</translation>
    </message>
    <message>
        <source>Ready.</source>
        <translation>Pronto.</translation>
    </message>
    <message>
        <source>Check against a demand</source>
        <translation>Verifica rispetto a una domanda</translation>
    </message>
    <message>
        <source>Limit state</source>
        <translation>Stato limite</translation>
    </message>
    <message>
        <source>On rigid ground (su suolo rigido); S apart</source>
        <translation>Su suolo rigido; S a parte</translation>
    </message>
    <message>
        <source>a_g on rigid ground, S apart</source>
        <translation>a_g su suolo rigido, S a parte</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spettro</translation>
    </message>
    <message>
        <source>no spectrum, S given</source>
        <translation>nessuno spettro, S assegnato</translation>
    </message>
    <message>
        <source>spectrum of a file</source>
        <translation>spettro da file</translation>
    </message>
    <message>
        <source>Intensity SI</source>
        <translation>Intensità SI</translation>
    </message>
    <message>
        <source>Soil</source>
        <translation>Suolo</translation>
    </message>
    <message>
        <source>Topography</source>
        <translation>Topografia</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Scegli file…</translation>
    </message>
    <message>
        <source>1.35 where the compressive strength is not in α; lower with a hinge setback</source>
        <translation>1.35 se la resistenza a compressione non entra in α; minore con cerniera arretrata</translation>
    </message>
    <message>
        <source>Records at the demand</source>
        <translation>Record alla domanda</translation>
    </message>
    <message>
        <source>as given</source>
        <translation>come dati</translation>
    </message>
    <message>
        <source>scaled to PGA = a_g S</source>
        <translation>scalati a PGA = a_g S</translation>
    </message>
    <message>
        <source>ζ required</source>
        <translation>ζ richiesto</translation>
    </message>
    <message>
        <source>q of the code</source>
        <translation>q di norma</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Sito</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordinate</translation>
    </message>
    <message>
        <source>years</source>
        <translation>anni</translation>
    </message>
    <message>
        <source>Spectrum: two columns, s and g</source>
        <translation>Spettro: due colonne, s e g</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>Step of the search</source>
        <translation>Passo della ricerca</translation>
    </message>
    <message>
        <source>Largest q</source>
        <translation>q massimo</translation>
    </message>
    <message>
        <source>Map up to times q</source>
        <translation>Mappa fino a volte q</translation>
    </message>
    <message>
        <source>Robust window</source>
        <translation>Finestra robusta</translation>
    </message>
    <message>
        <source>Sign of the records</source>
        <translation>Segno dei record</translation>
    </message>
    <message>
        <source>both</source>
        <translation>entrambi</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>come registrato</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>invertito</translation>
    </message>
    <message>
        <source>State the accuracy</source>
        <translation>Dichiara l'accuratezza</translation>
    </message>
    <message>
        <source>Seconds a wall: error of the solver and spread of q in the report</source>
        <translation>Secondi per parete: errore del solutore e dispersione di q nella relazione</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Committente</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Luogo</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Progetto</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autore</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>Revisione</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Report in</source>
        <translation>Relazione in</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titolo</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analisi</translation>
    </message>
    <message>
        <source>from {low} to {high} {unit}</source>
        <translation>da {low} a {high} {unit}</translation>
    </message>
    <message>
        <source>a number is needed here</source>
        <translation>qui serve un numero</translation>
    </message>
    <message>
        <source>{text}: not a number</source>
        <translation>{text}: non è un numero</translation>
    </message>
    <message>
        <source>Records found</source>
        <translation>Accelerogrammi trovati</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Anteprima</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>come dice il file</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>naturale</translation>
    </message>
    <message>
        <source>artificial</source>
        <translation>artificiale</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulato</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Choices apply to the files selected; those not readable are left out.</source>
        <translation>Le scelte valgono per i file selezionati; quelli non leggibili sono esclusi.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usa</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Record</translation>
    </message>
    <message>
        <source>D5-95 [s]</source>
        <translation>D5-95 [s]</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Segno</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Drop accelerograms or folders here.</source>
        <translation>Trascinare qui accelerogrammi o cartelle.</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Aggiungi…</translation>
    </message>
    <message>
        <source>Add accelerograms</source>
        <translation>Aggiungi accelerogrammi</translation>
    </message>
    <message>
        <source>Generate…</source>
        <translation>Genera…</translation>
    </message>
    <message>
        <source>Seven motions compatible with the spectrum</source>
        <translation>Sette moti compatibili con lo spettro</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inverti</translation>
    </message>
    <message>
        <source>Change the sign of the selected records</source>
        <translation>Cambia il segno dei record selezionati</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Togli</translation>
    </message>
    <message>
        <source>Remove the selected records</source>
        <translation>Togli i record selezionati</translation>
    </message>
    <message>
        <source>{n} records in use. Drop accelerograms or folders here.</source>
        <translation>{n} record in uso. Trascinare qui accelerogrammi o cartelle.</translation>
    </message>
    <message>
        <source>Choose a spectrum on the sheet Demand first.</source>
        <translation>Scegliere prima uno spettro nella scheda Domanda.</translation>
    </message>
    <message>
        <source>default of the mechanism</source>
        <translation>predefinito del meccanismo</translation>
    </message>
    <message>
        <source>Sorrentino, experimental (Eq. 5)</source>
        <translation>Sorrentino, sperimentale (Eq. 5)</translation>
    </message>
    <message>
        <source>Costa, upper bound</source>
        <translation>Costa, limite superiore</translation>
    </message>
    <message>
        <source>one-sided, theoretical (Eq. 6)</source>
        <translation>un lato, teorico (Eq. 6)</translation>
    </message>
    <message>
        <source>one-sided, experimental (Eq. 7)</source>
        <translation>un lato, sperimentale (Eq. 7)</translation>
    </message>
    <message>
        <source>given velocity ratio</source>
        <translation>rapporto di velocità dato</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Height H</source>
        <translation>Altezza H</translation>
    </message>
    <message>
        <source>Thickness t</source>
        <translation>Spessore t</translation>
    </message>
    <message>
        <source>Slenderness α</source>
        <translation>Snellezza α</translation>
    </message>
    <message>
        <source>arctan(t/H): larger is stockier</source>
        <translation>arctan(t/H): maggiore è più tozza</translation>
    </message>
    <message>
        <source>Radius R</source>
        <translation>Raggio R</translation>
    </message>
    <message>
        <source>Hinge setback u</source>
        <translation>Arretramento u</translation>
    </message>
    <message>
        <source>The wall turns about a hinge inside its edge: tan α = (t − 2u)/H</source>
        <translation>La parete ruota attorno a una cerniera arretrata dal bordo: tan α = (t − 2u)/H</translation>
    </message>
    <message>
        <source>Strength f</source>
        <translation>Resistenza f</translation>
    </message>
    <message>
        <source>Gives the setback u = 2 W / (3 f L); takes the unit weight and no u</source>
        <translation>Dà l'arretramento u = 2 W / (3 f L); richiede il peso specifico e nessun u</translation>
    </message>
    <message>
        <source>Unit weight</source>
        <translation>Peso specifico</translation>
    </message>
    <message>
        <source>Length L</source>
        <translation>Lunghezza L</translation>
    </message>
    <message>
        <source>Base above ground z</source>
        <translation>Base sopra il suolo z</translation>
    </message>
    <message>
        <source>Above the ground the motion of the floor is needed: no check is made</source>
        <translation>Sopra il suolo serve il moto del piano: nessuna verifica</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Piano</translation>
    </message>
    <message>
        <source>Restraint behind</source>
        <translation>Vincolo posteriore</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>No load from floors or roof</source>
        <translation>Nessun carico da solai o tetto</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>Velocity ratio e</source>
        <translation>Rapporto di velocità e</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>rigida</translation>
    </message>
    <message>
        <source>own D1, D2</source>
        <translation>D1, D2 propri</translation>
    </message>
    <message>
        <source>Moment-rotation law</source>
        <translation>Legge momento-rotazione</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Nuova</translation>
    </message>
    <message>
        <source>Add a wall</source>
        <translation>Aggiungi una parete</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplica</translation>
    </message>
    <message>
        <source>Copy this wall</source>
        <translation>Copia questa parete</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Delete this wall</source>
        <translation>Elimina questa parete</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Incolla</translation>
    </message>
    <message>
        <source>Paste rows copied from Excel</source>
        <translation>Incolla righe copiate da Excel</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabella…</translation>
    </message>
    <message>
        <source>Read walls from .xlsx or .csv</source>
        <translation>Leggi pareti da .xlsx o .csv</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometria</translation>
    </message>
    <message>
        <source>Geometry given by</source>
        <translation>Geometria data da</translation>
    </message>
    <message>
        <source>height and thickness</source>
        <translation>altezza e spessore</translation>
    </message>
    <message>
        <source>height and slenderness</source>
        <translation>altezza e snellezza</translation>
    </message>
    <message>
        <source>height and H/t</source>
        <translation>altezza e H/t</translation>
    </message>
    <message>
        <source>general block</source>
        <translation>blocco generico</translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation>Meccanismo</translation>
    </message>
    <message>
        <source>Free on both faces: rocks to both sides</source>
        <translation>Libera sulle due facce: oscilla sui due lati</translation>
    </message>
    <message>
        <source>A restraint behind: rocks outwards only</source>
        <translation>Vincolo posteriore: oscilla solo verso l'esterno</translation>
    </message>
    <message>
        <source>Two results: with the restraint behind and without</source>
        <translation>Due risultati: con il vincolo posteriore e senza</translation>
    </message>
    <message>
        <source>Restitution and law</source>
        <translation>Restituzione e legge</translation>
    </message>
    <message>
        <source>For checks and report</source>
        <translation>Per verifiche e relazione</translation>
    </message>
    <message>
        <source>No wall yet: press Add.</source>
        <translation>Nessuna parete: premere Nuova.</translation>
    </message>
    <message>
        <source>Choose a mechanism.</source>
        <translation>Scegliere un meccanismo.</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>parete</translation>
    </message>
    <message>
        <source>Read walls</source>
        <translation>Leggi pareti</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Walls not read</source>
        <translation>Pareti non lette</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Tutto</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Mostra tutto</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>Copia l'immagine</translation>
    </message>
    <message>
        <source>Save as PNG</source>
        <translation>Salva come PNG</translation>
    </message>
    <message>
        <source>Save as SVG</source>
        <translation>Salva come SVG</translation>
    </message>
    <message>
        <source>Save the data as CSV</source>
        <translation>Salva i dati come CSV</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Salva il grafico</translation>
    </message>
    <message>
        <source>Multiplier of the record</source>
        <translation>Moltiplicatore del record</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Anima</translation>
    </message>
    <message>
        <source>Ground motion</source>
        <translation>Moto del suolo</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>suolo</translation>
    </message>
    <message>
        <source>impacts</source>
        <translation>urti</translation>
    </message>
    <message>
        <source>overturns</source>
        <translation>ribalta</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>resiste</translation>
    </message>
    <message>
        <source>State the accuracy for this wall (some seconds)</source>
        <translation>Dichiara l'accuratezza per questa parete (alcuni secondi)</translation>
    </message>
    <message>
        <source>Error of the solver and spread of q by definition, for this wall and its governing record.</source>
        <translation>Errore del solutore e dispersione di q per definizione, per questa parete e il suo record governante.</translation>
    </message>
    <message>
        <source>time per history [ms]</source>
        <translation>tempo per storia [ms]</translation>
    </message>
    <message>
        <source>error / α [-]</source>
        <translation>errore / α [-]</translation>
    </message>
    <message>
        <source>Accuracy against speed</source>
        <translation>Accuratezza e velocità</translation>
    </message>
    <message>
        <source>Phase portrait</source>
        <translation>Piano delle fasi</translation>
    </message>
    <message>
        <source>Moment against rotation</source>
        <translation>Momento e rotazione</translation>
    </message>
    <message>
        <source>law</source>
        <translation>legge</translation>
    </message>
    <message>
        <source>survives</source>
        <translation>resiste</translation>
    </message>
    <message>
        <source>Solver ({method}): error of q {q}, of the history {history} α ({record}).</source>
        <translation>Solutore ({method}): errore di q {q}, della storia {history} α ({record}).</translation>
    </message>
    <message>
        <source>Definition: by the step of the search q spreads {q}, q robust {robust}; by rounding the record to five figures {rounded} and {rounded_robust}.</source>
        <translation>Definizione: con il passo della ricerca q varia del {q}, q robusto del {robust}; arrotondando il record a cinque cifre del {rounded} e {rounded_robust}.</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Verifiche</translation>
    </message>
    <message>
        <source>Clause</source>
        <translation>Clausola</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Esito</translation>
    </message>
    <message>
        <source>record</source>
        <translation>record</translation>
    </message>
    <message>
        <source>Peaks at the demand</source>
        <translation>Massimi alla domanda</translation>
    </message>
    <message>
        <source>No demand: no check. q of the wall: {q}</source>
        <translation>Nessuna domanda: nessuna verifica. q della parete: {q}</translation>
    </message>
    <message>
        <source>Should the restraint behind fail: ζ {zeta}</source>
        <translation>Se il vincolo posteriore cede: ζ {zeta}</translation>
    </message>
    <message>
        <source>within α</source>
        <translation>entro α</translation>
    </message>
    <message>
        <source>exceeds α or overturns</source>
        <translation>supera α o ribalta</translation>
    </message>
    <message>
        <source>Peak rotation against q</source>
        <translation>Rotazione massima e q</translation>
    </message>
    <message>
        <source>run</source>
        <translation>analisi</translation>
    </message>
    <message>
        <source>Survival map</source>
        <translation>Mappa di sopravvivenza</translation>
    </message>
    <message>
        <source>share collapsed [-]</source>
        <translation>quota di collassi [-]</translation>
    </message>
    <message>
        <source>Fragility</source>
        <translation>Fragilità</translation>
    </message>
    <message>
        <source>fragility</source>
        <translation>fragilità</translation>
    </message>
    <message>
        <source>Logarithmic axes</source>
        <translation>Assi logaritmici</translation>
    </message>
    <message>
        <source>No record with a q.</source>
        <translation>Nessun record con un q.</translation>
    </message>
    <message>
        <source>time histories</source>
        <translation>storie temporali</translation>
    </message>
    <message>
        <source>set: q {q}, q robust {robust}</source>
        <translation>insieme: q {q}, q robusto {robust}</translation>
    </message>
    <message>
        <source>Compatibility</source>
        <translation>Compatibilità</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regola</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>mean of the records</source>
        <translation>media dei record</translation>
    </message>
    <message>
        <source>target: {name}</source>
        <translation>spettro: {name}</translation>
    </message>
    <message>
        <source>SI is the area under the pseudo-velocity from 0.1 to 2.5 s (shaded).</source>
        <translation>SI è l'area sotto la pseudo-velocità da 0.1 a 2.5 s (in grigio).</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Passo temporale</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonna</translation>
    </message>
    <message>
        <source>Lines to skip</source>
        <translation>Righe da saltare</translation>
    </message>
    <message>
        <source>Of plain text: the column of the acceleration, 1 is the first</source>
        <translation>Di testo semplice: la colonna dell'accelerazione, 1 è la prima</translation>
    </message>
    <message>
        <source>Of plain text: lines of the head before the numbers</source>
        <translation>Di testo semplice: righe d'intestazione prima dei numeri</translation>
    </message>
    <message>
        <source>{n} more files are not shown: add them in parts.</source>
        <translation>Altri {n} file non sono mostrati: aggiungerli a parti.</translation>
    </message>
    <message>
        <source>Generated motions are one set: Remove takes them all, Generate… makes others.</source>
        <translation>I moti generati sono un solo gruppo: Togli li toglie tutti, Genera… ne fa altri.</translation>
    </message>
    <message>
        <source>No files there.</source>
        <translation>Nessun file lì.</translation>
    </message>
    <message>
        <source>theory: angular momentum kept, no sliding, no bouncing</source>
        <translation>teoria: momento angolare conservato, senza scorrimento né rimbalzo</translation>
    </message>
    <message>
        <source>tests on walls of tuff units and of clay bricks</source>
        <translation>prove su pareti di tufo e di mattoni pieni</translation>
    </message>
    <message>
        <source>tests on sack stone masonry; above Eq. 4 for α &gt; 6.63°</source>
        <translation>prove su muratura a sacco; sopra l'Eq. 4 per α &gt; 6.63°</translation>
    </message>
    <message>
        <source>theory: impacts of base, upper corner and base again</source>
        <translation>teoria: urti di base, spigolo superiore e di nuovo base</translation>
    </message>
    <message>
        <source>tests; v over the overturning velocity, beyond v = 1.58 held at e = 0; value for v = 0</source>
        <translation>prove; v sulla velocità di ribaltamento, oltre v = 1.58 tenuto a e = 0; valore per v = 0</translation>
    </message>
    <message>
        <source>given, 0 to 1</source>
        <translation>dato, da 0 a 1</translation>
    </message>
    <message>
        <source>It is being written.</source>
        <translation>È in corso la scrittura.</translation>
    </message>
    <message>
        <source>{n} files were left out: they cannot be read as they are.</source>
        <translation>{n} file sono stati lasciati fuori: così come sono non si leggono.</translation>
    </message>
    <message>
        <source>Saved without what stands in the red field.</source>
        <translation>Salvato senza quanto sta nel campo rosso.</translation>
    </message>
    <message>
        <source>Another program has changed {path}. Overwrite it?</source>
        <translation>Un altro programma ha cambiato {path}. Sovrascriverlo?</translation>
    </message>
    <message>
        <source>Needed with a demand: 0 on the ground. Above it no check is made yet</source>
        <translation>Richiesta con una domanda: 0 al suolo. Più in alto non si esegue ancora alcuna verifica</translation>
    </message>
    <message>
        <source>Free to vibrate</source>
        <translation>Libera di vibrare</translation>
    </message>
    <message>
        <source>two-sided yes, one-sided no</source>
        <translation>su due lati sì, su un lato no</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sì</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Parapet, gable top, pinnacle, free wall: no transverse wall holds it before it moves</source>
        <translation>Parapetto, sommità di timpano, pinnacolo, muro isolato: nessun muro trasversale la trattiene prima del moto</translation>
    </message>
    <message>
        <source>Elastic modulus E</source>
        <translation>Modulo elastico E</translation>
    </message>
    <message>
        <source>With the unit weight gives T_0 of an element free to vibrate (C8.7.1.7)</source>
        <translation>Con il peso specifico dà T_0 di un elemento libero di vibrare (C8.7.1.7)</translation>
    </message>
    <message>
        <source>FC acts</source>
        <translation>FC agisce</translation>
    </message>
    <message>
        <source>on the strength</source>
        <translation>sulla resistenza</translation>
    </message>
    <message>
        <source>on the demand</source>
        <translation>sulla domanda</translation>
    </message>
    <message>
        <source>C8.7.1.2.1.3: on the strength of the capacity curve; on the demand is more cautious</source>
        <translation>C8.7.1.2.1.3: sulla resistenza della curva di capacità; sulla domanda è più cautelativo</translation>
    </message>
    <message>
        <source>Periods compared</source>
        <translation>Periodi confrontati</translation>
    </message>
    <message>
        <source>Compatibility of the records; empty: 0.15 to 2.0 s, natural records to T_SLV</source>
        <translation>Compatibilità degli accelerogrammi; vuoto: da 0.15 a 2.0 s, naturali fino a T_SLV</translation>
    </message>
    <message>
        <source>{text}: not two numbers</source>
        <translation>{text}: non sono due numeri</translation>
    </message>
    <message>
        <source>Element free to vibrate</source>
        <translation>Elemento libero di vibrare</translation>
    </message>
    <message>
        <source>Restrained by transverse walls</source>
        <translation>Vincolata ai muri trasversali</translation>
    </message>
    <message>
        <source>failing within ±10 % of the demand: {share}</source>
        <translation>cedono entro ±10 % dalla domanda: {share}</translation>
    </message>
    <message>
        <source>The picture cannot be made.</source>
        <translation>L'immagine non può essere prodotta.</translation>
    </message>
</context>
</TS>
