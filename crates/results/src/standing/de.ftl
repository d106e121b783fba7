standing = Wandfuß unter den Momenten der Normen

standing-about =
    Der Tank hat keine Anker. Nebeneinanderliegende Streifen des Bodenblechs halten eine Wand, deren Fuß eben bleibt; Bleche, Wand und
    Gewicht sind die des Rechenblatts: abzüglich Korrosion, Vertikalbewegung und Überdruck. Maßgebend ist eine angegebene Steifigkeit des
    Bodens, bei angenommenen die ungünstigste.
standing-with-weight = Unter { $moment }, dem Moment nach { $method }, mit { $weight } aus Wand und Dach wie auf ihrem Rechenblatt.
standing-moment = Unter { $moment }, dem Moment nach { $method }.
standing-ground = Boden unter dem Rand
standing-information = { $ground }, zur Information
standing-not-held = nicht gehalten
standing-grounds-rotation = Verdrehung des Wandfußes
standing-uplift = Abhebung
standing-lifted_width = Abgehobene Breite
standing-plastic_rotation = Plastische Verdrehung
standing-toe_axial_stress = Spannung am Druckrand

standing-moment_rotation = Moment des Wandfußes über seiner Verdrehung
standing-lifted = Abgehobenes Bodenblech
standing-pressed = Bodenpressung darunter
standing-exaggerated = Auf der abgehobenen Seite, auf { $ground }; Höhen überhöht.
standing-moment_rotation-moment = Moment
standing-distance = Abstand von der Wand
standing-deflection = Durchbiegung
standing-pressure = Druck
standing-level = Boden
standing-plate = Blech
standing-yielded = plastiziert
