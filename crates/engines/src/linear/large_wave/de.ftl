large_wave = Nichtlineare Flüssigkeit

large_wave-asked =
    Die Flüssigkeit ist wie verlangt nichtlinear (`--liquid nonlinear`): die lineare Welle von { $wave } steht daneben. Bis { $limit } ist eine Welle
    klein, und ihr Wellenberg höchstens ein Zehntel höher als nach linearer Theorie. Drücke auf die Wand und Spannungen in ihr sind die der linearen
    Flüssigkeit.
large_wave-passed =
    Die lineare Welle von { $wave } ist nicht klein: über { $limit } ist ihr Wellenberg um mehr als ein Zehntel höher. Deshalb wurde die Flüssigkeit
    ein zweites Mal nichtlinear berechnet. Die Werte des Laufs und der Wellenberg, den sein Freibord aufnehmen muss, sind die der linearen
    Flüssigkeit.
large_wave-counts =
    Die lineare Welle von { $wave } ist nicht klein: über { $limit } ist ihr Wellenberg um mehr als ein Zehntel höher. Deshalb wurde die Flüssigkeit
    ein zweites Mal nichtlinear berechnet. Wellenberg und Wellental des Laufs und der Wellenberg, den sein Freibord aufnehmen muss, sind die der
    nichtlinearen Flüssigkeit: die Welle bricht, oder ihr Faktor gilt nicht mehr. Die übrigen Werte sind die der linearen Flüssigkeit.
large_wave-other =
    Die nichtlineare Flüssigkeit ist weggelassen. In einem starren Tank, der dem Boden folgt, ist die lineare Welle { $alone }, in diesem { $wave }: seine
    Basis kippt, oder seine Wand gibt nach, dem die nichtlineare Flüssigkeit nicht folgt. Der Wellenberg ist die lineare Welle mit ihrem Faktor.
large_wave-breaking =
    Ab t = { $time } ist die Neigung des Spiegels größer als { $slope }: die Welle kann brechen, was das Modell nicht abbildet. Was danach größer ist, ist
    eine untere Schranke.
large_wave-steep =
    Der nichtlineare Lauf endet bei t = { $time }, r = { $r }, θ = { $angle }, wo die Neigung des Spiegels 2 erreicht: die Welle bricht. Seine Werte sind
    untere Schranken: die bis dahin oder, wo er mehr hat, die des linearen Laufs.
large_wave-dry =
    Der nichtlineare Lauf endet bei t = { $time }, r = { $r }, θ = { $angle }, wo ein Wellental dem Boden nahe kommt. Seine Werte sind
    untere Schranken: die bis dahin oder, wo er mehr hat, die des linearen Laufs.
large_wave-diverged =
    Der nichtlineare Lauf endet bei t = { $time }, r = { $r }, θ = { $angle }, wo die Entwicklung des Spiegels divergiert. Seine Werte sind
    untere Schranken: die bis dahin oder, wo er mehr hat, die des linearen Laufs.
large_wave-model =
    Potentialströmung im starren Tank, bis zur dritten Ordnung nach den Eigenformen des Tanks entwickelt; ihr Unterschied zu einer linearen
    Flüssigkeit im starren Tank kommt zur linearen Antwort des elastischen hinzu.
large_wave-values = Lineare und nichtlineare Flüssigkeit
large_wave-value = Nichtlinear
large_wave-held = Linear
large_wave-crest_around = Höchster Wellenberg am Umfang
large_wave-wave_height_theta_0 = Welle an der Wand, θ = 0, um den höchsten Wellenberg
large_wave-linear = linear
large_wave-nonlinear = nichtlinear
large_wave-wave = Welle
large_wave-energies = Energie der Flüssigkeit am Ende, im Bezugssystem des Tanks
large_wave-energies-value = Energie
large_wave-input = Arbeit der Bewegung
large_wave-damped = Dämpfung
large_wave-kinetic = Kinetisch
large_wave-potential = Potentiell
large_wave-balance =
    Über { $steps } Schritte fehlen den Energien höchstens { $energy } der größten zu ihrem Gleichgewicht, dem mittleren Stand des Spiegels (sein Volumen
    über der Fläche) { $volume }. Die größte Neigung des Spiegels ist { $slope }.
