standing = Wandfuß unter den Momenten der Normen

standing-about =
    Der Tank hat keine Anker. Nebeneinanderliegende Streifen des Bodenblechs halten eine Wand, deren Fuß sich verwölbt, wie ihr oberer Rand es zulässt; Bleche, Wand und
    Gewicht sind die des Rechenblatts: abzüglich Korrosion, Vertikalbewegung und Überdruck. Maßgebend ist eine angegebene Steifigkeit des
    Bodens, bei angenommenen die ungünstigste.
standing-with-weight = Unter { $moment }, dem Moment nach { $method }, mit { $weight } aus Wand und Dach wie auf ihrem Rechenblatt.
standing-moment = Unter { $moment }, dem Moment nach { $method }.
standing-softened =
    Verdrehung, Abhebung und Spannung am Druckrand gelten nicht: der Bodendruck der Bewegung erreicht { $share } des Ruhedrucks, mehr als
    { $limit }, wenn das ganze Moment das der impulsiven Flüssigkeit ist. Unter einem nicht runden oberen Rand der Wand heben die Streifen,
    die diesen Druck nicht ansetzen, dann weniger ab als Schalen und haben zu wenig Spannung am Druckrand. Zu nehmen sind eine Zeitreihe und
    der nichtlineare Rechenkern, dessen Wand und Boden Schalen sind.
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
