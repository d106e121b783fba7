soil = Boden unter der Gründungsplatte

soil-about =
    Der Tank bewegt sich auf einer starren Platte auf dem Boden. Der ganze Lauf des linearen Rechenkerns enthält die Bewegung der Platte;
    Eigenformen sowie impulsive Periode und Masse des Vergleichs sind die auf starrem Fuß.
soil-about-nonlinear =
    Der Tank bewegt sich auf einer starren Platte auf dem Boden. Der ganze Lauf enthält die Bewegung der Platte, mit Federn und Dämpfern wie im
    linearen Rechenkern; Eigenformen und impulsive Periode des Vergleichs sind die auf starrem Fuß.
soil-ground =
    { $slab }. Boden mit V_s = { $velocity }, { $density }, Querkontraktionszahl { $poisson }: statische Steifigkeit { $horizontal } und
    { $rocking }. Impulsive Eigenform { $mass } bei { $arm } über der Plattenunterseite, Dämpfung { $damping } auf starrem Fuß.
soil-ground-layers =
    { $slab }. { $layers } Bodenschichten über einem Halbraum mit V_s = { $velocity }; Unterseite { $embedment } unter Gelände,
    Materialdämpfung { $hysteresis } im Halbraum. Impulsive Eigenform { $mass } bei { $arm } über der Plattenunterseite, Dämpfung
    { $damping } auf starrem Fuß.
soil-slab = Platte mit Radius { $radius }, { $thickness } dick, { $mass }
soil-slab-without-mass = Platte mit Radius { $radius }, ohne Masse

soil-cones = Federn und Dämpfer des Bodens
soil-impedance = Impedanz
soil-spring = Feder k
soil-dashpot = Dämpfer c
soil-inertia = Trägheit
soil-translation = Verschiebung
soil-rocking = Kippen
soil-internal = innere Verdrehung, über ihren Dämpfer mit der schaukelnden Platte verbunden

soil-effective = Periode und Dämpfung der impulsiven Eigenform
soil-mode = Impulsive Eigenform
soil-period = Periode
soil-effective-ratio = zu starrem Fuß
soil-damping = Dämpfung
soil-fixed = starrer Fuß
soil-effective-cones = auf Boden, komplexe Steifigkeit mit Kegeln
soil-effective-layers = auf Boden, komplexe Steifigkeit mit Kegeln in Schichten
soil-veletsos = auf Boden, komplexe Steifigkeit nach Veletsos und Verbic
soil-complex_mode = auf Boden, komplexe Eigenform auf Kegeln, mit der Platte
soil-static = auf Boden, statische Federn
soil-definitions =
    Die Definitionen der Dämpfung stimmen unterhalb von 0,10 überein und weichen oberhalb von 0,20 um bis zu einem Drittel ab. Kein Wert
    dieses Berichts ist aus ihnen berechnet: die Zeitverlaufsberechnung enthält die Kegel selbst.

soil-at-frequency =
    Federn und Dämpfer sind die komplexe Steifigkeit bei { $period }, der Periode der impulsiven Eigenform auf dem Boden; die
    Zeitverlaufsberechnung hat sie bei allen Frequenzen. Die viel langsameren Wellen der Flüssigkeit bewegen die Platte kaum.

soil-motion = Größte Bewegung der Platte
soil-motion-quantity = Platte
soil-motion-value = Größter Wert
soil-base_translation = Verschiebung relativ zum Freifeld
soil-base_rotation = Verdrehung
soil-beside = Werte auf dem Boden und auf fester Lagerung
soil-beside-value = Auf Boden
soil-foundation_translation = Verschiebung der Platte über die Zeit
soil-foundation_translation-axis = Verschiebung
soil-foundation_rotation = Verdrehung der Platte über die Zeit
soil-foundation_rotation-axis = Verdrehung

soil-rigid =
    Die Platte ist starr und liegt auf der Oberfläche eines gleichmäßigen Halbraums; das Freifeld bewegt sie ohne kinematische
    Wechselwirkung.
soil-meek =
    Boden als Kegel nach Meek und Wolf mit der Steifigkeit aus `shear_wave_velocity`, dem Wert bei den Dehnungen des Erdbebens; seine
    Hysterese bleibt außer Ansatz.
soil-rigid-layers =
    Die Platte ist starr, ihr Rand hat über die Tiefe ihrer Unterseite Kontakt mit dem Boden; das Freifeld an der Geländeoberfläche bewegt
    die Unterseite. Die kinematische Wechselwirkung, die diese Bewegung verkleinert und die Platte verdreht, bleibt außer Ansatz.
soil-layered =
    Boden als Kegel mit Reflexion und Brechung an { $layers } Schichten (Wolf und Deeks 2004), Scheiben über eine Einbindung von
    { $embedment }, Materialdämpfung nach dem Korrespondenzprinzip; Geschwindigkeiten bei den Dehnungen des Erdbebens.
soil-bottom =
    Der Bodendruck dreht die Platte, und die Flüssigkeit auf dem sich drehenden Boden hat ihre Trägheit; das Gewicht von Flüssigkeit und
    Wand hat in der gedrehten Lage kein Moment.
soil-modal = Die modale Dämpfung ist die des Tanks auf starrem Fuß; der Boden fügt seine Dämpfer hinzu.
soil-relative = Die Dämpfung der Wand wirkt auf ihre Bewegung relativ zur Platte; der Boden fügt seine Dämpfer hinzu.
soil-vertical = Die Vertikalbewegung ist die auf starrem Fuß.
soil-disc = Die Platte ist eine Scheibe aus Stahlbeton von { $density } mit dem Radius des Bodenblechs.
soil-no-mass = Ohne `tank.foundation.thickness` hat die Platte keine Masse.
